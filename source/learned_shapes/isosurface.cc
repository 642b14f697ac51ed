#include <asperity/base/errors.h>
#include <asperity/learned_shapes/isosurface.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

namespace asperity
{
  using namespace dealii;

  namespace
  {
    /** Gives points that lie within a tolerance one number. */
    template <int dim>
    class PointNumbers
    {
    public:
      explicit PointNumbers(const double tolerance)
        : tolerance(tolerance)
      {}

      unsigned int
      number(const Point<dim> &point)
      {
        // a point near the edge of its box may have its like in the next one
        std::array<long, dim> box;
        for (unsigned int c = 0; c < (1u << dim); ++c)
          {
            for (unsigned int d = 0; d < dim; ++d)
              box[d] = std::lround(point[d] / (4. * tolerance) +
                                   (c >> d & 1u ? 0.25 : -0.25));
            const auto found = numbers.find(box);
            if (found != numbers.end() &&
                points[found->second].distance(point) < tolerance)
              return found->second;
          }
        for (unsigned int c = 0; c < (1u << dim); ++c)
          {
            for (unsigned int d = 0; d < dim; ++d)
              box[d] = std::lround(point[d] / (4. * tolerance) +
                                   (c >> d & 1u ? 0.25 : -0.25));
            numbers.emplace(box, points.size());
          }
        points.push_back(point);
        return points.size() - 1;
      }

      std::vector<Point<dim>> points;

    private:
      double                                        tolerance;
      std::map<std::array<long, dim>, unsigned int> numbers;
    };



    /** Cuts a function on a grid at zero. */
    template <int dim>
    void
    march(const BatchFunction            &function,
          const double                    half_box,
          const unsigned int              n,
          const unsigned int              n_subdivisions,
          std::vector<Point<dim>>        &points,
          std::vector<CellData<dim - 1>> &cells)
    {
      Triangulation<dim> grid;
      GridGenerator::subdivided_hyper_cube(grid, n, -half_box, half_box);
      const FE_Q<dim>      fe(1);
      const MappingQ1<dim> mapping;
      DoFHandler<dim>      dof_handler(grid);
      dof_handler.distribute_dofs(fe);
      std::vector<Point<dim>> nodes(dof_handler.n_dofs());
      DoFTools::map_dofs_to_support_points(mapping, dof_handler, nodes);
      std::vector<double> coordinates;
      coordinates.reserve(dim * nodes.size());
      for (const Point<dim> &node : nodes)
        for (unsigned int d = 0; d < dim; ++d)
          coordinates.push_back(node[d]);
      const std::vector<double> values = function(coordinates);
      const Vector<double>      vector(values.begin(), values.end());
      GridTools::MarchingCubeAlgorithm<dim, Vector<double>>(mapping,
                                                            fe,
                                                            n_subdivisions)
        .process(dof_handler, vector, 0., points, cells);
    }



    /** Turns the simplices so that the function grows across them. */
    template <int dim>
    void
    turn_outwards(const BatchFunction                              &function,
                  const double                                      step,
                  const std::vector<Point<dim>>                    &points,
                  std::vector<typename BoundaryMesh<dim>::Simplex> &simplices)
    {
      std::vector<double> places;
      for (const auto &simplex : simplices)
        {
          Point<dim> middle;
          for (const unsigned int v : simplex)
            middle += points[v] / double(dim);
          Tensor<1, dim> normal;
          if constexpr (dim == 2)
            {
              const auto along = points[simplex[1]] - points[simplex[0]];
              normal           = Tensor<1, 2>({along[1], -along[0]});
            }
          else
            normal = cross_product_3d(points[simplex[1]] - points[simplex[0]],
                                      points[simplex[2]] - points[simplex[0]]);
          for (const double sign : {-1., 1.})
            for (unsigned int d = 0; d < dim; ++d)
              places.push_back(middle[d] +
                               sign * step * normal[d] / normal.norm());
        }
      const std::vector<double> values = function(places);
      for (std::size_t i = 0; i < simplices.size(); ++i)
        if (values[2 * i] > values[2 * i + 1])
          std::swap(simplices[i][0], simplices[i][1]);
    }



    /** The surface on a grid of which each cell is cut into parts. */
    template <int dim>
    BoundaryMesh<dim>
    cut(const BatchFunction &function,
        const double         half_box,
        const unsigned int   n,
        const unsigned int   n_subdivisions)
    {
      const double                   h = 2. * half_box / n / n_subdivisions;
      std::vector<Point<dim>>        points;
      std::vector<CellData<dim - 1>> cells;
      march(function, half_box, n, n_subdivisions, points, cells);

      PointNumbers<dim>                                numbers(1e-6 * h);
      std::vector<typename BoundaryMesh<dim>::Simplex> simplices;
      for (const CellData<dim - 1> &cell : cells)
        {
          typename BoundaryMesh<dim>::Simplex simplex;
          for (unsigned int k = 0; k < dim; ++k)
            simplex[k] = numbers.number(points[cell.vertices[k]]);
          // where the surface passes through a node, simplices may be points
          if (std::set<unsigned int>(simplex.begin(), simplex.end()).size() ==
              dim)
            simplices.push_back(simplex);
        }
      if (simplices.empty())
        throw InputError("The function has no zero in the box.");
      turn_outwards(function, 0.1 * h, numbers.points, simplices);
      return {numbers.points, simplices};
    }
  } // namespace



  template <int dim>
  BoundaryMesh<dim>
  isosurface(const BatchFunction &function,
             const double         half_box,
             const unsigned int   n)
  {
    // deal.II leaves out a cell in which two opposite corners are inside and
    // the others are not, as at a sharp tip: smaller parts of it, in which the
    // function is bilinear, have no such corners.
    BoundaryMesh<dim> result = cut<dim>(function, half_box, n, 1);
    for (unsigned int parts = 2; parts <= 4 && !result.is_closed(); parts *= 2)
      result = cut<dim>(function, half_box, n, parts);
    return result;
  }



  template BoundaryMesh<2>
  isosurface<2>(const BatchFunction &, const double, const unsigned int);
  template BoundaryMesh<3>
  isosurface<3>(const BatchFunction &, const double, const unsigned int);
} // namespace asperity
