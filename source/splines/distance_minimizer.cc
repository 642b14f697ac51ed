#include <asperity/splines/distance_minimizer.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    // A Newton step of relative length 1e-8 leaves an error of 1e-16, as long
    // as the Hessian is not nearly singular (point near the evolute).
    constexpr double newton_tolerance = 1e-8;
    constexpr double healthy_hessian  = 0.1;
    constexpr double step_tolerance   = 1e-13;
  } // namespace



  DistanceMinimizer::DistanceMinimizer(const CurvePieces &pieces,
                                       const double       px,
                                       const double       py)
    : pieces(pieces)
    , px(px)
    , py(py)
    , noise(4e-16 * (pieces.magnitude() + std::max(std::abs(px), std::abs(py))))
  {}



  bool
  DistanceMinimizer::stationary(const DistanceJet &jet) const
  {
    const double reach = noise + 1e-16 * (std::abs(jet.rx) + std::abs(jet.ry));
    const double gradient = jet.gradient();
    return gradient * gradient <= reach * reach * jet.squared_speed();
  }



  double
  DistanceMinimizer::round_off(const DistanceJet &jet) const
  {
    return 2. * noise * (std::sqrt(jet.squared_distance()) + noise);
  }



  bool
  DistanceMinimizer::settled(const DistanceJet &jet, const double ds) const
  {
    return std::abs(ds) <
           (jet.hessian() > healthy_hessian * jet.squared_speed() ?
              newton_tolerance :
              step_tolerance);
  }



  bool
  DistanceMinimizer::move(CurveLocation &location, const double ds) const
  {
    const double target = location.s + ds;
    if (std::abs(target) <= 1.)
      {
        location.s = target;
        return false;
      }
    const int direction = (target > 0. ? 1 : -1);
    location.s          = direction;
    if (jet(location).gradient() * direction > 0.)
      return false; // the minimum was overrun

    CurveLocation next = location;
    if (!pieces.step_over(next, direction))
      return true;
    if (jet(next).gradient() * direction > 0.)
      return true; // both sides lead here: a kink, or a minimum on a knot
    const double rest = (target - direction) *
                        pieces.parameter_scale(location.piece) /
                        pieces.parameter_scale(next.piece);
    location = next;
    location.s += std::max(-2., std::min(2., rest));
    return false;
  }



  bool
  DistanceMinimizer::newton(Result &result) const
  {
    result.method = Projection::Method::newton;
    for (unsigned int i = 0; i < 15; ++i)
      {
        const DistanceJet &here    = result.jet;
        const double       speed2  = here.squared_speed();
        const double       hessian = here.hessian();
        if (stationary(here) && hessian >= 0. && speed2 > 0.)
          return true;
        if (!(hessian > 1e-6 * speed2))
          return false;

        CurveLocation     next  = result.location;
        const double      ds    = -here.gradient() / hessian;
        const bool        ended = move(next, ds);
        const DistanceJet there = jet(next);
        ++result.iterations;
        if (!(there.squared_distance() <=
              here.squared_distance() + round_off(here)))
          return false;
        const bool done = ended || settled(here, ds);
        result.location = next;
        result.jet      = there;
        if (done)
          return true;
      }
    return false;
  }



  bool
  DistanceMinimizer::sequential_quadratic_programming(Result &result) const
  {
    result.method = Projection::Method::sqp;
    for (unsigned int i = 0; i < 40; ++i)
      {
        const DistanceJet here   = result.jet;
        const double      speed2 = here.squared_speed();
        if (stationary(here) && here.hessian() >= 0. && speed2 > 0.)
          return true;
        // The convex model: |H|, but not flatter than a fraction of the
        // Gauss-Newton term. At a maximum of the distance any way is down.
        const double curvature =
          std::max(std::abs(here.hessian()), 1e-2 * speed2);
        if (!(curvature > 0.))
          return false;
        double ds = -here.gradient() / curvature;
        if (stationary(here))
          ds = 0.1;

        // Armijo condition with the usual slope fraction.
        bool          ended = false, accepted = false;
        CurveLocation next;
        DistanceJet   there;
        for (unsigned int halving = 0; halving < 40 && !accepted; ++halving)
          {
            next  = result.location;
            ended = move(next, ds);
            there = jet(next);
            ++result.iterations;
            accepted = there.squared_distance() <=
                       here.squared_distance() +
                         1e-4 * 2. * std::min(0., here.gradient() * ds) +
                         round_off(here);
            if (!accepted)
              ds *= 0.5;
          }
        if (!accepted)
          return std::abs(ds) < step_tolerance && here.hessian() > 0.;
        result.location = next;
        result.jet      = there;
        if (ended || settled(here, ds))
          return true;
      }
    return false;
  }



  bool
  DistanceMinimizer::levenberg_marquardt(Result &result) const
  {
    result.method  = Projection::Method::levenberg_marquardt;
    double damping = 1.;
    for (unsigned int i = 0; i < 200; ++i)
      {
        const DistanceJet here = result.jet;
        if (stationary(here) && here.hessian() >= 0.)
          return true;
        const double normal_term =
          here.squared_speed() + here.x2 * here.x2 + here.y2 * here.y2;
        if (!(normal_term > 0.))
          return false;
        const double ds =
          -here.gradient() / (here.squared_speed() + damping * normal_term);
        CurveLocation     next  = result.location;
        const bool        ended = move(next, ds);
        const DistanceJet there = jet(next);
        ++result.iterations;
        if (there.squared_distance() <= here.squared_distance())
          {
            result.location = next;
            result.jet      = there;
            damping         = std::max(1e-12, damping / 5.);
            if (ended || (std::abs(ds) < step_tolerance && damping < 1.))
              return true;
          }
        else
          damping *= 4.;
        if (damping > 1e12)
          return true; // no shorter step comes closer
      }
    return false;
  }



  DistanceMinimizer::Result
  DistanceMinimizer::minimize(const CurveLocation &start) const
  {
    Result result;
    result.location = start;
    result.jet      = jet(start);
    if (newton(result))
      return result;
    if (!sequential_quadratic_programming(result) &&
        !levenberg_marquardt(result))
      {
        result.method = Projection::Method::none;
        return result;
      }
    // Methods that compare distances stop at the square root of round-off.
    Result polished = result;
    if (newton(polished))
      {
        polished.method = result.method;
        return polished;
      }
    return result;
  }



  DistanceMinimizer::Result
  DistanceMinimizer::minimize_between(CurveLocation location,
                                      double        low,
                                      double        high) const
  {
    Result result;
    result.method = Projection::Method::subdivision;
    location.s    = (low + high) / 2.;
    for (unsigned int i = 0; i < 100; ++i)
      {
        result.jet      = jet(location);
        result.location = location;
        ++result.iterations;
        if (stationary(result.jet))
          break;
        const double gradient        = result.jet.gradient();
        (gradient < 0. ? low : high) = location.s;
        double s = location.s - gradient / result.jet.hessian();
        if (!(s > low && s < high))
          s = (low + high) / 2.;
        const double ds = s - location.s;
        location.s      = s;
        if (std::abs(ds) < 1e-15 || high - low < 1e-15)
          break;
      }
    return result;
  }
} // namespace asperity
