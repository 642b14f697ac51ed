#ifndef asperity_surrogate_piecewise_power_law_h
#define asperity_surrogate_piecewise_power_law_h

#include <asperity/surrogate/regression.h>

#include <array>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * The friction law of Lee (2025), section 2.1, over the sliding velocity:
   *
   *   mu = mu_0 for v <= v_0, mu = mu_0 (v/v_0)^exponent beyond,
   *
   * dry there with v_0 = 46 m/min, and wet without the constant part. SI.
   */
  struct PiecewisePowerLaw
  {
    double mu_0     = 0.;
    double v_0      = 0.; ///< [m/s]
    double exponent = 0.;

    /** Whether v_0 is the end of a constant part that the measurements show, or
     *  that was given; else it is the smallest velocity that was measured. */
    bool has_constant_part = true;

    /** Covariance of ln mu_0, ln v_0 and the exponent, row by row; 0 for what
     *  was given and not fitted. */
    std::array<double, 9> covariance = {};

    /** Standard deviation of ln(mu) of one measurement. */
    double scatter = 0.;

    double
    operator()(const double velocity) const;

    /** Standard errors of mu_0, v_0 [m/s] and the exponent. */
    std::array<double, 3>
    standard_errors() const;
  };

  /**
   * The law as a function of the logarithm of the velocity, z = ln v [m/s], and
   * of the scale of ln(mu). From a thousand times the largest velocity on it is
   * constant, so that it stays finite. Its variances are those of the fitted
   * constants in the first order, and of a measurement, times the square of a
   * factor.
   */
  class PiecewisePowerRegression : public Regression
  {
  public:
    PiecewisePowerRegression(const PiecewisePowerLaw &law,
                             const double             largest_velocity,
                             const double             factor);

    void
    means(const std::size_t n, const double *z, double *result) const override;

    double
    evaluate(const double *z,
             double       *variance,
             double       *gradient) const override;

    double
    noise_variance() const override;

    const PiecewisePowerLaw &
    law() const;

    double
    factor() const;

    /** ln v from which on it is constant again. */
    double
    end() const;

  private:
    PiecewisePowerLaw law_;
    double            end_, factor_;
  };

  /** How the end of the constant part is found. */
  enum class ConstantPart
  {
    automatic, ///< fitted or none, as Akaike's corrected criterion prefers
    none,
    fitted,
    given
  };

  struct PiecewisePowerOptions
  {
    ConstantPart constant_part = ConstantPart::automatic;
    double       v_0           = 0.; ///< where it is given [m/s]

    /** Part of the values that have to lie beyond v_0. */
    double least_share_beyond = 0.;
  };

  struct PiecewisePowerFit
  {
    PiecewisePowerLaw law;
    unsigned int      degrees_of_freedom = 0; ///< values less constants

    /** Mean of |error| / value, and the same with each value left out of the
     *  fit that predicts it, at this v_0. */
    double mean_relative_error = 0., leave_one_out_error = 0.;
  };

  /**
   * Weighted least squares of ln(mu): the two other constants follow linearly
   * from v_0, which is the smallest minimum over the stretches between the
   * velocities that were measured (Hudson 1966). Standard errors by
   * linearisation, from the scatter about the fit, or from the deviations where
   * they are given; these are enlarged if the scatter is larger (Birge 1932).
   * Akaike's criterion (Burnham and Anderson 2002) counts the scatter among the
   * constants and needs six values.
   * @param v velocities [m/s] @param mu values
   * @param deviation standard deviations of mu, or empty
   * @throws InputError if a value is not positive, or if there are too few
   *   values or velocities for the constants, or if they do not determine them
   */
  PiecewisePowerFit
  fit_piecewise_power_law(const std::vector<double>   &v,
                          const std::vector<double>   &mu,
                          const std::vector<double>   &deviation,
                          const PiecewisePowerOptions &options = {});

  /** "mu = mu_0 (v/v_0)^n beyond v_0, mu_0 below, mu_0 = 0.52 (standard error
   *  0.01), ..." @param unit of v_0 */
  std::string
  to_string(const PiecewisePowerLaw &law, const std::string &unit);
} // namespace asperity

#endif
