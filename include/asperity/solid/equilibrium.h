#ifndef asperity_solid_equilibrium_h
#define asperity_solid_equilibrium_h

#include <asperity/isogeometric/force_term.h>
#include <asperity/solvers/linear_solver.h>
#include <asperity/solvers/low_rank_update.h>
#include <asperity/solvers/newton.h>
#include <asperity/solvers/unsymmetric_part.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/sparsity_pattern.h>

#include <memory>
#include <vector>

namespace asperity
{
  /** Seconds of wall time and counts, by phase, summed over a run. */
  struct EquilibriumCost
  {
    double       assembly       = 0.;
    double       factorisation  = 0.;
    double       solution       = 0.;
    unsigned int factorisations = 0;
  };

  /**
   * Force balance of a displacement field: the sum of force terms minus a dead
   * load, plus inertia on request, with some components prescribed.
   *
   * With inertia the residual is that of the generalized-alpha method,
   * factor M u + constant + static_weight (sum of terms - load).
   *
   * On several ranks each has terms of a part of the body, and the sum over the
   * terms is one over the ranks, too. Vectors are the same on all of them, the
   * matrix that a rank holds is its part of the tangent, and everything that
   * needs the balance is collective. There is no inertia then.
   */
  class Equilibrium : public NonlinearSystem
  {
  public:
    /**
     * @param n_dofs length of u
     * @param terms the contributions; they must outlive this object
     * @param constraints closed; each line prescribes a component of u, whose
     * values prescribe() takes; inhomogeneities are not read
     * @param shared the ranks that have the other parts of the terms, and what
     * a solver wants to know of the unknowns
     * @throws ComputationError if a line couples components
     */
    Equilibrium(const unsigned int                       n_dofs,
                const std::vector<ForceTerm *>          &terms,
                const dealii::AffineConstraints<double> &constraints,
                const LinearSolverKind solver = LinearSolverKind::umfpack,
                const SharedSystem    &shared = SharedSystem());

    bool
    residual(const dealii::Vector<double> &u,
             dealii::Vector<double>       &R) override;

    bool
    linearize(const dealii::Vector<double> &u,
              dealii::Vector<double>       &R) override;

    bool
    direction(const dealii::Vector<double> &R,
              dealii::Vector<double>       &d) override;

    /** Of an earlier u only where the sparse factor is all of the tangent. */
    std::string
    direction_failure() const override;

    bool
    has_tangent() const override;

    /** Names a degree of freedom whose diagonal entry is raised while the
     *  sparse matrix is factorised, and set right by a rank-one update: a body
     *  that nothing but rank-one terms hold can then be solved for, too. */
    void
    set_support(const unsigned int dof);

    /** Dead load [N/m or N], at the end of the step. */
    void
    set_load(const dealii::Vector<double> &load);

    /** See above; mass must outlive its use; nullptr: quasi-static. */
    void
    set_inertia(const dealii::SparseMatrix<double> *mass,
                const double                        factor,
                const dealii::Vector<double>       &constant,
                const double                        static_weight);

    /**
     * Moves u to the prescribed values by one linear step: the free components
     * follow as the tangent at u says.
     * @param target its prescribed components are used
     * @return false if no tangent exists at u
     */
    bool
    prescribe(dealii::Vector<double> &u, const dealii::Vector<double> &target);

    /** Replaces a force by the displacement that it causes under the tangent
     *  that direction() has factorised last, with its inertia and weights, but
     *  without what is not symmetric in it. */
    void
    back_substitute(dealii::Vector<double> &force) const;

    /** Sum of force terms without load, inertia and prescription: at the
     *  prescribed components these are the reactions. */
    bool
    forces(const dealii::Vector<double> &u, dealii::Vector<double> &R);

    /** A matrix with this object's sparsity pattern. */
    std::unique_ptr<dealii::SparseMatrix<double>>
    make_matrix() const;

    const dealii::SparseMatrix<double> &
    tangent() const;

    const EquilibriumCost &
    cost() const;

    /** Counts that of an earlier balance, too. */
    void
    add_cost(const EquilibriumCost &earlier);

  private:
    bool
    assemble(const dealii::Vector<double> &u,
             dealii::Vector<double>       &R,
             const bool                    with_tangent);

    /** Adds all terms of all ranks to R and those of this one to its part of
     *  the tangent, if there is any. @return false if there is no residual */
    bool
    add_terms(const dealii::Vector<double> &u,
              dealii::Vector<double>       &R,
              dealii::SparseMatrix<double> *tangent);

    /** Of the matrix. @return false if it is singular */
    bool
    factorize();

    void
    eliminate_prescribed();

    void
    collect_parts();

    /** Replaces b by the solution with the factorised tangent. */
    bool
    solve(dealii::Vector<double> &b);

    /** Where the unsymmetric part has no solution by the factor of the rest. */
    bool
    solve_with_fallback(dealii::Vector<double> &b);

    SharedSystem                      shared;
    std::vector<ForceTerm *>          terms;
    dealii::AffineConstraints<double> constraints;
    dealii::SparsityPattern           pattern;
    dealii::SparseMatrix<double>      matrix;
    /** Entries of the matrix beside its diagonal that a prescribed row or
     *  column has. */
    std::vector<dealii::SparseMatrix<double>::iterator> eliminated;
    std::unique_ptr<LinearSolver>                       solver;
    std::unique_ptr<LinearSolver>                       fallback;
    bool                                                solver_is_symmetric;
    UnsymmetricPart                                     unsymmetric;
    LowRankUpdate                                       dense_part;
    unsigned int                                        support;
    dealii::Vector<double>                              load;
    const dealii::SparseMatrix<double>                 *mass          = nullptr;
    double                                              mass_factor   = 0.;
    double                                              static_weight = 1.;
    dealii::Vector<double>                              inertia_constant;
    EquilibriumCost                                     cost_;

    bool matrix_is_new = false; ///< linearized and not factorised yet
    bool is_factorised = false; ///< an earlier matrix, at the least
  };
} // namespace asperity

#endif
