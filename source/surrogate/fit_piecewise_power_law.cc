#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/surrogate/piecewise_power_law.h>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "least_squares.h"

namespace asperity
{
  namespace
  {
    /** The measurements in logarithms, weighted. */
    class Fit
    {
    public:
      Fit(const std::vector<double>   &v,
          const std::vector<double>   &mu,
          const std::vector<double>   &deviation,
          const PiecewisePowerOptions &options)
        : options(options)
        , knows_deviations(!deviation.empty())
        , n(mu.size())
      {
        for (std::size_t i = 0; i < n; ++i)
          {
            for (const double value : {v[i], mu[i]})
              if (!(value > 0. && std::isfinite(value)))
                throw InputError("A power law needs positive velocities and "
                                 "friction coefficients; " +
                                 format_number(value) + " is among them.");
            const double relative =
              knows_deviations ? deviation[i] / mu[i] : 1.;
            if (!(relative > 0. && std::isfinite(relative)))
              throw InputError("A deviation of mu is " +
                               format_number(deviation[i]) +
                               "; a positive number is expected, or none for "
                               "all values.");
            root_weight.push_back(1. / relative);
            x.push_back(std::log(v[i]));
            y.push_back(std::log(mu[i]));
          }
        const std::set<double> distinct(x.begin(), x.end());
        velocities.assign(distinct.begin(), distinct.end());
      }

      /** The fit without constant part: its knee is the smallest velocity. */
      double
      smallest() const
      {
        return velocities.front();
      }

      /** The logarithm of v_0 with the least sum of squares. */
      double
      best_knee() const
      {
        double best = smallest(), least = std::numeric_limits<double>::max();
        // two velocities beyond the knee make a power
        for (std::size_t i = 0; i + 2 < velocities.size(); ++i)
          {
            const auto sum = [&](const double knee) {
              return enough_beyond(knee) ? at(knee).sum_of_squares() :
                                           std::numeric_limits<double>::max();
            };
            const int bits           = std::numeric_limits<double>::digits / 2;
            const auto [knee, value] = boost::math::tools::brent_find_minima(
              sum, velocities[i], velocities[i + 1], bits);
            if (value < least)
              {
                least = value;
                best  = knee;
              }
          }
        return best;
      }

      /** Akaike's corrected criterion for a number of constants. */
      double
      criterion(const double knee, const unsigned int n_constants) const
      {
        const double k    = n_constants + 1.; // and the scatter
        const double size = static_cast<double>(n);
        if (size - k - 1. < 1.)
          return std::numeric_limits<double>::max();
        // what is exact needs no further constant
        const double exact = size * 1e-20;
        return size * std::log(at(knee).sum_of_squares() / size + exact) +
               2. * k * size / (size - k - 1.);
      }

      PiecewisePowerFit
      finish(const double knee, const bool has_part, const bool is_fitted) const
      {
        const LeastSquares least_squares = at(knee);
        require(least_squares.is_determined());
        PiecewisePowerFit  result;
        PiecewisePowerLaw &law = result.law;
        law.mu_0               = std::exp(least_squares.coefficients()[0]);
        law.v_0                = std::exp(knee);
        law.exponent           = least_squares.coefficients()[1];
        law.has_constant_part  = has_part;
        const std::size_t m    = is_fitted ? 3 : 2;
        if (n <= m)
          throw InputError("There are " + std::to_string(n) +
                           " measurements for " + std::to_string(m) +
                           " constants; at least one more than constants is "
                           "expected, so that errors can be told.");
        result.degrees_of_freedom = static_cast<unsigned int>(n - m);
        set_errors(result, least_squares, is_fitted);
        const double size = static_cast<double>(n);
        for (std::size_t i = 0; i < n; ++i)
          {
            const double w = root_weight[i];
            result.mean_relative_error +=
              std::abs(std::expm1(-least_squares.residual(i) / w)) / size;
            result.leave_one_out_error +=
              std::abs(std::expm1(-least_squares.left_out_residual(i) / w)) /
              size;
          }
        return result;
      }

      const PiecewisePowerOptions options;

    private:
      LeastSquares
      at(const double knee) const
      {
        std::vector<double> a, b;
        for (std::size_t i = 0; i < n; ++i)
          {
            a.push_back(root_weight[i]);
            a.push_back(root_weight[i] * std::max(0., x[i] - knee));
            b.push_back(root_weight[i] * y[i]);
          }
        return {a, b};
      }

      bool
      enough_beyond(const double knee) const
      {
        const auto beyond =
          std::count_if(x.begin(), x.end(), [&](const double value) {
            return value > knee;
          });
        return static_cast<double>(beyond) >=
               options.least_share_beyond * static_cast<double>(n);
      }

      static void
      require(const bool is_determined)
      {
        if (!is_determined)
          throw InputError("The measurements do not determine the constants of "
                           "a power law over the velocity: they need two "
                           "velocities beyond the constant part, and a "
                           "constant part that is fitted needs one before its "
                           "end and a mu that changes behind it.");
      }

      /** Covariance by linearisation, and scatter. */
      void
      set_errors(PiecewisePowerFit  &fit,
                 const LeastSquares &least_squares,
                 const bool          is_fitted) const
      {
        PiecewisePowerLaw &law    = fit.law;
        const double       square = least_squares.sum_of_squares() /
                              static_cast<double>(fit.degrees_of_freedom);
        const double factor = knows_deviations ? std::max(1., square) : square;
        double       mean_square = 0.;
        for (const double w : root_weight)
          mean_square += 1. / (w * w * static_cast<double>(n));
        law.scatter = std::sqrt(factor * mean_square);

        const std::vector<std::size_t> place =
          is_fitted ? std::vector<std::size_t>{0, 1, 2} :
                      std::vector<std::size_t>{0, 2};
        const double        knee = std::log(law.v_0);
        std::vector<double> a;
        for (std::size_t i = 0; i < n; ++i)
          {
            const double by[3] = {1.,
                                  x[i] > knee ? -law.exponent : 0.,
                                  std::max(0., x[i] - knee)};
            for (const std::size_t p : place)
              a.push_back(root_weight[i] * by[p]);
          }
        const LeastSquares linearised(a, std::vector<double>(n, 0.));
        require(linearised.is_determined());
        const std::vector<double> inverse = linearised.inverse();
        for (std::size_t i = 0; i < place.size(); ++i)
          for (std::size_t j = 0; j < place.size(); ++j)
            law.covariance[3 * place[i] + place[j]] =
              factor * inverse[i * place.size() + j];
      }

      const bool          knows_deviations;
      const std::size_t   n;
      std::vector<double> x, y, root_weight, velocities;
    };
  } // namespace



  PiecewisePowerFit
  fit_piecewise_power_law(const std::vector<double>   &v,
                          const std::vector<double>   &mu,
                          const std::vector<double>   &deviation,
                          const PiecewisePowerOptions &options)
  {
    if (mu.empty())
      throw InputError("There is no measurement to which a power law could be "
                       "fitted.");
    const Fit fit(v, mu, deviation, options);
    switch (options.constant_part)
      {
        case ConstantPart::none:
          return fit.finish(fit.smallest(), false, false);
        case ConstantPart::given:
          return fit.finish(std::log(options.v_0), true, false);
        case ConstantPart::fitted:
          return fit.finish(fit.best_knee(), true, true);
        case ConstantPart::automatic:
          break;
      }
    const double knee = fit.best_knee();
    const bool   is_better =
      knee > fit.smallest() &&
      fit.criterion(knee, 3) < fit.criterion(fit.smallest(), 2);
    return fit.finish(is_better ? knee : fit.smallest(), is_better, is_better);
  }



  std::string
  to_string(const PiecewisePowerLaw &law, const std::string &unit)
  {
    const std::array<double, 3> error = law.standard_errors();
    const auto                  value =
      [](const double x, const double e, const std::string &in) {
        const double per_si = from_si(1., in) - from_si(0., in);
        return format_quantity(x, in, 4) +
               (e > 0. ? " (standard error " +
                           format_quantity(e * per_si, "1", 2) + ")" :
                         "");
      };
    return std::string("mu = mu_0 (v/v_0)^n") +
           (law.has_constant_part ? " beyond v_0, mu_0 below" : "") +
           ", mu_0 = " + value(law.mu_0, error[0], "1") +
           ", v_0 = " + value(law.v_0, error[1], unit) +
           ", n = " + value(law.exponent, error[2], "1");
  }
} // namespace asperity
