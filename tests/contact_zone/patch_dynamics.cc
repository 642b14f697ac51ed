#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene_examples.h"

using namespace asperity;

// The mass of a chip in three dimensions under a tool that is extruded across
// the motion: in plane strain, its momenta too.
TEST(PatchDynamics, extruded_tool_has_the_inertia_of_the_plane)
{
  SceneParameters parameters  = narrow_scene();
  parameters.protocol.inertia = Inertia::dynamic;
  const CompleteRunIn<3> patch(parameters);
  parameters.geometry.dimension = 2;
  const CompleteRun plane(parameters);
  parameters.protocol.inertia = Inertia::quasi_static;
  const CompleteRun without(parameters);
  ASSERT_EQ(patch.rows().size(), plane.rows().size());
  double by_inertia = 0.;
  for (std::size_t i = 1; i < plane.rows().size(); ++i)
    {
      const FrictionRow &a = patch.rows()[i], &b = plane.rows()[i];
      EXPECT_NEAR(a.T_x, b.T_x, 1e-6 * plane.load()) << "step " << i;
      EXPECT_NEAR(a.T_y, b.T_y, 1e-6 * plane.load());
      EXPECT_NEAR(a.T_transverse, 0., 1e-6 * plane.load());
      EXPECT_NEAR(a.mean_gap, b.mean_gap, 1e-6 * b.mean_gap);
      EXPECT_NEAR(a.max_plastic_strain,
                  b.max_plastic_strain,
                  1e-5 * b.max_plastic_strain);
      by_inertia =
        std::max(by_inertia, std::abs(b.T_y - without.rows()[i].T_y));
    }
  EXPECT_GT(by_inertia, 1e-3 * plane.load());
}
