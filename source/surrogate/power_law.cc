#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/surrogate/piecewise_power_law.h>
#include <asperity/surrogate/power_law.h>

#include <algorithm>
#include <cmath>

#include "least_squares.h"

namespace asperity
{
  namespace
  {
    /** @throws InputError if the runs do not determine the exponents */
    LeastSquares
    determined_fit(const std::vector<double> &a, const std::vector<double> &y)
    {
      const LeastSquares fit(a, y);
      if (!fit.is_determined())
        throw InputError("The runs of the friction law do not determine the "
                         "exponents of a power law: its inputs do not vary "
                         "independently of each other.");
      return fit;
    }

    /** The runs, with ln(mu). */
    struct Runs
    {
      explicit Runs(const FrictionLaw &law, const std::size_t n_unknowns)
        : inputs(law.description().inputs)
        , x(law.data().x)
        , y(law.data().y)
      {
        if (y.size() < n_unknowns + 2)
          throw InputError("The friction law has " + std::to_string(y.size()) +
                           " runs; at least " + std::to_string(n_unknowns + 2) +
                           " are expected for a power law.");
        for (double &value : y)
          {
            if (!(value > 0.))
              throw InputError("A power law needs positive values of mu; " +
                               format_number(value) + " is among them.");
            value = std::log(value);
          }
      }

      /** ln(max(x, floor) / lower) over that of the upper end. */
      double
      column(const std::size_t row,
             const std::size_t input,
             const double      floor) const
      {
        const LawInput &in = inputs[input];
        return std::log(std::max(x[row * inputs.size() + input], floor) /
                        in.lower) /
               scale(input);
      }

      double
      scale(const std::size_t input) const
      {
        return std::log(inputs[input].upper / inputs[input].lower);
      }

      bool
      has_logarithm(const std::size_t input) const
      {
        return inputs[input].lower > 0.;
      }

      const std::vector<LawInput> inputs;
      const std::vector<double>   x;
      std::vector<double>         y; ///< logarithms
    };

    /** @param active the inputs of columns 1, 2, ...; column 0 is constant */
    PowerLaw
    make_power_law(const Runs                     &runs,
                   const LeastSquares             &fit,
                   const std::vector<std::size_t> &active,
                   const std::vector<double>      &floors)
    {
      PowerLaw result;
      result.floors = floors;
      result.exponents.assign(runs.inputs.size(), 0.);
      double logarithm = fit.coefficients()[0];
      for (std::size_t i = 0; i < active.size(); ++i)
        {
          const double exponent =
            fit.coefficients()[i + 1] / runs.scale(active[i]);
          result.exponents[active[i]] = exponent;
          logarithm -= exponent * std::log(runs.inputs[active[i]].lower);
        }
      result.coefficient = std::exp(logarithm);
      const double n     = static_cast<double>(runs.y.size());
      for (std::size_t row = 0; row < runs.y.size(); ++row)
        {
          result.mean_relative_error +=
            std::abs(std::expm1(-fit.residual(row))) / n;
          result.leave_one_out_error +=
            std::abs(std::expm1(-fit.left_out_residual(row))) / n;
        }
      return result;
    }
  } // namespace



  double
  PowerLaw::operator()(const double *x) const
  {
    double result = coefficient;
    for (std::size_t i = 0; i < exponents.size(); ++i)
      if (exponents[i] != 0.)
        result *= std::pow(std::max(x[i], floors[i]), exponents[i]);
    return result;
  }



  PowerLaw
  fit_power_law(const FrictionLaw &law)
  {
    const std::vector<LawInput> &inputs = law.description().inputs;
    const Runs                   runs(law, inputs.size() + 1);
    std::vector<std::size_t>     active;
    std::vector<double>          floors, a;
    for (std::size_t i = 0; i < inputs.size(); ++i)
      {
        floors.push_back(inputs[i].lower);
        if (runs.has_logarithm(i))
          active.push_back(i);
      }
    for (std::size_t row = 0; row < runs.y.size(); ++row)
      {
        a.push_back(1.);
        for (const std::size_t i : active)
          a.push_back(runs.column(row, i, floors[i]));
      }
    return make_power_law(runs, determined_fit(a, runs.y), active, floors);
  }



  PowerLaw
  fit_velocity_law(const FrictionLaw &law)
  {
    const std::vector<LawInput> &inputs = law.description().inputs;
    const auto                   found =
      std::find_if(inputs.begin(), inputs.end(), [](const LawInput &input) {
        return input.symbol == "v";
      });
    if (found == inputs.end())
      throw InputError(
        "The friction law does not depend on a velocity v, so no "
        "power law over the velocity can be fitted to it.");
    const std::size_t v = static_cast<std::size_t>(found - inputs.begin());
    const Runs        runs(law, 3);
    if (!runs.has_logarithm(v))
      throw InputError("The range of the velocity starts at zero; a power law "
                       "over it needs a positive lower end.");

    std::vector<double> velocities, mu;
    for (std::size_t row = 0; row < runs.y.size(); ++row)
      {
        velocities.push_back(runs.x[row * inputs.size() + v]);
        mu.push_back(std::exp(runs.y[row]));
      }
    PiecewisePowerOptions options;
    options.least_share_beyond = 0.25;
    const PiecewisePowerFit fit =
      fit_piecewise_power_law(velocities, mu, {}, options);
    PowerLaw result;
    for (const LawInput &input : inputs)
      result.floors.push_back(input.lower);
    if (fit.law.has_constant_part)
      result.floors[v] = fit.law.v_0;
    result.exponents.assign(inputs.size(), 0.);
    result.exponents[v] = fit.law.exponent;
    result.coefficient =
      fit.law.mu_0 * std::pow(fit.law.v_0, -fit.law.exponent);
    result.mean_relative_error = fit.mean_relative_error;
    result.leave_one_out_error = fit.leave_one_out_error;
    return result;
  }



  std::string
  to_string(const PowerLaw &power_law, const std::vector<LawInput> &inputs)
  {
    std::string text = "mu = " + format_quantity(power_law.coefficient, "1", 4),
                floors;
    for (std::size_t i = 0; i < inputs.size(); ++i)
      if (power_law.exponents[i] != 0.)
        {
          text += " " + inputs[i].symbol + "^" +
                  format_quantity(power_law.exponents[i], "1", 4);
          floors += ", " + inputs[i].symbol +
                    " >= " + format_quantity(power_law.floors[i], "1", 4);
        }
    return text + " (SI)" + floors;
  }
} // namespace asperity
