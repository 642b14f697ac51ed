#include <asperity/lubricant/film_walls.h>

#include <gtest/gtest.h>

#include <cmath>

// Films between given walls against formulas. Everything in units of the
// problem: eta_0 = 1, length 1, outlet gap 1, speed 1.

namespace
{
  using namespace asperity;

  LubricantParameters
  unit_oil()
  {
    LubricantParameters oil;
    oil.compressibility.law = DensityLaw::incompressible;
    oil.viscosity.viscosity = 1.;
    return oil;
  }

  LubricantParameters
  barus_oil(const double alpha)
  {
    LubricantParameters oil            = unit_oil();
    oil.viscosity.pressure_law         = PressureLaw::barus;
    oil.viscosity.pressure_coefficient = alpha;
    return oil;
  }

  FilmEnds
  open_ends()
  {
    FilmEnds ends;
    ends.periodic = false;
    return ends;
  }

  /** Faces of n cells, a tenth as wide at the end as at the start if graded. */
  std::vector<double>
  faces(const unsigned int n, const bool graded = false)
  {
    std::vector<double> x(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double s = double(i) / n;
        x[i]           = graded ? (1. - std::pow(0.1, s)) / 0.9 : s;
      }
    return x;
  }

  /** The linear slider with gap K at x = 0 and 1 at x = 1; the lower wall
   *  moves. */
  FilmWalls
  slider(const double K, const unsigned int n, const bool graded = false)
  {
    FilmWalls walls;
    walls.x           = faces(n, graded);
    walls.gap         = [K](const double x) { return K + (1. - K) * x; };
    walls.lower_speed = 1.;
    return walls;
  }

  FilmForces
  solve_steady(const LubricantParameters &oil,
               const FilmWalls           &walls,
               const FilmEnds            &ends,
               std::vector<FilmState>    &states)
  {
    const ReynoldsFilm film(oil, walls.x.size() - 1, ends);
    states.assign(film.n_cells(), FilmState());
    const auto report = film.solve(walls.geometry(), FilmStep(), states);
    EXPECT_TRUE(report.converged) << report.reason;
    EXPECT_EQ(film.warning(walls.geometry(), states), "");
    return film_forces(film, walls, states);
  }
} // namespace



TEST(ReynoldsFilm, linear_slider_has_the_textbook_values)
{
  for (const double K : {1.5, 2., 2.18874, 3.})
    for (const bool graded : {false, true})
      {
        std::vector<FilmState> states;
        const FilmForces       forces = solve_steady(unit_oil(),
                                               slider(K, 1000, graded),
                                               open_ends(),
                                               states);
        const double           k = K - 1., l = std::log(K), m = k / (K + 1.);
        EXPECT_NEAR(forces.load, 6. / (k * k) * (l - 2. * m), 1e-5);
        EXPECT_NEAR(forces.lower_shear, -(4. * l - 6. * m) / k, 1e-5);
        EXPECT_NEAR(forces.upper_shear, (-2. * l + 6. * m) / k, 1e-5);
        EXPECT_NEAR(forces.max_pressure, 1.5 * k / (K * (K + 1.)), 1e-5);
        // Nothing else holds the oil in x.
        EXPECT_NEAR(forces.lower_shear + forces.upper_shear - forces.wedge,
                    0.,
                    1e-10);
        for (const FilmState &state : states)
          EXPECT_NEAR(state.fraction, 1., 1e-10);
        // Flow U h_m/2 with h_m = 2K/(K + 1) where the pressure is largest.
        for (const double flow : forces.flow)
          EXPECT_NEAR(flow, K / (K + 1.), 1e-5);
      }
}



TEST(ReynoldsFilm, slider_values_do_not_depend_on_the_frame)
{
  // The same slider with the upper wall moving the other way: its gap travels
  // with it, so dh/dt = -u_2 dh/dx, given as what it displaces.
  FilmWalls walls       = slider(2., 1000);
  walls.lower_speed     = 0.;
  walls.upper_speed     = -1.;
  FilmGeometry geometry = walls.geometry();
  geometry.supply.assign(1000, 0.);
  for (unsigned int i = 0; i < 1000; ++i)
    geometry.supply[i] = -(walls.gap(walls.x[i + 1]) - walls.gap(walls.x[i]));
  const ReynoldsFilm     film(unit_oil(), 1000, open_ends());
  std::vector<FilmState> states(1000);
  ASSERT_TRUE(film.solve(geometry, FilmStep(), states).converged);
  const FilmForces forces = film_forces(film, walls, states);
  EXPECT_NEAR(forces.load, 0.158883, 1e-5);
  EXPECT_NEAR(forces.lower_shear, -0.772589, 1e-5);
}



TEST(ReynoldsFilm, piezoviscous_slider_follows_the_reduced_pressure)
{
  const double alpha[] = {1., 2., 3., 3.5, 3.9};
  const double load[]  = {.177095, .203458, .248641, .291300, .369826};
  const double p_max[] = {.287682, .346574, .462098, .594126, .945867};
  for (unsigned int k = 0; k < 5; ++k)
    {
      const LubricantParameters oil = barus_oil(alpha[k]);
      std::vector<FilmState>    states;
      const FilmForces          forces =
        solve_steady(oil, slider(2., 2000), open_ends(), states);
      EXPECT_NEAR(forces.load, load[k], 1e-5) << alpha[k];
      EXPECT_NEAR(forces.max_pressure, p_max[k], k < 4 ? 1e-5 : 1e-4);
    }
}



TEST(ReynoldsFilm, cells_too_long_for_the_pressure_are_told)
{
  // ln(1 - alpha q)/alpha changes most beside the peak of q = 1/4.
  const auto told = [](const double alpha, const unsigned int n) {
    const LubricantParameters oil   = barus_oil(alpha);
    const FilmWalls           walls = slider(2., n);
    const ReynoldsFilm        film(oil, n, open_ends());
    std::vector<FilmState>    states(n);
    EXPECT_TRUE(film.solve(walls.geometry(), FilmStep(), states).converged);
    return film.coarseness(walls.geometry(), states);
  };
  EXPECT_EQ(told(0., 20), "");
  EXPECT_EQ(told(3., 20), "");
  EXPECT_EQ(told(3.8, 200), "");
  const std::string warning = told(3.8, 20);
  EXPECT_EQ(warning.find("The viscosity of the oil changes by a factor of "),
            0u)
    << warning;
  EXPECT_NE(warning.find("where less than 1.4 is expected"), std::string::npos)
    << warning;
}



TEST(ReynoldsFilm, piezoviscous_blow_up_is_reported)
{
  for (const double alpha : {4., 4.2, 6., 40.})
    for (const unsigned int n : {100, 1000})
      {
        const LubricantParameters oil   = barus_oil(alpha);
        const FilmWalls           walls = slider(2., n);
        const ReynoldsFilm        film(oil, n, open_ends());
        std::vector<FilmState>    states(n);
        const auto report = film.solve(walls.geometry(), FilmStep(), states);
        const std::string text = report.converged ?
                                   film.warning(walls.geometry(), states) :
                                   report.reason;
        EXPECT_NE(text.find("runs away"), std::string::npos)
          << alpha << " " << n << " " << text << report.iterations;
      }
}



TEST(ReynoldsFilm, parallel_walls_shear_and_leak)
{
  FilmWalls walls;
  walls.x            = faces(10, true);
  walls.gap          = [](double) { return 2.; };
  walls.lower_speed  = 3.;
  FilmEnds ends      = open_ends();
  ends.left.pressure = 5.;
  std::vector<FilmState> states;
  const FilmForces       forces = solve_steady(unit_oil(), walls, ends, states);
  const double           G      = 5.; // -dp/dx
  for (unsigned int f = 0; f < 11; ++f)
    {
      EXPECT_NEAR(forces.flow[f], 1.5 * 2. + 8. * G / 12., 1e-10);
      EXPECT_NEAR(forces.lower_stress[f], -3. / 2. + 2. * G / 2., 1e-10);
      EXPECT_NEAR(forces.upper_stress[f], 3. / 2. + 2. * G / 2., 1e-10);
    }
  EXPECT_NEAR(forces.load, 2.5, 1e-10);
}



TEST(ReynoldsFilm, stress_limit_acts_on_the_mean_rate)
{
  LubricantParameters oil       = unit_oil();
  oil.viscosity.stress_limit    = StressLimit::circular;
  oil.viscosity.limiting_stress = 0.5;
  FilmWalls walls;
  walls.x           = faces(10);
  walls.gap         = [](double) { return 2.; };
  walls.upper_speed = 3.;
  std::vector<FilmState> states;
  const FilmForces       forces = solve_steady(oil, walls, open_ends(), states);
  EXPECT_NEAR(forces.lower_shear, 1.5 / std::sqrt(1. + 9.), 1e-10);
}



TEST(ReynoldsFilm, squeezed_strip_carries_stefans_load)
{
  FilmWalls walls;
  walls.x               = faces(600);
  walls.gap             = [](double) { return 0.3; };
  FilmGeometry geometry = walls.geometry();
  geometry.supply.assign(600, 2. / 600.); // approach speed 2
  const ReynoldsFilm     film(unit_oil(), 600, open_ends());
  std::vector<FilmState> states(600);
  ASSERT_TRUE(film.solve(geometry, FilmStep(), states).converged);
  const double stefan = 2. / std::pow(0.3, 3);
  EXPECT_NEAR(film_forces(film, walls, states).load / stefan, 1., 1e-5);

  // The same by a step in time, with the strip at its end.
  FilmStep step;
  step.dt = 1e-3;
  step.old_content.assign(600, (0.3 + 2. * step.dt) / 600.);
  geometry.supply.clear();
  ASSERT_TRUE(film.solve(geometry, step, states).converged);
  EXPECT_NEAR(film_forces(film, walls, states).load / stefan, 1., 1e-5);
}



TEST(ReynoldsFilm, refuses_a_pressure_without_level)
{
  FilmWalls walls;
  walls.x   = faces(20);
  walls.gap = [](const double x) { return 1. + 0.2 * std::sin(7. * x); };
  walls.lower_speed               = 1.;
  walls.periodic                  = true;
  const FilmGeometry     geometry = walls.geometry();
  const ReynoldsFilm     film(unit_oil(), 20, FilmEnds());
  std::vector<FilmState> states(20);
  FilmStep               step;
  EXPECT_EQ(film.solve(geometry, step, states).reason,
            "a steady periodic film does not know how much oil it holds");
  step.dt = 0.1;
  for (const double oil : {1., 1.01, 0.99})
    {
      step.old_content = geometry.volume;
      for (double &m : step.old_content)
        m *= oil;
      states.assign(20, FilmState());
      const auto report = film.solve(geometry, step, states);
      EXPECT_EQ(report.converged, oil < 1.);
      EXPECT_EQ(report.reason,
                oil < 1. ? "" :
                           "an incompressible lubricant fills the whole period "
                           "or more, so that its pressure has no level");
    }
}
