#include <gtest/gtest.h>

#include <cmath>

#include "quarter_of_block.h"

namespace
{
  using example::QuarterOfBlock;

  // H. Hertz: a^3 = 3 F R/(4 E*), p0 = 3 F/(2 pi a^2), and
  // p^2 = p0^2 (1 - r^2/a^2), of which a line through p^2 over r^2 tells p0 and
  // a; K. L. Johnson, Contact Mechanics (1985), section 4.2.
  TEST(SpatialHertz, ball_presses_on_a_block_as_on_a_half_space)
  {
    const double   radius = 2., a_wanted = 0.1;
    QuarterOfBlock block(radius, a_wanted);
    const double   E_star = QuarterOfBlock::reduced_modulus();
    const double   force  = block.press(a_wanted * a_wanted / radius);
    const double   a      = std::cbrt(0.75 * force * radius / E_star);
    const double   p0     = 1.5 * force / (M_PI * a * a);
    double         n = 0., x = 0., y = 0., xx = 0., xy = 0.;
    const auto    &points = block.contact->positions();
    for (std::size_t q = 0; q < points.size(); ++q)
      {
        const double r = std::hypot(points[q][0], points[q][1]);
        if (r > 0.8 * a)
          continue;
        const double p = block.contact->pressure()[q],
                     w = block.contact->table().JxW[q];
        n += w;
        x += w * r * r;
        y += w * p * p;
        xx += w * r * r * r * r;
        xy += w * r * r * p * p;
      }
    const double slope = (n * xy - x * y) / (n * xx - x * x);
    const double level = (y - slope * x) / n;
    EXPECT_NEAR(std::sqrt(level), p0, 0.01 * p0);
    EXPECT_NEAR(std::sqrt(-level / slope), a, 0.01 * a);
    EXPECT_NEAR(a, a_wanted, 0.1 * a_wanted);
  }



  // Yield begins below the surface, at p0 = 1.60 Y for nu = 0.3; K. L. Johnson,
  // Contact Mechanics (1985), section 6.1.
  TEST(SpatialHertz, block_begins_to_yield_at_the_pressure_of_johnson)
  {
    const double   radius = 2., a_wanted = 0.1;
    const double   E_star = QuarterOfBlock::reduced_modulus();
    const double   Y      = 2. * E_star * a_wanted / (M_PI * radius) / 1.6;
    QuarterOfBlock block(radius, a_wanted, QuarterOfBlock::plastic(Y), 3);
    // largest pressure over Y, of the half-space under the same force
    const auto press = [&](const double factor) {
      const double force =
        block.press(factor * factor * a_wanted * a_wanted / radius);
      block.accept();
      const double a = std::cbrt(0.75 * force * radius / E_star);
      return 1.5 * force / (M_PI * a * a) / Y;
    };
    const double before = press(0.94);
    EXPECT_EQ(block.largest_plastic_strain(), 0.) << before;
    const double after = press(1.05);
    EXPECT_GT(block.largest_plastic_strain(), 0.) << after;
    EXPECT_GT(before, 1.60 * 0.92);
    EXPECT_LT(before, 1.60);
    EXPECT_GT(after, 1.60);
    EXPECT_LT(after, 1.60 * 1.08);
  }
} // namespace
