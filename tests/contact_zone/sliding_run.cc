#include <asperity/base/errors.h>
#include <asperity/contact_zone/scene_input.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "../files.h"
#include "scene_examples.h"

using namespace asperity;

// Expected values are balances, symmetries and limits of the model.

TEST(SlidingRun, carries_the_load_at_every_quasi_static_step)
{
  for (const auto formulation :
       {ContactFormulation::mortar, ContactFormulation::gauss_point})
    {
      SceneParameters parameters     = coarse_scene();
      parameters.contact.formulation = formulation;
      const CompleteRun run(parameters);
      ASSERT_GE(run.rows().size(), 16u);
      for (const FrictionRow &row : run.rows())
        EXPECT_NEAR(row.T_y,
                    -run.run.protocol().pressure(row.time) * run.scene.length,
                    1e-3 * run.load())
          << "step " << row.step;
    }
}

TEST(SlidingRun, a_tighter_tolerance_balances_the_load_more_closely)
{
  SceneParameters parameters  = coarse_scene();
  parameters.solver.tolerance = 1e-8;
  const CompleteRun run(parameters);
  for (const FrictionRow &row : run.rows())
    EXPECT_NEAR(row.T_y,
                -run.run.protocol().pressure(row.time) * run.scene.length,
                1e-7 * run.load());
}

TEST(SlidingRun, friction_acts_against_the_motion_of_the_chip)
{
  const CompleteRun run(coarse_scene());
  for (const FrictionRow &row : run.rows())
    if (row.time > 0.5 * 2.5e-7)
      {
        EXPECT_LT(row.T_x, 0.);
        EXPECT_DOUBLE_EQ(row.mu, row.T_x / row.T_y);
      }
  // Without adhesion no point of the tool resists more than its slope.
  EXPECT_LT(run.run.friction().mu, run.scene.tool_surface.largest_slope());
}

TEST(SlidingRun, moving_tool_by_whole_elements_changes_nothing)
{
  SceneParameters   parameters = coarse_scene();
  const CompleteRun here(parameters);
  shift_tool(parameters, 7. / 20. * parameters.geometry.length);
  const CompleteRun there(parameters);
  for (std::size_t i = 0; i < here.rows().size(); ++i)
    {
      EXPECT_NEAR(here.rows()[i].T_x, there.rows()[i].T_x, 1e-4 * here.load());
      EXPECT_NEAR(here.rows()[i].max_plastic_strain,
                  there.rows()[i].max_plastic_strain,
                  1e-3);
    }
}

TEST(SlidingRun, moving_tool_by_a_part_of_an_element_changes_mu_by_mesh_error)
{
  SceneParameters parameters = coarse_scene();
  const double    mu         = CompleteRun(parameters).run.friction().mu;
  shift_tool(parameters, 0.3 / 40. * parameters.geometry.length);
  EXPECT_NEAR(CompleteRun(parameters).run.friction().mu, mu, 0.03 * mu);
}

TEST(SlidingRun, mirror_image_has_the_mirrored_forces)
{
  SceneParameters   parameters = coarse_scene();
  const CompleteRun original(parameters);
  for (double &phase : parameters.tool.phases)
    phase *= -1.;
  parameters.load.velocity *= -1.;
  const CompleteRun image(parameters);
  for (std::size_t i = 0; i < original.rows().size(); ++i)
    {
      const FrictionRow &a = original.rows()[i], &b = image.rows()[i];
      EXPECT_NEAR(a.T_x, -b.T_x, 1e-4 * original.load());
      EXPECT_NEAR(a.T_y, b.T_y, 1e-4 * original.load());
      EXPECT_NEAR(a.contact_fraction, b.contact_fraction, 1e-2);
    }
}

TEST(SlidingRun, elastic_sliding_over_an_even_tool_has_no_friction)
{
  // Without plastic flow the chip stores and returns the work: the load turns
  // into a standing wave below the tool, and T_x is that of a symmetric
  // contact. Only the chip's slow shear that follows the tool remains.
  SceneParameters parameters     = coarse_scene();
  parameters.tool.wave_numbers   = {1.};
  parameters.tool.amplitudes     = {0.02e-6};
  parameters.tool.phases         = {0.3};
  parameters.load.pressure       = 30e6;
  parameters.load.plastic_strain = 5.;
  const CompleteRun run(parameters);
  ASSERT_EQ(run.rows().back().max_plastic_strain, 5.);
  EXPECT_NEAR(run.rows().back().T_x, 0., 1e-3 * run.load());
}

TEST(SlidingRun, penetration_falls_with_the_penalty)
{
  SceneParameters parameters        = coarse_scene();
  parameters.contact.penalty_factor = 2.;
  const CompleteRun soft(parameters);
  parameters.contact.penalty_factor = 20.;
  const CompleteRun hard(parameters);
  // Nearly the same pressures on ten times the stiffness.
  const double violation = soft.scene.contact->state().constraint_violation;
  EXPECT_NEAR(hard.scene.contact->state().constraint_violation,
              0.1 * violation,
              0.05 * violation);
}

TEST(SlidingRun, augmentation_removes_penetration)
{
  SceneParameters parameters               = coarse_scene();
  parameters.contact.penalty_factor        = 2.;
  parameters.contact.penetration_tolerance = 0.1e-9;
  const CompleteRun plain(parameters);
  EXPECT_GT(plain.scene.contact->state().constraint_violation, 1e-9);
  parameters.contact.augmentations = 20;
  const CompleteRun augmented(parameters);
  EXPECT_LE(augmented.scene.contact->state().constraint_violation, 0.1e-9);
  EXPECT_NEAR(augmented.rows().back().T_y,
              -augmented.load(),
              1e-3 * augmented.load());
}

TEST(SlidingRun, a_hardened_chip_is_ploughed_less)
{
  SceneParameters   parameters = coarse_scene();
  const CompleteRun soft(parameters);
  parameters.load.plastic_strain = 2.;
  const CompleteRun hard(parameters);
  EXPECT_EQ(hard.rows().front().max_plastic_strain, 2.);
  EXPECT_LT(hard.run.friction().mu, 0.95 * soft.run.friction().mu);
  EXPECT_LT(hard.rows().back().contact_fraction,
            soft.rows().back().contact_fraction);
  EXPECT_GT(hard.rows().back().max_contact_pressure,
            soft.rows().back().max_contact_pressure);
}

TEST(SlidingRun, a_hot_chip_yields_more)
{
  SceneParameters parameters = coarse_scene();
  parameters.mesh.spans      = 80;
  parameters.mesh.refinement = 2;
  const CompleteRun cold(parameters);
  parameters.load.temperature = 675. + 273.15;
  const CompleteRun hot(parameters);
  EXPECT_GT(hot.rows().back().contact_fraction,
            1.1 * cold.rows().back().contact_fraction);
  EXPECT_LT(hot.rows().back().max_contact_pressure,
            0.8 * cold.rows().back().max_contact_pressure);
  EXPECT_LT(hot.rows().back().mean_gap, cold.rows().back().mean_gap);
  for (const FrictionRow &row : hot.rows())
    EXPECT_GE(row.max_temperature, parameters.load.temperature);
}

TEST(SlidingRun, gauss_point_contact_agrees_with_mortar)
{
  SceneParameters parameters = coarse_scene();
  parameters.mesh.spans      = 80;
  parameters.mesh.refinement = 2;
  const CompleteRun mortar(parameters);
  parameters.contact.formulation = ContactFormulation::gauss_point;
  const CompleteRun gauss_point(parameters);
  const double      mu = mortar.run.friction().mu;
  EXPECT_NEAR(gauss_point.run.friction().mu, mu, 0.01 * mu);
}

// Another discretization of the same chip: they differ by what their meshes
// err.
TEST(SlidingRun, finite_elements_have_the_mu_of_splines)
{
  SceneParameters parameters = coarse_scene();
  parameters.mesh.spans      = 80;
  parameters.mesh.refinement = 2;
  const CompleteRun splines(parameters);
  parameters.mesh.continuity = Continuity::continuous;
  const CompleteRun elements(parameters);
  EXPECT_GT(elements.scene.space->n_functions(),
            3 * splines.scene.space->n_functions());
  EXPECT_NEAR(elements.run.friction().mu,
              splines.run.friction().mu,
              0.02 * splines.run.friction().mu);
}

TEST(SlidingRun, finite_elements_are_for_dry_profiles_on_a_mesh_that_stays)
{
  const std::vector<std::pair<std::string, std::string>> others = {
    {"Geometry/Dimension", "3"},
    {"Lubrication/Model", "pocket"},
    {"Mesh/Adaptive levels", "1"}};
  for (const auto &[path, value] : others)
    {
      dealii::ParameterHandler handler;
      ParameterDeclarator      declarator(handler);
      SceneParameters          parameters;
      parameters.declare(declarator);
      declarator.set("Mesh/Continuity", "C0");
      EXPECT_NO_THROW(parameters.check(declarator));
      declarator.set(path, value);
      const std::string message =
        message_of<InputError>([&]() { parameters.check(declarator); });
      EXPECT_EQ(message.find("entry 'Mesh/Continuity': found C0 with "), 0u)
        << message;
      EXPECT_NE(message.find("expected smooth, or " + path), std::string::npos)
        << message;
    }
}

TEST(SlidingRun, inertia_changes_little_at_200_m_per_min)
{
  // 0.03 to 0.6 % by an independent code; the rest is the time step.
  SceneParameters parameters      = coarse_scene();
  parameters.protocol.ramp_steps  = 20;
  parameters.protocol.slide_steps = 40;
  const double mu                 = CompleteRun(parameters).run.friction().mu;
  parameters.protocol.inertia     = Inertia::dynamic;
  const CompleteRun dynamic(parameters);
  ASSERT_TRUE(dynamic.run.solid_step().is_dynamic());
  EXPECT_NEAR(dynamic.run.friction().mu, mu, 0.02 * mu);
  EXPECT_NEAR(dynamic.run.friction().T_y,
              -dynamic.load(),
              0.01 * dynamic.load());
}

TEST(SlidingRun, steady_window_ends_when_two_means_agree)
{
  SceneParameters parameters           = coarse_scene();
  parameters.protocol.window           = FrictionWindow::steady;
  parameters.protocol.steady_distance  = 0.3e-6;
  parameters.protocol.steady_step      = 60e-9;
  parameters.protocol.steady_tolerance = 0.05;
  parameters.protocol.maximum_distance = 4e-6;
  const CompleteRun run(parameters);
  EXPECT_TRUE(run.run.is_steady());
  const double slid = run.rows().back().sliding_distance;
  EXPECT_LT(slid, 4e-6);
  const double v = parameters.load.velocity;
  const double last =
    average_friction(run.rows(), (slid - 0.3e-6) / v, slid / v).mu;
  const double before =
    average_friction(run.rows(), (slid - 0.6e-6) / v, (slid - 0.3e-6) / v).mu;
  EXPECT_LE(std::abs(last - before), 0.05 * last);
  EXPECT_DOUBLE_EQ(run.run.friction().mu, last);
}

TEST(SlidingRun, unsteady_run_ends_at_the_maximal_distance)
{
  SceneParameters parameters           = coarse_scene();
  parameters.protocol.window           = FrictionWindow::steady;
  parameters.protocol.steady_distance  = 0.2e-6;
  parameters.protocol.steady_step      = 60e-9;
  parameters.protocol.steady_tolerance = 1e-9;
  parameters.protocol.maximum_distance = 0.9e-6;
  const CompleteRun run(parameters);
  EXPECT_FALSE(run.run.is_steady());
  EXPECT_NEAR(run.rows().back().sliding_distance, 0.9e-6, 1e-15);
}

TEST(SlidingRun, slides_on_over_the_period_of_the_tool)
{
  // The chip leaves its period: forces stay finite and in balance.
  SceneParameters parameters      = coarse_scene();
  parameters.load.velocity        = 50.;
  parameters.protocol.slide_steps = 60;
  const CompleteRun run(parameters);
  EXPECT_GT(run.rows().back().sliding_distance, 1.2 * run.scene.length);
  for (const FrictionRow &row : run.rows())
    EXPECT_NEAR(row.T_y,
                -run.run.protocol().pressure(row.time) * run.scene.length,
                1e-3 * run.load());
}

TEST(SlidingRun, gives_up_with_the_last_good_state)
{
  SceneParameters parameters           = coarse_scene();
  parameters.solver.maximum_iterations = 1;
  parameters.solver.maximum_cuts       = 0;
  Scene<2>      scene(parameters);
  SlidingRun<2> run(parameters, scene);
  unsigned int  n_good = 0;
  try
    {
      run.run([&](const SlidingRun<2> &) { ++n_good; });
      FAIL() << "one iteration a step is not enough";
    }
  catch (const ComputationError &error)
    {
      EXPECT_NE(std::string(error.what()).find("failed after 0 cuts"),
                std::string::npos)
        << error.what();
    }
  EXPECT_EQ(run.state().step, n_good);
  EXPECT_EQ(run.state().rows.size(), n_good + 1);
}

// No step may let the plastic strain grow by more than the limit anywhere, and
// steps grow by a factor of two at most, up to the regular ones.
TEST(SlidingRun, halves_steps_in_which_the_strain_grows_too_much)
{
  const CompleteRun regular(coarse_scene());
  const double      limit              = 0.05;
  SceneParameters   parameters         = coarse_scene();
  parameters.protocol.strain_increment = limit;
  Scene<2>                   scene(parameters);
  SlidingRun<2>              run(parameters, scene);
  std::vector<MaterialState> before  = scene.chip->history();
  double                     largest = 0.;
  run.run([&](const SlidingRun<2> &) {
    const std::vector<MaterialState> &after = scene.chip->history();
    for (std::size_t q = 0; q < after.size(); ++q)
      largest =
        std::max(largest, after[q].plastic_strain - before[q].plastic_strain);
    before = after;
  });
  EXPECT_LE(largest, limit);
  EXPECT_GT(largest, 0.25 * limit);
  const std::vector<FrictionRow> &rows = run.state().rows;
  EXPECT_GT(rows.size(), regular.rows().size());
  EXPECT_GT(run.n_cuts(), 0u);
  for (std::size_t i = 2; i < rows.size(); ++i)
    EXPECT_LE(rows[i].time - rows[i - 1].time,
              2. * (rows[i - 1].time - rows[i - 2].time) * (1. + 1e-9));
  EXPECT_DOUBLE_EQ(rows.back().time, parameters.protocol.end_time);
}
