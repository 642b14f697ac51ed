#ifndef asperity_tests_heat_chip_examples_h
#define asperity_tests_heat_chip_examples_h

#include <asperity/heat/heat_conduction.h>
#include <asperity/heat/point_values.h>
#include <asperity/isogeometric/force_term.h>
#include <asperity/isogeometric/spline_space.h>

#include <deal.II/base/quadrature_lib.h>

#include <functional>
#include <memory>
#include <vector>

namespace heat_example
{
  using namespace asperity;
  using dealii::Point;
  using Vector = dealii::Vector<double>;

  /** A block, periodic in x, with n spans along x and rows as given. */
  struct Block
  {
    Block(const unsigned int         degree,
          const double               length,
          const unsigned int         n,
          const std::vector<double> &rows)
      : length(length)
      , space(KnotVector(degree, columns(length, n), true),
              KnotVector(degree, rows))
      , cells(tabulate_cells(space, {}, dealii::QGauss<2>(degree + 1)))
      , top(edge(Edge::top))
      , bottom(edge(Edge::bottom))
    {}

    static std::vector<double>
    columns(const double length, const unsigned int n)
    {
      std::vector<double> x;
      for (unsigned int i = 0; i <= n; ++i)
        x.push_back(length * i / n);
      return x;
    }

    BasisTable<2>
    edge(const Edge edge) const
    {
      return tabulate_edge(
        space, {}, edge, dealii::QGauss<1>(space.degree() + 2), true);
    }

    HeatConduction
    conduction(const ThermalProperties &material) const
    {
      return HeatConduction(cells, space.n_functions(), material);
    }

    /** A displacement at rest. */
    Vector
    at_rest() const
    {
      return Vector(2 * space.n_functions());
    }

    /** The projection of a displacement. */
    Vector
    displacement(
      const std::function<std::vector<double>(const Point<2> &)> &f) const
    {
      const auto coefficients = space.project(f, 2);
      Vector     u            = at_rest();
      for (unsigned int a = 0; a < space.n_functions(); ++a)
        for (unsigned int c = 0; c < 2; ++c)
          u(displacement_dof<2>(a, c)) = coefficients[c][a];
      return u;
    }

    /** Values of a function at the points of the cells. */
    Vector
    at_points(const std::function<double(const Point<2> &)> &f) const
    {
      Vector values(cells.position.size());
      for (unsigned int q = 0; q < values.size(); ++q)
        values(q) = f(cells.position[q]);
      return values;
    }

    /** power_a += int N_a f dS along an edge. */
    static void
    add_flux(const BasisTable<2>                           &edge,
             const std::function<double(const Point<2> &)> &f,
             Vector                                        &power)
    {
      Vector heat(edge.JxW.size());
      for (unsigned int q = 0; q < heat.size(); ++q)
        heat(q) = edge.JxW[q] * f(edge.position[q]);
      add_point_values(edge, heat, power);
    }

    double         length;
    SplineSpace<2> space;
    BasisTable<2>  cells, top, bottom;
  };

  /** Levels from 0 to `height`, finest at the top, where a row is `top` high;
   *  each is higher than the one above it by `grading`. */
  inline std::vector<double>
  rows(const double height, const double top, const double grading)
  {
    std::vector<double> depth = {0.};
    for (double row = top; depth.back() + 0.5 * row < height; row *= grading)
      depth.push_back(depth.back() + row);
    std::vector<double> levels;
    for (auto d = depth.rbegin(); d != depth.rend(); ++d)
      levels.push_back(height * (1. - *d / depth.back()));
    return levels;
  }
} // namespace heat_example

#endif
