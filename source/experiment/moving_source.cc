#include <asperity/base/errors.h>
#include <asperity/experiment/moving_source.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/bessel.hpp>

#include <cmath>

namespace asperity
{
  namespace
  {
    constexpr double pi = boost::math::constants::pi<double>();

    /** From where on the Bessel functions are replaced by their limit. */
    constexpr double large = 300.;

    /** Integral from 0 to z of e^-t K_0(|t|) (M. Abramowitz and I. A. Stegun,
     *  Handbook of Mathematical Functions, 1964, 11.3.16 and 11.3.17). */
    double
    integral_to(const double z)
    {
      using boost::math::cyl_bessel_k;
      const double x = std::abs(z);
      if (x == 0.)
        return 0.;
      if (z > 0.)
        return x > large ?
                 1. :
                 x * std::exp(-x) * (cyl_bessel_k(0, x) - cyl_bessel_k(1, x)) +
                   1.;
      // e^x (K_0 + K_1) tends to sqrt(2 pi/x)
      const double scaled =
        x > large ?
          std::sqrt(pi / (2. * x)) *
            (2. + (-0.125 + 0.375 + (9. / 128. - 15. / 128.) / x) / x) :
          std::exp(x) * (cyl_bessel_k(0, x) + cyl_bessel_k(1, x));
      return -(x * scaled - 1.);
    }
  } // namespace



  double
  HeatProperties::diffusivity() const
  {
    return conductivity / (density * heat_capacity);
  }



  double
  moving_band(const HeatProperties &body,
              const double          length,
              const double          velocity)
  {
    const double kappa = body.diffusivity();
    const double L     = velocity * length / (4. * kappa);
    // the source moves towards positive x, so that its heat lies behind it
    const auto rise = [&](const double X) {
      return integral_to(X + L) - integral_to(X - L);
    };
    double       error = 0.;
    const double mean =
      boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
        rise, -L, L, 15, 1e-9, &error) /
      (2. * L);
    if (!std::isfinite(mean) || error > 1e-6 * std::abs(mean) * 2. * L)
      throw ComputationError("The temperature under a moving band of heat "
                             "could not be integrated.");
    return 2. * kappa / (pi * body.conductivity * velocity) * mean;
  }



  double
  resting_rectangle(const double conductivity,
                    const double half_length,
                    const double half_width)
  {
    const double r = half_width / half_length;
    return 2. * half_length / (pi * conductivity) *
           (std::asinh(r) + r * std::asinh(1. / r) +
            (r * r + 1. / r - (r + 1. / r) * std::sqrt(1. + r * r)) / 3.);
  }



  double
  moving_circle(const HeatProperties &body,
                const double          radius,
                const double          velocity)
  {
    const double peclet = velocity * radius / (2. * body.diffusivity());
    return 1.22 * radius /
           (body.conductivity * std::sqrt(pi * (0.6575 + peclet)));
  }
} // namespace asperity
