#ifndef asperity_isogeometric_force_term_h
#define asperity_isogeometric_force_term_h

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace asperity
{
  /** Index of a displacement component of a function among the unknowns of a
   *  spline space: components are interleaved. */
  template <int dim>
  constexpr unsigned int
  displacement_dof(const unsigned int function, const unsigned int component)
  {
    return dim * function + component;
  }



  /** The dense part factor * vector vector^T of a tangent. */
  struct RankOneTerm
  {
    dealii::Vector<double> vector;
    double                 factor = 0.;
  };

  /**
   * One contribution to the residual of a displacement field u on a spline
   * space. Component c of function a has index displacement_dof(a, c), and u
   * counts from the reference configuration [m]. The residual is internal minus
   * external force [N/m in plane strain, N in axisymmetry and in three
   * dimensions]. Solids, contact and
   * loads are all of this kind, so none needs to know the others.
   */
  class ForceTerm
  {
  public:
    virtual ~ForceTerm() = default;

    /** Adds the couplings between unknowns that the tangent has. */
    virtual void
    add_couplings(dealii::DynamicSparsityPattern &pattern) const = 0;

    /**
     * Adds the residual and, unless null, its derivative.
     * @return false if there is no residual at u (an inverted element): the
     *   vectors are then of no use.
     */
    virtual bool
    add(const dealii::Vector<double> &u,
        dealii::Vector<double>       &residual,
        dealii::SparseMatrix<double> *tangent) = 0;

    /** What the tangent of the last add() holds beyond the sparse matrix and is
     *  not symmetric, so that the matrix may be; within the couplings of the
     *  term. Nullptr: nothing. */
    virtual const dealii::SparseMatrix<double> *
    unsymmetric_tangent() const
    {
      return nullptr;
    }

    /** What the tangent of the last add() holds beyond the sparse matrices,
     *  e.g. the stiffness of a volume, which couples a whole edge. */
    virtual std::vector<RankOneTerm>
    rank_one_terms() const
    {
      return {};
    }
  };
} // namespace asperity

#endif
