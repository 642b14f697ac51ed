#include <asperity/base/errors.h>
#include <asperity/time_integration/generalized_alpha.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using asperity::GeneralizedAlpha;

  /** a + omega^2 u = 0 with mass 1; the linear balance is solved directly. */
  class Oscillator
  {
  public:
    Oscillator(const double rho, const double omega)
      : method(rho)
      , stiffness(omega * omega)
    {
      method.u.reinit(1);
      method.v.reinit(1);
      method.a.reinit(1);
      method.u(0) = 1.;
      method.a(0) = -stiffness;
    }

    void
    step(const double dt)
    {
      const double           old_force = stiffness * method.u(0);
      const double           weight    = 1. - method.alpha_f();
      dealii::Vector<double> u(1);
      u(0) = -(method.constant(dt)(0) + method.alpha_f() * old_force) /
             (method.mass_factor(dt) + weight * stiffness);
      method.advance(u, dt);
    }

    double
    energy() const
    {
      return 0.5 * (method.v(0) * method.v(0) +
                    stiffness * method.u(0) * method.u(0));
    }

    GeneralizedAlpha method;

  private:
    double stiffness;
  };

  /** Error of displacement and velocity at t = 1 with n steps. */
  double
  oscillator_error(const double rho, const unsigned int n)
  {
    const double omega = 5.;
    Oscillator   oscillator(rho, omega);
    for (unsigned int i = 0; i < n; ++i)
      oscillator.step(1. / n);
    return std::hypot(oscillator.method.u(0) - std::cos(omega),
                      oscillator.method.v(0) / omega + std::sin(omega));
  }
} // namespace



TEST(GeneralizedAlpha, is_of_second_order_for_every_spectral_radius)
{
  for (const double rho : {0., 0.3, 0.5, 0.8, 1.})
    EXPECT_NEAR(std::log2(oscillator_error(rho, 400) /
                          oscillator_error(rho, 800)),
                2.,
                0.03)
      << "rho " << rho;
}



TEST(GeneralizedAlpha,
     conserves_the_energy_of_an_oscillator_for_unit_spectral_radius)
{
  Oscillator   oscillator(1., 5.);
  const double start = oscillator.energy();
  for (unsigned int i = 0; i < 10000; ++i)
    oscillator.step(0.1);
  EXPECT_NEAR(oscillator.energy() / start, 1., 1e-11);
}



TEST(GeneralizedAlpha, damps_stiff_modes_by_the_spectral_radius)
{
  // For omega dt -> infinity the amplitude falls by rho a step.
  for (const double rho : {0.2, 0.5, 0.8})
    {
      Oscillator oscillator(rho, 1e6);
      for (unsigned int i = 0; i < 20; ++i)
        oscillator.step(1.);
      const double before = std::sqrt(oscillator.energy());
      for (unsigned int i = 0; i < 20; ++i)
        oscillator.step(1.);
      // The double root brings a factor that is linear in the step number.
      const double rate =
        std::pow(std::sqrt(oscillator.energy()) / before, 1. / 20.);
      EXPECT_NEAR(rate / rho, 1., 0.1) << "rho " << rho;
    }
}



TEST(GeneralizedAlpha, follows_constant_acceleration_exactly)
{
  const double     g = -9.81, dt = 0.3;
  GeneralizedAlpha method(0.5);
  method.u.reinit(1);
  method.v.reinit(1);
  method.a.reinit(1);
  method.v(0) = 4.;
  method.a(0) = g;
  for (unsigned int i = 0; i < 10; ++i)
    {
      dealii::Vector<double> u(1);
      // mass_factor u + constant = g, which is M a = force
      u(0) = (g - method.constant(dt)(0)) / method.mass_factor(dt);
      EXPECT_NEAR(u(0), method.predict(dt)(0), 1e-12);
      method.advance(u, dt);
    }
  EXPECT_NEAR(method.u(0), 4. * 3. + 0.5 * g * 9., 1e-11);
  EXPECT_NEAR(method.v(0), 4. + g * 3., 1e-11);
}



TEST(GeneralizedAlpha, refuses_a_spectral_radius_outside_its_range)
{
  EXPECT_THROW(GeneralizedAlpha(-0.1), asperity::InputError);
  EXPECT_THROW(GeneralizedAlpha(1.1), asperity::InputError);
}
