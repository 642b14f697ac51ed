#include <asperity/base/errors.h>
#include <asperity/coupling/acceleration.h>
#include <asperity/coupling/quasi_newton.h>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  void
  Acceleration::finish_step(const bool converged)
  {
    if (!converged)
      reset();
  }



  void
  Acceleration::reset()
  {}



  void
  Acceleration::save(OutputArchive &) const
  {}



  void
  Acceleration::load(InputArchive &, const std::size_t)
  {}



  ConstantRelaxation::ConstantRelaxation(const double factor)
    : factor(factor)
  {}



  void
  ConstantRelaxation::start_step()
  {}



  Vector
  ConstantRelaxation::next(const Vector &x, const Vector &Hx)
  {
    Vector x_new = x;
    x_new.sadd(1. - factor, factor, Hx);
    return x_new;
  }



  AitkenRelaxation::AitkenRelaxation(const double first_factor)
    : first_factor(first_factor)
    , factor(first_factor)
  {}



  void
  AitkenRelaxation::start_step()
  {
    factor = first_factor;
    old_residual.reinit(0);
  }



  Vector
  AitkenRelaxation::next(const Vector &x, const Vector &Hx)
  {
    Vector r = Hx;
    r -= x;
    if (r.norm_sqr() == 0.)
      return Hx;
    if (old_residual.size() > 0)
      {
        Vector change = r;
        change -= old_residual;
        // A factor of zero would stop the iteration where it is.
        const double product = old_residual * change;
        if (change.norm_sqr() > 0. && product != 0.)
          factor *= -product / change.norm_sqr();
      }
    old_residual = r;
    Vector x_new = x;
    x_new.add(factor, r);
    return x_new;
  }



  std::unique_ptr<Acceleration>
  make_acceleration(const AccelerationParameters &parameters)
  {
    if (!(parameters.relaxation > 0. && parameters.relaxation <= 2.))
      throw InputError("The relaxation factor of the coupling is " +
                       std::to_string(parameters.relaxation) +
                       "; expected a value in (0, 2].");
    switch (parameters.kind)
      {
        case AccelerationKind::relaxation:
          return std::make_unique<ConstantRelaxation>(parameters.relaxation);
        case AccelerationKind::aitken:
          return std::make_unique<AitkenRelaxation>(parameters.relaxation);
        default:
          return std::make_unique<QuasiNewton>(parameters.relaxation,
                                               parameters.reused_steps,
                                               parameters.filter);
      }
  }
} // namespace asperity
