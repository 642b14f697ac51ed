#include <asperity/base/errors.h>
#include <asperity/surrogate/active_learning.h>
#include <asperity/surrogate/design.h>

#include <algorithm>
#include <cmath>

#include "posterior_covariance.h"

namespace asperity
{
  namespace
  {
    /** With more inputs there are too many corners to list. */
    constexpr unsigned int most_inputs_with_corners = 8;

    /**
     * Sobol points, the first of them once more stretched by a quarter about
     * the middle and clipped to the cube, so that each coordinate lies at an
     * end of its range with a probability of a fifth: faces, edges and corners
     * get their share. Then all corners.
     */
    std::vector<double>
    candidates_in_unit_cube(const unsigned int d, const std::size_t n)
    {
      std::vector<double> points = unit_sobol(n, d);
      for (std::size_t i = 0; i < n / 2 * d; ++i)
        points.push_back(
          std::min(1., std::max(0., 0.5 + 1.25 * (points[i] - 0.5))));
      if (d <= most_inputs_with_corners)
        for (const double z : unit_corners(d))
          points.push_back(z);
      return points;
    }

    /** Chooses points among candidates and keeps account of what is known. */
    class Chooser
    {
    public:
      Chooser(const FrictionLaw           &law,
              const std::vector<double>   &occupied,
              const ActiveLearningOptions &options);

      /** The best candidate, which is known from then on, or none. */
      bool
      choose(std::vector<double> &unit);

    private:
      /** Candidates near a point are no candidates any more. */
      void
      exclude_neighbours(const double *point);

      /** Inverse squares of the means at the candidates, up to a factor. */
      void
      weigh(const FrictionLaw &law);

      void
      correlate_with_references();

      double
      score(const std::size_t candidate) const;

      const ActiveLearningOptions      options;
      const unsigned int               d;
      const double                     noise;
      std::vector<double>              candidates; ///< in the unit cube
      std::size_t                      n_candidates, n_references;
      std::size_t                      first; ///< candidate among all points
      std::vector<bool>                is_free;
      std::vector<double>              weights;
      PosteriorCovariance              posterior;
      std::vector<std::vector<double>> covariances; ///< with the references
    };

    std::vector<double>
    joined(std::vector<double>        first,
           const std::vector<double> &second,
           const std::vector<double> &third)
    {
      first.insert(first.end(), second.begin(), second.end());
      first.insert(first.end(), third.begin(), third.end());
      return first;
    }

    Chooser::Chooser(const FrictionLaw           &law,
                     const std::vector<double>   &occupied,
                     const ActiveLearningOptions &options)
      : options(options)
      , d(law.description().inputs.size())
      , noise(law.process().hyperparameters().noise_variance +
              law.process().jitter())
      , candidates(candidates_in_unit_cube(d, options.n_candidates))
      , n_candidates(candidates.size() / d)
      , n_references(std::min(options.n_references, options.n_candidates))
      , first((law.process().data().x.size() + occupied.size()) / d)
      , is_free(n_candidates, true)
      , posterior(law.process().kernel(),
                  law.process().hyperparameters(),
                  joined(law.process().data().x,
                         law.coordinates().transform(occupied),
                         law.coordinates().transform(
                           map_to_box(law.description().inputs, candidates))))
    {
      const TrainingData       &data = law.process().data();
      const std::vector<double> known =
        map_to_unit(law.description().inputs,
                    joined(law.data().x, occupied, {}));
      const std::size_t n = data.y.size();
      for (std::size_t i = 0; i < first; ++i)
        {
          const bool is_noisy = i < n && !data.known_variance.empty();
          posterior.make_known(i,
                               noise +
                                 (is_noisy ? data.known_variance[i] : 0.));
          exclude_neighbours(&known[i * d]);
        }
      weigh(law);
      correlate_with_references();
    }



    void
    Chooser::exclude_neighbours(const double *point)
    {
      for (std::size_t j = 0; j < n_candidates; ++j)
        {
          double square = 0.;
          for (unsigned int k = 0; k < d; ++k)
            {
              const double difference = candidates[j * d + k] - point[k];
              square += difference * difference;
            }
          if (std::sqrt(square) < options.smallest_distance)
            is_free[j] = false;
        }
    }



    void
    Chooser::weigh(const FrictionLaw &law)
    {
      weights.assign(n_candidates, 1.);
      if (law.description().output_scale == Scale::logarithmic)
        return;
      const auto          x = map_to_box(law.description().inputs, candidates);
      std::vector<double> means(n_candidates);
      law.means(n_candidates, x.data(), means.data());
      double average = 0.;
      for (const double mean : means)
        average += std::abs(mean) / static_cast<double>(n_candidates);
      if (average == 0.)
        return;
      for (std::size_t j = 0; j < n_candidates; ++j)
        {
          const double mean = std::max(std::abs(means[j]) / average, 0.1);
          weights[j]        = 1. / (mean * mean);
        }
    }



    void
    Chooser::correlate_with_references()
    {
      for (std::size_t j = 0; j < n_candidates; ++j)
        covariances.push_back(
          posterior.covariances(first + j, first, first + n_references));
    }



    double
    Chooser::score(const std::size_t candidate) const
    {
      const double variance = posterior.variance(first + candidate);
      // The variance of a reference falls by cov^2 / (variance + noise).
      double decrease = 0.;
      for (std::size_t i = 0; i < n_references; ++i)
        decrease +=
          weights[i] * covariances[candidate][i] * covariances[candidate][i];
      return variance + noise > 0. ? decrease / (variance + noise) : 0.;
    }



    bool
    Chooser::choose(std::vector<double> &unit)
    {
      std::size_t best       = n_candidates;
      double      best_score = -1.;
      for (std::size_t j = 0; j < n_candidates; ++j)
        if (is_free[j])
          {
            const double candidate_score = score(j);
            if (candidate_score > best_score)
              {
                best       = j;
                best_score = candidate_score;
              }
          }
      if (best == n_candidates)
        return false;

      const double *const point = &candidates[best * d];
      unit.insert(unit.end(), point, point + d);
      posterior.make_known(first + best, noise);
      exclude_neighbours(point);
      const std::vector<double> &row = posterior.last_row();
      for (std::size_t j = 0; j < covariances.size(); ++j)
        for (std::size_t i = 0; i < n_references; ++i)
          covariances[j][i] -= row[first + j] * row[first + i];
      return true;
    }
  } // namespace



  std::vector<double>
  next_points(const FrictionLaw           &law,
              const std::vector<double>   &occupied,
              const std::size_t            n_points,
              const ActiveLearningOptions &options)
  {
    if (options.n_candidates == 0 || options.n_references == 0)
      throw InputError("Active learning was asked to choose among " +
                       std::to_string(options.n_candidates) +
                       " candidates with " +
                       std::to_string(options.n_references) +
                       " references; at least one of each is expected.");
    Chooser             chooser(law, occupied, options);
    std::vector<double> unit;
    for (std::size_t i = 0; i < n_points && chooser.choose(unit); ++i)
      ;
    return map_to_box(law.description().inputs, unit);
  }



  CrossValidation
  cross_validate(const FrictionLaw &law)
  {
    const std::vector<GaussianProcess::LeftOut> left_out =
      law.process().leave_one_out();
    const std::vector<double> &scaled = law.process().data().y;
    const std::vector<double> &y      = law.data().y;
    const bool                 is_logarithmic =
      law.description().output_scale == Scale::logarithmic;

    CrossValidation result;
    const double    n = static_cast<double>(y.size());
    for (std::size_t i = 0; i < y.size(); ++i)
      {
        const double g = law.offset() + law.factor() * left_out[i].mean;
        const double error =
          std::abs(is_logarithmic ? std::exp(g) - y[i] : g - y[i]) /
          std::max(std::abs(y[i]), 1e-300);
        result.mean_relative_error += error / n;
        result.largest_relative_error =
          std::max(result.largest_relative_error, error);
        if (std::abs(left_out[i].mean - scaled[i]) <=
            1.96 * std::sqrt(left_out[i].variance))
          result.coverage += 1. / n;
      }
    return result;
  }



  bool
  StoppingRule::is_met(const std::vector<double> &errors) const
  {
    if (errors.size() < std::max(n_batches, 1u))
      return false;
    return std::all_of(errors.end() - std::max(n_batches, 1u),
                       errors.end(),
                       [&](const double error) {
                         return safety * error <= target;
                       });
  }
} // namespace asperity
