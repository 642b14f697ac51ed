#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/heat/periodic_half_space.h>

#include <boost/math/quadrature/tanh_sinh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Against the formulas of Carslaw and Jaeger (1959), Conduction of Heat in
// Solids, and the moving band of Jaeger (1942).

namespace
{
  using namespace asperity;
  using Vector = dealii::Vector<double>;

  const ThermalProperties carbide{88., 15250., 292.};

  FourierBasis<2>
  along_x(const double period, const unsigned int n_waves)
  {
    return FourierBasis<2>({{period}}, {{n_waves}});
  }

  /** Rise at the end of a step with this flux. */
  template <int dim>
  Vector
  rise(const PeriodicHalfSpace<dim> &body, const Vector &flux, const double dt)
  {
    Vector result = body.remembered(dt);
    Vector now    = body.response(dt);
    now.scale(flux);
    result += now;
    return result;
  }
} // namespace



TEST(PeriodicHalfSpace, warms_as_the_square_root_of_time_under_a_constant_flux)
{
  PeriodicHalfSpace<2> body(carbide, along_x(10e-6, 0));
  Vector               flux(1);
  flux(0)     = 3e9;
  double time = 0.;
  // Steps of very unlike lengths, as halvings make them.
  for (unsigned int i = 0; i < 400; ++i)
    {
      const double dt = 1e-9 * std::pow(10., 2. * std::sin(i));
      time += dt;
      const double exact =
        2. * flux(0) * std::sqrt(time / (M_PI * 88. * 15250. * 292.));
      EXPECT_NEAR(rise(body, flux, dt)(0), exact, 2e-9 * exact) << i;
      body.accept(flux, dt);
      EXPECT_NEAR(body.heat(), 3e9 * time * 10e-6, 1e-12 * body.heat());
    }
}



TEST(PeriodicHalfSpace, tends_to_the_steady_temperature_of_each_wave)
{
  const double         L = 10e-6;
  PeriodicHalfSpace<2> body(carbide, along_x(L, 8));
  const double         a = carbide.diffusivity();
  Vector               flux(17);
  flux        = 2e9;
  double time = 0.;
  for (unsigned int i = 0; i < 60; ++i)
    {
      const double dt    = 1e-12 * std::pow(1.5, i);
      const Vector theta = rise(body, flux, dt);
      time += dt;
      for (unsigned int m = 1; m < 17; ++m)
        {
          const double kappa  = 2. * M_PI * ((m + 1) / 2) / L;
          const double steady = 2e9 / (88. * kappa);
          EXPECT_NEAR(theta(m),
                      steady * std::erf(kappa * std::sqrt(a * time)),
                      3e-9 * steady);
        }
      body.accept(flux, dt);
    }
  EXPECT_GT(a * std::pow(2. * M_PI / L, 2) * time, 100.);
}



TEST(PeriodicHalfSpace, sums_the_steps_of_a_changing_flux)
{
  // Each step of the flux adds q (S(age at its start) - S(age at its end)).
  const double         L = 1., times[] = {1e-6, 1e-2, 1e-9, 3e-3, 1e-4, 0.5};
  const double         fluxes[] = {5., -2., 7., 0., 1., 0.3};
  PeriodicHalfSpace<2> body({2., 3., 5.}, along_x(L, 2));
  std::vector<double>  ends = {0.};
  for (unsigned int i = 0; i < 6; ++i)
    {
      ends.push_back(ends.back() + times[i]);
      Vector flux(5);
      flux               = fluxes[i];
      const Vector theta = rise(body, flux, times[i]);
      for (unsigned int m = 0; m < 5; ++m)
        {
          const auto S = [m](const double t) {
            const double kappa = 2. * M_PI * ((m + 1) / 2);
            return m == 0 ?
                     2. * std::sqrt(t / (M_PI * 30.)) :
                     std::erf(kappa * std::sqrt(2. / 15. * t)) / (2. * kappa);
          };
          double exact = 0.;
          for (unsigned int j = 0; j <= i; ++j)
            exact += fluxes[j] *
                     (S(ends.back() - ends[j]) - S(ends.back() - ends[j + 1]));
          EXPECT_NEAR(theta(m), exact, 1e-9 * (1. + std::abs(exact)));
        }
      body.accept(flux, times[i]);
    }
}



namespace
{
  /**
   * Steady rise at the surface behind (x < 0) and under a band -b < x < b of
   * unit flux that moves in +x with speed v over a half-space of unit
   * conductivity: 1/pi int exp(-v (x - s)/(2 a)) K0(v |x - s|/(2 a)) ds
   * (J. C. Jaeger, J. Proc. R. Soc. N.S.W. 76 (1942) 203-224), with b = v = 1
   * and the Peclet number v b/(2 a).
   */
  double
  moving_band(const double x, const double peclet)
  {
    boost::math::quadrature::tanh_sinh<double> quadrature;
    // By the distance r from the singularity, on either side.
    const auto part = [&](const double sign, double from, double to) {
      from = std::max(from, 0.);
      if (to <= from)
        return 0.;
      return quadrature.integrate(
        [&](const double r) {
          const double z = peclet * r;
          return z > 300. && sign > 0. ? 0. :
                 z > 300. ? std::sqrt(M_PI / (2. * z)) * (1. - 1. / (8. * z)) :
                            std::exp(-sign * z) * std::cyl_bessel_k(0., z);
        },
        from,
        to);
    };
    // Heat at s = x - r lies behind x, that at s = x + r before it.
    return (part(1., x - 1., x + 1.) + part(-1., -1. - x, 1. - x)) / M_PI;
  }

  /** Lengths of steps in order of time, which get longer with the age of the
   *  heat, as it spreads. */
  std::vector<double>
  steps_towards_the_end(const double duration, const double diffusivity)
  {
    std::vector<double> steps;
    double              age = 0.;
    while (age < duration)
      {
        steps.push_back(
          0.002 + 0.1 * std::min(1. + 0.1 * age, std::sqrt(diffusivity * age)));
        age += steps.back();
      }
    std::reverse(steps.begin(), steps.end());
    return steps;
  }

  /** Largest error at some places of the band and behind it, over the largest
   *  rise, after the band has moved by `way` (all in half widths of it). */
  double
  error_of_moving_band(const double       peclet,
                       const double       way,
                       const double       period,
                       const unsigned int n_waves)
  {
    const double         a = 1. / (2. * peclet);
    PeriodicHalfSpace<2> body({1., 1., 1. / a}, along_x(period, n_waves));
    std::vector<double>  steps  = steps_towards_the_end(way, a);
    double               centre = 0.;
    Vector               theta;
    for (const double dt : steps)
      {
        // During a step the band stands where it is in the middle of it.
        centre += 0.5 * dt;
        Vector flux(body.basis().size());
        flux(0) = 2. / period;
        for (unsigned int m = 1; m < flux.size(); ++m)
          {
            const double kappa = body.basis().wave_number(m);
            flux(m)            = 4. * std::sin(kappa) / (kappa * period) *
                      (m % 2 == 1 ? std::cos(kappa * centre) :
                                    std::sin(kappa * centre));
          }
        centre += 0.5 * dt;
        theta = rise(body, flux, dt);
        body.accept(flux, dt);
      }
    double largest = 0., error = 0.;
    for (const double x : {-3., -1.5, -0.95, -0.6, 0., 0.5, 0.9})
      {
        const FourierValues<2> f(body.basis(), {dealii::Point<1>(centre + x)});
        const double           value = f.at_points(theta)(0);
        const double           exact = moving_band(x, peclet);
        largest                      = std::max(largest, exact);
        error                        = std::max(error, std::abs(value - exact));
      }
    return error / largest;
  }
} // namespace



TEST(PeriodicHalfSpace, warms_under_a_moving_band_as_jaeger_has_it)
{
  // The reference itself at its limit of a fast band, under whose end the rise
  // is that of the dwell time 2 b/v, 2 sqrt(2 b/(v pi)) over the effusivity.
  const double fast = 2. * std::sqrt(1. / (1e6 * M_PI));
  EXPECT_NEAR(moving_band(-1., 1e6), fast, 1e-3 * fast);
  EXPECT_LT(error_of_moving_band(0.1, 250., 500., 1000), 0.01);
  EXPECT_LT(error_of_moving_band(1., 30., 60., 500), 0.01);
  EXPECT_LT(error_of_moving_band(10., 8., 20., 400), 0.01);
  EXPECT_LT(error_of_moving_band(100., 6., 16., 800), 0.01);
}



// A flux q cos(kappa_x x) cos(kappa_y y) that is switched on and off again:
// q (S(t) - S(t - t_off)) with kappa^2 = kappa_x^2 + kappa_y^2.
TEST(PeriodicHalfSpace, warms_under_a_wave_along_two_directions)
{
  const double         L = 10e-6, W = 4e-6, q = 2e9;
  PeriodicHalfSpace<3> body(carbide, FourierBasis<3>({{L, W}}, {{3, 2}}));
  EXPECT_EQ(body.basis().size(), 35u);
  const auto wave = [&](const dealii::Point<2> &at) {
    return std::cos(6. * M_PI * at[0] / L) * std::cos(2. * M_PI * at[1] / W);
  };
  // The rectangle rule is exact for these waves.
  std::vector<dealii::Point<2>> places;
  for (unsigned int j = 0; j < 8; ++j)
    for (unsigned int i = 0; i < 8; ++i)
      places.emplace_back(L * i / 8., W * j / 8.);
  const FourierValues<3> f(body.basis(), places);
  Vector                 heat(places.size());
  for (unsigned int p = 0; p < heat.size(); ++p)
    heat(p) = q * wave(places[p]) * L * W / heat.size();
  Vector flux = f.sums(heat);
  for (unsigned int m = 0; m < flux.size(); ++m)
    flux(m) *= body.basis().norm(m);

  const double a     = carbide.diffusivity(),
               kappa = 2. * M_PI * std::hypot(3. / L, 1. / W);
  const auto S       = [&](const double t) {
    return std::erf(kappa * std::sqrt(a * std::max(t, 0.))) /
           (carbide.conductivity * kappa);
  };
  double time = 0., off = 0.;
  for (unsigned int i = 0; i < 40; ++i)
    {
      const double dt = 1e-12 * std::pow(1.5, i % 20);
      if (i == 20)
        {
          off  = time;
          flux = 0.;
        }
      const Vector now = f.at_points(rise(body, flux, dt));
      time += dt;
      const double exact = q * (S(time) - (i < 20 ? 0. : S(time - off)));
      for (unsigned int p = 0; p < now.size(); ++p)
        EXPECT_NEAR(now(p), exact * wave(places[p]), 1e-8 * q * S(time));
      body.accept(flux, dt);
      EXPECT_NEAR(body.heat(), 0., 1e-12 * q * time * L * W);
    }
}



// A spot of the tool, |x| < b and |y| < b, heated from t = 0 on has in its
// middle q/(rho c) int erf(b/(2 sqrt(a tau)))^2/sqrt(pi a tau) dtau (Carslaw
// and Jaeger 1959, section 10.5); that of the neighbours is too far.
TEST(PeriodicHalfSpace, warms_in_the_middle_of_a_square_spot)
{
  const double         b = 1e-6, L = 8. * b, q = 3e9;
  PeriodicHalfSpace<3> body(carbide, FourierBasis<3>({{L, L}}, {{64, 64}}));
  // The waves of the spot along each axis: int f_i dx over it.
  const auto integral = [&](const unsigned int i) {
    const double kappa = 2. * M_PI * ((i + 1) / 2) / L;
    return i == 0 ? 2. * b : i % 2 == 1 ? 2. * std::sin(kappa * b) / kappa : 0.;
  };
  Vector flux(body.basis().size());
  for (unsigned int m = 0; m < flux.size(); ++m)
    flux(m) = q * body.basis().norm(m) * integral(m % 129) * integral(m / 129);
  const FourierValues<3> middle(body.basis(), {dealii::Point<2>(0., L)});
  const double           a = carbide.diffusivity(), end = 0.5 * b * b / a;
  double                 time = 0.;
  for (unsigned int i = 0; i < 5; ++i)
    {
      const double dt  = end * (0.04 + 0.08 * i);
      const double now = middle.at_points(rise(body, flux, dt))(0);
      body.accept(flux, dt);
      time += dt;
      boost::math::quadrature::tanh_sinh<double> quadrature;
      const double                               exact =
        2. * q / std::sqrt(M_PI) * std::sqrt(a) / carbide.conductivity *
        quadrature.integrate(
          [&](const double s) { // tau = s^2
            return s == 0. ? 1. :
                             std::pow(std::erf(b / (2. * s * std::sqrt(a))), 2);
          },
          0.,
          std::sqrt(time));
      EXPECT_NEAR(now, exact, 5e-3 * exact) << i; // of the waves left out
    }
}



TEST(PeriodicHalfSpace, goes_on_from_an_archive_bit_for_bit)
{
  PeriodicHalfSpace<2> body(carbide, along_x(10e-6, 3)), copy = body;
  Vector               flux(7);
  flux = 1e9;
  body.accept(flux, 1e-9);
  body.accept(flux, 3e-9);
  const std::string bytes =
    to_bytes([&](OutputArchive &archive) { body.save(archive); });
  from_bytes(bytes, "The tool", [&](InputArchive &archive) {
    copy.load(archive);
  });
  EXPECT_EQ(copy.remembered(2e-9), body.remembered(2e-9));
  EXPECT_EQ(copy.heat(), body.heat());

  PeriodicHalfSpace<2> other(carbide, along_x(10e-6, 4));
  EXPECT_THROW(from_bytes(bytes,
                          "The tool",
                          [&](InputArchive &archive) { other.load(archive); }),
               InputError);
}
