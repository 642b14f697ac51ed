#include <asperity/base/parameters.h>
#include <asperity/topography/commands.h>
#include <asperity/topography/form_removal.h>
#include <asperity/topography/make_profile.h>
#include <asperity/topography/read_height_map.h>
#include <asperity/topography/roughness.h>

#include "topography_test_tools.h"

using namespace asperity;
using namespace asperity_test;

// The two tool surfaces of the repository have the Rz of those of Lee (2025).
namespace
{
  HeightMap
  read_level(const std::string &name)
  {
    HeightMap map = read_height_map(std::string(ASPERITY_SOURCE_DIR) +
                                    "/parameter_files/surfaces/" + name);
    remove_form(map, 1);
    return map;
  }

  /** Mean of Rz (ISO 4287) over all rows, or all columns. */
  double
  mean_Rz(const HeightMap &map, const bool rows)
  {
    const unsigned int n_lines = rows ? map.ny : map.nx;
    double             sum     = 0.;
    for (unsigned int line = 0; line < n_lines; ++line)
      {
        std::vector<double> heights;
        for (unsigned int k = 0; k < (rows ? map.nx : map.ny); ++k)
          heights.push_back(rows ? map(k, line) : map(line, k));
        sum += profile_roughness(heights, rows ? map.dx : map.dy).Rz;
      }
    return sum / n_lines;
  }
} // namespace

TEST(GeneratedSurfaces, polished_tool_has_its_Rz_in_both_directions)
{
  const HeightMap map = read_level("polished_tool.x3p");
  EXPECT_NEAR(mean_Rz(map, true), 0.29e-6, 0.01 * 0.29e-6);
  EXPECT_NEAR(mean_Rz(map, false), 0.26e-6, 0.01 * 0.26e-6);
  EXPECT_GT(map.missing_fraction(), 0.);
  EXPECT_LT(map.missing_fraction(), 0.005);
  EXPECT_TRUE(map.provenance.warnings.empty());
}

TEST(GeneratedSurfaces, blasted_tool_is_isotropic_and_has_its_Rz)
{
  const HeightMap map = read_level("blasted_tool.x3p");
  EXPECT_NEAR(mean_Rz(map, true), 0.96e-6, 0.01 * 0.96e-6);
  EXPECT_NEAR(mean_Rz(map, false), 0.96e-6, 0.01 * 0.96e-6);
  EXPECT_GT(map.missing_fraction(), 0.);
  EXPECT_LT(map.missing_fraction(), 0.005);
}

TEST(GeneratedSurfaces, profiles_become_periodic_without_losing_roughness)
{
  for (const char *name : {"polished_tool.x3p", "blasted_tool.x3p"})
    for (const char *position : {"middle", "20 um", "140 um"})
      {
        TopographyParameters parameters;
        parameters.file = std::string(ASPERITY_SOURCE_DIR) +
                          "/parameter_files/surfaces/" + name;
        parameters.position = position;
        TopographyReport report;
        const Profile    profile = make_profile(parameters, report);
        EXPECT_NEAR(profile.length(), 160e-6, 1e-6);
        const auto &c = report.continuation;
        EXPECT_NEAR(c.Rq_after, c.Rq_before, 0.25 * c.Rq_before);
        EXPECT_LT(std::abs(c.jump_after), 0.1 * report.measured_roughness.Rz);
        EXPECT_LT(c.max_slope_after, 1.1 * c.max_slope_before);
      }
}
