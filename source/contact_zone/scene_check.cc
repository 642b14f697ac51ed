#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/contact_zone/scene_parameters.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "patch_check.h"

namespace asperity
{
  namespace
  {
    /** Elements of the contact edge that a wave of a rough chip needs. */
    constexpr unsigned int elements_per_wave = 4;

    /** Time steps of a steady window; more are a mistake in a unit. */
    constexpr double largest_number_of_steps = 1e6;
  } // namespace



  void
  MeshParameters::check(const ParameterDeclarator &parameters,
                        const double               height) const
  {
    if (spans % (1u << refinement) != 0)
      throw InputError(parameters.where("Mesh/Spans") + ": found " +
                       std::to_string(spans) + "; expected a multiple of " +
                       std::to_string(1u << refinement) +
                       ", 2 to the power of the refinement levels.");
    if (spans >> refinement < 2 * degree + 2)
      throw InputError(parameters.where("Mesh/Spans") + ": found " +
                       std::to_string(spans) + " with " +
                       std::to_string(refinement) +
                       " refinement levels; expected at least " +
                       std::to_string((2 * degree + 2) << refinement) +
                       ", so that the coarsest level has 2 p + 2 spans.");
    if (strip >= height)
      throw InputError(parameters.where("Mesh/Strip depth") + ": found " +
                       format_quantity(strip, "um") +
                       "; expected less than the chip height of " +
                       format_quantity(height, "um") + ".");
    if (quadrature != 0 && quadrature < fewest_quadrature_points())
      throw InputError(parameters.where("Mesh/Quadrature points") + ": found " +
                       std::to_string(quadrature) + " with splines of degree " +
                       std::to_string(degree) + "; expected at least " +
                       std::to_string(fewest_quadrature_points()) +
                       ", or 0 for the usual number, since the chip could "
                       "move without stress.");
  }



  unsigned int
  MeshParameters::n_spans_across(const double length, const double width) const
  {
    const unsigned int multiple = 1u << refinement;
    const double       equal    = across ? *across : spans * width / length;
    const unsigned int n        = std::ceil(equal / multiple - 1e-9);
    return std::max(n, degree + 1) * multiple;
  }



  unsigned int
  MeshParameters::n_even_levels() const
  {
    return refinement - adaptive_levels;
  }



  bool
  MeshParameters::is_bounded() const
  {
    return adaptive_levels > 0 && most_unknowns > 0;
  }



  bool
  MeshParameters::has_coarser() const
  {
    return spans % 2 == 0 && (refinement > 0 || spans / 2 >= 2 * degree + 2);
  }



  bool
  MeshParameters::has_coarser_across() const
  {
    return refinement > 0 ||
           (across && *across % 2 == 0 && *across / 2 >= degree + 1);
  }



  void
  MeshParameters::coarsen()
  {
    spans /= 2;
    if (across)
      *across /= 2;
    if (refinement > 0)
      --refinement;
    adaptive_levels = std::min(adaptive_levels, refinement);
    offset /= 2.;
  }



  bool
  MeshParameters::has_finer() const
  {
    return 2 * spans <= most_spans && refinement < most_levels;
  }



  void
  MeshParameters::refine()
  {
    spans *= 2;
    if (across)
      *across *= 2;
    ++refinement;
    offset *= 2.;
  }



  unsigned int
  MeshParameters::fewest_quadrature_points() const
  {
    return std::max(2u, knot_multiplicity() > 1 ? degree + 1 : degree);
  }



  unsigned int
  MeshParameters::knot_multiplicity() const
  {
    return continuity == Continuity::smooth ? 1 : degree;
  }



  unsigned int
  MeshParameters::n_quadrature_points() const
  {
    return quadrature > 0 ? quadrature : fewest_quadrature_points();
  }



  void
  ProtocolParameters::check_reversal(const ParameterDeclarator &parameters,
                                     const double               velocity) const
  {
    const double way   = sliding_distance.value_or(velocity * end_time),
                 ramp  = ramp_fraction * way,
                 begin = (1. - window_fraction) * way;
    const auto fail    = [&](const std::string &expected) {
      throw InputError(parameters.where("Protocol/Reversal distance") +
                       ": found " + format_quantity(reversal_distance, "um") +
                       "; expected " + expected + ".");
    };
    if (window == FrictionWindow::steady)
      fail("none with the friction window `steady`, which compares windows of "
           "one direction");
    if (inertia == Inertia::dynamic)
      fail("none with a chip that has inertia, since its velocity would jump");
    if (reversal_distance < ramp || reversal_distance > begin)
      fail("a value between the ends of the load ramp (" +
           format_quantity(ramp, "um", 4) +
           ") and of the way that is not averaged (" +
           format_quantity(begin, "um", 4) + ")");
  }



  void
  ProtocolParameters::check(const ParameterDeclarator &parameters,
                            const double               velocity) const
  {
    if (reversal_distance > 0.)
      check_reversal(parameters, velocity);
    if (window != FrictionWindow::steady)
      return;
    if (steady_distance < 2. * steady_step)
      throw InputError(parameters.where("Protocol/Steady distance") +
                       ": found " + format_quantity(steady_distance, "um") +
                       " with a Steady step of " +
                       format_quantity(steady_step, "um") +
                       "; expected at least two steps, so that a window has a "
                       "mean.");
    if (maximum_distance < 2. * steady_distance)
      throw InputError(parameters.where("Protocol/Maximum distance") +
                       ": found " + format_quantity(maximum_distance, "um") +
                       " with a Steady distance of " +
                       format_quantity(steady_distance, "um") +
                       "; expected at least twice as much, since two windows "
                       "are compared.");
    if (maximum_distance > largest_number_of_steps * steady_step)
      throw InputError(parameters.where("Protocol/Steady step") + ": found " +
                       format_quantity(steady_step, "nm") +
                       " with a Maximum distance of " +
                       format_quantity(maximum_distance, "um") +
                       "; expected at least a millionth of it.");
  }



  namespace
  {
    /** k is a number for a chip that yields only. */
    void
    check_interface(const SceneParameters     &p,
                    const ParameterDeclarator &parameters)
    {
      if (!p.interface.uses_shear_strength())
        return;
      const auto chip = p.material.make_law();
      if (!std::isfinite(chip->shear_limit(0., 0., 0.)))
        throw InputError(parameters.where("Interface/Shear law") +
                         ": found a law of the chip's shear strength with the "
                         "material law `" +
                         chip->name() +
                         "`, which never yields; expected none, Coulomb, or a "
                         "law of plasticity.");
    }

    /** Finite elements are there to compare with: dry profiles on a mesh that
     *  stays. */
    void
    check_continuity(const SceneParameters     &p,
                     const ParameterDeclarator &parameters)
    {
      if (p.mesh.continuity == Continuity::smooth)
        return;
      const auto fail = [&](const std::string &found,
                            const std::string &expected) {
        throw InputError(parameters.where("Mesh/Continuity") +
                         ": found C0 with " + found + "; expected smooth, or " +
                         expected + ".");
      };
      if (p.geometry.dimension == 3)
        fail("a patch", "Geometry/Dimension = 2");
      if (p.lubrication.model != LubricantModel::none)
        fail("a lubricant", "Lubrication/Model = none");
      if (p.mesh.adaptive_levels > 0)
        fail("a mesh that changes", "Mesh/Adaptive levels = 0");
    }

    /** A mesh that changes takes chip, interface, enclosed oil and heat with
     *  it, but no velocities, multipliers or flow. */
    void
    check_adaptive_levels(const SceneParameters     &p,
                          const ParameterDeclarator &parameters)
    {
      const unsigned int levels = p.mesh.adaptive_levels;
      if (levels == 0)
        return;
      const auto fail = [&](const std::string &found,
                            const std::string &expected) {
        throw InputError(parameters.where("Mesh/Adaptive levels") + ": found " +
                         std::to_string(levels) + " with " + found +
                         "; expected 0, or " + expected + ".");
      };
      if (levels > p.mesh.refinement)
        fail(std::to_string(p.mesh.refinement) + " Refinement levels",
             "at most as many as those");
      if (p.chip.kind != SurfaceKind::flat)
        fail("a chip that is not flat", "Chip surface/Kind = flat");
      const LubricantModel lubricant = p.lubrication.model;
      if (lubricant == LubricantModel::reynolds || fills_gap(lubricant))
        fail("the lubricant model `" + name(lubricant) + "`",
             "Lubrication/Model = pocket or none");
      if (p.protocol.inertia == Inertia::dynamic)
        fail("a chip that has inertia", "Protocol/Inertia = quasi-static");
      if (p.contact.augmentations > 0)
        fail("multipliers of the contact", "Contact/Augmentations = 0");
    }

    /** Fields are those of fixed places at times that are known. */
    void
    check_field_times(const SceneParameters     &p,
                      const ParameterDeclarator &parameters)
    {
      const std::vector<double> &times = p.output.field_times;
      const auto                 fail  = [&](const std::string &found,
                            const std::string &expected) {
        throw InputError(parameters.where("Output/Field times") + ": found " +
                         found + "; expected " + expected + ".");
      };
      if (std::adjacent_find(times.begin(),
                             times.end(),
                             std::greater_equal<>()) != times.end())
        fail("times that do not grow", "shares of t_end in growing order");
      if (p.geometry.dimension == 3)
        fail("times with a patch", "nothing, or Geometry/Dimension = 2");
      if (p.mesh.adaptive_levels > 0)
        fail("times with a mesh that changes",
             "nothing, or Mesh/Adaptive levels = 0");
      if (p.accuracy.is_adaptive())
        fail("times with Accuracy/Control = adaptive, which changes the mesh",
             "nothing, or Accuracy/Control = estimate or off");
      if (p.protocol.window == FrictionWindow::steady)
        fail("times with a window that ends when mu is steady",
             "nothing, or Protocol/Friction window = time");
    }

    /** A chip near its melting temperature carries nothing. */
    void
    check_temperature(const SceneParameters     &p,
                      const ParameterDeclarator &parameters)
    {
      const auto softening = p.material.softening();
      if (softening &&
          p.load.temperature >= softening->temperature_at(Softening::floor))
        throw InputError(
          parameters.where("Load/Temperature") + ": found " +
          format_quantity(p.load.temperature, "degC") +
          ", at which the chip has no strength; expected less than " +
          format_quantity(softening->temperature_at(Softening::floor),
                          "degC",
                          6) +
          ", near the melting temperature of " +
          format_quantity(softening->melting_temperature, "degC") + " (" +
          p.material.melting_entry() + ").");
    }
  } // namespace



  void
  SceneParameters::check(const ParameterDeclarator &parameters) const
  {
    if (output.directory.empty())
      throw InputError(parameters.where("Output/Output directory") +
                       ": found nothing; expected a folder, such as '.' for "
                       "the current one.");
    tool.check(parameters, "Tool");
    chip.check(parameters, "Chip surface");
    lubrication.check(parameters);
    if (lubrication.model != LubricantModel::none)
      lubrication.oil.check_temperature(parameters, load.temperature);
    mesh.check(parameters, geometry.height);
    if (accuracy.is_wanted() && !mesh.has_coarser())
      throw InputError(parameters.where("Mesh/Spans") + ": found " +
                       std::to_string(mesh.spans) +
                       ", of which no coarser mesh can be made that would tell "
                       "the error of mu (Accuracy/Control); expected "
                       "an even number of at least " +
                       std::to_string(4 * mesh.degree + 4) + " spans.");
    if (accuracy.is_adaptive() && output.restart)
      throw InputError(parameters.where("Output/Restart") +
                       ": found true with Accuracy/Control = adaptive, which "
                       "begins with coarser runs; expected false, or a restart "
                       "by the parameters.prm of the output directory, which "
                       "has the settings of the last round.");
    if (accuracy.is_adaptive() && mesh.offset != 0.)
      throw InputError(parameters.where("Mesh/Offset") + ": found " +
                       format_quantity(mesh.offset, "1") +
                       " with Accuracy/Control = adaptive, which changes the "
                       "elements that it counts in; expected 0.");
    material.check(parameters);
    check_interface(*this, parameters);
    check_continuity(*this, parameters);
    check_adaptive_levels(*this, parameters);
    if (!output.field_times.empty())
      check_field_times(*this, parameters);
    if (geometry.dimension == 3)
      check_patch(*this, parameters);
    else
      check_profiles(*this, parameters);
    heat.check(parameters, material.heating.adiabatic);
    protocol.check(parameters, load.velocity);
    if (fills_gap(lubrication.model) &&
        protocol.inertia == Inertia::quasi_static)
      throw InputError(parameters.where("Protocol/Inertia") +
                       ": found quasi-static with the lubricant model `" +
                       name(lubrication.model) +
                       "`; expected dynamic or automatic, since a chip that "
                       "floats on oil is held by its mass alone while the flow "
                       "is solved for.");
    check_temperature(*this, parameters);
    if (chip.kind == SurfaceKind::harmonics &&
        mesh.spans < elements_per_wave * chip.highest_wave_number())
      throw InputError(
        parameters.where("Mesh/Spans") + ": found " +
        std::to_string(mesh.spans) + " for a chip of up to " +
        std::to_string(chip.highest_wave_number()) +
        " waves in a period; expected at least " +
        std::to_string(elements_per_wave * chip.highest_wave_number()) +
        ", so that the mesh follows them.");
  }
} // namespace asperity
