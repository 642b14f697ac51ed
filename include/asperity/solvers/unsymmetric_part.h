#ifndef asperity_solvers_unsymmetric_part_h
#define asperity_solvers_unsymmetric_part_h

#include <asperity/base/ranks.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <functional>
#include <vector>

namespace asperity
{
  /**
   * Solves (K + U) x = b where K is symmetric and has a factorisation, and U is
   * neither: by generalised conjugate residuals (Eisenstat, Elman and Schultz
   * 1983), preconditioned by K. They end where GMRES does, and K itself is
   * never applied: a direction is p = K^-1 r, and (K + U) p = r + U p. Since
   * directions are kept, there is one action of K^-1 for each, where GMRES,
   * which combines the r, takes two more for its solution and its true
   * residual; mostly two or three are enough. It pays where U couples few
   * unknowns, as the shear of a contact, since a Cholesky factorisation costs a
   * third of one without symmetry.
   *
   * On several ranks U is the sum of what each of them has added, vectors are
   * the same on all, and what needs all of U is collective.
   */
  class UnsymmetricPart
  {
  public:
    using Vector = dealii::Vector<double>;

    explicit UnsymmetricPart(const Ranks &ranks = Ranks());

    /** Forgets all matrices. */
    void
    clear();

    /** Adds the entries that a matrix has now. */
    void
    add(const dealii::SparseMatrix<double> &matrix);

    /** Collective. */
    bool
    empty() const;

    /** Multiplies all entries. */
    void
    scale(const double factor);

    /** y += U x with what this process has added. */
    void
    vmult_add(Vector &y, const Vector &x) const;

    /** Adds what this process has added to a matrix whose pattern has its
     * entries, but for those in constrained rows and columns. */
    void
    add_to(dealii::SparseMatrix<double>            &matrix,
           const dealii::AffineConstraints<double> &constraints) const;

    /** How K^-1 acts: replaces a vector. */
    using Action = std::function<void(Vector &)>;

    /**
     * Collective.
     * @param K_inverse by the factorisation of K
     * @param b right-hand side, zero at constrained components; becomes the
     *   solution
     * @param tolerance of the residual, over the norm of b
     * @return false if the iteration did not converge, or broke down; b is then
     *   as it was
     */
    bool
    solve(const Action                            &K_inverse,
          const dealii::AffineConstraints<double> &constraints,
          const double                             tolerance,
          Vector                                  &b) const;

  private:
    struct Entry
    {
      unsigned int row, column;
      double       value;
    };

    Ranks              ranks;
    std::vector<Entry> entries; ///< those that are not zero
  };
} // namespace asperity

#endif
