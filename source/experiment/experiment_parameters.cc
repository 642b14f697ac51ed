#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/base/text.h>
#include <asperity/experiment/experiment_parameters.h>

#include <cmath>

namespace asperity
{
  namespace
  {
    /** @param path of the entry, for messages */
    double
    parse_force(const std::string         &text,
                const std::string         &path,
                const ParameterDeclarator &parameters)
    {
      const std::string value = trim(text);
      for (const auto &[unit, factor] : {std::make_pair("kN", 1e3), {"N", 1.}})
        {
          const std::string suffix(unit);
          if (value.size() <= suffix.size() ||
              value.compare(value.size() - suffix.size(),
                            suffix.size(),
                            suffix) != 0)
            continue;
          try
            {
              return factor * parse_number(trim(
                                value.substr(0, value.size() - suffix.size())));
            }
          catch (const InputError &)
            {
              break; // the sentence below says it
            }
        }
      throw InputError(parameters.where(path) + ": found " + quoted_text(text) +
                       "; expected a force in N or kN, such as 1196 N.");
    }

    /** @throws InputError if an entry that is needed has no value */
    double
    needed(const std::optional<double> &value,
           const std::string           &path,
           const ParameterDeclarator   &parameters)
    {
      if (!value)
        throw InputError(parameters.where(path) +
                         ": found automatic; expected a value, which this "
                         "experiment needs.");
      return *value;
    }

    void
    declare_heat(ParameterDeclarator &parameters,
                 const std::string   &body,
                 HeatProperties      &heat)
    {
      parameters.quantity("Conductivity",
                          heat.conductivity,
                          "W/(m K)",
                          Range::positive(),
                          "Thermal conductivity of the " + body + ".");
      parameters.quantity("Density",
                          heat.density,
                          "kg/m3",
                          Range::positive(),
                          "Density of the " + body + ".");
      parameters.quantity("Heat capacity",
                          heat.heat_capacity,
                          "J/(kg K)",
                          Range::positive(),
                          "Specific heat of the " + body + ".");
    }
  } // namespace



  void
  ExperimentParameters::declare(ParameterDeclarator &parameters)
  {
    parameters.choice(
      "Experiment",
      kind,
      {{"cut", ExperimentKind::cut}, {"pin", ExperimentKind::pin}},
      "cut: an orthogonal cut, whose chip slides over the rake face; pin: a "
      "tribometer, whose pin slides over chip material.");
    parameters.quantity("Temperature",
                        cut.temperature,
                        "degC",
                        Range::positive(),
                        "Temperature of both bodies far from the contact.");
    declare_cut(parameters);
    declare_pin(parameters);
    declare_chip(parameters);
    const auto section = parameters.subsection("Tool");
    declare_heat(parameters, "tool", cut.tool);
    parameters.quantity("Young's modulus",
                        pin.tool_modulus,
                        "GPa",
                        Range::positive(),
                        "Young's modulus of the pin.");
    parameters.number("Poisson ratio",
                      pin.tool_poisson,
                      Range::between(0., 0.5),
                      "Poisson's ratio of the pin.");
  }



  void
  ExperimentParameters::declare_chip(ParameterDeclarator &parameters)
  {
    const auto section = parameters.subsection("Chip");
    declare_heat(parameters, "chip's material", cut.chip);
    parameters.quantity("Shear limit",
                        shear_limit,
                        "MPa",
                        Range::positive(),
                        "Shear flow stress k of the chip at the rake face, "
                        "which the shear stress there cannot exceed; "
                        "automatic: unknown, so that the chip slides "
                        "everywhere.");
    parameters.quantity("Hardness",
                        pin.hardness,
                        "MPa",
                        Range::positive(),
                        "Largest mean pressure of a ball that the chip's "
                        "material carries, about 2.8 times its flow stress.");
    parameters.quantity("Young's modulus",
                        pin.chip_modulus,
                        "GPa",
                        Range::positive(),
                        "Young's modulus of the chip's material.");
    parameters.number("Poisson ratio",
                      pin.chip_poisson,
                      Range::between(0., 0.5),
                      "Poisson's ratio of the chip's material.");
  }



  void
  ExperimentParameters::declare_cut(ParameterDeclarator &parameters)
  {
    const auto section = parameters.subsection("Cut");
    parameters.text("Cutting force",
                    cutting_force,
                    "Force along the cutting velocity, in N or kN.");
    parameters.text("Passive force",
                    passive_force,
                    "Force normal to the cutting velocity and the edge, in N "
                    "or kN.");
    parameters.text("Edge cutting force",
                    edge_cutting_force,
                    "What the edge takes of the cutting force, such as its "
                    "value at a vanishing thickness of the uncut chip.");
    parameters.text("Edge passive force",
                    edge_passive_force,
                    "The same of the passive force.");
    parameters.quantity(
      "Width", width, "mm", Range::positive(), "Width of the cut b.");
    parameters.quantity("Uncut chip thickness",
                        uncut_chip_thickness,
                        "mm",
                        Range::positive(),
                        "Thickness h of the layer that becomes the chip.");
    parameters.quantity("Cutting speed",
                        cutting_speed,
                        "m/min",
                        Range::positive(),
                        "Velocity of the cut v_c.");
    parameters.quantity("Rake angle",
                        cut.rake,
                        "deg",
                        Range::between(-1.2, 1.2),
                        "Rake angle gamma.");
    parameters.quantity("Chip thickness",
                        chip_thickness,
                        "mm",
                        Range::positive(),
                        "Thickness of the chip h_c; automatic: from the shear "
                        "angle.");
    parameters.quantity("Shear angle",
                        shear_angle,
                        "deg",
                        Range::between(0.01, 1.5),
                        "Shear angle phi, instead of the chip's thickness.");
    parameters.quantity("Contact length",
                        cut.contact_length,
                        "mm",
                        Range::positive(),
                        "Length of the contact of chip and rake face; "
                        "automatic: from the balance of moments on the chip.");
    parameters.number("Zorev exponent",
                      cut.zorev_exponent,
                      Range::between(0.1, 20.),
                      "Exponent xi of the pressure (1 - x/l)^xi on the rake "
                      "face; 0 would be uniform, 1 linear.");
  }



  void
  ExperimentParameters::declare_pin(ParameterDeclarator &parameters)
  {
    const auto section = parameters.subsection("Pin");
    parameters.choice("End",
                      pin.end,
                      {{"ball", PinEnd::ball}, {"flat", PinEnd::flat}},
                      "Shape of the end of the pin.");
    parameters.text("Normal force", normal_force, "Normal force, in N or kN.");
    parameters.quantity("Radius",
                        radius,
                        "mm",
                        Range::positive(),
                        "Radius of the ball or of the flat end.");
    parameters.quantity("Velocity",
                        pin_velocity,
                        "m/min",
                        Range::positive(),
                        "Sliding velocity.");
    parameters.number("Friction coefficient",
                      friction_coefficient,
                      Range::positive(),
                      "What was measured; it heats the contact.");
    parameters.flag("New material",
                    pin.is_open,
                    "Whether the pin always meets new material, as in an open "
                    "tribometer: then the front half of a plastic contact "
                    "carries.");
  }



  void
  ExperimentParameters::check(const ParameterDeclarator &parameters)
  {
    const std::string other = kind == ExperimentKind::cut ? "Pin" : "Cut";
    for (const ParameterEntry &entry : parameters.entries())
      if (entry.given && entry.subsection == other)
        throw InputError(parameters.where(entry.path()) +
                         ": found an entry that this experiment does not have; "
                         "expected none of the subsection " +
                         other + ", or another Experiment.");
    pin.chip        = cut.chip;
    pin.tool        = cut.tool;
    pin.temperature = cut.temperature;
    if (kind == ExperimentKind::cut)
      check_cut(parameters);
    else
      check_pin(parameters);
  }



  void
  ExperimentParameters::check_cut(const ParameterDeclarator &parameters)
  {
    const auto force = [&](const std::string &text, const std::string &key) {
      return parse_force(text, "Cut/" + key, parameters);
    };
    const auto length = [&](const std::optional<double> &value,
                            const std::string           &key) {
      return needed(value, "Cut/" + key, parameters);
    };
    cut.cutting_force      = force(cutting_force, "Cutting force");
    cut.passive_force      = force(passive_force, "Passive force");
    cut.edge_cutting_force = force(edge_cutting_force, "Edge cutting force");
    cut.edge_passive_force = force(edge_passive_force, "Edge passive force");
    cut.width              = length(width, "Width");
    cut.uncut_chip_thickness =
      length(uncut_chip_thickness, "Uncut chip thickness");
    cut.velocity = length(cutting_speed, "Cutting speed");
    if (shear_limit)
      cut.shear_limit = *shear_limit;
    if (chip_thickness && shear_angle)
      throw InputError(parameters.where("Cut/Shear angle") +
                       ": found an angle beside Chip thickness, which gives "
                       "it; expected one of both.");
    if (shear_angle)
      cut.chip_thickness = cut.uncut_chip_thickness *
                           std::cos(*shear_angle - cut.rake) /
                           std::sin(*shear_angle);
    else
      cut.chip_thickness = length(chip_thickness, "Chip thickness");
    if (!(cut.chip_thickness > 0.))
      throw InputError(parameters.where("Cut/Shear angle") +
                       ": found an angle that leaves no chip beside this rake "
                       "angle; expected less.");
  }



  void
  ExperimentParameters::check_pin(const ParameterDeclarator &parameters)
  {
    pin.normal_force =
      parse_force(normal_force, "Pin/Normal force", parameters);
    if (!(pin.normal_force > 0.))
      throw InputError(parameters.where("Pin/Normal force") + ": found " +
                       quoted_text(normal_force) + "; expected more than 0 N.");
    pin.radius   = needed(radius, "Pin/Radius", parameters);
    pin.velocity = needed(pin_velocity, "Pin/Velocity", parameters);
    pin.mu =
      needed(friction_coefficient, "Pin/Friction coefficient", parameters);
  }
} // namespace asperity
