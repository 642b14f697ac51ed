#ifndef asperity_campaign_profile_scatter_h
#define asperity_campaign_profile_scatter_h

#include <optional>
#include <vector>

namespace asperity
{
  /** A mean over all profiles, and what is not known of it. */
  struct ProfileMean
  {
    double mean      = 0.;
    double deviation = 0.; ///< standard; 0 if no profile is missing
  };

  /**
   * How a quantity differs between the profiles of one surface:
   *
   *     y_ik = y_i (1 + b_k + e_ik),
   *
   * with y_i the mean over the profiles k at point i, b_k what profile k has in
   * common at all points, and e_ik the rest; both sum to zero over k. The mean
   * over these very profiles is a smooth function of the point and knows no
   * noise of theirs: their scatter is an error that all points share, and says
   * how far the mean over the whole surface may be.
   */
  class ProfileScatter
  {
  public:
    explicit ProfileScatter(const unsigned int n_profiles);

    /** The values of all profiles at one point. A point whose mean is zero has
     *  no relative deviations and is left out. */
    void
    add(const std::vector<double> &values);

    /** Standard deviation between profiles of b_k + e_ik, relative to the mean;
     *  0 without two profiles. */
    double
    total() const;

    /** That of e_ik: how much profiles differ in more than a factor. */
    double
    beyond_factor() const;

    /** 1 + b_k. */
    double
    factor(const unsigned int profile) const;

    /**
     * The mean over all profiles at a point where some are missing: the sum of
     * those that are there over the sum of their factors (ratio estimator, W.
     * Cochran, Sampling Techniques, 1977, ch. 6), its deviation that of a
     * sample without replacement of the e_ik.
     * @return nothing without a value, or if some are missing and no point has
     *   told the factors
     */
    std::optional<ProfileMean>
    mean(const std::vector<std::optional<double>> &values) const;

  private:
    unsigned int n_profiles;
    std::vector<std::vector<double>>
      deviations; ///< b_k + e_ik, one row a point
  };
} // namespace asperity

#endif
