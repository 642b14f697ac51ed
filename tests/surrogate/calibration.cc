#include <gtest/gtest.h>

#include <algorithm>

#include "calibration_example.h"

using namespace calibration_example;

// 95 % are promised; the scatter of a thousand points is 0.7 %, that of the law
// itself more.
TEST(Calibration, band_holds_other_runs)
{
  for (const auto &truth : {dry, lubricated})
    for (const double noise : {0., 0.01})
      {
        const Quality quality = judge(truth, noise, 110, everything);
        EXPECT_GT(quality.coverage, 0.9);
        EXPECT_LT(quality.coverage, 0.98);
        // an unbiased law would be wrong by the mean of |noise|, 0.8 noise
        EXPECT_LT(quality.error, 0.01 + noise);
      }
}



// The law itself says which faces its points stay away from.
TEST(Calibration, tells_a_face_without_runs)
{
  const auto says = [](const Quality &quality) {
    return std::count_if(quality.warnings.begin(),
                         quality.warnings.end(),
                         [](const std::string &warning) {
                           return warning.find("No run lies in the") == 0;
                         });
  };
  EXPECT_EQ(says(judge(dry, 0.002, 40, everything)), 0);
  const Quality quality =
    judge(dry, 0.002, 40, [](const double *z) { return is_off_face(1, z); });
  EXPECT_EQ(says(quality), 1);
  EXPECT_NE(quality.warnings.back().find("No run lies in the highest"),
            std::string::npos)
    << quality.warnings.back();
  EXPECT_NE(quality.warnings.back().find(" % of the range of p, where"),
            std::string::npos)
    << quality.warnings.back();
}



// The mean of |noise| is 0.8 of its deviation.
TEST(Calibration, tells_runs_that_scatter_too_much)
{
  const auto told = [](const double noise) {
    std::string found;
    for (const std::string &warning :
         judge(dry, noise, 80, everything).warnings)
      if (warning.find("Runs that are left out lie ") == 0)
        found = warning;
    return found;
  };
  EXPECT_EQ(told(0.01), "");
  EXPECT_NE(told(0.06).find(
              " % off the law in the mean, where 3 % is the most"),
            std::string::npos)
    << told(0.06);
}



// A slab at one face of the box without a run: the error stays small, and the
// band knows of most of it, but not of a change of behaviour that it has not
// seen. So a law is trusted inside of its box only.
TEST(Calibration, edge_blocks_left_out)
{
  for (const auto &truth : {dry, lubricated})
    {
      double mean_coverage = 0.;
      for (unsigned int face = 0; face < 6; ++face)
        {
          const auto is_trained = [face](const double *z) {
            return is_off_face(face, z);
          };
          const Quality quality = judge(truth, 0.002, 110, is_trained);
          EXPECT_GT(quality.coverage, 0.6) << face;
          EXPECT_LT(quality.error, 0.04) << face;
          mean_coverage += quality.coverage / 6.;
        }
      EXPECT_GT(mean_coverage, 0.85);
    }
}
