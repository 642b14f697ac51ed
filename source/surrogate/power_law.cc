#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/surrogate/power_law.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "lapack.h"

namespace asperity
{
  namespace
  {
    /** ln y = sum over i of c_i a_i, by the normal equations: the columns are
     *  logarithms scaled to [0, 1], so these are well conditioned. */
    class LeastSquares
    {
    public:
      /** @param a n rows of m columns */
      LeastSquares(const std::vector<double> &a, const std::vector<double> &y)
        : a(a)
        , y(y)
        , m(a.size() / y.size())
      {
        std::vector<double> matrix(m * m, 0.);
        coefficients.assign(m, 0.);
        for (std::size_t row = 0; row < y.size(); ++row)
          for (std::size_t i = 0; i < m; ++i)
            {
              coefficients[i] += a[row * m + i] * y[row];
              for (std::size_t j = 0; j < m; ++j)
                matrix[i * m + j] += a[row * m + i] * a[row * m + j];
            }
        const int size = static_cast<int>(m);
        int       info = 0;
        dpotrf_("L", &size, matrix.data(), &size, &info);
        bool determined = info == 0;
        for (std::size_t i = 0; i < m && determined; ++i)
          determined = matrix[i * m + i] > 1e-7 * matrix[0];
        if (!determined)
          throw InputError("The runs of the friction law do not determine the "
                           "exponents of a power law: its inputs do not vary "
                           "independently of each other.");
        factor = matrix;
        solve(coefficients);
      }

      std::vector<double> coefficients;

      double
      residual(const std::size_t row) const
      {
        double result = y[row];
        for (std::size_t i = 0; i < m; ++i)
          result -= coefficients[i] * a[row * m + i];
        return result;
      }

      /** The residual without this row in the fit: r / (1 - h), h the diagonal
       *  of the hat matrix A (A^T A)^-1 A^T. */
      double
      left_out_residual(const std::size_t row) const
      {
        std::vector<double> b(a.begin() + row * m, a.begin() + (row + 1) * m);
        solve(b);
        double h = 0.;
        for (std::size_t i = 0; i < m; ++i)
          h += a[row * m + i] * b[i];
        return residual(row) / std::max(1. - h, 1e-12);
      }

      double
      sum_of_squares() const
      {
        double result = 0.;
        for (std::size_t row = 0; row < y.size(); ++row)
          result += residual(row) * residual(row);
        return result;
      }

    private:
      void
      solve(std::vector<double> &b) const
      {
        const int size = static_cast<int>(m), one = 1;
        int       info = 0;
        dpotrs_("L", &size, &one, factor.data(), &size, b.data(), &size, &info);
      }

      const std::vector<double> a, y;
      const std::size_t         m;
      std::vector<double>       factor;
    };

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
      double logarithm = fit.coefficients[0];
      for (std::size_t i = 0; i < active.size(); ++i)
        {
          const double exponent =
            fit.coefficients[i + 1] / runs.scale(active[i]);
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
    return make_power_law(runs, LeastSquares(a, runs.y), active, floors);
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

    constexpr unsigned int n_candidates = 200;
    double                 best = std::numeric_limits<double>::infinity();
    PowerLaw               result;
    for (unsigned int i = 0; i < n_candidates; ++i)
      {
        const double v_0 =
          found->lower * std::exp(runs.scale(v) * i / n_candidates);
        std::vector<double> a;
        std::set<double>    beyond;
        std::size_t         n_beyond = 0;
        for (std::size_t row = 0; row < runs.y.size(); ++row)
          {
            a.push_back(1.);
            a.push_back(runs.column(row, v, v_0));
            const double velocity = runs.x[row * inputs.size() + v];
            if (velocity > v_0)
              {
                beyond.insert(velocity);
                ++n_beyond;
              }
          }
        if (beyond.size() < 2 || 4 * n_beyond < runs.y.size())
          break;
        const LeastSquares fit(a, runs.y);
        if (fit.sum_of_squares() >= best)
          continue;
        best = fit.sum_of_squares();
        std::vector<double> floors;
        for (const LawInput &input : inputs)
          floors.push_back(input.lower);
        floors[v] = v_0;
        result    = make_power_law(runs, fit, {v}, floors);
      }
    if (!std::isfinite(best))
      throw InputError("The runs of the friction law have too few velocities "
                       "for a power law over the velocity.");
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
