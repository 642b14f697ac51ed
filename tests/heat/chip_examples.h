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

  /** The waves of one direction, or the same ones in two of the same period. */
  template <int dim = 2>
  FourierBasis<dim>
  waves(const double period, const unsigned int n)
  {
    typename FourierBasis<dim>::template Directions<double>       periods;
    typename FourierBasis<dim>::template Directions<unsigned int> numbers;
    periods.fill(period);
    numbers.fill(n);
    return FourierBasis<dim>(periods, numbers);
  }

  /** A block, periodic along its top, with n spans along each direction of it
   *  and rows as given. */
  template <int dim>
  struct BlockIn
  {
    using Function = std::function<double(const Point<dim> &)>;

    BlockIn(const unsigned int         degree,
            const double               length,
            const unsigned int         n,
            const std::vector<double> &rows)
      : length(length)
      , space(knots(degree, length, n, rows))
      , cells(tabulate_cells(space, {}, dealii::QGauss<dim>(degree + 1)))
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

    static SplineSpace<dim>
    knots(const unsigned int         degree,
          const double               length,
          const unsigned int         n,
          const std::vector<double> &rows)
    {
      const KnotVector along(degree, columns(length, n), true),
        upwards(degree, rows);
      if constexpr (dim == 2)
        return SplineSpace<2>(along, upwards);
      else
        return SplineSpace<3>(along, along, upwards);
    }

    BasisTable<dim>
    edge(const Edge edge) const
    {
      return tabulate_edge(
        space, {}, edge, dealii::QGauss<dim - 1>(space.degree() + 2), true);
    }

    HeatConduction<dim>
    conduction(const ThermalProperties &material) const
    {
      return HeatConduction<dim>(cells, space, material);
    }

    /** A displacement at rest. */
    Vector
    at_rest() const
    {
      return Vector(dim * space.n_functions());
    }

    /** The projection of a displacement. */
    Vector
    displacement(
      const std::function<std::vector<double>(const Point<dim> &)> &f) const
    {
      const auto coefficients = space.project(f, dim);
      Vector     u            = at_rest();
      for (unsigned int a = 0; a < space.n_functions(); ++a)
        for (unsigned int c = 0; c < dim; ++c)
          u(displacement_dof<dim>(a, c)) = coefficients[c][a];
      return u;
    }

    /** Values of a function at the points of the cells. */
    Vector
    at_points(const Function &f) const
    {
      Vector values(cells.position.size());
      for (unsigned int q = 0; q < values.size(); ++q)
        values(q) = f(cells.position[q]);
      return values;
    }

    /** power_a += int N_a f dS along an edge. */
    static void
    add_flux(const BasisTable<dim> &edge, const Function &f, Vector &power)
    {
      Vector heat(edge.JxW.size());
      for (unsigned int q = 0; q < heat.size(); ++q)
        heat(q) = edge.JxW[q] * f(edge.position[q]);
      add_point_values(edge, heat, power);
    }

    double           length;
    SplineSpace<dim> space;
    BasisTable<dim>  cells, top, bottom;
  };

  using Block = BlockIn<2>;

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
