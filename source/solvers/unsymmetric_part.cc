#include <asperity/solvers/finite.h>
#include <asperity/solvers/unsymmetric_part.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  namespace
  {
    /** Beyond it a factorisation is cheaper. */
    constexpr unsigned int maximum_iterations = 60;

    /** A product in the words of deal.II's solvers. */
    template <class Product>
    struct Operator
    {
      const Product &product;

      void
      vmult(Vector &y, const Vector &x) const
      {
        product(y, x);
      }
    };
  } // namespace



  UnsymmetricPart::UnsymmetricPart(const Ranks &ranks)
    : ranks(ranks)
  {}



  void
  UnsymmetricPart::clear()
  {
    entries.clear();
  }



  void
  UnsymmetricPart::add(const dealii::SparseMatrix<double> &matrix)
  {
    for (auto entry = matrix.begin(); entry != matrix.end(); ++entry)
      if (entry->value() != 0.)
        entries.push_back({static_cast<unsigned int>(entry->row()),
                           static_cast<unsigned int>(entry->column()),
                           entry->value()});
  }



  bool
  UnsymmetricPart::empty() const
  {
    return ranks.all(entries.empty());
  }



  void
  UnsymmetricPart::scale(const double factor)
  {
    for (Entry &entry : entries)
      entry.value *= factor;
  }



  void
  UnsymmetricPart::vmult_add(Vector &y, const Vector &x) const
  {
    for (const Entry &entry : entries)
      y(entry.row) += entry.value * x(entry.column);
  }



  void
  UnsymmetricPart::add_to(
    dealii::SparseMatrix<double>            &sum,
    const dealii::AffineConstraints<double> &constraints) const
  {
    for (const Entry &entry : entries)
      if (!constraints.is_constrained(entry.row) &&
          !constraints.is_constrained(entry.column))
        sum.add(entry.row, entry.column, entry.value);
  }



  bool
  UnsymmetricPart::solve(const Action                            &K_inverse,
                         const dealii::AffineConstraints<double> &constraints,
                         const double                             tolerance,
                         Vector                                  &b) const
  {
    Vector     x(b.size());
    const auto product = [&](Vector &y, const Vector &z) {
      x = z;
      K_inverse(x);
      y = 0.;
      vmult_add(y, x);
      ranks.sum(y.begin(), y.size());
      constraints.set_zero(y);
      y += z;
    };
    const double          goal = tolerance * b.l2_norm();
    dealii::SolverControl control(maximum_iterations, goal, false, false);
    Vector                z(b); // saves the product with a start of zero
    try
      {
        dealii::SolverGMRES<Vector>(control,
                                    dealii::SolverGMRES<Vector>::AdditionalData(
                                      maximum_iterations + 2))
          .solve(Operator<decltype(product)>{product},
                 z,
                 b,
                 dealii::PreconditionIdentity());
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        return false;
      }
    // Where the sum is singular GMRES believes in what it does not reach.
    if (!is_finite(z))
      return false;
    Vector residual(b.size());
    product(residual, z); // and x = K^-1 z
    residual -= b;
    if (!is_finite(residual) || residual.l2_norm() > 100. * goal)
      return false;
    b.swap(x);
    return true;
  }
} // namespace asperity
