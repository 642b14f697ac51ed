#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/experiment/rake_contact.h>

#include <cmath>

namespace asperity
{
  double
  RakeContact::edge_pressure() const
  {
    return (exponent + 1.) * mean_pressure;
  }



  double
  RakeContact::sticking() const
  {
    const double ratio = shear_limit / (mu * edge_pressure());
    return ratio < 1. ? 1. - std::pow(ratio, 1. / exponent) : 0.;
  }



  double
  RakeContact::sliding_pressure() const
  {
    return mean_pressure * std::pow(1. - sticking(), exponent);
  }



  double
  RakeContact::apparent_mu() const
  {
    const double ratio = shear_limit / (mu * edge_pressure());
    if (ratio >= 1.)
      return mu;
    return shear_limit / mean_pressure *
           (1. - exponent / (exponent + 1.) * std::pow(ratio, 1. / exponent));
  }



  RakeContact
  RakeContact::with_apparent_mu(const double mean_pressure,
                                const double exponent,
                                const double apparent_mu,
                                const double shear_limit)
  {
    RakeContact result{mean_pressure, exponent, apparent_mu, shear_limit};
    if (result.apparent_mu() == apparent_mu)
      return result; // the chip slides everywhere
    // the formula of apparent_mu(), solved for mu
    const double part = (1. - apparent_mu * mean_pressure / shear_limit) *
                        (exponent + 1.) / exponent;
    if (!(part > 0.))
      throw InputError(
        "The friction force takes a shear stress of " +
        format_quantity(apparent_mu * mean_pressure, "MPa", 4) +
        " on the whole contact, but the shear limit of the chip is " +
        format_quantity(shear_limit, "MPa", 4) +
        "; a longer contact or a larger shear limit is expected");
    result.mu =
      shear_limit / (result.edge_pressure() * std::pow(part, exponent));
    return result;
  }
} // namespace asperity
