#ifndef asperity_contact_shear_transfer_h
#define asperity_contact_shear_transfer_h

#include <asperity/contact/shear_traction.h>
#include <asperity/isogeometric/spline_hierarchy.h>

#include <vector>

namespace asperity
{
  /**
   * Takes the history of a shear from one mesh to another on the same level-0
   * knots. With the mortar, tractions and pressures are traces of splines,
   * which go over by TraceTransfer: they stay the same where the mesh is
   * refined, and their integrals everywhere; what then exceeds the strength of
   * the interface the next return map cuts. At Gauss points they go over by
   * transfer_edge_history(), within the range that they had. A pressure does
   * not become negative.
   *
   * @param points per element and direction of the edge
   * @param positions of the new points at the start of the step, seen from the
   *   obstacle [m]
   */
  template <int dim>
  typename ShearTraction<dim>::History
  transfer_shear(const SplineHierarchy<dim>                 &from,
                 const SplineHierarchy<dim>                 &to,
                 const Edge                                  edge,
                 const ContactFormulation                    formulation,
                 const unsigned int                          points,
                 const typename ShearTraction<dim>::History &history,
                 const std::vector<dealii::Point<dim>>      &positions);
} // namespace asperity

#endif
