#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/coupling/robin_coefficient.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  namespace
  {
    /** A new coefficient within this factor of the old one is not worth the
     *  loss of the quasi-Newton columns. */
    constexpr double hysteresis = 2.;

    /** Secants correct a tangent by at most this factor. */
    constexpr double largest_correction = 4.;

    /** Changes of the force below this share of it are not measured: their
     *  velocities drown in the tolerance of the solid. */
    constexpr double smallest_change = 1e-3;
  } // namespace



  std::optional<double>
  interface_impedance(const Vector &force,
                      const Vector &velocity,
                      const Vector &lengths)
  {
    double square = 0.;
    for (unsigned int i = 0; i < force.size(); ++i)
      if (lengths(i) > 0.)
        square += force(i) * force(i) / lengths(i);
    const double power = force * velocity;
    const double Z     = square / power;
    if (!(power > 0.) || !(Z > 0.) || !std::isfinite(Z))
      return {};
    return Z;
  }



  RobinCoefficient::RobinCoefficient(const std::optional<double> fixed)
    : fixed(fixed)
  {
    if (fixed && !(*fixed > 0.))
      throw InputError("The Robin coefficient of the coupling is " +
                       std::to_string(*fixed) +
                       " Pa s/m; expected a positive value.");
  }



  std::optional<double>
  RobinCoefficient::softest_impedance(SolidSide       &solid,
                                      const FluidSide &fluid) const
  {
    const Vector          lengths = fluid.lengths();
    std::optional<double> softest;
    Vector                velocity;
    for (const Vector &load : fluid.uniform_loads())
      {
        if (!solid.compliance(load, velocity))
          return {};
        velocity *= fluid.rate_coefficient();
        const auto Z = interface_impedance(load, velocity, lengths);
        if (Z && (!softest || *Z < *softest))
          softest = Z;
      }
    return softest;
  }



  bool
  RobinCoefficient::begin_step(SolidSide &solid, const FluidSide &fluid)
  {
    last_force.reinit(0);
    if (fixed)
      {
        value_ = *fixed;
        return true;
      }
    std::optional<double> Z = softest_impedance(solid, fluid);
    if (Z)
      *Z *= correction;
    else
      Z = secant;
    if (!Z)
      return false;
    if (value_ == 0. || *Z > hysteresis * value_ || hysteresis * *Z < value_)
      value_ = *Z;
    return true;
  }



  void
  RobinCoefficient::observe(SolidSide       &solid,
                            const FluidSide &fluid,
                            const Vector    &force,
                            const Vector    &displacement)
  {
    Vector force_change = force, change = displacement;
    if (last_force.size() > 0)
      {
        force_change -= last_force;
        change -= last_displacement;
      }
    const bool is_measured =
      last_force.size() > 0 &&
      force_change.l2_norm() > smallest_change * force.l2_norm();
    last_force        = force;
    last_displacement = displacement;
    if (fixed || !is_measured)
      return;
    Vector foretold;
    if (solid.compliance(force_change, foretold))
      {
        const double ratio =
          (force_change * foretold) / (force_change * change);
        if (ratio > 0. && std::isfinite(ratio))
          correction = std::min(std::max(ratio, 1. / largest_correction),
                                largest_correction);
      }
    change *= fluid.rate_coefficient();
    if (const auto Z =
          interface_impedance(force_change, change, fluid.lengths()))
      secant = Z;
  }



  double
  RobinCoefficient::value() const
  {
    return value_;
  }



  void
  RobinCoefficient::save(OutputArchive &archive) const
  {
    // An impedance is positive.
    const double last = secant.value_or(0.);
    archive << value_ << correction << last;
  }



  void
  RobinCoefficient::load(InputArchive &archive)
  {
    double last = 0.;
    archive >> value_ >> correction >> last;
    secant.reset();
    if (last > 0.)
      secant = last;
  }
} // namespace asperity
