#include "likelihood_maximizer.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multimin.h>

#include <memory>

#include "covariance_matrix.h"

namespace asperity
{
  namespace
  {
    /** The negative log likelihood per point as GSL wants it. GSL asks for
     * value and gradient at the same place one after the other: the
     * factorisation is kept in between. */
    class Objective
    {
    public:
      Objective(const KernelKind                kernel,
                const TrainingData             &data,
                const std::vector<SmoothClamp> &clamps)
        : data(data)
        , clamps(clamps)
        , covariance(kernel, data)
        , point(clamps.size(), std::numeric_limits<double>::quiet_NaN())
      {}

      double
      value(const gsl_vector *u)
      {
        move_to(u);
        return is_factorized ? -covariance.log_likelihood() * scale() :
                               GSL_POSINF;
      }

      void
      gradient(const gsl_vector *u, gsl_vector *result)
      {
        move_to(u);
        gsl_vector_set_zero(result);
        if (!is_factorized)
          return;
        const std::vector<double> values = covariance.log_likelihood_gradient();
        for (std::size_t i = 0; i < clamps.size(); ++i)
          gsl_vector_set(result,
                         i,
                         -values[i] * scale() * clamps[i].slope(point[i]));
      }

      unsigned int n_evaluations = 0;

    private:
      double
      scale() const
      {
        return 1. / static_cast<double>(data.y.size());
      }

      void
      move_to(const gsl_vector *u)
      {
        bool same = true;
        for (std::size_t i = 0; i < clamps.size(); ++i)
          same = same && gsl_vector_get(u, i) == point[i];
        if (same)
          return;
        std::vector<double> logarithms(clamps.size());
        for (std::size_t i = 0; i < clamps.size(); ++i)
          {
            point[i]      = gsl_vector_get(u, i);
            logarithms[i] = clamps[i].value(point[i]);
          }
        ++n_evaluations;
        // otherwise as bad as can be: the line search turns back
        is_factorized = covariance.factorize(hyperparameters_of(logarithms));
      }

      const TrainingData             &data;
      const std::vector<SmoothClamp> &clamps;
      CovarianceMatrix                covariance;
      std::vector<double>             point;
      bool                            is_factorized = false;
    };

    double
    gsl_value(const gsl_vector *u, void *objective)
    {
      return static_cast<Objective *>(objective)->value(u);
    }

    void
    gsl_gradient(const gsl_vector *u, void *objective, gsl_vector *result)
    {
      static_cast<Objective *>(objective)->gradient(u, result);
    }

    void
    gsl_both(const gsl_vector *u,
             void             *objective,
             double           *value,
             gsl_vector       *gradient)
    {
      *value = gsl_value(u, objective);
      gsl_gradient(u, objective, gradient);
    }

    /** GSL's own handler ends the program. */
    struct QuietGsl
    {
      gsl_error_handler_t *const previous = gsl_set_error_handler_off();

      ~QuietGsl()
      {
        gsl_set_error_handler(previous);
      }
    };
  } // namespace



  Hyperparameters
  hyperparameters_of(const std::vector<double> &logarithms)
  {
    Hyperparameters result;
    result.signal_variance = std::exp(logarithms.front());
    result.noise_variance  = std::exp(logarithms.back());
    for (std::size_t i = 1; i + 1 < logarithms.size(); ++i)
      result.length_scales.push_back(std::exp(logarithms[i]));
    return result;
  }



  LikelihoodMaximizer::LikelihoodMaximizer(
    const KernelKind                kernel,
    const TrainingData             &data,
    const std::vector<SmoothClamp> &clamps)
    : kernel(kernel)
    , data(data)
    , clamps(clamps)
  {}



  unsigned int
  LikelihoodMaximizer::n_evaluations() const
  {
    return n_evaluations_;
  }



  LikelihoodMaximum
  LikelihoodMaximizer::climb(const std::vector<double> &start,
                             const unsigned int         max_iterations)
  {
    const QuietGsl quiet;
    Objective      objective(kernel, data, clamps);
    using Vector = std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)>;
    using Minimizer =
      std::unique_ptr<gsl_multimin_fdfminimizer,
                      decltype(&gsl_multimin_fdfminimizer_free)>;
    const Vector u(gsl_vector_alloc(start.size()), gsl_vector_free);
    std::copy(start.begin(), start.end(), u->data);
    if (!std::isfinite(objective.value(u.get())))
      return {};

    const Minimizer minimizer(
      gsl_multimin_fdfminimizer_alloc(gsl_multimin_fdfminimizer_vector_bfgs2,
                                      start.size()),
      gsl_multimin_fdfminimizer_free);
    gsl_multimin_function_fdf function{
      gsl_value, gsl_gradient, gsl_both, start.size(), &objective};
    gsl_multimin_fdfminimizer_set(
      minimizer.get(), &function, u.get(), 0.5, 0.3);

    // A step that gains less than 1e-4 in the log likelihood is the last one:
    // hyperparameters within one of the maximum are about as likely.
    const double n    = static_cast<double>(data.y.size());
    double       last = minimizer->f;
    for (unsigned int i = 0; i < max_iterations; ++i)
      {
        if (gsl_multimin_fdfminimizer_iterate(minimizer.get()) != GSL_SUCCESS ||
            n * (last - minimizer->f) < 1e-4)
          break;
        last = minimizer->f;
      }
    n_evaluations_ += objective.n_evaluations;
    const gsl_vector *const x = minimizer->x;
    return {{x->data, x->data + start.size()}, -n * minimizer->f};
  }
} // namespace asperity
