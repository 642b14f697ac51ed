#include <asperity/surrogate/piecewise_power_law.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** Velocities beyond the largest one over which the power goes on. */
    constexpr double range_beyond = 1000.;
  } // namespace



  double
  PiecewisePowerLaw::operator()(const double velocity) const
  {
    return mu_0 * std::pow(std::max(velocity, v_0) / v_0, exponent);
  }



  std::array<double, 3>
  PiecewisePowerLaw::standard_errors() const
  {
    return {{mu_0 * std::sqrt(covariance[0]),
             v_0 * std::sqrt(covariance[4]),
             std::sqrt(covariance[8])}};
  }



  PiecewisePowerRegression::PiecewisePowerRegression(
    const PiecewisePowerLaw &law,
    const double             largest_velocity,
    const double             factor)
    : law_(law)
    , end_(std::log(range_beyond * largest_velocity))
    , factor_(factor)
  {}



  void
  PiecewisePowerRegression::means(const std::size_t n,
                                  const double     *z,
                                  double           *result) const
  {
    double variance;
    for (std::size_t i = 0; i < n; ++i)
      result[i] = evaluate(z + i, &variance, nullptr);
  }



  double
  PiecewisePowerRegression::evaluate(const double *z,
                                     double       *variance,
                                     double       *gradient) const
  {
    const double knee      = std::log(law_.v_0);
    const bool   is_beyond = !(*z <= knee); // also if it is no number
    const double beyond    = !is_beyond ? 0. : (*z > end_ ? end_ : *z) - knee;
    const std::array<double, 3> by = {
      {1., is_beyond ? -law_.exponent : 0., beyond}};
    *variance = 0.;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        *variance += by[i] * law_.covariance[3 * i + j] * by[j];
    *variance *= *variance < 0. ? 0. : factor_ * factor_;
    if (gradient != nullptr)
      *gradient = is_beyond && !(*z > end_) ? law_.exponent : 0.;
    return std::log(law_.mu_0) + law_.exponent * beyond;
  }



  double
  PiecewisePowerRegression::noise_variance() const
  {
    return std::pow(factor_ * law_.scatter, 2);
  }



  const PiecewisePowerLaw &
  PiecewisePowerRegression::law() const
  {
    return law_;
  }



  double
  PiecewisePowerRegression::factor() const
  {
    return factor_;
  }



  double
  PiecewisePowerRegression::end() const
  {
    return end_;
  }
} // namespace asperity
