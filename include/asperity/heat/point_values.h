#ifndef asperity_heat_point_values_h
#define asperity_heat_point_values_h

#include <asperity/isogeometric/basis_table.h>

#include <deal.II/lac/vector.h>

namespace asperity
{
  /** Values of a scalar spline at the points of a table.
   *  @param coefficients by function */
  template <int dim>
  dealii::Vector<double>
  values_at_points(const BasisTable<dim>        &table,
                   const dealii::Vector<double> &coefficients);

  /** The transposed: result_a += sum_q N_a(q) value_q. With heat by point
   *  [W/m^(3 - dim)] it adds the power by function. */
  template <int dim>
  void
  add_point_values(const BasisTable<dim>        &table,
                   const dealii::Vector<double> &values,
                   dealii::Vector<double>       &result);
} // namespace asperity

#endif
