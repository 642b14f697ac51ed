#include <gtest/gtest.h>

#include "cook_membrane.h"
#include "thick_cylinder.h"

using namespace loaded_solid;

TEST(CookMembrane, rises_into_the_published_band_where_linear_splines_lock)
{
  // 6.9 to 7.4 mm over the literature since Simo and Armero (1992).
  const double fine = 1e3 * cook_membrane(4, 16, 10);
  EXPECT_GT(fine, 6.9);
  EXPECT_LT(fine, 7.4);
  EXPECT_NEAR(1e3 * cook_membrane(2, 16, 10) / fine, 1., 0.03);
  EXPECT_NEAR(1e3 * cook_membrane(3, 8, 10) / fine, 1., 0.03);
  EXPECT_LT(1e3 * cook_membrane(1, 16, 10) / fine, 0.7);
}



TEST(ThickCylinder, reference_pressure_tends_to_the_rigid_plastic_formula)
{
  // Volume changes are of the order of stress over bulk modulus, 0.7 %.
  for (const double a : {20e-3, 40e-3, 85e-3})
    EXPECT_NEAR(ThickCylinder::elastic_plastic_pressure(a) /
                  ThickCylinder::rigid_plastic_pressure(a),
                1.,
                0.02)
      << a;
}



TEST(ThickCylinder, expands_at_the_pressure_of_the_formula)
{
  const double exact = ThickCylinder::elastic_plastic_pressure(85e-3);
  EXPECT_NEAR(ThickCylinder::ring_pressure(2, 4, 75, 85e-3) / exact, 1., 1e-5);
  EXPECT_NEAR(ThickCylinder::ring_pressure(3, 4, 75, 85e-3) / exact, 1., 1e-6);
  EXPECT_NEAR(ThickCylinder::quarter_pressure(2, 3, 75, 85e-3) / exact,
              1.,
              1e-4);
}
