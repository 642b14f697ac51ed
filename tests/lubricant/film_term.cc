#include <asperity/base/archive.h>
#include <asperity/lubricant/film_term.h>
#include <asperity/solvers/linear_solver.h>
#include <asperity/solvers/newton.h>
#include <asperity/splines/spline_fit.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

// The film between a chip and a tool. Units of the problem: length of the chip
// 4, its height 1, viscosity and pressures of order 1.

namespace
{
  using namespace asperity;
  using Vector = dealii::Vector<double>;
  using Matrix = dealii::SparseMatrix<double>;

  FilmTermOptions
  options_with(const PressureLaw law, const double wetting)
  {
    FilmTermOptions options;
    options.oil.compressibility.bulk_modulus   = 8.;
    options.oil.viscosity.viscosity            = 0.3;
    options.oil.viscosity.pressure_law         = law;
    options.oil.viscosity.pressure_coefficient = 0.2;
    options.wetting                            = wetting;
    options.gap.residual                       = 0.05;
    options.cells_per_span                     = 2;
    options.pressure_scale                     = 2.;
    options.gap_scale                          = 0.5;
    return options;
  }

  SplineCurve
  tool(const double height, const double amplitude)
  {
    return interpolate_periodic_function(
      [=](const double x) { return height + amplitude * std::sin(M_PI * x); },
      0.,
      4.,
      16,
      3);
  }

  PatchGeometry<2>
  wavy_block(const SplineSpace<2> &space)
  {
    return PatchGeometry<2>::from_map(space, [](const dealii::Point<2> &p) {
      return dealii::Point<2>(p[0] + 0.1 * std::sin(M_PI * p[0]),
                              p[1] * (1. + 0.1 * std::cos(0.5 * M_PI * p[0])));
    });
  }

  /** A film as a nonlinear system, with springs between some degrees of freedom
   *  and a given position; those without spring and load are held. */
  class SprungFilm : public NonlinearSystem
  {
  public:
    SprungFilm(FilmTerm &film, const unsigned int n_chip_dofs)
      : film(film)
      , stiffness(n_chip_dofs)
      , load(n_chip_dofs)
      , solver(make_linear_solver(LinearSolverKind::umfpack))
    {
      const unsigned int             n = n_chip_dofs + film.n_unknowns();
      dealii::DynamicSparsityPattern couplings(n);
      film.add_couplings(couplings);
      for (unsigned int i = 0; i < n; ++i)
        couplings.add(i, i);
      pattern.copy_from(couplings);
      matrix.reinit(pattern);
    }

    bool
    residual(const Vector &u, Vector &R) override
    {
      return assemble(u, R, nullptr);
    }

    bool
    linearize(const Vector &u, Vector &R) override
    {
      matrix = 0.;
      return assemble(u, R, &matrix);
    }

    bool
    direction(const Vector &R, Vector &d) override
    {
      for (unsigned int i = 0; i < stiffness.size(); ++i)
        if (stiffness(i) == 0.)
          for (auto entry = matrix.begin(i); entry != matrix.end(i); ++entry)
            entry->value() = entry->column() == i ? 1. : 0.;
      if (!solver->factorize(matrix))
        return false;
      d.equ(-1., R);
      solver->solve(d);
      return true;
    }

    ConvergenceReport
    solve(Vector &u)
    {
      NewtonOptions options;
      options.merit              = NewtonMerit::residual_norm;
      options.tolerance          = 1e-10;
      options.maximum_iterations = 60;
      options.line_search_trials = 30;
      NewtonStatistics statistics;
      return newton(*this, u, options, statistics);
    }

  private:
    bool
    assemble(const Vector &u, Vector &R, Matrix *tangent)
    {
      R = 0.;
      if (!film.add(u, R, tangent))
        return false;
      for (unsigned int i = 0; i < stiffness.size(); ++i)
        if (stiffness(i) == 0.)
          R(i) = 0.;
        else
          {
            R(i) += stiffness(i) * u(i) - load(i);
            if (tangent != nullptr)
              tangent->add(i, i, stiffness(i));
          }
      return true;
    }

    FilmTerm &film;

  public:
    Vector                        stiffness, load;
    dealii::SparsityPattern       pattern;
    Matrix                        matrix;
    std::unique_ptr<LinearSolver> solver;
  };

  class Film : public testing::Test
  {
  protected:
    Film()
      : space(KnotVector(2, {0., 0.4, 1., 1.5, 2., 2.7, 3.2, 4.}, true),
              KnotVector(2, {0., 0.5, 1.}))
      , n_chip(2 * space.n_functions())
    {}

    /** Moves the whole chip. */
    void
    translate(Vector &u, const double dx, const double dy) const
    {
      for (unsigned int a = 0; a < space.n_functions(); ++a)
        {
          u(2 * a)     = dx;
          u(2 * a + 1) = dy;
        }
    }

    SplineSpace<2>     space;
    const unsigned int n_chip;
  };

  class FilmTangent : public Film, public testing::WithParamInterface<double>
  {};

  // The lift selects the branch of the gap: open, in part at the residual film.
  TEST_P(FilmTangent, is_that_of_finite_differences)
  {
    FilmTermOptions options = options_with(PressureLaw::barus, 0.8);
    options.oil.compressibility.ambient_ratio = 0.95; // warm oil
    FilmTerm   film(space, wavy_block(space), tool(1.5, 0.2), options, n_chip);
    SprungFilm system(film, n_chip);
    Vector     u(n_chip + film.n_unknowns());
    film.initialize(u);
    dealii::Tensor<1, 2> offset;
    offset[0] = 0.1;
    offset[1] = -GetParam();
    film.set_tool_offset(offset);
    film.begin_step(u, 1, 0.3, 0.3);
    for (unsigned int i = 0; i < n_chip; ++i)
      u(i) = 0.05 * std::sin(1. + 7. * i) + (i % 2 == 0 ? 1.3 : 0.);
    for (unsigned int i = n_chip; i < u.size(); i += 2)
      {
        u(i)     = 0.3 * std::sin(i) + 0.1;
        u(i + 1) = 0.5 - 0.2 * std::abs(std::cos(i));
      }
    Vector R(u.size()), plus(u.size()), minus(u.size()), d(u.size());
    for (const double phase : {0., 1., 2.})
      {
        for (unsigned int i = 0; i < d.size(); ++i)
          d(i) = std::cos(phase + 3. * i);
        system.matrix = 0.;
        R             = 0.;
        ASSERT_TRUE(film.add(u, R, &system.matrix));
        Vector expected(u.size());
        system.matrix.vmult(expected, d);
        const double step = 1e-6;
        Vector       v    = u;
        v.add(step, d);
        plus = 0.;
        ASSERT_TRUE(film.add(v, plus, nullptr));
        v = u;
        v.add(-step, d);
        minus = 0.;
        ASSERT_TRUE(film.add(v, minus, nullptr));
        plus -= minus;
        plus /= 2. * step;
        plus -= expected;
        EXPECT_LT(plus.linfty_norm(), 1e-7 * expected.linfty_norm());
      }
  }

  INSTANTIATE_TEST_SUITE_P(Gaps, FilmTangent, testing::Values(0., 0.35, 0.6));

  TEST_F(Film, that_warms_up_between_fixed_walls_is_compressed)
  {
    FilmTermOptions options = options_with(PressureLaw::none, 1.);
    FilmTerm   film(space, wavy_block(space), tool(1.5, 0.2), options, n_chip);
    SprungFilm system(film, n_chip);
    Vector     u(n_chip + film.n_unknowns());
    film.initialize(u);
    options.oil.compressibility.ambient_ratio = 0.97;
    film.set_oil(options.oil);
    ASSERT_TRUE(system.solve(u).converged);
    for (const FilmState &state : film.film_states())
      EXPECT_NEAR(state.pressure, 0.8 * (std::pow(1. / 0.97, 10.) - 1.), 1e-6);
  }

  TEST_F(Film, flat_walls_that_slide_only_shear)
  {
    const auto options = options_with(PressureLaw::none, 1.);
    FilmTerm   film(space, PatchGeometry<2>(), tool(1.4, 0.), options, n_chip);
    Vector     u(n_chip + film.n_unknowns()), R(u.size());
    film.initialize(u);
    film.begin_step(u, 1, 0.1, 0.1);
    translate(u, 0.25, 0.); // speed 2.5
    ASSERT_TRUE(film.add(u, R, nullptr));
    double sum = 0.;
    for (unsigned int i = 0; i < u.size(); ++i)
      if (i < n_chip && i % 2 == 0)
        sum += R(i);
      else
        EXPECT_NEAR(R(i), 0., 1e-13) << i;
    // The residual is minus the force, which brakes the chip.
    EXPECT_NEAR(sum, 0.3 * 2.5 / 0.4 * 4., 1e-12);
    EXPECT_NEAR(film.state().shear_force[0], -sum, 1e-12);
  }

  TEST_F(Film, agrees_with_the_film_between_given_walls)
  {
    const auto options = options_with(PressureLaw::barus, 1.);
    FilmTerm   film(space, PatchGeometry<2>(), tool(1.4, 0.2), options, n_chip);
    SprungFilm system(film, n_chip);
    Vector     u(n_chip + film.n_unknowns());
    film.initialize(u);
    dealii::Tensor<1, 2> offset;
    offset[0] = 0.3;
    offset[1] = -0.02;
    film.set_tool_offset(offset);
    film.begin_step(u, 1, 0.1, 0.1);
    const auto report = system.solve(u);
    ASSERT_TRUE(report.converged) << report.reason;

    // Cells, volumes and gaps from the formula of the tool.
    FilmGeometry              geometry;
    FilmStep                  step;
    std::vector<double>       x;
    const std::vector<double> knots = {0., 0.4, 1., 1.5, 2., 2.7, 3.2, 4.};
    for (unsigned int k = 0; k + 1 < knots.size(); ++k)
      {
        x.push_back(knots[k]);
        x.push_back(0.5 * (knots[k] + knots[k + 1]));
      }
    x.push_back(4.);
    const auto volume = [&](const unsigned int i, const double dx) {
      return 0.4 * (x[i + 1] - x[i]) - 0.2 / M_PI *
                                         (std::cos(M_PI * (x[i + 1] - dx)) -
                                          std::cos(M_PI * (x[i] - dx)));
    };
    const unsigned int n = x.size() - 1;
    step.dt              = 0.1;
    for (unsigned int i = 0; i < n; ++i)
      {
        step.old_content.push_back(volume(i, 0.));
        geometry.volume.push_back(volume(i, 0.3) - 0.02 * (x[i + 1] - x[i]));
        const double before = i > 0 ? x[i - 1] : x[n - 1] - 4.;
        geometry.faces.push_back({0.38 + 0.2 * std::sin(M_PI * (x[i] - 0.3)),
                                  1.5,
                                  3.,
                                  0.5 * (x[i + 1] - before)});
      }
    const ReynoldsFilm     reynolds(options.oil, n, FilmEnds());
    std::vector<FilmState> states(n);
    ASSERT_TRUE(reynolds.solve(geometry, step, states).converged);
    double p_max = 0.;
    for (const FilmState &state : states)
      p_max = std::max(p_max, state.pressure);
    EXPECT_GT(p_max, 1.);
    // The tool is a spline through the sine: the difference is its error.
    for (unsigned int i = 0; i < n; ++i)
      EXPECT_NEAR(film.film_states()[i].pressure,
                  states[i].pressure,
                  2e-2 * p_max);
  }

  TEST_F(Film, carries_a_lifted_chip_by_compression)
  {
    auto       options = options_with(PressureLaw::none, 1.);
    FilmTerm   film(space, PatchGeometry<2>(), tool(1.4, 0.), options, n_chip);
    SprungFilm system(film, n_chip);
    const double k = 5., P = 3.; // per area
    for (unsigned int i = 0; i < film.edge().n_cells(); ++i)
      for (const auto &[dof, area] : film.edge().area_vector(i))
        if (dof % 2 == 1)
          {
            system.stiffness(dof) += k * area;
            system.load(dof) += P * area;
          }
    Vector u(n_chip + film.n_unknowns());
    film.initialize(u);
    film.begin_step(u, 1, 0.1, 0.1);
    const auto report = system.solve(u);
    ASSERT_TRUE(report.converged) << report.reason;
    // P - k u = p and r(p) (h - u) = h, by bisection.
    double low = 0., high = 0.4;
    for (unsigned int i = 0; i < 60; ++i)
      {
        const double middle = 0.5 * (low + high);
        const double r      = options.oil.compressibility.ratio(P - k * middle);
        (r * (0.4 - middle) > 0.4 ? low : high) = middle;
      }
    for (const FilmState &state : film.film_states())
      {
        EXPECT_NEAR(state.pressure, P - k * low, 1e-8);
        EXPECT_NEAR(state.fraction, 1., 1e-12);
      }
    const LubricantState state = film.state();
    EXPECT_NEAR(state.mean_pressure, P - k * low, 1e-8);
    EXPECT_NEAR(state.smallest_film, 0.4 - low, 1e-9);
    EXPECT_NEAR(state.reference_volume, 1.6, 1e-14);
  }

  TEST_F(Film, keeps_its_oil_while_surfaces_touch_and_slide)
  {
    auto options = options_with(PressureLaw::barus, 0.6);
    options.oil.viscosity.pressure_coefficient = 5e-4;
    FilmTerm   film(space, wavy_block(space), tool(1.5, 0.3), options, n_chip);
    SprungFilm system(film, n_chip);
    Vector     u(n_chip + film.n_unknowns());
    film.initialize(u);
    const double oil    = film.state().reference_volume;
    double       lowest = 1., highest = 0.;
    for (unsigned int step = 1; step <= 40; ++step)
      {
        film.begin_step(u, step, 0.1 * step, 0.1);
        translate(u, 0.11 * step, 0.15 * std::sin(0.08 * step));
        const auto report = system.solve(u);
        ASSERT_TRUE(report.converged) << step << report.reason;
        film.accept(u);
        const LubricantState state = film.state();
        EXPECT_NEAR(state.reference_volume / oil, 1., 1e-12);
        lowest  = std::min(lowest, state.smallest_film);
        highest = std::max(highest, state.max_pressure);
        // And the states hold what the fluxes brought.
        double held = 0.;
        for (unsigned int i = 0; i < film.edge().n_cells(); ++i)
          {
            const auto [p, theta] = film.film_states()[i];
            EXPECT_GT(p, -1e-9);
            EXPECT_LT(theta, 1. + 1e-9);
            held += theta * options.oil.compressibility.ratio(std::max(p, 0.)) *
                    film.edge().volume(i);
          }
        EXPECT_NEAR(held / oil, 1., 1e-9);
      }
    EXPECT_LT(lowest, 0.051);
    EXPECT_GT(highest, 1.);

    // A restart goes on from the same numbers.
    FilmTerm   again(space, wavy_block(space), tool(1.5, 0.3), options, n_chip);
    const auto bytes = [](const FilmTerm &term) {
      return to_bytes([&](OutputArchive &archive) { term.save(archive); });
    };
    from_bytes(bytes(film), "the film", [&](InputArchive &archive) {
      again.load(archive);
    });
    EXPECT_EQ(bytes(again), bytes(film));
    Vector R(u.size()), R_again(u.size());
    film.begin_step(u, 41, 4.1, 0.1);
    again.begin_step(u, 41, 4.1, 0.1);
    ASSERT_TRUE(film.add(u, R, nullptr) && again.add(u, R_again, nullptr));
    R -= R_again;
    EXPECT_EQ(R.linfty_norm(), 0.);
  }
} // namespace
