#include <asperity/splines/distance_minimizer.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    double
    cross(const double ax, const double ay, const double bx, const double by)
    {
      return ax * by - ay * bx;
    }



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
    for (unsigned int i = 0; i < 30; ++i)
      {
        const DistanceJet here = result.jet;
        if (stationary(here) && here.hessian() >= 0.)
          return true;
        const double normal_term =
          here.squared_speed() + here.x2 * here.x2 + here.y2 * here.y2;
        if (!(normal_term > 0.) || !std::isfinite(here.gradient()))
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
    // Far from its start a method may have come near to a minimum on which an
    // earlier one can now finish: several rounds.
    for (unsigned int round = 0; round < 10; ++round)
      {
        if (newton(result))
          return result;
        if (sequential_quadratic_programming(result) ||
            levenberg_marquardt(result))
          {
            // Methods that compare distances stop at the square root of
            // round-off.
            Result polished = result;
            if (newton(polished))
              {
                polished.method = result.method;
                return polished;
              }
            return result;
          }
      }
    result.method = Projection::Method::none;
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



  Projection
  DistanceMinimizer::describe(const Result   &result,
                              const CurveSide free_side) const
  {
    const DistanceJet &jet  = result.jet;
    const double       side = (free_side == CurveSide::left ? 1. : -1.);
    Projection         projection;
    projection.parameter  = pieces.parameter(result.location);
    projection.point      = Point<2>(px + jet.rx, py + jet.ry);
    projection.method     = result.method;
    projection.iterations = result.iterations;
    projection.converged  = (result.method != Projection::Method::none);

    const double speed = std::sqrt(jet.squared_speed());
    // Where the curve stops for a moment its direction is that of the second
    // derivative.
    double tx = jet.x1, ty = jet.y1, norm = speed;
    if (!(speed > 0.))
      {
        tx   = -result.location.s * jet.x2;
        ty   = -result.location.s * jet.y2;
        norm = std::hypot(tx, ty);
      }
    if (norm > 0.)
      {
        projection.tangent[0] = tx / norm;
        projection.tangent[1] = ty / norm;
      }
    projection.speed = speed / pieces.parameter_scale(result.location.piece);
    projection.normal[0] = -side * projection.tangent[1];
    projection.normal[1] = side * projection.tangent[0];
    if (speed > 0.)
      projection.curvature =
        side * cross(jet.x1, jet.y1, jet.x2, jet.y2) / (speed * speed * speed);
    projection.distance =
      -(jet.rx * projection.normal[0] + jet.ry * projection.normal[1]);

    if (std::abs(result.location.s) == 1.)
      describe_piece_end(result, side, projection);
    return projection;
  }



  void
  DistanceMinimizer::describe_piece_end(const Result &result,
                                        const double  side,
                                        Projection   &projection) const
  {
    const DistanceJet &jet      = result.jet;
    const double       distance = std::sqrt(jet.squared_distance());
    const double       slip =
      std::abs(jet.rx * projection.tangent[0] + jet.ry * projection.tangent[1]);
    const bool normal_here = slip <= 1e-10 * distance + 4. * noise;

    Tensor<1, 2>  mean_normal = projection.normal;
    CurveLocation other       = result.location;
    const int     sense       = (result.location.s > 0. ? 1 : -1);
    const bool    end         = !pieces.step_over(other, sense);
    if (!end)
      {
        const DistanceJet neighbor = pieces.jet(other, px, py);
        const double      speed    = std::sqrt(neighbor.squared_speed());
        if (!(speed > 0.))
          return;
        const Tensor<1, 2> normal =
          Point<2>(-side * neighbor.y1 / speed, side * neighbor.x1 / speed);
        if (normal * projection.normal > 1. - 1e-12)
          return; // no kink
        mean_normal += normal;
        if (sense > 0) // the right side is the neighbour's
          {
            projection.tangent[0] = neighbor.x1 / speed;
            projection.tangent[1] = neighbor.y1 / speed;
          }
      }
    else if (normal_here)
      return;

    projection.place = (end ? Projection::Place::end : Projection::Place::kink);
    const Tensor<1, 2> to_point = Point<2>(-jet.rx, -jet.ry);
    projection.distance = (to_point * mean_normal < 0. ? -distance : distance);
    if (distance > 0.)
      projection.normal = to_point / projection.distance;
    else if (mean_normal.norm() > 0.)
      projection.normal = mean_normal / mean_normal.norm();
  }
} // namespace asperity
