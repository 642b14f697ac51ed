#include <asperity/solvers/low_rank_update.h>

#include <cmath>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  void
  LowRankUpdate::clear()
  {
    vectors.clear();
    solved.clear();
    factors.clear();
  }



  void
  LowRankUpdate::add(const Vector &v, const double d)
  {
    if (d == 0. || v.all_zero())
      return;
    vectors.push_back(v);
    factors.push_back(d);
  }



  bool
  LowRankUpdate::factorize(const LinearSolver &solver)
  {
    const unsigned int n = vectors.size();
    if (n == 0)
      return true;
    solved = vectors;
    capacitance.reinit(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        solver.solve(solved[i]);
        for (unsigned int j = 0; j < n; ++j)
          capacitance(j, i) = vectors[j] * solved[i];
        capacitance(i, i) += 1. / factors[i];
      }
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        if (!std::isfinite(capacitance(i, j)))
          return false;
    try
      {
        capacitance.compute_lu_factorization();
      }
    catch (const dealii::LACExceptions::ExcSingular &)
      {
        return false;
      }
    return true;
  }



  void
  LowRankUpdate::correct(Vector &x) const
  {
    if (vectors.empty())
      return;
    Vector l(vectors.size());
    for (unsigned int i = 0; i < l.size(); ++i)
      l(i) = vectors[i] * x;
    capacitance.solve(l);
    for (unsigned int i = 0; i < l.size(); ++i)
      x.add(-l(i), solved[i]);
  }



  void
  LowRankUpdate::vmult_add(Vector &y, const Vector &x) const
  {
    for (unsigned int i = 0; i < vectors.size(); ++i)
      y.add(factors[i] * (vectors[i] * x), vectors[i]);
  }



  void
  LowRankUpdate::drop_rows(const dealii::AffineConstraints<double> &constraints)
  {
    for (Vector &v : vectors)
      constraints.set_zero(v);
  }



  void
  LowRankUpdate::scale(const double factor)
  {
    for (double &d : factors)
      d *= factor;
  }



  bool
  LowRankUpdate::empty() const
  {
    return vectors.empty();
  }
} // namespace asperity
