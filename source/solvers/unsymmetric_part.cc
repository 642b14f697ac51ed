#include <asperity/solvers/finite.h>
#include <asperity/solvers/unsymmetric_part.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

namespace asperity
{
  namespace
  {
    /** Residual over the right-hand side: far below what Newton's method gains
     *  in a step. */
    constexpr double tolerance = 1e-8;

    /** Beyond it a factorisation is cheaper. */
    constexpr unsigned int maximum_iterations = 60;

    /** An action in the words of deal.II's solvers. */
    struct Operator
    {
      const UnsymmetricPart::Action &action;

      void
      vmult(dealii::Vector<double> &y, const dealii::Vector<double> &x) const
      {
        action(y, x);
      }
    };
  } // namespace



  void
  UnsymmetricPart::clear()
  {
    matrices.clear();
    factor = 1.;
  }



  void
  UnsymmetricPart::add(const dealii::SparseMatrix<double> &matrix)
  {
    matrices.push_back(&matrix);
  }



  bool
  UnsymmetricPart::empty() const
  {
    return matrices.empty();
  }



  void
  UnsymmetricPart::scale(const double new_factor)
  {
    factor *= new_factor;
  }



  void
  UnsymmetricPart::vmult_add(Vector &y, const Vector &x) const
  {
    Vector product(x.size());
    for (const auto *matrix : matrices)
      {
        matrix->vmult(product, x);
        y.add(factor, product);
      }
  }



  void
  UnsymmetricPart::add_to(
    dealii::SparseMatrix<double>            &sum,
    const dealii::AffineConstraints<double> &constraints) const
  {
    for (const auto *matrix : matrices)
      for (auto entry = matrix->begin(); entry != matrix->end(); ++entry)
        if (entry->value() != 0. && !constraints.is_constrained(entry->row()) &&
            !constraints.is_constrained(entry->column()))
          sum.add(entry->row(), entry->column(), factor * entry->value());
  }



  bool
  UnsymmetricPart::solve(const Action                            &K,
                         const Action                            &K_inverse,
                         const dealii::AffineConstraints<double> &constraints,
                         Vector                                  &b) const
  {
    const Action sum = [&](Vector &y, const Vector &x) {
      y = 0.;
      vmult_add(y, x);
      constraints.set_zero(y);
      Vector product(x.size());
      K(product, x);
      y += product;
    };
    dealii::SolverControl control(maximum_iterations,
                                  tolerance * b.l2_norm(),
                                  false,
                                  false);
    using GMRES = dealii::SolverGMRES<Vector>;
    GMRES  gmres(control, GMRES::AdditionalData(maximum_iterations + 2, true));
    Vector x(b.size());
    try
      {
        gmres.solve(Operator{sum}, x, b, Operator{K_inverse});
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        return false;
      }
    // Where the sum is singular GMRES believes in what it does not reach.
    if (!is_finite(x))
      return false;
    Vector residual(x.size());
    sum(residual, x);
    residual -= b;
    if (!is_finite(residual) ||
        residual.l2_norm() > 100. * tolerance * b.l2_norm())
      return false;
    b.swap(x);
    return true;
  }
} // namespace asperity
