#include <asperity/lubricant/film_walls.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

// Cavitation, compressible and transient films. Units of the problem.

namespace
{
  using namespace asperity;

  constexpr double pi = M_PI;

  LubricantParameters
  unit_oil(const DensityLaw law)
  {
    LubricantParameters oil;
    oil.compressibility.law          = law;
    oil.compressibility.bulk_modulus = 4.;
    oil.viscosity.viscosity          = 1.;
    return oil;
  }

  /** Integral by 200 panels of a 10-point Gauss rule. */
  template <typename Function>
  double
  integral(const Function &f, const double a, const double b)
  {
    double sum = 0.;
    for (unsigned int i = 0; i < 200; ++i)
      sum += boost::math::quadrature::gauss<double, 10>::integrate(
        f, a + (b - a) * i / 200., a + (b - a) * (i + 1) / 200.);
    return sum;
  }

  /**
   * Converging and diverging film, h = 1 + a cos 2 pi x, lower wall at speed 1,
   * flooded at p = 0 at x = 0 and at p_end at x = 1. By the theory of
   * Jakobsson, Floberg and Olsson the full film ruptures at x_r where p = p' =
   * 0, carries the flow h_r/2 behind it, and is full again from x_f on:
   *   int_0^x_r (h - h_r)/h^3 dx = 0,  6 int_x_f^1 (h - h_r)/h^3 dx = p_end.
   */
  struct RupturedFilm
  {
    double a = 0.6, p_end = 0.6, x_r, x_f, load;

    double
    h(const double x) const
    {
      return 1. + a * std::cos(2. * pi * x);
    }

    /** dp/dx */
    double
    slope(const double x, const double h_r) const
    {
      return 6. * (h(x) - h_r) / std::pow(h(x), 3);
    }

    RupturedFilm()
    {
      const auto root = [](const auto &f, const double low, const double high) {
        const auto bracket = boost::math::tools::bisect(
          f, low, high, boost::math::tools::eps_tolerance<double>(40));
        return 0.5 * (bracket.first + bracket.second);
      };
      x_r = root(
        [&](const double r) {
          return integral([&](double x) { return slope(x, h(r)); }, 0., r);
        },
        0.51,
        0.99);
      const double h_r = h(x_r);
      x_f              = root(
        [&](const double f) {
          return integral([&](double x) { return slope(x, h_r); }, f, 1.) -
                 p_end;
        },
        x_r,
        1.);
      load =
        integral([&](double x) { return (x_r - x) * slope(x, h_r); }, 0., x_r) +
        integral([&](double x) { return (1. - x) * slope(x, h_r); }, x_f, 1.);
    }
  };

  FilmWalls
  walls_of(const RupturedFilm &exact, const unsigned int n)
  {
    FilmWalls walls;
    for (unsigned int i = 0; i <= n; ++i)
      walls.x.push_back(double(i) / n);
    walls.gap         = [&exact](const double x) { return exact.h(x); };
    walls.lower_speed = 1.;
    return walls;
  }

  double
  total(const std::vector<double> &values)
  {
    return std::accumulate(values.begin(), values.end(), 0.);
  }
} // namespace



TEST(FilmCavitation, ruptures_and_reforms_where_theory_has_it)
{
  const RupturedFilm exact;
  ASSERT_GT(exact.x_f, exact.x_r + 0.05);
  FilmEnds ends;
  ends.periodic       = false;
  ends.right.pressure = exact.p_end;
  for (const unsigned int n : {100, 400, 1600})
    {
      const FilmWalls    walls = walls_of(exact, n);
      const ReynoldsFilm film(unit_oil(DensityLaw::incompressible), n, ends);
      std::vector<FilmState> states(n);
      const auto report = film.solve(walls.geometry(), FilmStep(), states);
      ASSERT_TRUE(report.converged) << report.reason;

      const auto   x        = walls.centres();
      const double h_r      = exact.h(exact.x_r);
      double       ruptured = 0., reformed = 1.;
      for (unsigned int i = 0; i < n; ++i)
        if (states[i].fraction < 1. - 1e-9)
          {
            if (ruptured == 0.)
              ruptured = walls.x[i];
            reformed = walls.x[i + 1];
            if (x[i] < exact.x_f - 2. / n)
              {
                EXPECT_NEAR(states[i].fraction, h_r / exact.h(x[i]), 20. / n);
              }
          }
      EXPECT_NEAR(ruptured, exact.x_r, 2. / n);
      EXPECT_NEAR(reformed, exact.x_f, 2. / n);
      const FilmForces forces = film_forces(film, walls, states);
      const double     error  = std::abs(forces.load / exact.load - 1.);
      EXPECT_LT(error, 1e-2 / n);
      for (const double flow : forces.flow)
        EXPECT_NEAR(flow, 0.5 * h_r, 20. / n / n);
    }
}



TEST(FilmCavitation, periodic_film_keeps_its_oil)
{
  // A wave that travels against the walls, starved at first.
  const unsigned int n   = 100;
  const double       oil = 0.7, dt = 0.01;
  FilmWalls          walls;
  for (unsigned int i = 0; i <= n; ++i)
    walls.x.push_back(double(i) / n);
  walls.lower_speed = 1.;
  walls.upper_speed = 0.5;
  walls.periodic    = true;
  double t          = 0.;
  walls.gap         = [&t](const double x) {
    return 1. + 0.5 * std::sin(2. * pi * (x + 0.8 * t)) - 0.35 * t;
  };
  for (const DensityLaw law :
       {DensityLaw::incompressible, DensityLaw::murnaghan})
    {
      t = 0.;
      const ReynoldsFilm     film(unit_oil(law), n, FilmEnds());
      std::vector<FilmState> states(n, FilmState{0., oil});
      FilmStep               step;
      step.dt          = dt;
      step.old_content = walls.geometry().volume;
      for (double &m : step.old_content)
        m *= oil;
      const double at_start = total(step.old_content);
      unsigned int n_full   = 0;
      for (unsigned int k = 0; k < 80; ++k)
        {
          t += dt;
          const FilmGeometry geometry = walls.geometry();
          const auto         report   = film.solve(geometry, step, states);
          ASSERT_TRUE(report.converged) << k << " " << report.reason;
          FilmLinearization linearization;
          film.linearize(states, geometry, 1., linearization);
          const auto content =
            film.advanced_content(linearization, geometry, step);
          EXPECT_NEAR(total(content) / at_start, 1., 1e-12);
          for (unsigned int i = 0; i < n; ++i)
            {
              EXPECT_GT(states[i].pressure, -1e-9);
              EXPECT_LT(states[i].fraction, 1. + 1e-9);
              EXPECT_NEAR(linearization.content[i].value, content[i], 1e-10);
              n_full += states[i].pressure > 1e-3;
            }
          step.old_content = content;
        }
      EXPECT_GT(n_full, 400); // it fills
    }
}



namespace
{
  /** A smooth solution p(x, t) in a moving gap; the supply makes it one. */
  struct Manufactured
  {
    LubricantParameters oil = unit_oil(DensityLaw::constant_modulus);

    Manufactured()
    {
      oil.viscosity.pressure_law         = PressureLaw::barus;
      oil.viscosity.pressure_coefficient = 0.5;
    }

    static double
    p(const double x, const double t)
    {
      return 2. + std::sin(2. * x + t);
    }

    static double
    h(const double x, const double t)
    {
      return 1. + 0.3 * std::cos(3. * x - t);
    }

    /** Exact flow with the walls at a mean speed of 1. */
    static double
    flow(const double x, const double t)
    {
      const double H = h(x, t), P = p(x, t);
      return std::exp(P / 4.) * (H - H * H * H / (12. * std::exp(0.5 * P)) *
                                       2. * std::cos(2. * x + t));
    }

    /** d(r h)/dt */
    static double
    storage(const double x, const double t)
    {
      const double r = std::exp(p(x, t) / 4.);
      return r * (0.25 * std::cos(2. * x + t) * h(x, t) +
                  0.3 * std::sin(3. * x - t));
    }

    /** Largest error of the pressure at the time 0.2. */
    double
    error(const unsigned int n, const unsigned int n_steps) const
    {
      double    t = 0.;
      FilmWalls walls;
      for (unsigned int i = 0; i <= n; ++i)
        {
          const double s = double(i) / n;
          walls.x.push_back(s + 0.2 * s * (1. - s));
        }
      walls.gap         = [&t](const double x) { return h(x, t); };
      walls.lower_speed = walls.upper_speed = 1.;
      const auto             x              = walls.centres();
      std::vector<FilmState> states(n);
      FilmStep               step;
      for (unsigned int i = 0; i < n; ++i)
        {
          states[i].pressure = p(x[i], 0.);
          step.old_content.push_back(integral(
            [](double s) { return std::exp(p(s, 0.) / 4.) * h(s, 0.); },
            walls.x[i],
            walls.x[i + 1]));
        }
      const double end = 0.2;
      for (unsigned int k = 1; k <= n_steps; ++k)
        {
          t       = end * k / n_steps;
          step.dt = end / n_steps;
          FilmEnds ends;
          ends.periodic         = false;
          ends.left.pressure    = p(walls.x[0], t);
          ends.right.pressure   = p(walls.x[n], t);
          FilmGeometry geometry = walls.geometry();
          for (unsigned int i = 0; i < n; ++i)
            geometry.supply.push_back(
              flow(walls.x[i + 1], t) - flow(walls.x[i], t) +
              boost::math::quadrature::gauss<double, 10>::integrate(
                [&](double s) { return storage(s, t); },
                walls.x[i],
                walls.x[i + 1]));
          const ReynoldsFilm film(oil, n, ends);
          const auto         report = film.solve(geometry, step, states);
          EXPECT_TRUE(report.converged) << report.reason;
          FilmLinearization linearization;
          film.linearize(states, geometry, 1., linearization);
          step.old_content =
            film.advanced_content(linearization, geometry, step);
        }
      double error = 0.;
      for (unsigned int i = 0; i < n; ++i)
        error = std::max(error, std::abs(states[i].pressure - p(x[i], end)));
      return error;
    }
  };
} // namespace



TEST(FilmManufactured, is_of_second_order_in_space)
{
  const Manufactured problem;
  const double       coarse = problem.error(20, 1600);
  const double       fine   = problem.error(40, 1600);
  EXPECT_NEAR(std::log2(coarse / fine), 2., 0.15) << coarse << " " << fine;
}



TEST(FilmManufactured, is_of_first_order_in_time)
{
  const Manufactured problem;
  const double       coarse = problem.error(500, 4);
  const double       fine   = problem.error(500, 8);
  EXPECT_NEAR(std::log2(coarse / fine), 1., 0.15) << coarse << " " << fine;
}



TEST(FilmLubricant, derivatives_are_those_of_finite_differences)
{
  LubricantParameters oil            = unit_oil(DensityLaw::murnaghan);
  oil.viscosity.shear_law            = ShearLaw::carreau;
  oil.viscosity.time_constant        = 0.4;
  oil.viscosity.pressure_law         = PressureLaw::barus;
  oil.viscosity.pressure_coefficient = 0.7;
  oil.viscosity.stress_limit         = StressLimit::circular;
  oil.viscosity.limiting_stress      = 1.5;
  const FilmLubricant lubricant(oil);
  for (const double speed : {1.3, -0.7})
    for (const double sliding : {2.1, -1.1})
      for (const double p : {0.8, -0.9})
        {
          std::array<double, n_film_variables> at;
          at[left_pressure]   = p;
          at[right_pressure]  = 1.7 * p;
          at[left_fraction]   = 0.6;
          at[right_fraction]  = 0.9;
          at[face_gap]        = 1.1;
          at[couette_speed]   = speed;
          at[sliding_speed]   = sliding;
          at[face_distance]   = 0.3;
          const auto evaluate = [&](const auto &v) {
            return lubricant.fluxes({v[0], v[2]},
                                    {v[1], v[3]},
                                    {v[4], v[5], v[6], v[7]});
          };
          const FilmFluxes fluxes = evaluate(at);
          for (unsigned int k = 0; k < n_film_variables; ++k)
            {
              auto plus = at, minus = at;
              plus[k] += 1e-6;
              minus[k] -= 1e-6;
              const FilmFluxes a = evaluate(plus), b = evaluate(minus);
              for (const auto value : {&FilmFluxes::flow,
                                       &FilmFluxes::lower_shear,
                                       &FilmFluxes::upper_shear})
                EXPECT_NEAR((fluxes.*value).derivative[k],
                            ((a.*value).value - (b.*value).value) / 2e-6,
                            1e-8)
                  << k;
            }
        }
}



TEST(FischerBurmeister, vanishes_on_the_complementary_states_only)
{
  EXPECT_EQ(fischer_burmeister({3., 1.}, 2.).value, 0.);
  EXPECT_EQ(fischer_burmeister({0., 0.4}, 2.).value, 0.);
  EXPECT_GT(fischer_burmeister({1e-9, 0.4}, 2.).value, 0.);
  EXPECT_LT(fischer_burmeister({-1e-3, 0.4}, 2.).value, 0.);
  EXPECT_LT(fischer_burmeister({1., 1.001}, 2.).value, 0.);
  for (const double p : {-1., 0.3, 5.})
    for (const double theta : {0.2, 0.99, 1.4})
      {
        const auto at = fischer_burmeister({p, theta}, 2.);
        const auto by = [&](const double dp, const double dtheta) {
          return (fischer_burmeister({p + dp, theta + dtheta}, 2.).value -
                  fischer_burmeister({p - dp, theta - dtheta}, 2.).value) /
                 2e-6;
        };
        EXPECT_NEAR(at.d_pressure, by(1e-6, 0.), 1e-8);
        EXPECT_NEAR(at.d_fraction, by(0., 1e-6), 1e-8);
      }
}
