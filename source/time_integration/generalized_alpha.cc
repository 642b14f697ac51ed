#include <asperity/base/errors.h>
#include <asperity/time_integration/generalized_alpha.h>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  GeneralizedAlpha::GeneralizedAlpha(const double rho)
    : alpha_m_((2. * rho - 1.) / (rho + 1.))
    , alpha_f_(rho / (rho + 1.))
  {
    if (!(rho >= 0. && rho <= 1.))
      throw InputError("The spectral radius of generalized-alpha is " +
                       std::to_string(rho) + "; expected a value in [0, 1].");
    const double x = 1. - alpha_m_ + alpha_f_;
    beta           = 0.25 * x * x;
    gamma          = x - 0.5;
  }



  double
  GeneralizedAlpha::alpha_f() const
  {
    return alpha_f_;
  }



  double
  GeneralizedAlpha::mass_factor(const double dt) const
  {
    return (1. - alpha_m_) / (beta * dt * dt);
  }



  Vector
  GeneralizedAlpha::constant(const double dt) const
  {
    // a_{n+1} = (u_{n+1} - u - dt v) / (beta dt^2) - (1/(2 beta) - 1) a
    Vector       b = u;
    const double m = mass_factor(dt);
    b *= -m;
    b.add(-m * dt, v);
    b.add(alpha_m_ - (1. - alpha_m_) * (0.5 / beta - 1.), a);
    return b;
  }



  Vector
  GeneralizedAlpha::predict(const double dt) const
  {
    Vector u_new = u;
    u_new.add(dt, v, 0.5 * dt * dt, a);
    return u_new;
  }



  void
  GeneralizedAlpha::advance(const Vector &u_new, const double dt)
  {
    Vector a_new = u_new;
    a_new.add(-1., u, -dt, v);
    a_new.sadd(1. / (beta * dt * dt), -(0.5 / beta - 1.), a);
    v.add(dt * (1. - gamma), a, dt * gamma, a_new);
    a = a_new;
    u = u_new;
  }
} // namespace asperity
