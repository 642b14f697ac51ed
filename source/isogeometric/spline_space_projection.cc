#include <asperity/isogeometric/bernstein.h>
#include <asperity/isogeometric/l2_projection.h>
#include <asperity/isogeometric/spline_space.h>

#include <deal.II/base/quadrature_lib.h>

namespace asperity
{
  namespace
  {
    using VectorFunction =
      std::function<std::vector<double>(const dealii::Point<2> &)>;

    /** Adds factor * area * sum_q w_q N_a(x_q) f(x_q) to the load of every
     *  function of a cell; points and weights are those of the unit square. */
    void
    add_products(const SplineHierarchy               &hierarchy,
                 const unsigned int                   cell,
                 const std::vector<dealii::Point<2>> &points,
                 const std::vector<double>           &weights,
                 const BernsteinTable                &bernstein,
                 const VectorFunction                &f,
                 const double                         factor,
                 std::vector<dealii::Vector<double>> &loads)
    {
      const auto &functions  = hierarchy.cell_functions(cell);
      const auto &extraction = hierarchy.cell_extraction(cell);
      const auto [low, high] = hierarchy.cell_box(cell);
      const double area      = (high[0] - low[0]) * (high[1] - low[1]);
      for (unsigned int q = 0; q < points.size(); ++q)
        {
          const std::vector<double> value =
            f(dealii::Point<2>(low[0] + points[q][0] * (high[0] - low[0]),
                               low[1] + points[q][1] * (high[1] - low[1])));
          for (unsigned int a = 0; a < functions.size(); ++a)
            {
              double N = 0.;
              for (unsigned int b = 0; b < extraction.n(); ++b)
                N += extraction(a, b) * bernstein.values[q][b];
              for (unsigned int c = 0; c < loads.size(); ++c)
                loads[c][functions[a]] +=
                  N * value[c] * factor * area * weights[q];
            }
        }
    }
  } // namespace



  std::vector<std::vector<double>>
  SplineSpace::project(const VectorFunction &f,
                       const unsigned int    n_components,
                       const double          edge_weight) const
  {
    const auto                          space = hierarchy();
    std::vector<dealii::Vector<double>> loads(
      n_components, dealii::Vector<double>(n_functions()));

    const dealii::QGauss<2> quadrature(degree() + 3);
    const BernsteinTable    bernstein(degree(), quadrature.get_points());
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      add_products(*space,
                   cell,
                   quadrature.get_points(),
                   quadrature.get_weights(),
                   bernstein,
                   f,
                   1.,
                   loads);

    const dealii::QGauss<1> edge_quadrature(degree() + 3);
    if (edge_weight != 0.)
      for (const Edge edge : boundary_edges(*space))
        {
          const auto           points = edge_points(edge_quadrature, edge);
          const BernsteinTable edge_bernstein(degree(), points);
          // The length of the face times the cell's width normal to it: as in
          // L2Projection.
          for (const unsigned int cell : edge_cells(edge))
            add_products(*space,
                         cell,
                         points,
                         edge_quadrature.get_weights(),
                         edge_bernstein,
                         f,
                         edge_weight,
                         loads);
        }

    const L2Projection               projection(*space, edge_weight);
    std::vector<std::vector<double>> coefficients;
    for (auto &load : loads)
      {
        projection.solve(load);
        coefficients.emplace_back(load.begin(), load.end());
      }
    return coefficients;
  }
} // namespace asperity
