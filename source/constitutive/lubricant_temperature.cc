#include <asperity/base/parameters.h>
#include <asperity/constitutive/lubricant_temperature.h>
#include <asperity/constitutive/lubricant_viscosity.h>

#include <cmath>
#include <limits>

namespace asperity
{
  namespace
  {
    constexpr double roelands_temperature = 138.; // T at which eta is infinite
  }



  void
  LubricantTemperature::declare(ParameterDeclarator &d)
  {
    d.choice("Temperature law",
             law,
             {{"none", TemperatureLaw::none},
              {"Roelands", TemperatureLaw::roelands},
              {"Vogel", TemperatureLaw::vogel}},
             "How viscosity, density and bulk modulus follow the temperature "
             "of the oil, the mean of its walls: not at all; or density and "
             "modulus exponentially, and the viscosity after Roelands or after "
             "Vogel. The walls are the tool, at Load/Temperature, and the "
             "chip's surface, in the mean over the period, at the start of "
             "each step.");
    const auto section = d.subsection("Temperature");
    d.quantity("Reference temperature",
               reference,
               "degC",
               Range::between(200., 1000.),
               "Temperature T_0 to which Viscosity, Density and Bulk modulus "
               "belong.");
    d.number("Roelands slope",
             roelands_slope,
             Range::between(0., 3.),
             "Slope index S_0 of Roelands; 1.1 is that of mineral oils "
             "(Roelands 1966).");
    d.quantity("Vogel constant",
               vogel_constant,
               "K",
               Range::between(0., 1e4),
               "Constant B of Vogel; 755.6 K is an oil SAE 30 (Seireg and "
               "Dandage 1982).");
    d.quantity("Vogel temperature",
               vogel_temperature,
               "degC",
               Range::between(0., 500.),
               "Temperature T_V of Vogel, at which the viscosity is infinite; "
               "-70.55 degC is an oil SAE 30 (Seireg and Dandage 1982).");
    d.quantity("Thermal expansion",
               expansion,
               "1/K",
               Range::between(0., 0.01),
               "beta, relative growth of the volume; 6.5e-4/K is that of "
               "mineral oils (Dowson and Higginson 1966).");
    d.quantity("Bulk modulus decay",
               modulus_decay,
               "1/K",
               Range::between(0., 0.1),
               "beta_K, relative loss of the bulk modulus; 6.5e-3/K is that of "
               "most oils (Bair 2007).");
  }



  double
  LubricantTemperature::lowest() const
  {
    switch (law)
      {
        case TemperatureLaw::roelands:
          return roelands_temperature;
        case TemperatureLaw::vogel:
          return vogel_temperature;
        case TemperatureLaw::none:
          break;
      }
    return 0.;
  }



  double
  LubricantTemperature::glass_temperature(const double viscosity) const
  {
    const double glass = LubricantViscosity::glass_viscosity;
    if (law == TemperatureLaw::vogel)
      return vogel_temperature +
             vogel_constant /
               (std::log(glass / viscosity) +
                vogel_constant / (reference - vogel_temperature));
    if (law == TemperatureLaw::none || roelands_slope == 0.)
      return lowest();
    const double eta_R = LubricantViscosity::roelands_viscosity;
    return roelands_temperature +
           (reference - roelands_temperature) *
             std::pow(std::log(glass / eta_R) / std::log(viscosity / eta_R),
                      -1. / roelands_slope);
  }



  double
  LubricantTemperature::viscosity(const double viscosity,
                                  const double temperature) const
  {
    if (law == TemperatureLaw::none)
      return viscosity;
    if (temperature <= lowest())
      return std::numeric_limits<double>::infinity();
    if (law == TemperatureLaw::vogel)
      return viscosity *
             std::exp(vogel_constant / (temperature - vogel_temperature) -
                      vogel_constant / (reference - vogel_temperature));
    const double eta_R = LubricantViscosity::roelands_viscosity;
    return eta_R * std::pow(viscosity / eta_R,
                            std::pow((temperature - roelands_temperature) /
                                       (reference - roelands_temperature),
                                     -roelands_slope));
  }



  double
  LubricantTemperature::density_ratio(const double temperature) const
  {
    return law == TemperatureLaw::none ?
             1. :
             std::exp(-expansion * (temperature - reference));
  }



  double
  LubricantTemperature::modulus_ratio(const double temperature) const
  {
    return law == TemperatureLaw::none ?
             1. :
             std::exp(-modulus_decay * (temperature - reference));
  }
} // namespace asperity
