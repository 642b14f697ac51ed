#include <gtest/gtest.h>

#include "problems.h"

using namespace asperity;

// A lining of ten times the fluid's density, and one as heavy as the fluid.
TEST(LinedChannel, dirichlet_neumann_stops_at_light_linings)
{
  const std::string coarse = "subsection Fluid\n set Cells along = 50\nend\n";
  const auto        heavy =
    make_problem(read_problem("lined_channel_dirichlet_neumann", coarse));
  const auto light = make_problem(
    read_problem("lined_channel_dirichlet_neumann",
                 coarse +
                   "subsection Material\n set Density = 1000 kg/m^3\nend\n"));
  bool light_converges = true;
  for (unsigned int i = 0; i < 10; ++i)
    {
      ASSERT_TRUE(heavy->system->advance(1e-4).converged);
      light_converges =
        light_converges && light->system->advance(1e-4).converged;
    }
  EXPECT_FALSE(light_converges);
}
