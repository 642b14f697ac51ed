#include <asperity/surrogate/friction_law.h>
#include <asperity/surrogate/hyperparameter_search.h>

#include <algorithm>
#include <cmath>

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
    const TrainingData               data = law.scaled_data();
    const HyperparameterSearchResult found =
      find_hyperparameters(description.kernel, data);
    law.process_ =
      std::make_shared<const GaussianProcess>(description.kernel,
                                              found.hyperparameters,
                                              data);
    law.description_.warnings = found.warnings;
    if (law.process_->jitter() > 0.)
      law.description_.warnings.push_back(
        "A jitter was added to the diagonal of the covariance matrix: some "
        "training points nearly coincide.");

    double     error    = 0.;
    const auto left_out = law.process_->leave_one_out();
    for (std::size_t j = 0; j < y.size(); ++j)
      error += std::abs(law.unscaled(left_out[j].mean) - y[j]) /
               std::max(std::abs(y[j]), 1e-300);
    law.description_.leave_one_out_error =
      error / static_cast<double>(y.size());
    return law;
  }
} // namespace asperity
