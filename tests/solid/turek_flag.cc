#include "turek_flag.h"

#include <gtest/gtest.h>

using namespace loaded_solid;

// Reference values: S. Turek, J. Hron (2006) and the refined values of the
// FeatFlow benchmark page, in millimetres.

TEST(TurekFlag, HangsAsInTheBenchmarkCsm1)
{
  const auto tip = hanging_flag_tip(4, 24, 3, 0.5e6);
  EXPECT_NEAR(1e3 * tip[0] / -7.187190, 1., 1e-3);
  EXPECT_NEAR(1e3 * tip[1] / -66.099802, 1., 1e-3);
}



TEST(TurekFlag, HangsAsInTheBenchmarkCsm2)
{
  const auto tip = hanging_flag_tip(4, 24, 3, 2e6);
  EXPECT_NEAR(1e3 * tip[0] / -0.4690, 1., 1e-3);
  EXPECT_NEAR(1e3 * tip[1] / -16.97, 1., 1e-3);
}



TEST(TurekFlag, SwingsAsInTheBenchmarkCsm3)
{
  // The published value belongs to this step; it is not yet converged in time
  // (see tools/benchmarks/README.md).
  const Oscillation swing = swinging_flag(3, 12, 2, 0.005, 10., 1.);
  EXPECT_NEAR(1e3 * swing.mean[0] / -14.305, 1., 1e-2);
  EXPECT_NEAR(1e3 * swing.amplitude[0] / 14.305, 1., 1e-2);
  EXPECT_NEAR(1e3 * swing.mean[1] / -63.607, 1., 1e-2);
  EXPECT_NEAR(1e3 * swing.amplitude[1] / 65.160, 1., 1e-2);
  EXPECT_NEAR(swing.frequency / 1.0995, 1., 1e-2);
}
