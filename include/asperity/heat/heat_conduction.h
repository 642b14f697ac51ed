#ifndef asperity_heat_heat_conduction_h
#define asperity_heat_heat_conduction_h

#include <asperity/heat/body_continuation.h>
#include <asperity/heat/conductance_integrals.h>
#include <asperity/heat/thermal_properties.h>
#include <asperity/isogeometric/cell_partition.h>
#include <asperity/solvers/linear_solver.h>
#include <asperity/solvers/matrix_entries.h>

#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace asperity
{
  class InputArchive;
  class OutputArchive;

  /**
   * Conduction of heat in a deforming body, in the reference frame:
   *
   *   rho0 c dT/dt = Div(K Grad T) + s,  K = lambda J F^{-1} F^{-T},
   *
   * with F = 1 + Grad u the deformation of the step, plane strain in two
   * dimensions, and a source s per reference volume; conduction is isotropic
   * in the current frame. T is a spline, the scheme backward Euler, of first
   * order in time. Without loads its edges are insulated. The functions sum to
   * one, so heat is conserved to round-off: what comes in is stored, or goes on
   * to continue_beyond().
   *
   * Vectors have an entry a function; temperatures are rises over the one that
   * the body starts from, so that a body at rest stays there to the last bit.
   *
   * On several ranks each integrates its own cells; begin_step(), add_source(),
   * accept() and load() are collective, and everything else is the same on
   * all of them: each has the whole matrix and its factor.
   */
  template <int dim>
  class HeatConduction
  {
  public:
    using Vector = dealii::Vector<double>;

    /**
     * @param cells of the body, which must outlive this object; its
     *   quadrature is also that of the source, and its points are those of
     *   the material; on several ranks with the functions of own cells
     * @param space whose functions these are
     * @param material its density is that of the reference
     * @param rows see ConductanceIntegrals
     */
    HeatConduction(const BasisTable<dim>   &cells,
                   const SplineSpace<dim>  &space,
                   const ThermalProperties &material,
                   const CellShare         &share = CellShare(),
                   const GradientRows      &rows  = {});

    /** Lets the body go on beyond an edge, see BodyContinuation. */
    void
    continue_beyond(const BasisTable<dim>   &edge,
                    const FourierBasis<dim> &waves);

    /**
     * Begins a step, or begins it anew.
     * @param u displacement, numbered by displacement_dof(), at the end of the
     *   step [m]; must not fold the body
     * @param dt length [s]
     * @throws ComputationError if the matrix cannot be factorised
     */
    void
    begin_step(const Vector &u, const double dt);

    /** power_a += int N_a s dV [W/m^(3 - dim)], with s per reference volume at
     *  the points of the cells [W/m^3]. */
    void
    add_source(const Vector &source, Vector &power) const;

    /** Replaces a power by function [W/m^(3 - dim)] by the rise at the end of
     *  the step that it causes alone [K]. */
    void
    respond(Vector &power) const;

    /** Rise over the step [K] under a power by function [W/m^(3 - dim)]. */
    Vector
    change(const Vector &power) const;

    /** The step ends with this change. */
    void
    accept(const Vector &change);

    /** Coefficients of the rise at the end of the last step [K]. */
    const Vector &
    rise() const;

    /** The rise at the points of the cells [K]. */
    const Vector &
    rise_at_points() const;

    /** Heat stored beyond that of the start [J/m^(3 - dim)]. */
    double
    stored() const;

    /** Heat that has gone on beyond the edge [J/m^(3 - dim)]; 0 without
     *  continuation. */
    double
    passed_on() const;

    void
    save(OutputArchive &archive) const;

    /** @param transfer takes the coefficients of a rise from the mesh on which
     *    it was saved to this one; empty if that is the same
     *  @throws InputError if the archive is of another body */
    void
    load(InputArchive &archive,
         const std::function<std::vector<double>(const std::vector<double> &)>
           &transfer = {});

  private:
    void
    evaluate_points();

    void
    make_pattern();

    /** Adds the entries of the functions of each element.
     *  @param block element -> its entries, rows of integrals.stride() */
    template <class Block>
    void
    add_blocks(const Block &block, dealii::SparseMatrix<double> &sum);

    void
    assemble_capacity();

    void
    assemble_conductance(const Vector &u);

    const BasisTable<dim>               &cells;
    const SplineSpace<dim>              &space;
    CellShare                            share;
    ConductanceIntegrals<dim>            integrals;
    ThermalProperties                    material;
    std::optional<BodyContinuation<dim>> continuation;

    dealii::SparsityPattern       pattern;
    dealii::SparseMatrix<double>  capacity;    ///< int rho0 c N_a N_b dV
    dealii::SparseMatrix<double>  conductance; ///< int Grad N_a K Grad N_b dV
    dealii::SparseMatrix<double>  matrix;
    MatrixEntries                 entries; ///< of capacity and conductance
    std::unique_ptr<LinearSolver> solver;

    Vector rise_;
    Vector rise_at_points_;
    Vector heat_content; ///< int rho0 c N_a dV [J/(m^(3 - dim) K)]
  };
} // namespace asperity

#endif
