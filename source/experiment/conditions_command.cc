#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/base/text.h>
#include <asperity/experiment/commands.h>
#include <asperity/experiment/experiment_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <iostream>

namespace asperity
{
  namespace
  {
    std::string
    number(const double value, const std::string &unit = "1")
    {
      return format_quantity(value, unit, 4);
    }

    /** The number without its unit. */
    std::string
    bare(const double value, const std::string &unit)
    {
      return number(from_si(value, unit));
    }

    /** Where the heat of friction goes. */
    void
    print_heat(const double to_chip)
    {
      if (to_chip >= 0.)
        std::cout << "Of the heat of friction the chip takes "
                  << number(to_chip, "%") << ", the tool the rest\n";
      else
        std::cout << "The tool takes the heat of friction, and "
                  << number(-to_chip, "%") << " of it from the hot chip\n";
    }

    void
    print_contact(const CutConditions &at)
    {
      const RakeContact &contact = at.contact;
      std::cout << "Pressure " << number(contact.mean_pressure, "MPa")
                << " on average, " << number(contact.edge_pressure(), "MPa")
                << " at the edge";
      if (contact.sticking() > 0.)
        std::cout << "; the chip sticks on " << number(contact.sticking(), "%")
                  << " of the contact, and slides beyond with mu = "
                  << number(contact.mu) << " under "
                  << number(contact.sliding_pressure(), "MPa") << " on average";
      std::cout << "\n";
    }

    void
    print_cut(const CutConditions &at)
    {
      std::cout << "Rake face: friction force " << number(at.friction_force)
                << " N, normal force " << number(at.normal_force)
                << " N, mu = " << number(at.friction_force / at.normal_force)
                << "\nShear angle " << number(at.shear_angle, "deg")
                << ", contact length " << number(at.contact_length, "mm")
                << "\n";
      print_contact(at);
      std::cout << "Shear plane: shear stress "
                << number(at.shear_stress, "MPa") << ", the chip behind it "
                << number(at.shear_plane_temperature, "degC") << "\n";
      print_heat(at.heat_to_chip);
    }

    void
    print_pin(const PinConditions &at)
    {
      std::cout << "The contact is " << (at.is_plastic ? "plastic" : "elastic")
                << ", its radius " << number(at.radius, "um") << "\n";
      print_heat(at.heat_to_chip);
    }

    /** Ready to be copied. @param plastic_strain 0: not said */
    void
    print_scene(const double p,
                const double v,
                const double T,
                const double mu,
                const double plastic_strain)
    {
      std::cout << "\nIn a scene:\n\nsubsection Load\n  set Pressure = "
                << number(p, "MPa")
                << "\n  set Velocity = " << number(v, "m/min")
                << "\n  set Temperature = " << number(T, "degC") << "\n";
      if (plastic_strain > 0.)
        std::cout << "  set Plastic strain = " << number(plastic_strain)
                  << "\n";
      std::cout << "end\n\nIn a file of measurements:\n\n"
                << "p [MPa],v [m/min],T [degC],mu\n"
                << bare(p, "MPa") << "," << bare(v, "m/min") << ","
                << bare(T, "degC") << "," << number(mu) << "\n";
    }

    /** Of an experiment whose file is read. */
    void
    print_conditions(const ExperimentParameters &experiment)
    {
      if (experiment.kind == ExperimentKind::pin)
        {
          const PinConditions at = conditions_of(experiment.pin);
          print_pin(at);
          print_scene(at.mean_pressure,
                      experiment.pin.velocity,
                      at.temperature,
                      experiment.pin.mu,
                      0.);
          return;
        }
      const CutConditions at = conditions_of(experiment.cut);
      print_cut(at);
      print_scene(at.contact.mean_pressure,
                  at.chip_velocity,
                  at.interface_temperature,
                  at.friction_force / at.normal_force,
                  at.plastic_strain);
    }
  } // namespace



  void
  declare_experiment_parameters(ParameterDeclarator &parameters)
  {
    static ExperimentParameters experiment;
    experiment.declare(parameters);
  }



  int
  print_conditions(const std::string &file)
  {
    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator(handler);
    ExperimentParameters     experiment;
    experiment.declare(declarator);
    declarator.read_file(file);
    experiment.check(declarator);
    if (!is_first_rank())
      return 0;
    try
      {
        print_conditions(experiment);
      }
    catch (const InputError &error)
      {
        throw InputError(file + ": " + error.what() + ".");
      }
    return 0;
  }
} // namespace asperity
