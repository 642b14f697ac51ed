#ifndef asperity_surrogate_regression_h
#define asperity_surrogate_regression_h

#include <cstddef>

namespace asperity
{
  /**
   * A function of d inputs that was fitted to data and knows its error: what
   * stands behind the scales of a FrictionLaw. No units, no scaling. Immutable,
   * so that threads may share it. A coordinate that is NaN makes the answer
   * NaN.
   */
  class Regression
  {
  public:
    virtual ~Regression() = default;

    /** @param x n x d inputs, one point after the other @param result n means
     */
    virtual void
    means(const std::size_t n, const double *x, double *result) const = 0;

    /** @param variance of the fitted function, without noise; not negative
     *  @param gradient of the mean, d numbers, or nullptr @return the mean */
    virtual double
    evaluate(const double *x, double *variance, double *gradient) const = 0;

    /** Variance of a further value about the fitted function. */
    virtual double
    noise_variance() const = 0;
  };
} // namespace asperity

#endif
