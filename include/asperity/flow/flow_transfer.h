#ifndef asperity_flow_flow_transfer_h
#define asperity_flow_flow_transfer_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/vector.h>

namespace asperity
{
  /**
   * Interpolates a nodal field from one mesh and degree to another, in the
   * reference configuration: the value at a node is that at the same material
   * point. Exact if the new space contains the old one. Hanging nodes have
   * values of their own, too.
   *
   * The discrete divergence of an interpolated flow does not vanish, so the
   * pressure of the next step is wrong.
   * @param u by `from`
   * @param to its mesh is refined from the same coarse mesh as that of `from`
   * @throws InputError if the coarse meshes have different numbers of cells
   */
  dealii::Vector<double>
  interpolate_to_mesh(const dealii::DoFHandler<2>  &from,
                      const dealii::Vector<double> &u,
                      const dealii::DoFHandler<2>  &to);
} // namespace asperity

#endif
