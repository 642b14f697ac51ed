#include <gtest/gtest.h>

#include <filesystem>

#include "scene_examples.h"

using namespace asperity;

namespace
{
  /** All but the time that the machine took. */
  void
  expect_identical(const FrictionRow &a, const FrictionRow &b)
  {
    EXPECT_EQ(a.step, b.step);
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.sliding_distance, b.sliding_distance);
    EXPECT_EQ(a.T_x, b.T_x);
    EXPECT_EQ(a.T_y, b.T_y);
    EXPECT_EQ(a.mu, b.mu);
    EXPECT_EQ(a.contact_fraction, b.contact_fraction);
    EXPECT_EQ(a.max_contact_pressure, b.max_contact_pressure);
    EXPECT_EQ(a.max_plastic_strain, b.max_plastic_strain);
    EXPECT_EQ(a.max_temperature, b.max_temperature);
    EXPECT_EQ(a.mean_gap, b.mean_gap);
    EXPECT_EQ(a.max_penetration, b.max_penetration);
    EXPECT_EQ(a.newton_iterations, b.newton_iterations);
    EXPECT_EQ(a.factorisations, b.factorisations);
  }

  /** Runs to the end, keeps the state after a step on disk, and runs from
   *  there again. */
  void
  expect_identical_rest(const SceneParameters &parameters,
                        const unsigned int     stop)
  {
    const std::string folder =
      std::filesystem::temp_directory_path().string() + "/asperity_restart_" +
      testing::UnitTest::GetInstance()->current_test_info()->name() +
      std::to_string(stop);
    std::filesystem::remove_all(folder);
    const CheckpointFolder checkpoints(folder);
    // The observer needs the scene of the run, so there is no CompleteRun.
    Scene      scene(parameters);
    SlidingRun run(parameters, scene);
    run.run([&](const SlidingRun &now) {
      if (now.state().step == stop)
        checkpoints.write(save(now, scene), stop);
    });

    Scene      second_scene(parameters);
    SlidingRun second(parameters, second_scene);
    load(checkpoints.read_newest().checkpoint, second, second_scene);
    EXPECT_EQ(second.state().step, stop);
    second.run([](const SlidingRun &) {});
    std::filesystem::remove_all(folder);

    ASSERT_EQ(second.state().rows.size(), run.state().rows.size());
    for (std::size_t i = 0; i < run.state().rows.size(); ++i)
      expect_identical(run.state().rows[i], second.state().rows[i]);
    EXPECT_EQ(second.state().u, run.state().u);
    EXPECT_EQ(second_scene.chip->history().size(),
              scene.chip->history().size());
    for (std::size_t q = 0; q < scene.chip->history().size(); ++q)
      EXPECT_EQ(second_scene.chip->history()[q].plastic_strain,
                scene.chip->history()[q].plastic_strain);
  }
} // namespace

TEST(Restart, goes_on_identically_from_any_quasi_static_step)
{
  for (const unsigned int stop : {1, 4, 9, 14})
    expect_identical_rest(coarse_scene(), stop);
}

TEST(Restart, goes_on_identically_in_a_dynamic_run)
{
  SceneParameters parameters  = coarse_scene();
  parameters.protocol.inertia = Inertia::dynamic;
  for (const unsigned int stop : {1, 7})
    expect_identical_rest(parameters, stop);
}

TEST(Restart, keeps_the_multipliers_of_augmented_contact)
{
  SceneParameters parameters               = coarse_scene();
  parameters.contact.augmentations         = 2;
  parameters.contact.penetration_tolerance = 1e-12;
  expect_identical_rest(parameters, 8);
}

TEST(Restart, keeps_what_a_steady_window_has_seen)
{
  SceneParameters parameters           = coarse_scene();
  parameters.protocol.window           = FrictionWindow::steady;
  parameters.protocol.steady_distance  = 0.2e-6;
  parameters.protocol.steady_step      = 60e-9;
  parameters.protocol.steady_tolerance = 0.1;
  parameters.protocol.maximum_distance = 1.5e-6;
  expect_identical_rest(parameters, 7);
}
