#include <asperity/isogeometric/bernstein.h>
#include <asperity/isogeometric/l2_projection.h>
#include <asperity/isogeometric/spline_space.h>

#include <deal.II/base/quadrature_lib.h>

namespace asperity
{
  namespace
  {
    template <int dim>
    using VectorFunction =
      std::function<std::vector<double>(const dealii::Point<dim> &)>;

    /** Adds factor * volume * sum_q w_q N_a(x_q) f(x_q) to the load of every
     *  function of a cell; points and weights are those of the unit cell. */
    template <int dim>
    void
    add_products(const SplineHierarchy<dim>            &hierarchy,
                 const unsigned int                     cell,
                 const std::vector<dealii::Point<dim>> &points,
                 const std::vector<double>             &weights,
                 const BernsteinTable<dim>             &bernstein,
                 const VectorFunction<dim>             &f,
                 const double                           factor,
                 std::vector<dealii::Vector<double>>   &loads)
    {
      const auto  &functions  = hierarchy.cell_functions(cell);
      const auto  &extraction = hierarchy.cell_extraction(cell);
      const auto   box        = hierarchy.cell_box(cell);
      const double volume     = measure(box);
      for (unsigned int q = 0; q < points.size(); ++q)
        {
          const std::vector<double> value = f(from_unit_cell(box, points[q]));
          for (unsigned int a = 0; a < functions.size(); ++a)
            {
              double N = 0.;
              for (unsigned int b = 0; b < extraction.n(); ++b)
                N += extraction(a, b) * bernstein.values[q][b];
              for (unsigned int c = 0; c < loads.size(); ++c)
                loads[c][functions[a]] +=
                  N * value[c] * factor * volume * weights[q];
            }
        }
    }
  } // namespace



  template <int dim>
  std::vector<std::vector<double>>
  SplineSpace<dim>::project(const VectorFunction<dim> &f,
                            const unsigned int         n_components,
                            const double               edge_weight) const
  {
    const auto                          space = hierarchy();
    std::vector<dealii::Vector<double>> loads(
      n_components, dealii::Vector<double>(n_functions()));

    const dealii::QGauss<dim> quadrature(degree() + 3);
    const BernsteinTable<dim> bernstein(degree(), quadrature.get_points());
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      add_products(*space,
                   cell,
                   quadrature.get_points(),
                   quadrature.get_weights(),
                   bernstein,
                   f,
                   1.,
                   loads);

    const dealii::QGauss<dim - 1> edge_quadrature(degree() + 3);
    if (edge_weight != 0.)
      for (const Edge edge : boundary_edges(*space))
        {
          const auto points = edge_points<dim>(edge_quadrature, edge);
          const BernsteinTable<dim> edge_bernstein(degree(), points);
          // The measure of the face times the cell's width normal to it: as
          // in L2Projection.
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

    const L2Projection<dim>          projection(*space, edge_weight);
    std::vector<std::vector<double>> coefficients;
    for (auto &load : loads)
      {
        projection.solve(load);
        coefficients.emplace_back(load.begin(), load.end());
      }
    return coefficients;
  }



  template std::vector<std::vector<double>>
  SplineSpace<2>::project(const VectorFunction<2> &,
                          const unsigned int,
                          const double) const;
  template std::vector<std::vector<double>>
  SplineSpace<3>::project(const VectorFunction<3> &,
                          const unsigned int,
                          const double) const;
} // namespace asperity
