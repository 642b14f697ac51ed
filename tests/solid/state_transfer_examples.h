#ifndef asperity_tests_solid_state_transfer_examples_h
#define asperity_tests_solid_state_transfer_examples_h

#include <asperity/constitutive/material_law.h>
#include <asperity/isogeometric/spline_space.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/base/symmetric_tensor.h>

#include <vector>

namespace asperity
{
  /** exp of a symmetric tensor of small size, by its series. */
  inline dealii::SymmetricTensor<2, 3>
  exponential(const dealii::SymmetricTensor<2, 3> &tensor)
  {
    using Gradient                     = dealii::Tensor<2, 3>;
    dealii::SymmetricTensor<2, 3> sum  = dealii::unit_symmetric_tensor<3>(),
                                  term = sum;
    for (unsigned int k = 1; k < 12; ++k)
      {
        term = symmetrize(Gradient(term) * Gradient(tensor)) / k;
        sum += term;
      }
    return sum;
  }

  /** Of the plastic strain, over a body whose parameters are its places. */
  template <int dim>
  double
  integral_of_strain(const SplineSpace<dim>           &space,
                     const dealii::Quadrature<dim>    &quadrature,
                     const std::vector<MaterialState> &states)
  {
    const auto table = tabulate_cells(space, {}, quadrature);
    double     sum   = 0.;
    for (std::size_t q = 0; q < states.size(); ++q)
      sum += table.JxW[q] * states[q].plastic_strain;
    return sum;
  }
} // namespace asperity

#endif
