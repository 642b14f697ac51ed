#include <gtest/gtest.h>

#include "flooded_scene.h"

using namespace asperity;

// Where the surfaces are nearer than the sealing gap the oil is cut. Its amount
// stays the same to round-off, and the content of each pocket is that of its
// oil to what the iterations between chip and oil leave.
TEST(FlowPockets, falls_into_pockets_that_keep_their_oil)
{
  SceneParameters parameters         = flooded_scene();
  parameters.geometry.initial_gap    = 0.002e-6;
  parameters.lubrication.sealing_gap = 20e-9;
  for (const auto &[tolerance, compressible] :
       {std::pair{1e-5, false}, {1e-7, false}, {1e-5, true}})
    {
      SCOPED_TRACE(compressible);
      parameters.lubrication.coupling.tolerance = tolerance;
      parameters.lubrication.flow.compressible  = compressible;
      Scene<2>      scene(parameters);
      SlidingRun<2> run(parameters, scene);
      const double  start = scene.gap_flow->state().reference_volume;
      EXPECT_LT(scene.gap_flow->flow().volume(), start);
      run.run(
        [&, limit = tolerance, changes = compressible](const SlidingRun<2> &) {
          const LubricantState state = scene.gap_flow->state();
          EXPECT_NEAR(state.reference_volume, start, 1e-12 * start);
          if (!changes)
            {
              EXPECT_NEAR(state.oil_volume, start, 1e-12 * start);
            }
          EXPECT_LT(scene.gap_flow->volume_error(), limit);
        });
    }
}

TEST(FlowPockets, says_that_the_oil_has_no_room)
{
  SceneParameters parameters         = flooded_scene();
  parameters.lubrication.sealing_gap = 5e-6;
  try
    {
      const Scene<2> scene(parameters);
      FAIL();
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("no room to flow"),
                std::string::npos);
    }
}

// Flat surfaces close everywhere at once, as soon as the load has compressed
// the oil.
TEST(FlowPockets, says_that_its_room_vanishes)
{
  SceneParameters parameters               = flooded_scene();
  parameters.tool.kind                     = SurfaceKind::flat;
  parameters.chip                          = SurfaceParameters();
  parameters.chip.kind                     = SurfaceKind::flat;
  parameters.load.pressure                 = 5e6;
  parameters.lubrication.sealing_gap       = 0.9995 * 0.1e-6;
  parameters.lubrication.flow.compressible = true;
  Scene<2>      scene(parameters);
  SlidingRun<2> run(parameters, scene);
  std::string   message;
  try
    {
      run.run([](const SlidingRun<2> &) {});
    }
  catch (const ComputationError &error)
    {
      message = error.what();
    }
  EXPECT_GT(run.state().step, 0U);
  EXPECT_NE(message.find("no room to flow"), std::string::npos) << message;
}

namespace
{
  /** Nearly in touch, so that there are several pockets. */
  SceneParameters
  scene_with_pockets()
  {
    SceneParameters parameters               = flooded_scene();
    parameters.geometry.initial_gap          = 0.002e-6;
    parameters.lubrication.sealing_gap       = 60e-9;
    parameters.lubrication.flow.compressible = true;
    return parameters;
  }

  /** What building the scene says, or nothing. */
  std::string
  refusal(const SceneParameters &parameters)
  {
    try
      {
        const Scene<2> scene(parameters);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

// The oil of a part of the void carries nothing until the void has closed to
// it, and none is lost.
TEST(FlowPockets, oil_waits_until_it_fills_the_void)
{
  for (const bool compressible : {false, true})
    {
      SCOPED_TRACE(compressible);
      SceneParameters parameters               = scene_with_pockets();
      parameters.lubrication.wetting           = 0.95;
      parameters.lubrication.flow.compressible = compressible;
      Scene<2>       scene(parameters);
      SlidingRun<2>  run(parameters, scene);
      LubricantState start = scene.gap_flow->state();
      EXPECT_NEAR(start.reference_volume / start.void_volume, 0.95, 1e-12);
      EXPECT_TRUE(scene.gap_flow->flow().space().cells().empty());
      bool is_still = false, flows = false;
      run.run([&](const SlidingRun<2> &) {
        const LubricantState state = scene.gap_flow->state();
        EXPECT_NEAR(scene.gap_flow->pockets()->total(),
                    start.reference_volume,
                    1e-12 * start.reference_volume);
        if (scene.gap_flow->flow().space().cells().empty())
          {
            is_still = true;
            EXPECT_EQ(state.mean_pressure, 0.);
            EXPECT_GT(state.void_volume, 0.998 * start.reference_volume);
          }
        else
          flows = true;
      });
      EXPECT_TRUE(is_still);
      EXPECT_TRUE(flows);
    }
}

namespace
{
  /** How far the flow is off the model `pocket` in its pressure. */
  double
  difference_to_pocket(SceneParameters parameters)
  {
    const CompleteRun flow(parameters);
    parameters.lubrication.model = LubricantModel::pocket;
    const CompleteRun pocket(parameters);
    // The start is the same.
    EXPECT_NEAR(flow.rows()[1].oil_reference_volume /
                  pocket.rows()[1].oil_reference_volume,
                1.,
                1e-12);
    return std::abs(
      flow.rows().back().oil_pressure / pocket.rows().back().oil_pressure - 1.);
  }
} // namespace

// Where the oil slides slowly its flow makes no pressure of its own: chip, oil
// and contact share the load as the model `pocket` says, but for an error of
// mesh and steps. It falls with both.
TEST(FlowPockets, carry_as_the_model_pocket_where_the_flow_is_slow)
{
  SceneParameters parameters     = scene_with_pockets();
  parameters.lubrication.wetting = 0.9;
  parameters.load.velocity /= 10.;
  const double coarse = difference_to_pocket(parameters);
  EXPECT_LT(coarse, 0.1);
  SceneParameters finer = parameters;
  finer.mesh.spans *= 2;
  EXPECT_LT(difference_to_pocket(finer), 0.6 * coarse);
  finer = parameters;
  finer.protocol.ramp_steps *= 2;
  finer.protocol.slide_steps *= 2;
  EXPECT_LT(difference_to_pocket(finer), 0.6 * coarse);
}

// A cosine of two waves on a flat chip encloses two pockets of the same size,
// from 3.1 um to 6.9 um and across the end of the period of 10 um.
TEST(FlowPockets, hold_oil_where_it_is_asked_for)
{
  SceneParameters parameters     = scene_with_pockets();
  parameters.chip                = SurfaceParameters();
  parameters.chip.kind           = SurfaceKind::flat;
  parameters.tool.wave_numbers   = {2};
  parameters.tool.amplitudes     = {0.2e-6};
  parameters.tool.phases         = {0.};
  parameters.lubrication.pockets = {4e-6, 6e-6};
  const Scene<2>       scene(parameters);
  const LubricantState state = scene.gap_flow->state();
  EXPECT_EQ(state.n_pockets, 2U);
  EXPECT_NEAR(state.reference_volume / state.void_volume, 0.5, 1e-9);
  EXPECT_EQ(scene.gap_flow->flow().space().parts().size(), 1U);

  const auto expect = [](const std::string &text, const std::string &part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  parameters.lubrication.pockets = {4e-6, 9e-6};
  expect(refusal(parameters), "is below the sealing gap");
  parameters.lubrication.pockets = {12e-6, 13e-6};
  expect(refusal(parameters), "holds no column of the oil's mesh");
  parameters.lubrication.pockets = {4e-6, 5e-6, 5.1e-6, 6e-6};
  expect(refusal(parameters), "lies in the same pocket");
  parameters.lubrication.pockets = {1e-6, 3e-6, 2e-6, 4e-6};
  expect(complaint(parameters), "expected increasing values");
  parameters.lubrication.pockets = {1e-6, 3e-6, 4e-6};
  expect(complaint(parameters), "expected two for each interval");
  parameters.lubrication.sealing_gap = 0.;
  expect(complaint(parameters), "intervals without a Sealing gap");
}
