#include <asperity/contact_zone/friction_result.h>
#include <asperity/learned_fields/field_model.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** Width of a 95 % interval over the standard deviation. */
    constexpr double interval = 2. * 1.959964;

    /** Deviation of another run's value. */
    double
    deviation_of(const LawPrediction &at)
    {
      return (at.upper - at.lower) / interval;
    }

    double
    root_mean_square(const std::vector<double> &values)
    {
      double sum = 0.;
      for (const double value : values)
        sum += value * value;
      return values.empty() ? 0. : std::sqrt(sum / values.size());
    }

    /** Distance from the box along its worst input, over the width. */
    double
    distance_from_box(const FrictionLawDescription &description,
                      const std::vector<double>    &x)
    {
      double largest = 0.;
      for (std::size_t i = 0; i < x.size(); ++i)
        {
          const LawInput &input = description.inputs[i];
          largest =
            std::max({largest,
                      (input.lower - x[i]) / (input.upper - input.lower),
                      (x[i] - input.upper) / (input.upper - input.lower)});
        }
      return largest;
    }
  } // namespace



  double
  FieldTrust::score() const
  {
    return std::max({load, stress, shear, codes, box});
  }



  FieldModel::FieldModel(const FieldData                        &data,
                         std::shared_ptr<const FieldDecoder>     decoder,
                         const std::vector<std::vector<double>> &codes)
    : FieldModel(data.layout, data.times, std::move(decoder))
  {
    train_laws(data, codes);
    set_limits(data, codes);
  }



  FieldModel::FieldModel(const FieldLayout                  &layout,
                         const std::vector<FieldTime>       &times,
                         std::shared_ptr<const FieldDecoder> decoder)
    : layout_(layout)
    , times(times)
    , decoder_(std::move(decoder))
  {
    if (const FieldModes *modes = decoder_->modes())
      forces_of_modes.emplace(layout_, *modes);
  }



  void
  FieldModel::train_laws(const FieldData                        &data,
                         const std::vector<std::vector<double>> &codes)
  {
    std::vector<double>              x;
    std::vector<std::vector<double>> z(decoder_->n_codes()), mu(times.size());
    for (std::size_t r = 0; r < data.runs.size(); ++r)
      {
        const FieldRun &run = data.runs[r];
        if (run.held)
          continue;
        x.insert(x.end(), run.x.begin(), run.x.end());
        for (std::size_t k = 0; k < z.size(); ++k)
          z[k].push_back(codes[r][k]);
        for (std::size_t i = 0; i < times.size(); ++i)
          mu[i].push_back(run.mu[i]);
      }
    FrictionLawDescription description = data.description;
    description.output_scale           = Scale::linear;
    for (std::size_t i = 0; i < times.size(); ++i)
      {
        description.output = "mu";
        mu_laws.push_back(FrictionLaw::train(description, x, mu[i]));
      }
    for (std::size_t k = 0; k < z.size(); ++k)
      {
        description.output = "code " + std::to_string(k + 1);
        code_laws.push_back(FrictionLaw::train(description, x, z[k]));
        double mean = 0.;
        for (const double value : z[k])
          mean += value / z[k].size();
        for (double &value : z[k])
          value -= mean;
        spread.push_back(root_mean_square(z[k]));
      }
  }



  void
  FieldModel::set_limits(const FieldData                        &data,
                         const std::vector<std::vector<double>> &codes)
  {
    FieldLimits         largest;
    std::vector<double> errors;
    for (std::size_t r = 0; r < data.runs.size(); ++r)
      {
        const FieldRun &run = data.runs[r];
        if (!run.held)
          continue;
        const FieldPrediction at = predict(run.x);
        for (const FieldMomentPrediction &moment : at.moments)
          {
            largest.load   = std::max(largest.load, moment.load_residual);
            largest.stress = std::max(largest.stress, moment.stress_residual);
            largest.shear  = std::max(largest.shear, moment.shear_residual);
          }
        largest.codes   = std::max(largest.codes, at.trust.codes);
        const auto best = judge(codes[r], run.x);
        for (std::size_t i = 0; i < times.size(); ++i)
          errors.push_back(best[i].mu - run.mu[i]);
      }
    // A residual of rounding is none.
    constexpr double smallest = 1e-6;
    for (double *limit :
         {&largest.load, &largest.stress, &largest.shear, &largest.codes})
      *limit = std::max(smallest, FieldLimits::margin * *limit);
    largest.mu = root_mean_square(errors);
    limits_    = largest;
  }



  double
  FieldModel::load_at(const unsigned int         time,
                      const std::vector<double> &x) const
  {
    const auto p = pressure_of(mu_law().description());
    return times[time].pressure * (p ? x[*p] : 1.);
  }



  std::vector<FieldMomentPrediction>
  FieldModel::judge(const std::vector<double> &code,
                    const std::vector<double> &x) const
  {
    const std::vector<FieldForces>     at = forces(code);
    const double                       L  = layout_.about().places.period;
    std::vector<FieldMomentPrediction> result;
    for (unsigned int i = 0; i < times.size(); ++i)
      {
        const auto           &force     = at[i].traction;
        const auto           &imbalance = at[i].imbalance;
        const double          load      = load_at(i, x) * L;
        FieldMomentPrediction moment;
        moment.T_x = force[0];
        moment.T_y = force[1];
        moment.mu =
          friction_coefficient(force[0], force[1], times[i].direction);
        moment.load_residual   = std::abs(force[1] + load) / load;
        moment.stress_residual = std::hypot(imbalance[0], imbalance[1]) / load;
        moment.shear_residual =
          std::abs(friction_coefficient(force[0], -load, times[i].direction) -
                   mu_laws[i].mean(x.data()));
        result.push_back(moment);
      }
    return result;
  }



  std::vector<FieldForces>
  FieldModel::forces(const std::vector<double> &code) const
  {
    if (forces_of_modes)
      return forces_of_modes->combine(decoder_->coefficients(code));
    return forces_of(layout_, decoder_->decode(code));
  }



  FieldPrediction
  FieldModel::predict(const std::vector<double> &x) const
  {
    FieldPrediction result;
    for (const FrictionLaw &law : code_laws)
      {
        const LawPrediction at = law.predict(x.data());
        result.code.push_back(at.mean);
        result.deviation.push_back(deviation_of(at));
      }
    result.moments = judge(result.code, x);
    // The components of the code err independently, and mu is all but linear
    // in each of them within a deviation.
    std::vector<double> variance(times.size(), limits_.mu * limits_.mu);
    for (std::size_t k = 0; k < result.code.size(); ++k)
      {
        std::vector<double> moved = result.code;
        moved[k] += result.deviation[k];
        const std::vector<FieldForces> shifted = forces(moved);
        for (std::size_t i = 0; i < times.size(); ++i)
          {
            const auto  &T = shifted[i].traction;
            const double change =
              friction_coefficient(T[0], T[1], times[i].direction) -
              result.moments[i].mu;
            variance[i] += change * change;
          }
      }
    for (std::size_t i = 0; i < times.size(); ++i)
      result.moments[i].mu_deviation = std::sqrt(variance[i]);
    result.trust = trust(result, x);
    return result;
  }



  FieldTrust
  FieldModel::trust(const FieldPrediction     &prediction,
                    const std::vector<double> &x) const
  {
    const auto over = [](const double value, const double limit) {
      return limit > 0. ? value / limit : value;
    };
    FieldTrust result;
    for (const FieldMomentPrediction &moment : prediction.moments)
      {
        result.load =
          std::max(result.load, over(moment.load_residual, limits_.load));
        result.stress =
          std::max(result.stress, over(moment.stress_residual, limits_.stress));
        result.shear =
          std::max(result.shear, over(moment.shear_residual, limits_.shear));
      }
    result.codes =
      over(root_mean_square(prediction.deviation) / root_mean_square(spread),
           limits_.codes);
    const double distance = distance_from_box(mu_law().description(), x);
    result.box = distance > FrictionLaw::edge_tolerance ? 1. + distance : 0.;
    return result;
  }



  FieldMoment
  FieldModel::moment(const unsigned int         time,
                     const std::vector<double> &x) const
  {
    FieldMoment result{times[time].time, times[time].sliding_distance, time};
    const auto &inputs = mu_law().description().inputs;
    for (std::size_t i = 0; i < inputs.size(); ++i)
      if (inputs[i].name == "Load/Velocity")
        result.time = result.sliding_distance / x[i];
    return result;
  }



  const FieldLayout &
  FieldModel::layout() const
  {
    return layout_;
  }



  const FieldDecoder &
  FieldModel::decoder() const
  {
    return *decoder_;
  }



  const FrictionLaw &
  FieldModel::mu_law() const
  {
    return mu_laws.back();
  }



  const FieldLimits &
  FieldModel::limits() const
  {
    return limits_;
  }
} // namespace asperity
