#ifndef asperity_mesh_motion_elastic_mesh_update_h
#define asperity_mesh_motion_elastic_mesh_update_h

#include <asperity/solvers/linear_solver.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>

#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace asperity
{
  struct ElasticMeshOptions
  {
    /** chi: 0 for none, 1 is the same as to leave out the Jacobian, which
     *  keeps small cells from being distorted; larger ones keep them stiff. */
    double stiffening_exponent = 1.;

    double poisson_ratio = 0.3;

    /** Boundaries whose nodes have both components prescribed. */
    std::set<dealii::types::boundary_id> prescribed;

    /** Boundaries whose nodes have y prescribed, and find their x. */
    std::set<dealii::types::boundary_id> sliding_in_x;

    /** Pairs of sides that move alike, images by a translation along x. */
    std::vector<
      std::pair<dealii::types::boundary_id, dealii::types::boundary_id>>
      periodic;
  };



  /**
   * The elastic mesh update method: the mesh follows its boundaries like a
   * linear elastic body,
   *   int (J_0/J)^chi sigma(d) : grad(phi) dX = 0,
   * J the Jacobian determinant of the cells (T. Tezduyar, M. Behr, S. Mittal,
   * A. A. Johnson, ASME PVP 246 (1992) 7-24; with the exponent K. Stein,
   * T. Tezduyar, R. Benney, J. Appl. Mech. 70 (2003) 58-63).
   *
   * d is the total displacement from the reference configuration, not an
   * increment, so a cyclic motion of the boundaries returns to the same mesh,
   * and the path does not matter. The matrix never changes: each update costs
   * one back-substitution.
   *
   * With chi != 0 and cells of different size a linear boundary displacement
   * does not give a linear interior: large cells take more of the strain.
   *
   * Linear elasticity knows nothing of inversion: watch the mesh, MeshWatch.
   */
  class ElasticMeshUpdate
  {
  public:
    using Vector = dealii::Vector<double>;

    /**
     * @param dofs of an FESystem<2>(FE_Q<2>(k), 2), must outlive this object
     * @param reference shape of the cells without displacement
     * @throws InputError if no boundary is prescribed in both components, or if
     * a part of the mesh is not held
     */
    ElasticMeshUpdate(const dealii::DoFHandler<2> &dofs,
                      const dealii::Mapping<2>    &reference,
                      const ElasticMeshOptions    &options);

    /** @param boundary_displacement of all nodes [m], of which those with a
     *  prescribed displacement are read
     *  @return displacement of all nodes [m] */
    Vector
    update(const Vector &boundary_displacement) const;

  private:
    void
    make_constraints(const ElasticMeshOptions &options);

    void
    assemble(const dealii::Mapping<2> &reference,
             const ElasticMeshOptions &options);

    const dealii::DoFHandler<2>      &dof_handler;
    dealii::AffineConstraints<double> topology; ///< hanging nodes, periodicity
    dealii::AffineConstraints<double> prescribed; ///< by the boundaries
    dealii::SparsityPattern           sparsity;
    dealii::SparseMatrix<double>      matrix;
    std::unique_ptr<LinearSolver>     solver; ///< of the free displacements
  };
} // namespace asperity

#endif
