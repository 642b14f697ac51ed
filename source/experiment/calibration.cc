#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/experiment/calibration.h>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity
{
  namespace
  {
    /** The sum of squares as a function of the input. */
    class Misfit
    {
    public:
      Misfit(const FrictionLaw     &law,
             const std::size_t      input,
             const CalibrationData &data)
        : law(law)
        , input(input)
        , data(data)
      {
        for (std::size_t i = 0; i < data.mu.size(); ++i)
          size.push_back(data.deviation.empty() ? data.mu[i] :
                                                  data.deviation[i]);
      }

      std::vector<LawPrediction>
      predict(const double value) const
      {
        std::vector<LawPrediction> result;
        for (std::vector<double> x : data.x)
          {
            x[input] = value;
            result.push_back(law.predict(x.data()));
          }
        return result;
      }

      double
      operator()(const double value) const
      {
        double sum = 0.;
        for (std::size_t i = 0; i < data.mu.size(); ++i)
          {
            std::vector<double> x = data.x[i];
            x[input]              = value;
            sum += std::pow((data.mu[i] - law.mean(x.data())) / size[i], 2);
          }
        return sum;
      }

      /** The best value. @throws InputError if it is an end of the range */
      double
      minimum() const
      {
        constexpr unsigned int n     = 64;
        const LawInput        &range = law.description().inputs[input];
        const auto             at    = [&](const double i) {
          return range.lower + i / n * (range.upper - range.lower);
        };
        unsigned int best  = 0;
        double       least = std::numeric_limits<double>::max();
        for (unsigned int i = 0; i <= n; ++i)
          if (const double value = (*this)(at(i)); value < least)
            {
              least = value;
              best  = i;
            }
        const double found =
          boost::math::tools::brent_find_minima(
            [&](const double value) { return (*this)(value); },
            at(best == 0 ? 0. : best - 1.),
            at(std::min(best + 1., 1. * n)),
            std::numeric_limits<double>::digits / 2)
            .first;
        const double margin = 1e-6 * (range.upper - range.lower);
        for (const double end : {range.lower, range.upper})
          if (std::abs(found - end) < margin)
            refuse_end(end);
        return found;
      }

      void
      set_errors(Calibration &result) const
      {
        double curvature = 0., of_law = 0.;
        for (std::size_t i = 0; i < data.mu.size(); ++i)
          {
            const LawPrediction &at = result.computed[i];
            curvature += std::pow(at.gradient[input] / size[i], 2);
            of_law += at.gradient[input] * at.deviation / (size[i] * size[i]);
          }
        const LawInput &range  = law.description().inputs[input];
        const double    extent = range.upper - range.lower;
        const double    n      = static_cast<double>(data.mu.size());
        const double    square = n > 1. ? (*this)(result.value) / (n - 1.) : 0.;
        const bool      is_known = n > 1. || !data.deviation.empty();
        if (is_known)
          result.standard_error =
            std::sqrt((data.deviation.empty() ? square : std::max(1., square)) /
                      curvature);
        // a change of mu by its own size over the whole range
        const bool is_flat = !(curvature * extent * extent > 1e-6 * n);
        if (is_flat || (is_known && !(*result.standard_error < 0.5 * extent)))
          throw InputError(
            "The measurements do not determine " + quoted_name(range.name) +
            (is_flat ? ": the friction law hardly depends on it there." :
                       ": its standard error would be " +
                         format_quantity(*result.standard_error, "1", 2) +
                         ", in a range from " +
                         format_quantity(range.lower, range.unit, 4) + " to " +
                         format_quantity(range.upper, range.unit, 4) + "."));
        result.error_of_law = std::abs(of_law) / curvature;
      }

    private:
      [[noreturn]] void
      refuse_end(const double end) const
      {
        const LawInput &range    = law.description().inputs[input];
        double          measured = 0., computed = 0.;
        const auto      at = predict(end);
        const double    n  = static_cast<double>(data.mu.size());
        for (std::size_t i = 0; i < data.mu.size(); ++i)
          {
            measured += data.mu[i] / n;
            computed += at[i].mean / n;
          }
        throw InputError(
          "The measurements do not determine " + quoted_name(range.name) +
          ": the best value is the end of its range, " +
          format_quantity(end, range.unit, 4) + ", where the mean of mu is " +
          format_quantity(computed, "1", 3) + ", and " +
          format_quantity(measured, "1", 3) + " was measured.");
      }

      const FrictionLaw     &law;
      const std::size_t      input;
      const CalibrationData &data;
      std::vector<double>    size;
    };
  } // namespace



  Calibration
  calibrate(const FrictionLaw     &law,
            const std::size_t      input,
            const CalibrationData &data)
  {
    const Misfit misfit(law, input, data);
    Calibration  result;
    result.value    = misfit.minimum();
    result.computed = misfit.predict(result.value);
    misfit.set_errors(result);
    return result;
  }
} // namespace asperity
