#ifndef asperity_surrogate_active_learning_h
#define asperity_surrogate_active_learning_h

#include <asperity/surrogate/friction_law.h>

#include <cstddef>
#include <vector>

namespace asperity
{
  struct ActiveLearningOptions
  {
    /** Sobol points among which the next ones are chosen. Half as many are
     *  pushed onto the edges of the box, and the corners stand for
     *  themselves. */
    std::size_t n_candidates = 2048;

    /** Sobol points over which the deviation is averaged. */
    std::size_t n_references = 512;

    /** No point comes closer to another one; in the unit cube. */
    double smallest_distance = 0.01;
  };

  /**
   * The next runs of a campaign, chosen one after the other: those after which
   * the law is surest on average over the box, by the largest decrease of the
   * mean of the squared relative deviation (Cohn, Ghahramani and Jordan 1996;
   * Seo et al. 2000). Points of the largest deviation (MacKay 1992) would lie
   * on the edges of the box, which costs accuracy inside. How sure a law is
   * depends on where its points lie and not on their values, so that each point
   * chosen counts as known at once (with hyperparameters as they are, and as if
   * its value were what the law predicts), and a batch spreads by itself. The
   * deviation is relative to the mean: that of ln(mu) on a logarithmic scale of
   * the output, else divided by the mean, or by a tenth of the mean over the
   * box where that is larger. Deterministic.
   *
   * @param occupied n x d points in SI units at which runs are pending, or have
   *   failed: they count as known, too, so that the neighbourhood of a failure
   *   is not tried again and again
   * @return at most n_points x d SI values; fewer if no candidate is left
   * @throws InputError if there are no candidates or references
   */
  std::vector<double>
  next_points(const FrictionLaw           &law,
              const std::vector<double>   &occupied,
              const std::size_t            n_points,
              const ActiveLearningOptions &options = {});

  /**
   * How well the other points predict each training point. Points of active
   * learning and Sobol points are predicted from farther away than a random
   * point of the box, so that these errors are larger than those of random test
   * runs. Those of grids are many times smaller, and no measure:
   * hyperparameters that suit the coordinates of a grid know nothing of what
   * lies between.
   */
  struct CrossValidation
  {
    double mean_relative_error    = 0.; ///< of |prediction - value| / value
    double largest_relative_error = 0.;

    /** Share of the values inside of the 95 % interval of their prediction. */
    double coverage = 0.;
  };

  /** Leave-one-out, with the hyperparameters of all points (Rasmussen and
   *  Williams 2006, equations 5.10 to 5.12). */
  CrossValidation
  cross_validate(const FrictionLaw &law);

  /** When a campaign has made enough runs. */
  struct StoppingRule
  {
    double target = 0.01; ///< of the mean relative error

    /** The error that is measured counts so many times. */
    double safety = 1.;

    /** So many batches in a row must meet the target, as one may by chance. */
    unsigned int n_batches = 2;

    /** @param errors cross-validated ones after each batch, the last at the end
     */
    bool
    is_met(const std::vector<double> &errors) const;
  };
} // namespace asperity

#endif
