#include <asperity/constitutive/lubricant_density.h>

#include <cmath>
#include <limits>

namespace asperity
{
  namespace
  {
    // Dowson and Higginson's constants for mineral oil [1/Pa].
    constexpr double dh_rise = 0.6e-9, dh_limit = 1.7e-9;
  } // namespace



  double
  LubricantDensity::ratio(const double pressure) const
  {
    switch (law)
      {
        case DensityLaw::murnaghan:
          return ambient_ratio *
                 std::pow(1. + modulus_derivative * pressure / bulk_modulus,
                          1. / modulus_derivative);
        case DensityLaw::dowson_higginson:
          return ambient_ratio *
                 (1. + dh_rise * pressure / (1. + dh_limit * pressure));
        case DensityLaw::constant_modulus:
          return ambient_ratio * std::exp(pressure / bulk_modulus);
        case DensityLaw::incompressible:
          break;
      }
    return ambient_ratio;
  }



  double
  LubricantDensity::derivative(const double pressure) const
  {
    switch (law)
      {
        case DensityLaw::murnaghan:
          return ambient_ratio *
                 std::pow(1. + modulus_derivative * pressure / bulk_modulus,
                          1. / modulus_derivative - 1.) /
                 bulk_modulus;
        case DensityLaw::dowson_higginson:
          {
            const double denominator = 1. + dh_limit * pressure;
            return ambient_ratio * dh_rise / (denominator * denominator);
          }
        case DensityLaw::constant_modulus:
          return ambient_ratio * std::exp(pressure / bulk_modulus) /
                 bulk_modulus;
        case DensityLaw::incompressible:
          break;
      }
    return 0.;
  }



  double
  LubricantDensity::pressure(const double density_ratio) const
  {
    const double ratio = density_ratio / ambient_ratio;
    switch (law)
      {
        case DensityLaw::murnaghan:
          return bulk_modulus / modulus_derivative *
                 (std::pow(ratio, modulus_derivative) - 1.);
        case DensityLaw::dowson_higginson:
          {
            const double excess = ratio - 1., limit = dh_rise / dh_limit;
            if (excess >= limit)
              return std::numeric_limits<double>::infinity();
            return excess / (dh_rise - dh_limit * excess);
          }
        case DensityLaw::constant_modulus:
          return bulk_modulus * std::log(ratio);
        case DensityLaw::incompressible:
          break;
      }
    return std::numeric_limits<double>::infinity();
  }
} // namespace asperity
