#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/constitutive/heating_parameters.h>

#include <string>

namespace asperity
{
  void
  HeatingParameters::declare(ParameterDeclarator &parameters)
  {
    parameters.flag("Adiabatic heating",
                    adiabatic,
                    "Whether plastic work heats the point where it is done; "
                    "otherwise the temperature stays.");
    parameters.quantity("Heat capacity",
                        heat_capacity,
                        "J/(kg K)",
                        Range::between(1., 1e5),
                        "Specific heat capacity c_p.");
    parameters.number("Heat fraction",
                      heat_fraction,
                      Range::between(0., 1.),
                      "Share chi of the plastic work that becomes heat.");
  }



  double
  HeatingParameters::temperature_per_work(const double density) const
  {
    if (!adiabatic)
      return 0.;
    if (!(heat_capacity > 0.))
      throw InputError("The heat capacity must be positive, but it is " +
                       std::to_string(heat_capacity) + " J/(kg K).");
    if (!(heat_fraction >= 0. && heat_fraction <= 1.))
      throw InputError("The share of the plastic work that becomes heat must "
                       "lie between 0 and 1, but it is " +
                       std::to_string(heat_fraction) + ".");
    return heat_fraction / (density * heat_capacity);
  }
} // namespace asperity
