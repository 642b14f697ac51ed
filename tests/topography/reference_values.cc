#include <asperity/topography/form_removal.h>
#include <asperity/topography/gaussian_filter.h>
#include <asperity/topography/missing_data.h>
#include <asperity/topography/read_height_map.h>
#include <asperity/topography/roughness.h>

#include "topography_test_tools.h"

using namespace asperity;
using namespace asperity_test;

// The expected values were computed with an independent numpy program:
// least-squares plane removed, all valid points, no filter.
namespace
{
  struct Reference
  {
    double Sa, Sq, Sz, Ssk, Sku;
    double skewness_tolerance, kurtosis_tolerance;
  };

  void
  expect_roughness(HeightMap map, const Reference &expected)
  {
    remove_form(map, 1);
    const auto a = areal_roughness(map);
    EXPECT_NEAR(a.Sa, expected.Sa, 5e-7 * expected.Sa);
    EXPECT_NEAR(a.Sq, expected.Sq, 5e-7 * expected.Sq);
    EXPECT_NEAR(a.Sz, expected.Sz, 5e-7 * expected.Sz);
    EXPECT_NEAR(a.Ssk, expected.Ssk, expected.skewness_tolerance);
    EXPECT_NEAR(a.Sku, expected.Sku, expected.kurtosis_tolerance);
  }
} // namespace

TEST(MeasuredSurfaces, alicona_scan)
{
  const auto file = measured("alicona_al3d-1.al3d");
  SKIP_WITHOUT(file);
  const HeightMap map = read_height_map(file);
  EXPECT_EQ(map.provenance.format, "AL3D");
  EXPECT_EQ(map.nx, 200u);
  EXPECT_EQ(map.ny, 296u);
  EXPECT_NEAR(map.length_x(), 87.6e-6, 0.05e-6);
  EXPECT_NEAR(map.length_y(), 129.7e-6, 0.05e-6);
  EXPECT_EQ(map.missing_fraction(), 0.);
  expect_roughness(map,
                   {2.301961e-07,
                    2.898221e-07,
                    2.086316e-06,
                    -0.00497653,
                    3.07127790,
                    1e-8,
                    1e-8});
}

TEST(MeasuredSurfaces, alicona_scan_L_filtered_at_25_um)
{
  const auto file = measured("alicona_al3d-1.al3d");
  SKIP_WITHOUT(file);
  HeightMap map = read_height_map(file);
  remove_form(map, 1);
  const auto waviness = areal_roughness(gaussian_low_pass(map, 25e-6));
  EXPECT_NEAR(waviness.Sq, 2.012054e-07, 5e-14);
  apply_l_filter(map, 25e-6);
  const auto roughness = areal_roughness(map);
  EXPECT_NEAR(roughness.Sq, 1.519845e-07, 5e-14);
  EXPECT_NEAR(roughness.Sz, 1.265548e-06, 5e-13);
}

TEST(MeasuredSurfaces, cut_wire_with_its_missing_points)
{
  const auto file = measured("wire_cut_aluminium.x3p");
  SKIP_WITHOUT(file);
  const HeightMap map = read_height_map(file);
  EXPECT_EQ(map.nx, 231u);
  EXPECT_EQ(map.ny, 172u);
  EXPECT_NEAR(map.missing_fraction(), 0.294, 0.0005);
  expect_roughness(map,
                   {5.185903e-06,
                    6.935955e-06,
                    5.014955e-05,
                    -0.27616228,
                    4.37988860,
                    1e-7,
                    1e-7});
}

TEST(MeasuredSurfaces, cut_wire_in_its_largest_rectangle_without_holes)
{
  const auto file = measured("wire_cut_aluminium.x3p");
  SKIP_WITHOUT(file);
  const HeightMap full   = read_height_map(file);
  const Window    window = largest_window_without_holes(full);
  EXPECT_EQ(window.column, 60u);
  EXPECT_EQ(window.row, 46u);
  EXPECT_EQ(window.nx, 136u);
  EXPECT_EQ(window.ny, 67u);
  HeightMap map = crop(full, window);
  EXPECT_NEAR(map.length_x(), 877e-6, 0.5e-6);
  EXPECT_NEAR(map.length_y(), 432e-6, 0.5e-6);
  expect_roughness(map,
                   {1.649472e-06,
                    2.114503e-06,
                    1.674345e-05,
                    -0.50694512,
                    3.06697443,
                    1e-7,
                    1e-7});

  remove_form(map, 1);
  const std::vector<double> row(&map(0, 30), &map(0, 31));
  const auto                r = profile_roughness(row, map.dx);
  EXPECT_NEAR(r.Rz, 5.650076e-06, 5e-13);
  EXPECT_NEAR(r.Rt, 1.056405e-05, 5e-12);
}

// The published values are those of the instrument's float32 micrometres; the
// file was converted to float32 metres, whose rounding (4 pm on 18 nm) moved
// them in the sixth digit. Rounding back gives the instrument's numbers.
TEST(MeasuredSurfaces, unidirectional_lay_in_the_instruments_own_numbers)
{
  const auto file = measured("sensofar_plu1_unidirectional.x3p");
  SKIP_WITHOUT(file);
  HeightMap map = read_height_map(file);
  EXPECT_EQ(map.nx, 768u);
  EXPECT_EQ(map.ny, 576u);
  for (double &z : map.heights)
    z = 1e-6 * static_cast<double>(static_cast<float>(1e6 * z));
  expect_roughness(map,
                   {1.462904e-08,
                    1.828196e-08,
                    5.749074e-07,
                    -0.44260348,
                    9.24489388,
                    1e-6,
                    1e-5});
}

TEST(MeasuredSurfaces, unidirectional_lay_as_the_file_stores_it)
{
  const auto file = measured("sensofar_plu1_unidirectional.x3p");
  SKIP_WITHOUT(file);
  expect_roughness(read_height_map(file),
                   {1.462901e-08,
                    1.828192e-08,
                    5.749080e-07,
                    -0.44261194,
                    9.24502974,
                    1e-6,
                    1e-5});
}

TEST(MeasuredSurfaces, bullet_land_inside_a_folder_of_its_archive)
{
  const auto file = measured("sample-land.x3p");
  SKIP_WITHOUT(file);
  const HeightMap map = read_height_map(file);
  EXPECT_EQ(map.nx, 918u);
  EXPECT_EQ(map.ny, 256u);
  EXPECT_NEAR(map.missing_fraction(), 0.10762186819172113, 1e-12);
  expect_roughness(map,
                   {2.901624e-05,
                    3.364028e-05,
                    1.356128e-04,
                    -0.47346397,
                    2.00578076,
                    1e-7,
                    1e-7});
}
