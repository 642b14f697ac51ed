#include <asperity/base/errors.h>
#include <asperity/base/random_numbers.h>
#include <asperity/learned_shapes/boundary_mesh.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "closest_on_simplex.h"

namespace asperity
{
  using namespace dealii;

  namespace
  {
    using Edge = std::pair<unsigned int, unsigned int>;

    /** The pieces of a simplex's rim that it shares with neighbours, in the
     *  direction in which it goes along them: the ends of a segment, the edges
     *  of a triangle. */
    std::array<Edge, 2>
    rim(const std::array<unsigned int, 2> &s)
    {
      // an end is gone through from the segment, a beginning to it
      return {{{s[0], 0}, {s[1], 1}}};
    }

    std::array<Edge, 3>
    rim(const std::array<unsigned int, 3> &s)
    {
      return {{{s[0], s[1]}, {s[1], s[2]}, {s[2], s[0]}}};
    }

    Edge
    opposite(const std::array<unsigned int, 2> &, const Edge &end)
    {
      return {end.first, 1 - end.second};
    }

    Edge
    opposite(const std::array<unsigned int, 3> &, const Edge &edge)
    {
      return {edge.second, edge.first};
    }

    Edge
    sorted(const unsigned int a, const unsigned int b)
    {
      return {std::min(a, b), std::max(a, b)};
    }
  } // namespace



  template <int dim>
  struct BoundaryMesh<dim>::Tree
  {
    using Box = std::pair<BoundingBox<dim>, unsigned int>;

    RTree<Box>                     boxes;
    std::map<Edge, Tensor<1, dim>> edge_normals; ///< in space
  };

  template <int dim>
  struct BoundaryMesh<dim>::Closest
  {
    Simplex                 simplex;
    std::array<double, dim> weights; ///< of its vertices
    Point<dim>              point;
    double                  distance = std::numeric_limits<double>::infinity();
  };



  template <int dim>
  BoundaryMesh<dim>::BoundaryMesh(const std::vector<Point<dim>> &vertices,
                                  const std::vector<Simplex>    &simplices)
    : vertices_(vertices)
    , simplices_(simplices)
  {
    if (simplices.empty())
      throw InputError("A shape has no surface.");
    for (const Simplex &simplex : simplices)
      for (const unsigned int vertex : simplex)
        if (vertex >= vertices.size())
          throw InputError("The surface of a shape has no vertex " +
                           std::to_string(vertex) + ".");
    double sum = 0.;
    for (const Simplex &simplex : simplices)
      cumulative_measure.push_back(sum +=
                                   scaled_normal(simplex).norm() / (dim - 1.));
    add_pseudonormals();
  }



  template <int dim>
  BoundaryMesh<dim>::BoundaryMesh(BoundaryMesh &&) noexcept = default;

  template <int dim>
  BoundaryMesh<dim> &
  BoundaryMesh<dim>::operator=(BoundaryMesh &&) noexcept = default;

  template <int dim>
  BoundaryMesh<dim>::~BoundaryMesh() = default;



  /** Outwards, as long as the segment or twice the triangle's area. */
  template <int dim>
  Tensor<1, dim>
  BoundaryMesh<dim>::scaled_normal(const Simplex &simplex) const
  {
    const Tensor<1, dim> along = vertices_[simplex[1]] - vertices_[simplex[0]];
    if constexpr (dim == 2)
      return Tensor<1, 2>({along[1], -along[0]});
    else
      return cross_product_3d(along,
                              vertices_[simplex[2]] - vertices_[simplex[0]]);
  }



  template <int dim>
  void
  BoundaryMesh<dim>::add_pseudonormals()
  {
    auto                            result = std::make_unique<Tree>();
    std::vector<typename Tree::Box> boxes;
    vertex_normals.resize(vertices_.size());
    for (unsigned int i = 0; i < simplices_.size(); ++i)
      {
        const Simplex          &simplex = simplices_[i];
        std::vector<Point<dim>> corners;
        for (const unsigned int vertex : simplex)
          corners.push_back(vertices_[vertex]);
        boxes.emplace_back(BoundingBox<dim>(corners), i);
        const Tensor<1, dim> scaled = scaled_normal(simplex);
        const double         length = scaled.norm();
        if (!(length > 0.))
          continue;
        const Tensor<1, dim> normal = scaled / length;
        for (unsigned int k = 0; k < dim; ++k)
          if constexpr (dim == 2)
            vertex_normals[simplex[k]] += normal;
          else
            {
              const Tensor<1, dim> a      = corners[(k + 1) % 3] - corners[k];
              const Tensor<1, dim> b      = corners[(k + 2) % 3] - corners[k];
              const double         cosine = a * b / (a.norm() * b.norm());
              vertex_normals[simplex[k]] +=
                std::acos(std::clamp(cosine, -1., 1.)) * normal;
              result->edge_normals[sorted(simplex[k], simplex[(k + 1) % 3])] +=
                normal;
            }
      }
    result->boxes = pack_rtree(boxes);
    tree          = std::move(result);
  }



  template <int dim>
  typename BoundaryMesh<dim>::Closest
  BoundaryMesh<dim>::closest(const Point<dim> &point) const
  {
    namespace bgi = boost::geometry::index;
    Closest    best;
    const auto nearest = bgi::nearest(point, simplices_.size());
    for (auto box = tree->boxes.qbegin(nearest); box != tree->boxes.qend();
         ++box)
      {
        // boxes come in the order of their distances
        if (boost::geometry::distance(box->first, point) > best.distance)
          break;
        const Simplex              &simplex = simplices_[box->second];
        std::array<Point<dim>, dim> corners;
        for (unsigned int k = 0; k < dim; ++k)
          corners[k] = vertices_[simplex[k]];
        const auto weights = closest_on_simplex(corners, point);
        Point<dim> nearest_point;
        for (unsigned int k = 0; k < dim; ++k)
          nearest_point += weights[k] * corners[k];
        const double distance = nearest_point.distance(point);
        if (distance < best.distance)
          best = {simplex, weights, nearest_point, distance};
      }
    return best;
  }



  template <int dim>
  double
  BoundaryMesh<dim>::signed_distance(const Point<dim> &point) const
  {
    const Closest             found = closest(point);
    std::vector<unsigned int> feature; // vertices between which the point is
    for (unsigned int k = 0; k < dim; ++k)
      if (found.weights[k] > 0.)
        feature.push_back(found.simplex[k]);
    Tensor<1, dim> normal;
    if (feature.size() == dim)
      normal = scaled_normal(found.simplex);
    else if (feature.size() == 1)
      normal = vertex_normals[feature[0]];
    else
      normal = tree->edge_normals.at(sorted(feature[0], feature[1]));
    return (point - found.point) * normal < 0. ? -found.distance :
                                                 found.distance;
  }



  template <int dim>
  Point<dim>
  BoundaryMesh<dim>::surface_point(RandomNumbers &random) const
  {
    const double   place   = random.uniform() * surface_measure();
    const auto     found   = std::upper_bound(cumulative_measure.begin(),
                                        cumulative_measure.end() - 1,
                                        place);
    const Simplex &simplex = simplices_[found - cumulative_measure.begin()];
    const double   u       = random.uniform();
    if constexpr (dim == 2)
      return vertices_[simplex[0]] +
             u * (vertices_[simplex[1]] - vertices_[simplex[0]]);
    else
      {
        const double root = std::sqrt(u), v = random.uniform();
        return vertices_[simplex[0]] +
               root * (1. - v) *
                 (vertices_[simplex[1]] - vertices_[simplex[0]]) +
               root * v * (vertices_[simplex[2]] - vertices_[simplex[0]]);
      }
  }



  template <int dim>
  double
  BoundaryMesh<dim>::measure() const
  {
    // the divergence of x is dim
    double sum = 0.;
    for (const Simplex &simplex : simplices_)
      sum += (vertices_[simplex[0]] - Point<dim>()) * scaled_normal(simplex) /
             (dim * (dim - 1.));
    return sum;
  }



  template <int dim>
  bool
  BoundaryMesh<dim>::is_closed() const
  {
    std::map<Edge, int> count;
    for (const Simplex &simplex : simplices_)
      for (const Edge &edge : rim(simplex))
        {
          ++count[edge];
          --count[opposite(simplex, edge)];
        }
    return std::all_of(count.begin(), count.end(), [](const auto &c) {
      return c.second == 0;
    });
  }



  template <int dim>
  int
  BoundaryMesh<dim>::euler_number() const
  {
    if constexpr (dim == 2)
      {
        // parts run counterclockwise, holes clockwise
        std::vector<unsigned int> root(vertices_.size());
        std::iota(root.begin(), root.end(), 0u);
        const auto find = [&](unsigned int v) {
          while (root[v] != v)
            v = root[v] = root[root[v]];
          return v;
        };
        for (const Simplex &simplex : simplices_)
          root[find(simplex[0])] = find(simplex[1]);
        std::map<unsigned int, double> areas;
        for (const Simplex &simplex : simplices_)
          areas[find(simplex[0])] +=
            (vertices_[simplex[0]] - Point<dim>()) * scaled_normal(simplex);
        int result = 0;
        for (const auto &loop : areas)
          result += loop.second > 0. ? 1 : -1;
        return result;
      }
    else
      {
        std::map<Edge, int>         edges;
        std::map<unsigned int, int> corners;
        for (const Simplex &simplex : simplices_)
          for (unsigned int k = 0; k < dim; ++k)
            {
              ++corners[simplex[k]];
              ++edges[sorted(simplex[k], simplex[(k + 1) % dim])];
            }
        return (int(corners.size()) - int(edges.size()) +
                int(simplices_.size())) /
               2;
      }
  }



  BoundaryMesh<2>
  polygon(const std::vector<Point<2>> &points)
  {
    std::vector<BoundaryMesh<2>::Simplex> segments;
    for (unsigned int i = 0; i < points.size(); ++i)
      segments.push_back({{i, (i + 1) % unsigned(points.size())}});
    return {points, segments};
  }



  template class BoundaryMesh<2>;
  template class BoundaryMesh<3>;
} // namespace asperity
