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
    FrictionRow without_time = a;
    without_time.wall_time   = b.wall_time;
    std::vector<double> first, second;
    for_each_entry(without_time,
                   [&](const auto entry) { first.push_back(entry); });
    for_each_entry(b, [&](const auto entry) { second.push_back(entry); });
    EXPECT_EQ(first, second) << "step " << a.step;
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

TEST(Restart, keeps_the_oil_of_each_pocket)
{
  SceneParameters parameters         = coarse_scene();
  parameters.load.pressure           = 1300e6;
  parameters.load.temperature        = 948.15;
  parameters.lubrication.model       = LubricantModel::pocket;
  parameters.lubrication.wetting     = 0.3;
  parameters.lubrication.sealing_gap = 20e-9;
  for (const unsigned int stop : {3, 8, 12})
    expect_identical_rest(parameters, stop);
  parameters.lubrication.oil.compressibility.law = DensityLaw::incompressible;
  parameters.lubrication.sealing_gap             = 0.;
  expect_identical_rest(parameters, 7);
}

TEST(Restart, keeps_the_oil_of_a_film)
{
  SceneParameters parameters     = coarse_scene();
  parameters.lubrication.model   = LubricantModel::reynolds;
  parameters.lubrication.wetting = 0.8;
  for (const unsigned int stop : {2, 9})
    expect_identical_rest(parameters, stop);
}

TEST(Restart, keeps_the_flow_in_the_gap_and_what_the_coupling_has_learnt)
{
  SceneParameters parameters       = coarse_scene();
  parameters.protocol.inertia      = Inertia::dynamic;
  parameters.protocol.slide_steps  = 5;
  parameters.lubrication.model     = LubricantModel::navier_stokes;
  parameters.lubrication.mesh.rows = 1;
  for (const unsigned int stop : {1, 6})
    expect_identical_rest(parameters, stop);
}
