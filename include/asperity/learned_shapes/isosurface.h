#ifndef asperity_learned_shapes_isosurface_h
#define asperity_learned_shapes_isosurface_h

#include <asperity/learned_shapes/boundary_mesh.h>

#include <functional>
#include <vector>

namespace asperity
{
  /** Values of a function at many points, whose coordinates are given point
   *  after point. */
  using BatchFunction =
    std::function<std::vector<double>(const std::vector<double> &)>;

  /**
   * The surface on which a function, negative inside, is zero: by marching
   * cubes (Lorensen and Cline 1987; deal.II's) in n^dim cells of a cube around
   * zero, in each of which it is taken for bilinear. Vertices of neighbouring
   * cells become one, and simplices turn outwards.
   * Cells are cut into parts, up to four a direction, if the surface is not
   * closed otherwise.
   * @param half_box half of the cube's edge
   * @throws InputError if the function has no zero there
   */
  template <int dim>
  BoundaryMesh<dim>
  isosurface(const BatchFunction &function,
             const double         half_box,
             const unsigned int   n);
} // namespace asperity

#endif
