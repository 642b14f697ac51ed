#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/experiment/orthogonal_cut.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    void
    require(const bool condition, const std::string &sentence)
    {
      if (!condition)
        throw InputError(sentence);
    }

    /** Shear angle and velocity of the chip. */
    void
    set_kinematics(const OrthogonalCut &cut, CutConditions &result)
    {
      const double r      = cut.uncut_chip_thickness / cut.chip_thickness;
      const double across = 1. - r * std::sin(cut.rake);
      result.shear_angle  = std::atan2(r * std::cos(cut.rake), across);
      require(result.shear_angle - cut.rake > -1.5 && across > 0.,
              "The chip is thinner than this rake angle allows: there is no "
              "shear plane; a thicker chip is expected");
      result.chip_velocity = cut.velocity * r;
    }

    void
    set_forces(const OrthogonalCut &cut, CutConditions &result)
    {
      const double F_c = cut.cutting_force - cut.edge_cutting_force,
                   F_p = cut.passive_force - cut.edge_passive_force;
      const double c = std::cos(cut.rake), s = std::sin(cut.rake);
      result.friction_force = F_c * s + F_p * c;
      result.normal_force   = F_c * c - F_p * s;
      require(result.friction_force > 0. && result.normal_force > 0.,
              "The forces press the rake face with " +
                format_quantity(result.normal_force, "1", 4) +
                " N and rub it with " +
                format_quantity(result.friction_force, "1", 4) +
                " N; positive forces are expected");
    }

    void
    set_contact(const OrthogonalCut &cut, CutConditions &result)
    {
      const double phi      = result.shear_angle;
      const double mu       = result.friction_force / result.normal_force;
      const double lambda   = std::atan(mu);
      result.contact_length = cut.contact_length.value_or(
        cut.uncut_chip_thickness * 0.5 * (cut.zorev_exponent + 2.) *
        std::sin(phi + lambda - cut.rake) / (std::sin(phi) * std::cos(lambda)));
      require(result.contact_length > 0.,
              "The balance of moments gives no contact between chip and rake "
              "face; a contact length is expected");
      result.contact =
        RakeContact::with_apparent_mu(result.normal_force /
                                        (cut.width * result.contact_length),
                                      cut.zorev_exponent,
                                      mu,
                                      cut.shear_limit);
    }

    /** Stress, strain and temperature that the shear plane gives the chip. */
    void
    set_shear_plane(const OrthogonalCut &cut, CutConditions &result)
    {
      const double phi = result.shear_angle;
      const double F_c = cut.cutting_force - cut.edge_cutting_force,
                   F_p = cut.passive_force - cut.edge_passive_force;
      const double h = cut.uncut_chip_thickness, b = cut.width;
      result.shear_stress =
        (F_c * std::cos(phi) - F_p * std::sin(phi)) * std::sin(phi) / (b * h);
      result.plastic_strain =
        std::cos(cut.rake) /
        (std::sin(phi) * std::cos(phi - cut.rake) * std::sqrt(3.));
      const double work =
        F_c * cut.velocity - result.friction_force * result.chip_velocity;
      require(work > 0. && result.shear_stress > 0.,
              "The friction on the rake face takes more than the work of the "
              "cutting force; other forces or a thicker chip are expected");
      // Boothroyd's data in the formula of Oxley
      const double number =
        cut.velocity * h / cut.chip.diffusivity() * std::tan(phi);
      const double to_workpiece =
        std::clamp((number > 10. ? 0.3 - 0.15 * std::log10(number) :
                                   0.5 - 0.35 * std::log10(number)),
                   0.,
                   1.);
      result.shear_plane_temperature =
        cut.temperature +
        (1. - to_workpiece) * work /
          (cut.chip.density * cut.chip.heat_capacity * cut.velocity * b * h);
    }

    void
    set_interface(const OrthogonalCut &cut, CutConditions &result)
    {
      const double l = result.contact_length;
      const double flux =
        result.friction_force * result.chip_velocity / (cut.width * l);
      const double of_chip = moving_band(cut.chip, l, result.chip_velocity);
      // the rake face and its mirror image at the flank are half-spaces
      const double of_tool =
        resting_rectangle(cut.tool.conductivity, l, 0.5 * cut.width);
      const double start = result.shear_plane_temperature - cut.temperature;
      result.heat_to_chip =
        (flux * of_tool - start) / (flux * (of_chip + of_tool));
      result.interface_temperature =
        result.shear_plane_temperature + result.heat_to_chip * flux * of_chip;
    }
  } // namespace



  CutConditions
  conditions_of(const OrthogonalCut &cut)
  {
    CutConditions result;
    set_kinematics(cut, result);
    set_forces(cut, result);
    set_contact(cut, result);
    set_shear_plane(cut, result);
    set_interface(cut, result);
    return result;
  }
} // namespace asperity
