#include <asperity/base/errors.h>
#include <asperity/contact_zone/heat_parameters.h>

#include <utility>
#include <vector>

namespace asperity
{
  namespace
  {
    const std::vector<std::pair<std::string, HeatModel>> models = {
      {"automatic", HeatModel::automatic},
      {"isothermal", HeatModel::isothermal},
      {"adiabatic", HeatModel::adiabatic},
      {"conducting", HeatModel::conducting}};
  } // namespace



  std::string
  name(const HeatModel model)
  {
    for (const auto &entry : models)
      if (entry.second == model)
        return entry.first;
    return "";
  }



  void
  HeatParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Heat");
    parameters.choice(
      "Model",
      model,
      models,
      "What becomes of heat. `isothermal`: temperatures stay; `adiabatic`: "
      "plastic work heats the point where it is done, and frictional heat is "
      "left out; `conducting`: both spread in the chip and into the tool; "
      "`automatic`: conducting if the interface has a shear law, otherwise "
      "adiabatic; isothermal without Material/Adiabatic heating.");
    parameters.quantity("Chip conductivity",
                        chip_conductivity,
                        "W/(m K)",
                        Range::between(1e-3, 1e4),
                        "lambda of the chip. Its density and heat capacity are "
                        "in Material.");
    parameters.quantity("Tool conductivity",
                        tool.conductivity,
                        "W/(m K)",
                        Range::between(1e-3, 1e4),
                        "lambda of the tool; the default is cemented carbide.");
    parameters.quantity("Tool density",
                        tool.density,
                        "kg/m3",
                        Range::between(1., 1e5),
                        "rho of the tool.");
    parameters.quantity("Tool heat capacity",
                        tool.heat_capacity,
                        "J/(kg K)",
                        Range::between(1., 1e5),
                        "Specific heat capacity c of the tool.");
    parameters.quantity("Tool temperature",
                        tool_temperature,
                        "degC",
                        Range::between(0., 5273.15),
                        "Of the tool far away from the contact, and at the "
                        "start everywhere; `automatic` takes that of the chip, "
                        "Load/Temperature.");
    parameters.quantity(
      "Contact conductance",
      contact_conductance,
      "W/(m2 K)",
      Range::between(0., 1e12),
      "h, heat flux over the difference of temperatures where tool and chip "
      "touch. The roughness that the mesh has is not in it, only what is finer: "
      "1e9 is a roughness of about 10 nm that is pressed flat.");
    parameters.quantity("Oil conductivity",
                        oil_conductivity,
                        "W/(m K)",
                        Range::between(0., 1e4),
                        "lambda of the oil, through which heat goes over the "
                        "gap where they do not touch; dry gaps insulate.");
  }



  void
  HeatParameters::check(const ParameterDeclarator &parameters,
                        const bool                 heats) const
  {
    if (!heats &&
        (model == HeatModel::adiabatic || model == HeatModel::conducting))
      throw InputError(parameters.where("Heat/Model") + ": found " +
                       name(model) +
                       " with Material/Adiabatic heating = false; expected "
                       "that to be true, or the model isothermal.");
  }
} // namespace asperity
