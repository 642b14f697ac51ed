#include <asperity/base/errors.h>
#include <asperity/contact_zone/audit.h>
#include <asperity/contact_zone/scene_computation.h>

#include <gtest/gtest.h>

#include <cmath>

#include "flooded_scene.h"

using namespace asperity;

// What a run says of itself, and flat bodies, whose results are formulas.

namespace
{
  bool
  says(const std::vector<std::string> &warnings, const std::string &words)
  {
    for (const std::string &warning : warnings)
      if (warning.find(words) != std::string::npos)
        return true;
    return false;
  }

  /** Flat bodies and a film 20 nm thick at the start. */
  SceneParameters
  flat_film()
  {
    SceneParameters parameters      = coarse_scene();
    parameters.tool.kind            = SurfaceKind::flat;
    parameters.lubrication.model    = LubricantModel::reynolds;
    parameters.geometry.initial_gap = 20e-9;
    return parameters;
  }
} // namespace

TEST(FlatFilm, shears_as_a_layer_of_the_compressed_thickness)
{
  SceneParameters   parameters = flat_film();
  const SceneResult result     = compute_scene(parameters);
  // Murnaghan: rho/rho_0 = (1 + 10 p/K_0)^(1/10), and tau = eta v/h.
  const double ratio = std::pow(1. + 10. * 300. / 1600., 0.1);
  const double tau   = 0.032 * (200. / 60.) / (20e-9 / ratio);
  EXPECT_NEAR(result.friction.mu, tau / 300e6, 1e-5);
  EXPECT_NEAR(result.oil_load_share, 1., 1e-3);
  EXPECT_EQ(result.status, FrictionStatus::valid);
}

TEST(FlatFilm, without_a_gap_is_one_that_has_no_void)
{
  SceneParameters parameters      = flat_film();
  parameters.geometry.initial_gap = 0.;
  const SceneResult result        = compute_scene(parameters);
  EXPECT_TRUE(std::isfinite(result.friction.mu));
}

TEST(SceneWarnings, of_an_oil_that_shears_as_none_does)
{
  SceneParameters parameters = flat_film();
  auto           &oil        = parameters.lubrication.oil.viscosity;
  // Factor exp(2) at 300 MPa: tau = 131 MPa, where 5 + 0.05 300 = 20 are borne.
  oil.pressure_law         = PressureLaw::barus;
  oil.pressure_coefficient = 2. / 300e6;
  const SceneResult free   = compute_scene(parameters);
  EXPECT_TRUE(says(free.warnings, "set Lubricant/Stress limit = circular"));
  EXPECT_TRUE(says(free.warnings, "above 20 MPa"));
  oil.stress_limit          = StressLimit::circular;
  const SceneResult limited = compute_scene(parameters);
  EXPECT_FALSE(says(limited.warnings, "Stress limit"));
  EXPECT_LE(limited.friction.mu, 20. / 300.);
}

TEST(SceneWarnings, of_a_chip_that_plastic_work_melts)
{
  // 1 - T*^m = 0.02 is reached at 1478.1 degC, T* = (T - 20)/(1500 - 20).
  SceneParameters parameters      = coarse_scene();
  parameters.load.temperature     = 1476. + 273.15;
  parameters.protocol.ramp_steps  = 4;
  parameters.protocol.slide_steps = 3;
  EXPECT_TRUE(says(compute_scene(parameters).warnings,
                   "all but melts there (melting temperature 1500 degC)"));
  parameters.material.heating.adiabatic = false;
  EXPECT_FALSE(says(compute_scene(parameters).warnings, "melts"));
}

TEST(SceneWarnings, of_a_poisson_ratio_at_which_meshes_lock)
{
  SceneParameters parameters                   = coarse_scene();
  parameters.material.elasticity.poisson_ratio = 0.47;
  EXPECT_FALSE(
    says(audit_scene(parameters, Scene<2>(parameters)).warnings, "Poisson"));
  parameters.material.elasticity.poisson_ratio = 0.49;
  EXPECT_TRUE(says(audit_scene(parameters, Scene<2>(parameters)).warnings,
                   "With a Poisson's ratio of 0.49 the chip nearly keeps its "
                   "volume"));
}

TEST(SceneWarnings, of_choices_that_the_stability_map_shows_to_fail)
{
  SceneParameters parameters = coarse_scene();
  const auto      audit      = [&parameters]() {
    return audit_scene(parameters, Scene<2>(parameters)).warnings;
  };
  parameters.protocol.inertia = Inertia::dynamic;
  EXPECT_FALSE(says(audit(), "degree 1"));
  EXPECT_FALSE(says(audit(), "Gauss-point"));
  EXPECT_FALSE(says(audit(), "nothing damps"));
  EXPECT_FALSE(says(audit(), "penalty is soft"));
  parameters.contact.penalty_factor = 0.05;
  EXPECT_TRUE(
    says(audit(), "The contact penalty is soft against the roughness"));
  parameters.contact.augmentations = 10;
  EXPECT_FALSE(says(audit(), "penalty is soft"));
  parameters.contact.penalty_factor = 100.;
  EXPECT_FALSE(says(audit(), "Gauss-point"));
  parameters.contact.formulation      = ContactFormulation::gauss_point;
  parameters.protocol.spectral_radius = 1.;
  parameters.mesh.degree              = 1;
  EXPECT_TRUE(says(audit(),
                   "The pressure of a Gauss-point contact oscillates with a "
                   "penalty factor of 100"));
  EXPECT_TRUE(says(audit(), "With a spectral radius of 1 nothing damps"));
  EXPECT_TRUE(says(audit(), "Elements of degree 1 lock"));

  // mu_0 p/(stick penalty times penalty) against a way of 0.83 um
  parameters.interface.law = InterfaceShear::coulomb;
  EXPECT_FALSE(says(audit(), "Spots stick"));
  parameters.interface.stick_penalty = 1e-6;
  EXPECT_TRUE(says(audit(), "Interface/Stick penalty"));
}

TEST(SceneWarnings, of_a_fast_chip_that_has_not_reached_the_tool)
{
  // The ramp of 1.4 ns is shorter than a wave's way through the chip.
  SceneParameters parameters           = coarse_scene();
  parameters.load.velocity             = 1e4 / 60.;
  parameters.protocol.inertia          = Inertia::automatic;
  parameters.protocol.sliding_distance = 0.5e-6;
  parameters.resolve();
  const SceneResult result = compute_scene(parameters);
  EXPECT_EQ(result.status, FrictionStatus::load_not_carried);
  EXPECT_TRUE(says(result.warnings, "mu is no friction coefficient"));
}

TEST(SceneWarnings, of_a_step_that_fails_with_what_may_help)
{
  SceneParameters parameters           = flat_film();
  auto           &oil                  = parameters.lubrication.oil.viscosity;
  oil.pressure_law                     = PressureLaw::barus;
  parameters.solver.maximum_iterations = 1;
  parameters.solver.maximum_cuts       = 0;
  try
    {
      compute_scene(parameters);
      FAIL() << "one iteration a step is not enough";
    }
  catch (const ComputationError &error)
    {
      EXPECT_NE(
        std::string(error.what()).find("try Lubricant/Stress limit = circular"),
        std::string::npos)
        << error.what();
    }
}

TEST(GradedRows, a_chip_flatter_than_its_elements_are_long_has_one_row)
{
  EXPECT_EQ(graded_rows(5e-6, 10e-6, 1.5), (std::vector<double>{0., 5e-6}));
  EXPECT_EQ(graded_rows(5e-6, 1e-3, 1.), (std::vector<double>{0., 5e-6}));
}

TEST(SceneWarnings, of_a_way_on_which_the_contact_runs_in)
{
  // An asperity of R0 is 0.91 um long: 0.28 um is more than a quarter of it.
  SceneParameters parameters = coarse_scene();
  const auto      audit      = [&parameters]() {
    return audit_scene(parameters, Scene<2>(parameters)).warnings;
  };
  parameters.protocol.sliding_distance = 0.28e-6;
  parameters.resolve();
  EXPECT_FALSE(says(audit(), "running in"));
  parameters.protocol.sliding_distance = 0.1e-6;
  parameters.resolve();
  EXPECT_TRUE(says(audit(), "The chip slides only 100 nm, 0.11 of the length"));
}

TEST(SceneWarnings, of_a_load_that_grows_too_long_or_too_fast)
{
  SceneParameters parameters = coarse_scene();
  const auto      audit      = [&parameters]() {
    return audit_scene(parameters, Scene<2>(parameters)).warnings;
  };
  parameters.protocol.window_fraction = 0.5;
  parameters.protocol.ramp_fraction   = 0.45;
  EXPECT_FALSE(says(audit(), "The load still grows"));
  parameters.protocol.ramp_fraction = 0.5;
  EXPECT_TRUE(says(audit(), "The load still grows"));
  parameters.protocol.inertia       = Inertia::dynamic;
  parameters.protocol.ramp_fraction = 0.2; // 29 transits
  EXPECT_FALSE(says(audit(), "transits"));
  parameters.protocol.ramp_fraction = 0.05;
  EXPECT_TRUE(says(audit(), "The load grows within 7.3 transits"));
}

TEST(SceneWarnings, of_penalties_that_are_too_soft_or_too_hard)
{
  SceneParameters parameters = coarse_scene();
  const auto      audit      = [&parameters]() {
    return audit_scene(parameters, Scene<2>(parameters)).warnings;
  };
  EXPECT_FALSE(says(audit(), "enalty"));
  parameters.contact.penalty_factor = 1.;
  EXPECT_TRUE(says(audit(), "With a penalty factor of 1 small contacts"));
  parameters.contact.augmentations = 5;
  EXPECT_FALSE(says(audit(), "small contacts"));
  parameters.contact.penalty_factor = 1e8;
  EXPECT_TRUE(says(audit(), "the rounding of positions"));
}

TEST(SceneWarnings, of_a_loose_tolerance_between_chip_and_flow)
{
  SceneParameters parameters = flooded_scene();
  const auto      audit      = [&parameters]() {
    return audit_scene(parameters, Scene<2>(parameters)).warnings;
  };
  EXPECT_FALSE(says(audit(), "Coupling/Tolerance"));
  EXPECT_FALSE(says(audit(), "goes on ringing"));
  parameters.lubrication.coupling.tolerance = 1e-3;
  EXPECT_TRUE(says(audit(), "With Coupling/Tolerance = 0.001"));
}

TEST(SceneWarnings, of_a_chip_that_rings_in_long_steps)
{
  SceneParameters parameters = coarse_scene();
  const auto      audit      = [&parameters]() {
    return audit_scene(parameters, Scene<2>(parameters)).warnings;
  };
  EXPECT_FALSE(says(audit(), "goes on ringing"));
  parameters.protocol.inertia = Inertia::dynamic;
  EXPECT_TRUE(says(audit(), "expected with such steps is Protocol/Inertia"));
  parameters.protocol.spectral_radius = 0.;
  EXPECT_FALSE(says(audit(), "goes on ringing"));
}
