#include <asperity/base/errors.h>
#include <asperity/experiment/orthogonal_cut.h>
#include <asperity/experiment/pin_contact.h>
#include <asperity/experiment/rake_contact.h>

#include <gtest/gtest.h>

#include <cmath>

#include "../files.h"

using namespace asperity;

namespace
{
  constexpr double degree = 3.14159265358979323846 / 180.;

  /** Lee (2025), section 2.1: dry, blasted rake face, 5 m/min. */
  OrthogonalCut
  dry_cut()
  {
    OrthogonalCut cut;
    cut.cutting_force        = 1196.;
    cut.passive_force        = 647.;
    cut.width                = 2e-3;
    cut.uncut_chip_thickness = 0.15e-3;
    cut.velocity             = 5. / 60.;
    cut.chip_thickness       = 0.81e-3;
    return cut;
  }
} // namespace

TEST(RakeContact, integrates_zorevs_stresses)
{
  for (const double k : {200e6, 350e6, 1e9})
    for (const double exponent : {0.7, 2., 3.})
      {
        const RakeContact  contact{500e6, exponent, 0.8, k};
        constexpr unsigned n        = 200000;
        double             pressure = 0., shear = 0., sticks = 0.;
        for (unsigned int i = 0; i < n; ++i)
          {
            const double x = (i + 0.5) / n;
            const double sigma =
              contact.edge_pressure() * std::pow(1. - x, exponent);
            pressure += sigma / n;
            shear += std::min(0.8 * sigma, k) / n;
            sticks += (0.8 * sigma > k ? 1. : 0.) / n;
          }
        EXPECT_NEAR(pressure, 500e6, 1e-5 * 500e6);
        EXPECT_NEAR(contact.apparent_mu(), shear / pressure, 1e-5);
        EXPECT_NEAR(contact.sticking(), sticks, 1e-5);
        const RakeContact same = RakeContact::with_apparent_mu(
          500e6, exponent, contact.apparent_mu(), k);
        EXPECT_NEAR(same.mu, 0.8, 1e-9);
      }
  EXPECT_NE(message_of<InputError>([] {
              RakeContact::with_apparent_mu(500e6, 2., 0.6, 200e6);
            }).find("takes a shear stress of 300 MPa on the whole contact"),
            std::string::npos);
}

// All numbers by hand, the moving band by quadrature.
TEST(OrthogonalCut, of_the_dissertation)
{
  const CutConditions at = conditions_of(dry_cut());
  EXPECT_NEAR(at.shear_angle / degree, 10.49148, 1e-5);
  EXPECT_NEAR(at.chip_velocity * 60., 0.925926, 1e-6);
  EXPECT_NEAR(at.friction_force, 647., 1e-9);
  EXPECT_NEAR(at.normal_force, 1196., 1e-9);
  EXPECT_NEAR(at.contact_length, 1.176371e-3, 1e-9);
  EXPECT_NEAR(at.contact.mean_pressure, 508.3429e6, 100.);
  EXPECT_NEAR(at.contact.mu, 647. / 1196., 1e-12);
  EXPECT_NEAR(at.shear_stress, 642.2856e6, 100.);
  EXPECT_NEAR(at.plastic_strain, 3.224608, 1e-6);
  EXPECT_NEAR(at.shear_plane_temperature - 293.15, 234.7045, 1e-4);
  EXPECT_NEAR(at.heat_to_chip, -1.563477, 1e-5);
  EXPECT_NEAR(at.interface_temperature - 273.15, 146.6934, 1e-3);
}

// Merchant's circle: the same force seen along and across the rake face.
TEST(OrthogonalCut, turns_the_forces_by_the_rake_angle)
{
  OrthogonalCut cut      = dry_cut();
  cut.rake               = -7. * degree;
  cut.chip_thickness     = 0.416e-3;
  cut.velocity           = 200. / 60.;
  const CutConditions at = conditions_of(cut);
  EXPECT_NEAR(std::hypot(at.friction_force, at.normal_force),
              std::hypot(1196., 647.),
              1e-9);
  EXPECT_NEAR(std::atan2(at.friction_force, at.normal_force),
              std::atan2(647., 1196.) - 7. * degree,
              1e-12);
  // the velocities of chip and cut have one component across the shear plane
  EXPECT_NEAR(at.chip_velocity * std::cos(at.shear_angle - cut.rake),
              cut.velocity * std::sin(at.shear_angle),
              1e-12);
  EXPECT_NEAR(cut.chip_thickness / cut.uncut_chip_thickness,
              std::cos(at.shear_angle - cut.rake) / std::sin(at.shear_angle),
              1e-12);
  // faster cuts heat the interface more
  EXPECT_GT(at.interface_temperature, 900.);

  cut.contact_length        = 0.4e-3;
  cut.shear_limit           = 700e6;
  const CutConditions stuck = conditions_of(cut);
  EXPECT_EQ(stuck.contact_length, 0.4e-3);
  EXPECT_GT(stuck.contact.sticking(), 0.);
  EXPECT_NEAR(stuck.contact.apparent_mu(),
              stuck.friction_force / stuck.normal_force,
              1e-12);
}

TEST(OrthogonalCut, says_what_contradicts_itself)
{
  OrthogonalCut cut = dry_cut();
  cut.passive_force = -100.;
  EXPECT_NE(message_of<InputError>([&] {
              conditions_of(cut);
            }).find("positive forces are expected"),
            std::string::npos);
  cut                = dry_cut();
  cut.passive_force  = 1300.;
  cut.chip_thickness = 0.12e-3;
  EXPECT_NE(message_of<InputError>([&] {
              conditions_of(cut);
            }).find("takes more than the work of the cutting force"),
            std::string::npos);
}

// Steel on steel, ball of 5 mm, 10 N: E* = 115.385 GPa, a = (3 F R/(4
// E*))^(1/3) = 68.75 um, p = 673.4 MPa on average.
TEST(PinContact, is_elastic_after_hertz)
{
  PinContact pin;
  pin.normal_force       = 10.;
  pin.radius             = 5e-3;
  pin.velocity           = 1.;
  pin.mu                 = 0.5;
  pin.tool_modulus       = 210e9;
  pin.tool_poisson       = 0.3;
  const PinConditions at = conditions_of(pin);
  EXPECT_FALSE(at.is_plastic);
  EXPECT_NEAR(at.radius, 68.75e-6, 0.01e-6);
  EXPECT_NEAR(at.mean_pressure, 673.4e6, 0.2e6);

  // heat: both bodies have the same mean temperature, and share all of it
  const double q       = 0.5 * at.mean_pressure * 1.;
  const double of_chip = moving_circle(pin.chip, at.radius, 1.),
               of_tool = moving_circle(pin.tool, at.radius, 0.);
  EXPECT_NEAR(at.heat_to_chip * of_chip,
              (1. - at.heat_to_chip) * of_tool,
              1e-18);
  EXPECT_NEAR(at.temperature - 293.15, at.heat_to_chip * q * of_chip, 1e-9);
}

TEST(PinContact, is_plastic_at_the_hardness)
{
  PinContact pin;
  pin.normal_force           = 1000.;
  pin.radius                 = 8.5e-3;
  pin.velocity               = 1.;
  pin.mu                     = 0.3;
  pin.is_open                = false;
  const PinConditions closed = conditions_of(pin);
  EXPECT_TRUE(closed.is_plastic);
  EXPECT_EQ(closed.mean_pressure, 2e9);
  // F/H = 0.5 mm^2
  EXPECT_NEAR(closed.radius, std::sqrt(0.5e-6 / (180. * degree)), 1e-12);
  pin.is_open                = true;
  const PinConditions groove = conditions_of(pin);
  EXPECT_NEAR(groove.radius, std::sqrt(2.) * closed.radius, 1e-12);
  pin.end    = PinEnd::flat;
  pin.radius = 1e-3;
  EXPECT_NEAR(conditions_of(pin).mean_pressure, 318.31e6, 0.01e6);
}
