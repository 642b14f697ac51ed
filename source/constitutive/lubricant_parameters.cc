#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/constitutive/lubricant_parameters.h>

namespace asperity
{
  namespace
  {
    void
    declare_density(double              &density,
                    LubricantDensity    &law,
                    ParameterDeclarator &d)
    {
      d.quantity("Density",
                 density,
                 "kg/m^3",
                 Range::between(10., 1e5),
                 "Mass density rho_0 at ambient pressure.");
      d.choice("Density law",
               law.law,
               {{"incompressible", DensityLaw::incompressible},
                {"Murnaghan", DensityLaw::murnaghan},
                {"Dowson-Higginson", DensityLaw::dowson_higginson},
                {"constant modulus", DensityLaw::constant_modulus}},
               "How the density grows with pressure p: not at all; after "
               "Murnaghan, (1 + K' p/K_0)^(1/K'); after Dowson and Higginson "
               "for mineral oil, without constants of its own; or "
               "exp(p/K_0).");
      d.quantity("Bulk modulus",
                 law.bulk_modulus,
                 "GPa",
                 Range::between(1e6, 1e12),
                 "Bulk modulus K_0 at ambient pressure.");
      d.number("Bulk modulus slope",
               law.modulus_derivative,
               Range::between(0.1, 100.),
               "Growth K' of the bulk modulus with pressure, of Murnaghan's "
               "law.");
    }



    void
    declare_shear_law(ViscosityParameters &p, ParameterDeclarator &d)
    {
      d.quantity("Viscosity",
                 p.viscosity,
                 "Pa s",
                 Range::between(1e-6, 1e6),
                 "Dynamic viscosity eta_0 at low shear rate and ambient "
                 "pressure.");
      d.choice("Shear law",
               p.shear_law,
               {{"Newtonian", ShearLaw::newtonian},
                {"Carreau", ShearLaw::carreau}},
               "Whether the viscosity falls with the shear rate: not, or after "
               "Carreau with the three constants below.");
      const auto section = d.subsection("Carreau");
      d.quantity("Infinite shear viscosity",
                 p.infinite_shear_viscosity,
                 "Pa s",
                 Range::between(0., 1e6),
                 "Viscosity eta_inf at infinite shear rate.");
      d.quantity("Time constant",
                 p.time_constant,
                 "s",
                 Range::between(0., 1.),
                 "Time constant lambda: thinning starts at the rate "
                 "1/lambda.");
      d.number("Power index",
               p.power_index,
               Range{0., 1., false, true},
               "Power index n: the viscosity falls as the rate to the n - 1.");
    }



    void
    declare_pressure_laws(ViscosityParameters &p, ParameterDeclarator &d)
    {
      d.choice("Pressure law",
               p.pressure_law,
               {{"none", PressureLaw::none},
                {"Barus", PressureLaw::barus},
                {"Roelands", PressureLaw::roelands}},
               "How the viscosity grows with pressure p: not at all; after "
               "Barus, exp(alpha p); or after Roelands, slower at high "
               "pressure.");
      d.quantity("Pressure coefficient",
                 p.pressure_coefficient,
                 "1/GPa",
                 Range::between(0., 1e-6),
                 "Pressure-viscosity coefficient alpha of Barus.");
      d.number("Roelands exponent",
               p.roelands_exponent,
               Range::between(0., 2.),
               "Exponent Z of Roelands.");
      d.choice("Stress limit",
               p.stress_limit,
               {{"none", StressLimit::none},
                {"circular", StressLimit::circular}},
               "Whether the shear stress is limited by that at which the "
               "lubricant slips like a plastic solid: not, or by the circular "
               "law of Lee and Hamrock.");
      d.quantity("Limiting stress",
                 p.limiting_stress,
                 "MPa",
                 Range::between(1e3, 1e10),
                 "Limiting shear stress tau_0 at ambient pressure.");
      d.number("Limiting stress slope",
               p.limiting_stress_slope,
               Range::between(0., 1.),
               "Growth zeta of the limiting shear stress with pressure.");
    }
  } // namespace



  void
  LubricantParameters::declare(ParameterDeclarator &parameters)
  {
    const auto section = parameters.subsection("Lubricant");
    declare_density(density, compressibility, parameters);
    declare_shear_law(viscosity, parameters);
    declare_pressure_laws(viscosity, parameters);
    temperature.declare(parameters);
  }



  LubricantParameters
  LubricantParameters::at(const double T, const double T_of_volume) const
  {
    LubricantParameters oil = *this;
    if (temperature.law == TemperatureLaw::none)
      return oil;
    const double shift =
      temperature.viscosity(viscosity.viscosity, T) / viscosity.viscosity;
    oil.viscosity.viscosity *= shift;
    oil.viscosity.infinite_shear_viscosity *= shift;
    oil.viscosity.time_constant *= shift;
    oil.density *= temperature.density_ratio(T);
    oil.compressibility.bulk_modulus *= temperature.modulus_ratio(T);
    oil.compressibility.ambient_ratio =
      temperature.density_ratio(T) / temperature.density_ratio(T_of_volume);
    return oil;
  }



  void
  LubricantParameters::check() const
  {
    const auto require_positive =
      [](const double value, const std::string &name, const std::string &unit) {
        if (!(value > 0.))
          throw InputError("The lubricant's " + name +
                           " must be positive, but it is " +
                           format_quantity(value, unit) + ".");
      };
    require_positive(density, "density", "kg/m^3");
    const LubricantDensity &law = compressibility;
    if (law.law == DensityLaw::murnaghan ||
        law.law == DensityLaw::constant_modulus)
      require_positive(law.bulk_modulus, "bulk modulus", "GPa");
    if (law.law == DensityLaw::murnaghan)
      require_positive(law.modulus_derivative, "bulk modulus slope", "1");
    LubricantViscosity{viscosity}; // its constructor checks
  }



  void
  LubricantParameters::check(const ParameterDeclarator &parameters) const
  {
    const ViscosityParameters &p = viscosity;
    if (p.shear_law == ShearLaw::carreau &&
        p.infinite_shear_viscosity > p.viscosity)
      throw InputError(
        parameters.where("Lubricant/Carreau/Infinite shear viscosity") +
        ": found " + format_quantity(p.infinite_shear_viscosity, "Pa s") +
        "; expected at most the viscosity at rest, " +
        format_quantity(p.viscosity, "Pa s") + ".");
    if (p.pressure_law == PressureLaw::roelands &&
        p.viscosity <= LubricantViscosity::roelands_viscosity)
      throw InputError(
        parameters.where("Lubricant/Viscosity") + ": found " +
        format_quantity(p.viscosity, "Pa s") + "; expected more than " +
        format_quantity(LubricantViscosity::roelands_viscosity, "Pa s") +
        " for the law of Roelands.");
    check();
  }



  void
  LubricantParameters::check_temperature(const ParameterDeclarator &parameters,
                                         const double               T) const
  {
    const LubricantTemperature &law = temperature;
    if (law.law == TemperatureLaw::none)
      return;
    if (law.law == TemperatureLaw::vogel &&
        viscosity.pressure_law == PressureLaw::roelands)
      throw InputError(parameters.where("Lubricant/Temperature law") +
                       ": found Vogel with the Pressure law Roelands, which "
                       "falls where a hot oil is thinner than 6.31e-5 Pa s; "
                       "expected Roelands for both, or another pressure law.");
    if (law.law == TemperatureLaw::roelands &&
        viscosity.viscosity <= LubricantViscosity::roelands_viscosity)
      throw InputError(
        parameters.where("Lubricant/Viscosity") + ": found " +
        format_quantity(viscosity.viscosity, "Pa s") + "; expected more than " +
        format_quantity(LubricantViscosity::roelands_viscosity, "Pa s") +
        " for the law of Roelands.");
    const std::string reference = "Lubricant/Temperature/Reference temperature";
    if (law.reference <= law.lowest())
      throw InputError(parameters.where(reference) + ": found " +
                       format_quantity(law.reference, "degC") +
                       "; expected more than " +
                       format_quantity(law.lowest(), "degC") +
                       ", where the law of the viscosity ends.");
    const double solid = law.glass_temperature(viscosity.viscosity);
    if (T <= solid)
      throw InputError(parameters.where("Load/Temperature") + ": found " +
                       format_quantity(T, "degC") +
                       ", at which the oil is a glass by its Temperature law; "
                       "expected more than " +
                       format_quantity(solid, "degC", 4) + ".");
  }
} // namespace asperity
