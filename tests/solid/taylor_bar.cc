#include "taylor_bar.h"

#include <gtest/gtest.h>

using namespace loaded_solid;

// Bands around the values of DynELA and Abaqus/Explicit, which are 26.52 and
// 26.56 mm, 11.15 and 11.16 mm, 582 and 591 degrees Celsius, 1.78 and 1.81, on
// 5 x 50 cells. Mesh, step and what is converged: tools/benchmarks/README.md.

TEST(TaylorBar, ShortensMushroomsAndHeatsAsPublished)
{
  const TaylorBarResult bar = taylor_bar(2, 8, 32, 1280, 0.5);
  EXPECT_NEAR(1e3 * bar.length / 26.52, 1., 0.005);
  EXPECT_NEAR(1e3 * bar.diameter / 11.15, 1., 0.015);
  EXPECT_GT(bar.temperature, 0.97 * 582.);
  EXPECT_LT(bar.temperature, 1.03 * 591.);
  EXPECT_NEAR(bar.plastic_strain / 1.81, 1., 0.05);
  EXPECT_LT(bar.kinetic_energy, 0.01); // the bar has come to rest
}
