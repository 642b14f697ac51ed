#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/constitutive/finite_strain_j2.h>
#include <asperity/constitutive/johnson_cook.h>

#include <cmath>

namespace asperity
{
  void
  JohnsonCookParameters::declare(ParameterDeclarator &parameters)
  {
    const auto section = parameters.subsection("Johnson-Cook");
    parameters.quantity(
      "A", A, "MPa", Range::between(1e3, 1e11), "Initial flow stress A.");
    parameters.quantity("B",
                        B,
                        "MPa",
                        Range::between(0., 1e12),
                        "Hardening coefficient B of B eps^n.");
    parameters.number("n",
                      n,
                      Range::between(0.001, 10.),
                      "Hardening exponent n.");
    parameters.number("C",
                      C,
                      Range::between(0., 1.),
                      "Rate sensitivity C of 1 + C ln(rate/reference rate).");
    parameters.quantity(
      "Reference rate",
      reference_rate,
      "1/s",
      Range::between(1e-12, 1e9),
      "Plastic strain rate below which the flow stress does not "
      "depend on the rate.");
    parameters.number("m",
                      m,
                      Range::between(0.01, 20.),
                      "Exponent m of thermal softening.");
    parameters.quantity("Transition temperature",
                        transition_temperature,
                        "degC",
                        Range::between(0., 5273.15),
                        "Temperature at which softening starts.");
    parameters.quantity(
      "Melting temperature",
      melting_temperature,
      "degC",
      Range::between(0., 5273.15),
      "Temperature at which the flow stress has fallen to its "
      "floor, a thousandth of that at the transition temperature.");
    parameters.number(
      "Strain limit",
      strain_limit,
      Range::between(1e-3, 1e6),
      "Plastic strain from which on hardening is constant, A + B eps^n with "
      "this eps. The default is a strain that no point reaches, that is, no "
      "limit; Lee (2025), section 2.1, has 2.");
  }



  void
  JohnsonCookParameters::check(const ParameterDeclarator &parameters) const
  {
    if (!(melting_temperature > transition_temperature))
      throw InputError(
        parameters.where("Material/Johnson-Cook/Melting temperature") +
        ": found " + format_quantity(melting_temperature, "degC") +
        "; expected more than the transition temperature of " +
        format_quantity(transition_temperature, "degC") +
        ", at which softening starts.");
  }



  std::unique_ptr<MaterialLaw>
  JohnsonCookParameters::make_law(const ElasticParameters &elasticity,
                                  const HeatingParameters &heating) const
  {
    return std::make_unique<FiniteStrainJ2<JohnsonCook>>(name,
                                                         elasticity,
                                                         JohnsonCook(*this),
                                                         heating);
  }



  JohnsonCook::JohnsonCook(const JohnsonCookParameters &parameters)
    : parameters(parameters)
    , thermal{parameters.m,
              parameters.transition_temperature,
              parameters.melting_temperature}
  {
    const auto require =
      [](const bool condition, const std::string &what, const double found) {
        if (!condition)
          throw InputError("The Johnson-Cook constant " + what +
                           ", but it is " + std::to_string(found) + ".");
      };
    require(parameters.A > 0., "A must be positive", parameters.A);
    require(parameters.B >= 0., "B must not be negative", parameters.B);
    require(parameters.n > 0., "n must be positive", parameters.n);
    require(parameters.C >= 0., "C must not be negative", parameters.C);
    require(parameters.m > 0., "m must be positive", parameters.m);
    require(parameters.reference_rate > 0.,
            "reference rate must be positive",
            parameters.reference_rate);
    require(parameters.strain_limit > 0.,
            "strain limit must be positive",
            parameters.strain_limit);
    require(parameters.melting_temperature > parameters.transition_temperature,
            "melting temperature must lie above the transition temperature (" +
              std::to_string(parameters.transition_temperature) + " K)",
            parameters.melting_temperature);
  }



  std::optional<PowerHardening>
  JohnsonCook::hardening_law() const
  {
    return PowerHardening{parameters.B / parameters.A,
                          parameters.n,
                          parameters.strain_limit};
  }



  std::optional<Softening>
  JohnsonCook::softening() const
  {
    return thermal;
  }
} // namespace asperity
