#include <asperity/base/archive.h>
#include <asperity/coupling/quasi_newton.h>

#include <deal.II/lac/qr.h>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  namespace
  {
    /** The norm of what the columns of Q leave of v; twice, so that a small
     *  remainder is not one of round-off. */
    double
    orthogonal_norm(const dealii::QR<Vector> &qr, const Vector &v)
    {
      Vector w = v, projection(v.size());
      if (qr.size() == 0)
        return w.l2_norm();
      Vector coefficients(qr.size());
      for (unsigned int pass = 0; pass < 2; ++pass)
        {
          qr.multiply_with_QT(coefficients, w);
          qr.multiply_with_Q(projection, coefficients);
          w -= projection;
        }
      return w.l2_norm();
    }
  } // namespace



  QuasiNewton::QuasiNewton(const double       first_factor,
                           const unsigned int reused_steps,
                           const double       filter)
    : reused_steps(reused_steps)
    , filter(filter)
    , relaxation(first_factor)
  {}



  void
  QuasiNewton::start_step()
  {
    if (steps.empty() || !steps.front().empty())
      steps.emplace_front();
    if (steps.size() > reused_steps + 1)
      steps.pop_back();
    relaxation.start_step();
    old_residual.reinit(0);
  }



  Vector
  QuasiNewton::next(const Vector &x, const Vector &Hx)
  {
    Vector r = Hx;
    r -= x;
    if (r.norm_sqr() == 0.)
      return Hx;
    add_column(r, Hx);
    const Vector step = correction(r);
    // Aitken is asked in any case, so that it knows the last residual.
    Vector x_new = relaxation.next(x, Hx);
    if (step.size() > 0)
      {
        x_new = Hx;
        x_new += step;
      }
    return x_new;
  }



  void
  QuasiNewton::add_column(const Vector &r, const Vector &Hx)
  {
    if (old_residual.size() > 0)
      {
        Column column{r, Hx};
        column.residual -= old_residual;
        column.output -= old_output;
        steps.front().push_front(column);
      }
    old_residual = r;
    old_output   = Hx;
  }



  Vector
  QuasiNewton::correction(const Vector &r)
  {
    dealii::QR<Vector>  qr;
    std::vector<Vector> outputs;
    const auto          is_dependent = [&](const Column &column) {
      const double norm = column.residual.l2_norm();
      if (norm == 0. || qr.size() == r.size() ||
          orthogonal_norm(qr, column.residual) <= filter * norm)
        return true;
      qr.append_column(column.residual);
      outputs.push_back(column.output);
      return false;
    };
    for (Step &step : steps)
      {
        Step independent;
        for (const Column &column : step)
          if (!is_dependent(column))
            independent.push_back(column);
        step = independent;
      }
    if (outputs.empty())
      return {};
    Vector projected(qr.size()), c(qr.size());
    qr.multiply_with_QT(projected, r);
    projected *= -1.;
    qr.solve(c, projected);
    Vector step(r.size());
    for (unsigned int i = 0; i < outputs.size(); ++i)
      step.add(c(i), outputs[i]);
    return step;
  }



  void
  QuasiNewton::finish_step(const bool converged)
  {
    if (!converged)
      reset();
  }



  void
  QuasiNewton::reset()
  {
    steps.clear();
    steps.emplace_front();
    old_residual.reinit(0);
  }



  void
  QuasiNewton::save(OutputArchive &archive) const
  {
    // The last residual is no part of it: start_step() forgets it.
    archive << steps;
  }



  void
  QuasiNewton::load(InputArchive &archive, const std::size_t n_unknowns)
  {
    reset();
    archive >> steps;
    for (const Step &step : steps)
      for (const Column &column : step)
        for (const Vector *v : {&column.residual, &column.output})
          require_length("differences of the coupling", v->size(), n_unknowns);
  }



  unsigned int
  QuasiNewton::n_columns() const
  {
    unsigned int n = 0;
    for (const Step &step : steps)
      n += step.size();
    return n;
  }
} // namespace asperity
