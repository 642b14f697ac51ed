#ifndef asperity_solvers_unsymmetric_part_h
#define asperity_solvers_unsymmetric_part_h

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <functional>
#include <vector>

namespace asperity
{
  /**
   * Solves (K + U) x = b where K is symmetric and has a factorisation, and U is
   * neither: by GMRES, preconditioned by K from the right. It pays where U
   * couples few unknowns, as the shear of a contact, since a Cholesky
   * factorisation costs a third of one without symmetry.
   */
  class UnsymmetricPart
  {
  public:
    using Vector = dealii::Vector<double>;

    /** Forgets all matrices. */
    void
    clear();

    /** Adds a matrix, which must outlive its use. */
    void
    add(const dealii::SparseMatrix<double> &matrix);

    bool
    empty() const;

    /** Multiplies all matrices. */
    void
    scale(const double factor);

    /** y += U x */
    void
    vmult_add(Vector &y, const Vector &x) const;

    /** Adds U to a matrix whose pattern has its entries, but for those in
     *  constrained rows and columns. */
    void
    add_to(dealii::SparseMatrix<double>            &matrix,
           const dealii::AffineConstraints<double> &constraints) const;

    /** How a matrix without U acts: destination, source. */
    using Action = std::function<void(Vector &, const Vector &)>;

    /**
     * @param K, K_inverse the matrix and its factorisation
     * @param b right-hand side, zero at constrained components; becomes the
     *   solution
     * @return false if the iteration did not converge; b is then as it was
     */
    bool
    solve(const Action                            &K,
          const Action                            &K_inverse,
          const dealii::AffineConstraints<double> &constraints,
          Vector                                  &b) const;

  private:
    std::vector<const dealii::SparseMatrix<double> *> matrices;

    double factor = 1.;
  };
} // namespace asperity

#endif
