#ifndef asperity_flow_channel_meshes_h
#define asperity_flow_channel_meshes_h

#include <deal.II/grid/tria.h>

namespace asperity
{
  /** Boundary ids of the channel meshes. The flag's sides are ids of their own,
   *  so that its wall is the set {flag_bottom, flag_tip, flag_top}. */
  enum ChannelBoundary : dealii::types::boundary_id
  {
    channel_inlet    = 0,
    channel_outlet   = 1,
    channel_walls    = 2,
    channel_cylinder = 3,
    flag_bottom      = 4,
    flag_tip         = 5,
    flag_top         = 6
  };

  /**
   * The channel of M. Schaefer, S. Turek (1996): 2.2 m x 0.41 m, cylinder of
   * radius 0.05 m round (0.2, 0.2) m, inflow at x = 0; deal.II's mesh, whose
   * cells round the cylinder are bounded by arcs.
   * @param n_refinements uniform, of the coarse mesh
   * @param n_wall_layers further refinements of the cells that touch the
   *   cylinder, with hanging nodes
   */
  void
  make_channel_with_cylinder(dealii::Triangulation<2> &mesh,
                             const unsigned int        n_refinements,
                             const unsigned int        n_wall_layers = 0);

  /**
   * The channel of S. Turek, J. Hron (2006): 2.5 m long, and behind the
   * cylinder a flag, 0.02 m thick, with its tip at (0.6, 0.2) m, that is left
   * out of the mesh. Wall layers are those of cylinder and flag.
   * @param n_corner_layers further refinements of the cells that touch a corner
   *   of the flag, where the stress is singular
   */
  void
  make_channel_with_flag(dealii::Triangulation<2> &mesh,
                         const unsigned int        n_refinements,
                         const unsigned int        n_wall_layers   = 0,
                         const unsigned int        n_corner_layers = 0);
} // namespace asperity

#endif
