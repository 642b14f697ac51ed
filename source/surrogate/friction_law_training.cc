#include <asperity/base/quantity.h>
#include <asperity/surrogate/friction_law.h>
#include <asperity/surrogate/hyperparameter_search.h>

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity
{
  namespace
  {
    /** Mean and standard deviation of g(y). Constant values get the deviation
     *  of their rounding error, so that the law is constant and sure of it. */
    void
    standardize(const Scale                scale,
                const std::vector<double> &y,
                double                    &offset,
                double                    &factor)
    {
      const double        n = static_cast<double>(y.size());
      std::vector<double> g = y;
      if (scale == Scale::logarithmic)
        for (double &value : g)
          value = std::log(value);
      offset = 0.;
      for (const double value : g)
        offset += value / n;
      double square = 0.;
      for (const double value : g)
        square += (value - offset) * (value - offset) / n;
      factor = std::max(std::sqrt(square), 1e-12 * (1. + std::abs(offset)));
    }



    /**
     * The factor of the deviation with which the 95 % interval holds 95 % of
     * the training points, each predicted by the others. The likelihood alone
     * trusts that the function is a draw of the kernel's process (R. Barber et
     * al., Ann. Statist. 49 (2021) 486, the quantile of the jackknife; F.
     * Bachoc, Comput. Stat. Data Anal. 66 (2013) 55, variances by
     * cross-validation).
     */
    double
    calibration_factor(const GaussianProcess &process)
    {
      constexpr std::size_t least_points = 20; // no 95 % of fewer
      constexpr double      largest      = 2.; // what few points may change

      const TrainingData &data     = process.data();
      const auto          left_out = process.leave_one_out();
      std::vector<double> error;
      for (std::size_t j = 0; j < data.y.size(); ++j)
        // A factor on all variances leaves the mean; known ones are fixed.
        if (data.known_variance.empty() || data.known_variance[j] == 0.)
          error.push_back(std::abs(left_out[j].mean - data.y[j]) /
                          std::sqrt(left_out[j].variance));
      const std::size_t n = error.size();
      if (n < least_points)
        return 1.;
      const auto rank = static_cast<std::size_t>(std::ceil(0.95 * (n + 1.)));
      const auto quantile = error.begin() + (std::min(rank, n) - 1);
      std::nth_element(error.begin(), quantile, error.end());
      // The point of the quantile lies inside of the interval.
      const double factor = (1. + 1e-6) * *quantile / 1.96;
      return std::min(std::max(factor, 1. / largest), largest);
    }



    /** A sentence for each face of the box that the training points stay away
     *  from: the interval knows nothing of a change of behaviour there. In a
     *  slab of 15 % it has held 64 to 100 % (tools/stability, C24). */
    std::vector<std::string>
    bare_faces(const std::vector<LawInput> &inputs,
               const std::vector<double>   &x)
    {
      constexpr double         largest_gap = 0.1;
      std::vector<std::string> warnings;
      for (std::size_t i = 0; i < inputs.size(); ++i)
        {
          const LawInput &in       = inputs[i];
          const auto      position = [&in](const double value) {
            return in.scale == Scale::logarithmic ?
                          std::log(value / in.lower) /
                       std::log(in.upper / in.lower) :
                          (value - in.lower) / (in.upper - in.lower);
          };
          double lowest = 1., highest = 0.;
          for (std::size_t j = i; j < x.size(); j += inputs.size())
            {
              lowest  = std::min(lowest, position(x[j]));
              highest = std::max(highest, position(x[j]));
            }
          for (const bool upper : {false, true})
            if (const double gap = upper ? 1. - highest : lowest;
                gap > largest_gap)
              warnings.push_back(
                std::string("No run lies in the ") +
                (upper ? "highest " : "lowest ") +
                std::to_string(static_cast<int>(100. * gap)) +
                " % of the range of " + in.symbol +
                ", where the 95 % interval may hold far less: compute runs "
                "there, or narrow the range.");
        }
      return warnings;
    }



    /** A sentence if the runs scatter so much that the interval is too narrow:
     *  what is learnt of it takes a part of the scatter for the law. Runs with
     *  noise of 3 to 10 % have left 0.03 to 0.1, and 77 to 97 % of other runs
     *  in the interval; of 2 % and less 94 to 97 % (tools/stability, C24). */
    std::string
    scatter_warning(const double left_out_error)
    {
      constexpr double largest = 0.03;
      if (left_out_error <= largest)
        return "";
      return "Runs that are left out lie " + per_cent(left_out_error) +
             " off the law in the mean, where " + per_cent(largest) +
             " is the most that is expected: by such scatter the 95 % interval "
             "has held only 77 to 97 % of other runs; slide farther (Protocol/"
             "Sliding distance) or compute more runs.";
    }
  } // namespace



  FrictionLaw
  FrictionLaw::train(const FrictionLawDescription &description,
                     const std::vector<double>    &x,
                     const std::vector<double>    &y,
                     const std::vector<double>    &known_deviation)
  {
    FrictionLaw law(description,
                    {x, y, known_deviation},
                    "Training of the friction law");
    standardize(description.output_scale, y, law.offset_, law.factor_);
    const TrainingData         data = law.scaled_data();
    HyperparameterSearchResult found =
      find_hyperparameters(description.kernel, data);
    Hyperparameters &chosen = found.hyperparameters;
    const double     factor =
      calibration_factor(GaussianProcess(description.kernel, chosen, data));
    chosen.signal_variance *= factor * factor;
    chosen.noise_variance *= factor * factor;
    law.regression =
      std::make_shared<const GaussianProcess>(description.kernel, chosen, data);
    law.description_.calibration = factor;
    if (const double n = description.n_profiles; n > 1.)
      law.description_.topography_error = gsl_cdf_tdist_Pinv(0.975, n - 1.) *
                                          description.topography_scatter /
                                          std::sqrt(n);
    law.description_.warnings = found.warnings;
    if (law.process().jitter() > 0.)
      law.description_.warnings.push_back(
        "A jitter was added to the diagonal of the covariance matrix: some "
        "training points nearly coincide.");
    for (const std::string &warning : bare_faces(description.inputs, x))
      law.description_.warnings.push_back(warning);
    law.description_.leave_one_out_error = law.left_out_error();
    if (const auto warning =
          scatter_warning(law.description_.leave_one_out_error);
        !warning.empty())
      law.description_.warnings.push_back(warning);
    return law;
  }



  FrictionLaw
  FrictionLaw::fit_to_measurements(const FrictionLawDescription &description,
                                   const std::vector<double>    &v,
                                   const std::vector<double>    &mu,
                                   const std::vector<double>    &deviation,
                                   const PiecewisePowerOptions  &options)
  {
    const PiecewisePowerFit fit =
      fit_piecewise_power_law(v, mu, deviation, options);
    FrictionLawDescription own = description;
    LawInput              &in  = own.inputs.at(0);
    in.lower                   = *std::min_element(v.begin(), v.end());
    in.upper                   = *std::max_element(v.begin(), v.end());
    in.scale                   = Scale::logarithmic;
    own.output_scale           = Scale::logarithmic;
    own.leave_one_out_error    = fit.leave_one_out_error;
    own.calibration = gsl_cdf_tdist_Pinv(0.975, fit.degrees_of_freedom) / 1.96;
    FrictionLaw law(own, {v, mu, deviation}, "Fit of the friction law");
    law.set_fitted(fit.law);
    return law;
  }
} // namespace asperity
