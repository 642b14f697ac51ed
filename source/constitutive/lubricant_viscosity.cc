#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/constitutive/flow_stress.h>
#include <asperity/constitutive/lubricant_viscosity.h>

#include <cmath>
#include <limits>

namespace asperity
{
  namespace
  {
    constexpr double roelands_pressure = 196.2e6; // p_R [Pa]

    void
    require(const bool         condition,
            const std::string &what,
            const double       found,
            const std::string &unit)
    {
      if (!condition)
        throw InputError("The lubricant's " + what + ", but it is " +
                         format_quantity(found, unit) + ".");
    }



    void
    check_shear_law(const ViscosityParameters &p)
    {
      require(p.viscosity > 0. &&
                p.viscosity < LubricantViscosity::glass_viscosity,
              "viscosity must be positive and below that of a glass, 1e12 Pa s",
              p.viscosity,
              "Pa s");
      if (p.shear_law == ShearLaw::newtonian)
        return;
      // The flow rate must not fall with growing stress, hence n > 0.
      require(p.infinite_shear_viscosity >= 0. &&
                p.infinite_shear_viscosity <= p.viscosity,
              "viscosity at infinite shear rate must lie between 0 and that at "
              "rest",
              p.infinite_shear_viscosity,
              "Pa s");
      require(p.time_constant >= 0.,
              "time constant must not be negative",
              p.time_constant,
              "s");
      require(p.power_index > 0. && p.power_index <= 1.,
              "power index must be positive and at most 1",
              p.power_index,
              "1");
    }



    /** eta_C and its derivative by the shear rate. */
    ValueAndSlope
    at_ambient_pressure(const ViscosityParameters &p, const double rate)
    {
      if (p.shear_law == ShearLaw::newtonian)
        return {p.viscosity, 0.};
      const double excess = p.viscosity - p.infinite_shear_viscosity;
      const double w      = p.time_constant * rate;
      const double base   = 1. + w * w;
      const double power  = std::pow(base, 0.5 * (p.power_index - 1.));
      return {p.infinite_shear_viscosity + excess * power,
              excess * (p.power_index - 1.) * power / base * w *
                p.time_constant};
    }



    /** ln F and its derivative by the pressure. */
    ValueAndSlope
    log_pressure_factor(const ViscosityParameters &p, const double pressure)
    {
      if (pressure < 0. || p.pressure_law == PressureLaw::none)
        return {0., 0.};
      if (p.pressure_law == PressureLaw::barus)
        return {p.pressure_coefficient * pressure, p.pressure_coefficient};
      const double log_ratio =
        std::log(p.viscosity / LubricantViscosity::roelands_viscosity);
      const double base  = 1. + pressure / roelands_pressure;
      const double power = std::pow(base, p.roelands_exponent);
      return {log_ratio * (power - 1.),
              log_ratio * p.roelands_exponent * power /
                (base * roelands_pressure)};
    }
  } // namespace



  LubricantViscosity::LubricantViscosity(const ViscosityParameters &parameters)
    : parameters_(parameters)
  {
    const ViscosityParameters &p = parameters_;
    check_shear_law(p);
    if (p.pressure_law == PressureLaw::barus)
      require(p.pressure_coefficient >= 0.,
              "pressure-viscosity coefficient must not be negative",
              p.pressure_coefficient,
              "1/GPa");
    if (p.pressure_law == PressureLaw::roelands)
      {
        require(p.roelands_exponent >= 0.,
                "Roelands exponent must not be negative",
                p.roelands_exponent,
                "1");
        require(p.viscosity > roelands_viscosity,
                "viscosity must lie above 6.31e-5 Pa s for the law of Roelands",
                p.viscosity,
                "Pa s");
      }
    if (p.stress_limit != StressLimit::none)
      {
        require(p.limiting_stress > 0.,
                "limiting shear stress must be positive",
                p.limiting_stress,
                "MPa");
        require(p.limiting_stress_slope >= 0.,
                "limiting shear stress must not fall with pressure",
                p.limiting_stress_slope,
                "1");
      }
  }



  double
  LubricantViscosity::limiting_stress(const double pressure) const
  {
    if (parameters_.stress_limit == StressLimit::none)
      return std::numeric_limits<double>::infinity();
    return parameters_.limiting_stress +
           parameters_.limiting_stress_slope * std::fmax(pressure, 0.);
  }



  bool
  LubricantViscosity::is_constant() const
  {
    return parameters_.shear_law == ShearLaw::newtonian &&
           parameters_.pressure_law == PressureLaw::none &&
           parameters_.stress_limit == StressLimit::none;
  }



  const ViscosityParameters &
  LubricantViscosity::parameters() const
  {
    return parameters_;
  }



  ViscosityValue
  LubricantViscosity::evaluate(const double rate, const double pressure) const
  {
    if (is_constant())
      return {parameters_.viscosity, 0., 0., false};

    // In logarithms, since eta_N alone may overflow where the limit acts.
    const ValueAndSlope ambient    = at_ambient_pressure(parameters_, rate);
    const ValueAndSlope factor     = log_pressure_factor(parameters_, pressure);
    double              log_eta    = std::log(ambient.value) + factor.value;
    double              log_d_rate = ambient.slope / ambient.value;
    double              log_d_pressure = factor.slope;
    if (parameters_.stress_limit == StressLimit::circular && rate > 0.)
      {
        const double tau_L = limiting_stress(pressure);
        const double d_tau_L =
          pressure > 0. ? parameters_.limiting_stress_slope : 0.;
        // s = (eta_N gamma/tau_L)^2; share = s/(1 + s) of the slope is lost.
        const double log_s   = 2. * (log_eta + std::log(rate / tau_L));
        const double inverse = std::exp(-std::fabs(log_s));
        const double share   = (log_s > 0. ? 1. : inverse) / (1. + inverse);
        const double log_root =
          0.5 * (std::fmax(log_s, 0.) + std::log1p(inverse)); // sqrt(1 + s)
        log_eta -= log_root;
        log_d_rate -= share * (log_d_rate + 1. / rate);
        log_d_pressure -= share * (log_d_pressure - d_tau_L / tau_L);
      }
    if (log_eta >= std::log(glass_viscosity))
      return {glass_viscosity, 0., 0., true};
    const double eta = std::exp(log_eta);
    return {eta, eta * log_d_rate, eta * log_d_pressure, false};
  }
} // namespace asperity
