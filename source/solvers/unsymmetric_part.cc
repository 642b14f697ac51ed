#include <asperity/solvers/finite.h>
#include <asperity/solvers/unsymmetric_part.h>

#include <cmath>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  namespace
  {
    /** Beyond it a factorisation is cheaper. */
    constexpr unsigned int maximum_iterations = 60;

    /** A direction that changes the residual by less, relative, is lost in
     *  round-off. */
    constexpr double singular = 1e-10;
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
    const double        goal = tolerance * b.l2_norm();
    Vector              x(b.size()), r(b);
    std::vector<Vector> p, q; // directions, and (K + U) p, orthonormal
    while (r.l2_norm() > goal && p.size() < maximum_iterations)
      {
        Vector p_new(r), q_new(b.size());
        K_inverse(p_new);
        vmult_add(q_new, p_new);
        ranks.sum(q_new.begin(), q_new.size());
        constraints.set_zero(q_new);
        q_new += r;
        for (std::size_t i = 0; i < q.size(); ++i)
          {
            const double c = q_new * q[i];
            q_new.add(-c, q[i]);
            p_new.add(-c, p[i]);
          }
        const double length = q_new.l2_norm();
        if (!(length > singular * r.l2_norm()) || !std::isfinite(length))
          return false;
        q.push_back(q_new /= length);
        p.push_back(p_new /= length);
        const double a = r * q.back();
        x.add(a, p.back());
        r.add(-a, q.back());
      }
    if (!is_finite(x) || !(r.l2_norm() <= goal))
      return false;
    b.swap(x);
    return true;
  }
} // namespace asperity
