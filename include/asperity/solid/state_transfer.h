#ifndef asperity_solid_state_transfer_h
#define asperity_solid_state_transfer_h

#include <asperity/constitutive/material_law.h>
#include <asperity/isogeometric/spline_hierarchy.h>

#include <deal.II/base/quadrature.h>

#include <vector>

namespace asperity
{
  /**
   * Takes the states of material points from one mesh to another by
   * transfer_history(): plastic strain and temperature stay within the bounds
   * that they had in each cell, with their integrals. Of C_p^{-1} it is the
   * logarithm in the plane that goes over, so that C_p remains positive
   * definite with det C_p = 1. Cells of both meshes keep their states bit by
   * bit.
   *
   * @param quadrature that of both meshes on the unit square
   * @param states of plane or axisymmetric kinematics, [cell * n_q + q]
   */
  std::vector<MaterialState>
  transfer_states(const SplineHierarchy<2>         &from,
                  const SplineHierarchy<2>         &to,
                  const dealii::Quadrature<2>      &quadrature,
                  const std::vector<MaterialState> &states);
} // namespace asperity

#endif
