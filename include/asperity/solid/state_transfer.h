#ifndef asperity_solid_state_transfer_h
#define asperity_solid_state_transfer_h

#include <asperity/constitutive/material_law.h>
#include <asperity/isogeometric/spline_hierarchy.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace asperity
{
  /**
   * Takes the states of material points from one mesh to another by
   * transfer_history(): plastic strain and temperature stay within the bounds
   * that they had in the body, with their integrals. Of the rest it is the
   * logarithmic elastic strain 1/2 ln b, b = F C_p^{-1} F^T, that goes over,
   * and with it the stress, so that what was in balance stays so; then
   * C_p^{-1} = F^{-1} b F^{-T} with the new F. A transfer of C_p itself would
   * leave stresses as large as Young's modulus times what two fits, of F and
   * of C_p, differ by. det C_p is off from one by as much as a coarser F is off
   * in its volume. Cells of both meshes keep their states bit by bit unless
   * their F has changed; where nothing has yielded C_p stays one.
   *
   * @param quadrature that of both meshes on the unit cell
   * @param states [cell * n_q + q], in two dimensions of plane or axisymmetric
   *   kinematics
   * @param F_before, F_after deformation gradients in the same order, in the
   *   old and in the new mesh
   */
  template <int dim>
  std::vector<MaterialState>
  transfer_states(const SplineHierarchy<dim>              &from,
                  const SplineHierarchy<dim>              &to,
                  const dealii::Quadrature<dim>           &quadrature,
                  const std::vector<MaterialState>        &states,
                  const std::vector<dealii::Tensor<2, 3>> &F_before,
                  const std::vector<dealii::Tensor<2, 3>> &F_after);
} // namespace asperity

#endif
