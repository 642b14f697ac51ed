#include <asperity/base/errors.h>
#include <asperity/base/random_numbers.h>
#include <asperity/learned_shapes/base_shapes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace asperity
{
  using namespace dealii;

  namespace
  {
    const double pi = 3.14159265358979323846;

    unsigned int
    n_corners(const BaseShape shape)
    {
      switch (shape)
        {
          case BaseShape::triangle:
            return 3;
          case BaseShape::square:
            return 4;
          case BaseShape::hexagon:
            return 6;
          case BaseShape::disc:
            break;
        }
      return 0;
    }



    /** Counterclockwise around the middle, an edge at the bottom. */
    std::vector<Point<2>>
    outline(const BaseShape shape, const unsigned int n_pieces)
    {
      const unsigned int n =
        shape == BaseShape::disc ? n_pieces : n_corners(shape);
      const unsigned int n_on_edge = std::max(1u, n_pieces / n);
      const auto         corner    = [n](const unsigned int i) {
        const double angle = -0.5 * pi + (2. * i + 1.) * pi / n;
        return Point<2>(std::cos(angle), std::sin(angle));
      };
      std::vector<Point<2>> result;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n_on_edge; ++j)
          result.push_back(corner(i) +
                           double(j) / n_on_edge * (corner(i + 1) - corner(i)));
      return result;
    }



    BoundaryMesh<2>
    extruded(const std::vector<Point<2>> &section, const Point<2> &)
    {
      return polygon(section);
    }



    /** Bottom and top are fans, the sides squares cut into two. */
    BoundaryMesh<3>
    extruded(const std::vector<Point<2>> &section, const Point<3> &)
    {
      const unsigned int    n = section.size(), n_layers = std::max(2u, n / 4);
      std::vector<Point<3>> points;
      std::vector<BoundaryMesh<3>::Simplex> triangles;
      for (unsigned int layer = 0; layer <= n_layers; ++layer)
        for (const Point<2> &p : section)
          points.emplace_back(p[0], p[1], 2. * layer / n_layers - 1.);
      const unsigned int bottom = points.size(), top = bottom + 1;
      points.emplace_back(0., 0., -1.);
      points.emplace_back(0., 0., 1.);
      for (unsigned int i = 0; i < n; ++i)
        {
          const unsigned int next = (i + 1) % n, last = n * n_layers;
          triangles.push_back({{bottom, next, i}});
          triangles.push_back({{top, last + i, last + next}});
          for (unsigned int layer = 0; layer < n_layers; ++layer)
            {
              const unsigned int a = n * layer + i, b = n * layer + next;
              triangles.push_back({{a, b, b + n}});
              triangles.push_back({{a, b + n, a + n}});
            }
        }
      return {points, triangles};
    }



    template <int dim>
    void
    normalise(std::vector<Point<dim>> &points)
    {
      Point<dim> low = points[0], up = points[0];
      for (const Point<dim> &p : points)
        for (unsigned int d = 0; d < dim; ++d)
          {
            low[d] = std::min(low[d], p[d]);
            up[d]  = std::max(up[d], p[d]);
          }
      const Point<dim> centre = low + 0.5 * (up - low);
      double           radius = 0.;
      for (const Point<dim> &p : points)
        radius = std::max(radius, p.distance(centre));
      for (Point<dim> &p : points)
        p = Point<dim>((p - centre) / (1.03 * radius));
    }



    const std::array<std::pair<const char *, double ShapeDeformation::*>, 6>
      deformations = {{{"shrink x", &ShapeDeformation::shrink_x},
                       {"translate top x", &ShapeDeformation::translate_top_x},
                       {"translate top y", &ShapeDeformation::translate_top_y},
                       {"expand middle", &ShapeDeformation::expand_middle},
                       {"expand top", &ShapeDeformation::expand_top},
                       {"rotate top", &ShapeDeformation::rotate_top}}};

    void
    describe(ShapeRecipe &recipe)
    {
      std::ostringstream out;
      out.precision(3);
      out << name_of(recipe.base);
      for (const auto &deformation : deformations)
        if (const double x = recipe.deformation.*deformation.second; x != 0.)
          out << ", " << deformation.first << " " << x;
      recipe.name = out.str();
    }
  } // namespace



  std::string
  name_of(const BaseShape shape)
  {
    switch (shape)
      {
        case BaseShape::triangle:
          return "triangle";
        case BaseShape::square:
          return "square";
        case BaseShape::hexagon:
          return "hexagon";
        case BaseShape::disc:
          return "disc";
      }
    return "";
  }



  template <int dim>
  BoundaryMesh<dim>
  make_shape(const ShapeRecipe &recipe,
             const unsigned int n_pieces,
             const bool         normalised)
  {
    if (n_pieces < 3)
      throw InputError("The outline of a shape has at least three pieces.");
    const BoundaryMesh<dim> body =
      extruded(outline(recipe.base, n_pieces), Point<dim>());
    Point<dim> lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] = -1.;
        upper[d] = 1.;
      }
    const auto deformation =
      free_form_deformation(lower, upper, recipe.deformation);
    std::vector<Point<dim>> points;
    for (const Point<dim> &p : body.vertices())
      points.push_back(deformation.value(p));
    if (normalised)
      normalise(points);
    return {points, body.simplices()};
  }



  std::vector<ShapeRecipe>
  shape_recipes(const unsigned int  n_per_base,
                const unsigned int  n_magnitudes,
                const double        amplitude,
                const std::uint64_t seed)
  {
    RandomNumbers            random(seed);
    std::vector<ShapeRecipe> result;
    for (const BaseShape base : {BaseShape::triangle,
                                 BaseShape::square,
                                 BaseShape::hexagon,
                                 BaseShape::disc})
      {
        std::vector<ShapeRecipe> of_base = {{base, {}, ""}};
        for (const auto &deformation : deformations)
          for (unsigned int k = 1; k <= n_magnitudes; ++k)
            for (const double sign : {1., -1.})
              {
                of_base.push_back({base, {}, ""});
                of_base.back().deformation.*deformation.second =
                  sign * amplitude * k / n_magnitudes;
              }
        while (of_base.size() < n_per_base)
          {
            ShapeRecipe  recipe{base, {}, ""};
            unsigned int n_deformations = 0;
            for (const auto &deformation : deformations)
              if (random.uniform() < 0.5)
                {
                  ++n_deformations;
                  recipe.deformation.*deformation.second =
                    amplitude * (2. * random.uniform() - 1.);
                }
            if (n_deformations > 1)
              of_base.push_back(recipe);
          }
        of_base.resize(n_per_base);
        result.insert(result.end(), of_base.begin(), of_base.end());
      }
    for (ShapeRecipe &recipe : result)
      describe(recipe);
    return result;
  }



  template BoundaryMesh<2>
  make_shape<2>(const ShapeRecipe &, const unsigned int, const bool);
  template BoundaryMesh<3>
  make_shape<3>(const ShapeRecipe &, const unsigned int, const bool);
} // namespace asperity
