#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/constitutive/hyperelasticity.h>
#include <asperity/constitutive/material_parameters.h>

#include <cmath>

namespace asperity
{
  namespace
  {
    void
    declare_elasticity(ElasticParameters &p, ParameterDeclarator &d)
    {
      d.quantity("Density",
                 p.density,
                 "kg/m^3",
                 Range::between(1., 1e5),
                 "Mass density rho of the undeformed body.");
      d.quantity("Young's modulus",
                 p.young_modulus,
                 "GPa",
                 Range::between(1e6, 2e12),
                 "Young's modulus E at small strain.");
      d.number(
        "Poisson's ratio",
        p.poisson_ratio,
        Range::between(-0.9, 0.49),
        "Poisson's ratio nu at small strain; nearer to 0.5, where a body "
        "keeps its volume, the splines lock: they hardly yield.");
    }



    void
    declare_heating(HeatingParameters &p, ParameterDeclarator &d)
    {
      d.flag("Adiabatic heating",
             p.adiabatic,
             "Whether plastic work heats the point where it is done; "
             "otherwise the temperature stays.");
      d.quantity("Heat capacity",
                 p.heat_capacity,
                 "J/(kg K)",
                 Range::between(1., 1e5),
                 "Specific heat capacity c_p.");
      d.number("Heat fraction",
               p.heat_fraction,
               Range::between(0., 1.),
               "Share chi of the plastic work that becomes heat.");
    }



    void
    declare_johnson_cook(JohnsonCookParameters &p, ParameterDeclarator &d)
    {
      const auto section = d.subsection("Johnson-Cook");
      d.quantity(
        "A", p.A, "MPa", Range::between(1e3, 1e11), "Initial flow stress A.");
      d.quantity("B",
                 p.B,
                 "MPa",
                 Range::between(0., 1e12),
                 "Hardening coefficient B of B eps^n.");
      d.number("n", p.n, Range::between(0.001, 10.), "Hardening exponent n.");
      d.number("C",
               p.C,
               Range::between(0., 1.),
               "Rate sensitivity C of 1 + C ln(rate/reference rate).");
      d.quantity("Reference rate",
                 p.reference_rate,
                 "1/s",
                 Range::between(1e-12, 1e9),
                 "Plastic strain rate below which the flow stress does not "
                 "depend on the rate.");
      d.number("m",
               p.m,
               Range::between(0.01, 20.),
               "Exponent m of thermal softening.");
      d.quantity("Transition temperature",
                 p.transition_temperature,
                 "degC",
                 Range::between(0., 5273.15),
                 "Temperature at which softening starts.");
      d.quantity("Melting temperature",
                 p.melting_temperature,
                 "degC",
                 Range::between(0., 5273.15),
                 "Temperature at which the flow stress has fallen to its "
                 "floor, a thousandth of that at the transition temperature.");
    }



    void
    declare_hardening(SaturationHardeningParameters &p, ParameterDeclarator &d)
    {
      const auto section = d.subsection("Saturation hardening");
      d.quantity("Yield stress",
                 p.yield_stress,
                 "MPa",
                 Range::between(1e3, 1e11),
                 "Initial flow stress sigma_0.");
      d.quantity("Saturation stress",
                 p.saturation_stress,
                 "MPa",
                 Range::between(1e3, 1e11),
                 "Flow stress sigma_inf that the saturating part tends to.");
      d.number("Saturation rate",
               p.saturation_rate,
               Range::between(0., 1e6),
               "Rate delta of 1 - exp(-delta eps), per plastic strain.");
      d.quantity("Linear hardening",
                 p.linear_hardening,
                 "MPa",
                 Range::between(0., 1e12),
                 "Linear hardening modulus H.");
    }
  } // namespace



  void
  MaterialParameters::declare(ParameterDeclarator &parameters)
  {
    const auto section = parameters.subsection("Material");
    parameters.choice(
      "Law",
      law,
      {{"Johnson-Cook", MaterialLawName::johnson_cook},
       {"saturation hardening", MaterialLawName::saturation_hardening},
       {"Hencky", MaterialLawName::hencky},
       {"neo-Hooke", MaterialLawName::neo_hooke},
       {"St. Venant-Kirchhoff", MaterialLawName::st_venant_kirchhoff}},
      "The material law: finite-strain J2 plasticity with the flow stress of "
      "Johnson and Cook or with linear and saturating hardening; or elasticity "
      "after Hencky, neo-Hooke or St. Venant-Kirchhoff.");
    declare_elasticity(elasticity, parameters);
    declare_heating(heating, parameters);
    declare_johnson_cook(johnson_cook, parameters);
    declare_hardening(hardening, parameters);
  }



  void
  MaterialParameters::check(const ParameterDeclarator &parameters) const
  {
    const double softens = johnson_cook.transition_temperature,
                 melts   = johnson_cook.melting_temperature;
    if (law == MaterialLawName::johnson_cook && !(melts > softens))
      throw InputError(
        parameters.where("Material/Johnson-Cook/Melting temperature") +
        ": found " + format_quantity(melts, "degC") +
        "; expected more than the transition temperature of " +
        format_quantity(softens, "degC") + ", at which softening starts.");
  }



  std::optional<double>
  MaterialParameters::softest_temperature(const double strength) const
  {
    if (law != MaterialLawName::johnson_cook)
      return {};
    // 1 - T*^m = strength
    const JohnsonCookParameters &p = johnson_cook;
    return p.transition_temperature +
           (p.melting_temperature - p.transition_temperature) *
             std::pow(1. - strength, 1. / p.m);
  }



  bool
  MaterialParameters::heats_itself() const
  {
    const bool yields = law == MaterialLawName::johnson_cook ||
                        law == MaterialLawName::saturation_hardening;
    return yields && heating.adiabatic && heating.heat_fraction > 0.;
  }



  std::unique_ptr<MaterialLaw>
  make_material_law(const MaterialParameters &parameters)
  {
    const ElasticParameters &elasticity = parameters.elasticity;
    HeatingParameters        no_heating;
    no_heating.adiabatic = false;
    switch (parameters.law)
      {
        case MaterialLawName::johnson_cook:
          return std::make_unique<JohnsonCookJ2>("Johnson-Cook",
                                                 elasticity,
                                                 JohnsonCook(
                                                   parameters.johnson_cook),
                                                 parameters.heating);
        case MaterialLawName::saturation_hardening:
          return std::make_unique<SaturationJ2>("saturation hardening",
                                                elasticity,
                                                SaturationHardening(
                                                  parameters.hardening),
                                                parameters.heating);
        case MaterialLawName::hencky:
          return std::make_unique<HenckyElastic>("Hencky",
                                                 elasticity,
                                                 NeverYields(),
                                                 no_heating);
        case MaterialLawName::neo_hooke:
          return std::make_unique<NeoHooke>(elasticity);
        case MaterialLawName::st_venant_kirchhoff:
          return std::make_unique<StVenantKirchhoff>(elasticity);
      }
    throw InputError("There is no material law with the number " +
                     std::to_string(static_cast<int>(parameters.law)) + ".");
  }
} // namespace asperity
