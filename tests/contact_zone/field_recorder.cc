#include <asperity/base/errors.h>
#include <asperity/contact_zone/field_recorder.h>
#include <asperity/contact_zone/friction_result.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../files.h"
#include "scene_examples.h"

using namespace asperity;

namespace
{
  /** A run whose fields are taken. */
  struct RecordedRun
  {
    explicit RecordedRun(const SceneParameters &given)
      : parameters(given)
      , scene(parameters)
      , run(parameters, scene)
      , recorder(parameters, scene)
    {
      run.run([&](const SlidingRun<2> &now) { recorder.step(now); });
    }

    const SceneParameters parameters;
    Scene<2>              scene;
    SlidingRun<2>         run;
    FieldRecorder         recorder;
  };

  SceneParameters
  recorded_scene()
  {
    SceneParameters parameters    = coarse_scene();
    parameters.solver.tolerance   = 1e-9;
    parameters.output.field_times = {0.2, 0.5, 1.};
    return parameters;
  }

  /** mu of the tractions against that of the row, and the balance of stress and
   *  load against Newton's tolerance. */
  void
  expect_balance(const RecordedRun &run)
  {
    const FieldSnapshots &fields = run.recorder.fields();
    ASSERT_TRUE(fields.is_complete());
    for (const FieldSnapshot &snapshot : fields.snapshots)
      {
        const auto   force = force_of_tractions(fields, snapshot.values);
        const double load  = snapshot.pressure * run.scene.length;
        EXPECT_NEAR(friction_coefficient(force[0],
                                         force[1],
                                         snapshot.direction),
                    snapshot.mu,
                    1e-10);
        EXPECT_NEAR(force[1] / load, -1., 1e-7);
        const auto imbalance = imbalance_of_stress(fields, snapshot.values);
        EXPECT_NEAR(imbalance[0] / load, 0., 1e-7);
        EXPECT_NEAR(imbalance[1] / load, 0., 1e-7);
      }
  }
} // namespace

TEST(FieldRecorder, takes_tractions_that_give_mu_and_balance_stress_and_load)
{
  expect_balance(RecordedRun(recorded_scene()));
}

TEST(FieldRecorder, takes_the_shear_of_the_interface_along)
{
  SceneParameters parameters                = recorded_scene();
  parameters.interface.law                  = InterfaceShear::coulomb;
  parameters.interface.friction_coefficient = 0.1;
  const RecordedRun run(parameters);
  expect_balance(run);
  const FieldSnapshots &fields = run.recorder.fields();
  const auto           &shear =
    fields.snapshots.back().values[fields.find(field_names::shear_traction)];
  EXPECT_GT(*std::max_element(shear.begin(), shear.end()), 0.);
}

// The pressure of oil in sealed pockets is all that it does to the edge: what
// is left of the force is rounding, which is no field.
TEST(FieldRecorder, takes_the_oil_along)
{
  SceneParameters parameters     = recorded_scene();
  parameters.lubrication.model   = LubricantModel::pocket;
  parameters.lubrication.wetting = 1.;
  const RecordedRun     run(parameters);
  const FieldSnapshots &fields = run.recorder.fields();
  ASSERT_TRUE(fields.is_complete());
  for (const FieldSnapshot &snapshot : fields.snapshots)
    {
      const auto &oil = snapshot.values[fields.find(field_names::oil_pressure)];
      EXPECT_GT(*std::max_element(oil.begin(), oil.end()), 0.);
      const auto force = force_of_tractions(fields, snapshot.values);
      EXPECT_NEAR(friction_coefficient(force[0], force[1], 1.),
                  snapshot.mu,
                  1e-12);
      EXPECT_EQ(snapshot.values[fields.find(field_names::further_force)],
                std::vector<double>({0., 0.}));
    }
}

// A film shears the chip beside its pressure.
TEST(FieldRecorder, takes_the_shear_of_a_film_along)
{
  SceneParameters parameters     = recorded_scene();
  parameters.lubrication.model   = LubricantModel::reynolds;
  parameters.lubrication.wetting = 1.;
  const RecordedRun     run(parameters);
  const FieldSnapshots &fields = run.recorder.fields();
  ASSERT_TRUE(fields.is_complete());
  const auto &last  = fields.snapshots.back();
  const auto  force = force_of_tractions(fields, last.values);
  EXPECT_NEAR(friction_coefficient(force[0], force[1], 1.), last.mu, 1e-12);
  const double shear = run.run.state().rows.back().shear_T_x;
  EXPECT_GT(std::abs(shear), 1e-3 * std::abs(last.T_x));
  EXPECT_NEAR(last.values[fields.find(field_names::further_force)][0] / shear,
              1.,
              1e-9);
}

TEST(FieldRecorder, takes_the_first_step_at_or_after_each_time)
{
  const RecordedRun     run(recorded_scene());
  const FieldSnapshots &fields = run.recorder.fields();
  const double          end    = run.run.protocol().end_time();
  // five steps to 0.2 t_end, ten of 0.08 t_end behind it
  ASSERT_EQ(fields.snapshots.size(), 3u);
  EXPECT_EQ(fields.snapshots[0].step, 5u);
  EXPECT_EQ(fields.snapshots[1].step, 9u);
  EXPECT_NEAR(fields.snapshots[1].time, 0.52 * end, 1e-9 * end);
  EXPECT_EQ(fields.snapshots[2].step, 15u);
}

TEST(FieldRecorder, has_the_same_places_at_any_load_and_others_on_another_mesh)
{
  const SceneParameters parameters = recorded_scene();
  SceneParameters       hotter = parameters, finer = parameters;
  hotter.load.pressure    = 900e6;
  hotter.load.temperature = 600.;
  finer.mesh.spans *= 2;
  const auto places = [](const SceneParameters &p) {
    const Scene<2> scene(p);
    return FieldRecorder(p, scene).fields().places;
  };
  EXPECT_TRUE(places(parameters).is_same_as(places(hotter)));
  EXPECT_FALSE(places(parameters).is_same_as(places(finer)));
  // weights are areas and lengths
  const FieldPlaces found = places(parameters);
  for (const PlaceKind kind :
       {PlaceKind::nodes, PlaceKind::points, PlaceKind::edge})
    {
      double sum = 0.;
      for (std::size_t i = 0; i < found.n_places(kind); ++i)
        sum += found.weight(kind, i);
      const double expected =
        parameters.geometry.length *
        (kind == PlaceKind::edge ? 1. : parameters.geometry.height);
      EXPECT_NEAR(sum / expected, 1., 1e-12);
    }
}

TEST(FieldRecorder, goes_on_with_what_was_taken_before_a_checkpoint)
{
  const std::string path = test_folder() + "/fields.h5";
  const RecordedRun run(recorded_scene());
  run.recorder.fields().write(path);
  RunState state = run.run.state();
  state.step     = 9;
  state.time *= 0.52;
  FieldRecorder again(run.parameters, run.scene);
  again.go_on(path, state);
  EXPECT_EQ(again.fields().snapshots.size(), 2u);
  EXPECT_EQ(again.fields().snapshots[1].values,
            run.recorder.fields().snapshots[1].values);

  const auto message = [&](const SceneParameters &parameters) {
    const Scene<2> scene(parameters);
    FieldRecorder  recorder(parameters, scene);
    return message_of<InputError>([&]() { recorder.go_on(path, state); });
  };
  SceneParameters other    = run.parameters;
  other.output.field_times = {0.2, 0.4, 1.};
  EXPECT_NE(message(other).find("other Field times"), std::string::npos);
  other            = run.parameters;
  other.mesh.spans = 80;
  EXPECT_NE(message(other).find("another mesh"), std::string::npos);
  FieldSnapshots few = run.recorder.fields();
  few.snapshots.resize(1);
  few.write(path);
  EXPECT_NE(message(run.parameters).find("misses the fields at 0.5"),
            std::string::npos);
  std::filesystem::remove(path);
  EXPECT_NE(message(run.parameters).find("could not be opened"),
            std::string::npos);
}
