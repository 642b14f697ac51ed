#include <gtest/gtest.h>

#include "channel_examples.h"

using namespace flow_examples;

// Reference values of the Featflow group.
TEST(ChannelFlow, dfg_cylinder_at_reynolds_20)
{
  const auto c = dfg_2d_1(2, 1, 3);
  EXPECT_NEAR(c.drag, 5.57953523384, 1e-4 * 5.57953523384);
  EXPECT_NEAR(c.lift, 0.010618948146, 1e-4 * 0.010618948146);
  EXPECT_NEAR(c.pressure_difference, 0.11752016697, 1e-4 * 0.11752016697);
}



// Drag and lift of cylinder and flag. CFD2 needs a finer mesh, see
// tools/benchmarks.
TEST(ChannelFlow, turek_hron_cfd1)
{
  const auto force = turek_hron_cfd(0.2, 2, 3);
  EXPECT_NEAR(force[0], 14.292672, 1e-3 * 14.292672);
  EXPECT_NEAR(force[1], 1.118978, 1e-3 * 1.118978);
}



// Extrema of the velocity on the centre lines at Reynolds number 100; Ghia's
// own accuracy is about one per cent.
TEST(ChannelFlow, lid_cavity_of_ghia)
{
  LidCavity cavity(16);
  cavity.solve_at(100.);
  EXPECT_NEAR(cavity.flow->velocity_at({0.5, 0.4531})[0], -0.21090, 0.015);
  EXPECT_NEAR(cavity.flow->velocity_at({0.2344, 0.5})[1], 0.17527, 0.01);
  EXPECT_NEAR(cavity.flow->velocity_at({0.8047, 0.5})[1], -0.24533, 0.01);
}
