#ifndef asperity_mesh_motion_mesh_quality_h
#define asperity_mesh_motion_mesh_quality_h

#include <asperity/base/convergence_report.h>

#include <deal.II/base/point.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace asperity
{
  struct MeshQuality
  {
    /** det J over the product of the lengths of its columns, the sine of the
     *  angle between the lines of a cell: 1 for rectangles, 0 where a cell
     *  degenerates, negative where it is inverted. */
    double smallest_scaled_jacobian = 1.;

    /** Longer over shorter column of J. */
    double largest_aspect_ratio = 1.;

    /** Where the scaled Jacobian is smallest [m]. */
    unsigned int     worst_cell = 0; ///< active_cell_index()
    dealii::Point<2> worst_place;
  };



  /**
   * Watches the cells of a moving mesh, so that the caller can cut the step
   * before one is inverted. J is evaluated at the nodes and at the Gauss points
   * of the cells.
   */
  class MeshWatch
  {
  public:
    using Vector = dealii::Vector<double>;

    /**
     * @param dofs of an FESystem<2>(FE_Q<2>(k), 2): displacement of the mesh
     * @param reference shape of the cells without displacement
     * @param smallest_allowed scaled Jacobian that check() accepts
     */
    MeshWatch(const dealii::DoFHandler<2> &dofs,
              const dealii::Mapping<2>    &reference,
              const double                 smallest_allowed = 0.02);

    MeshQuality
    quality(const Vector &displacement) const;

    /** `residual` is the smallest scaled Jacobian. */
    ConvergenceReport
    check(const Vector &displacement) const;

  private:
    const dealii::DoFHandler<2> &dof_handler;
    const double                 smallest_allowed;

    /** Reference positions by dof: x for dofs of component 0, else y. */
    Vector reference_positions;

    /** Gradients [point][node] and values of the scalar element. */
    std::vector<std::vector<dealii::Tensor<1, 2>>> gradients;
    std::vector<std::vector<double>>               values;

    /** Local dofs of a node, x and y. */
    std::vector<std::array<unsigned int, 2>> node_dofs;
  };
} // namespace asperity

#endif
