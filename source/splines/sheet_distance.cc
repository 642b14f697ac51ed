#include <asperity/splines/sheet_distance.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using dealii::Point;
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  namespace
  {
    // A Newton step of 1e-8 span widths leaves an error of 1e-16.
    constexpr double newton_tolerance = 1e-8;
    constexpr double step_tolerance   = 1e-13;
    constexpr double healthy_hessian  = 0.1;
  } // namespace



  SheetDistance::SheetDistance(const SheetPieces &pieces, const Point<3> &point)
    : pieces(pieces)
    , given_point(point)
    , noise(4e-16 * std::max({pieces.period(0),
                              pieces.period(1),
                              std::abs(pieces.lowest()),
                              std::abs(pieces.highest()),
                              std::abs(point[0]),
                              std::abs(point[1]),
                              std::abs(point[2])}))
  {}



  SheetFoot
  SheetDistance::foot(const double x, const double y) const
  {
    SheetFoot result;
    result.x   = x;
    result.y   = y;
    result.jet = pieces.jet(x, y);
    result.rx  = x - given_point[0];
    result.ry  = y - given_point[1];
    result.rz  = result.jet.height - given_point[2];
    return result;
  }



  bool
  SheetDistance::stationary(const SheetFoot &foot) const
  {
    const double reach =
      noise +
      1e-16 * (std::abs(foot.rx) + std::abs(foot.ry) + std::abs(foot.rz));
    return foot.gradient().norm_square() <=
           reach * reach * (1. + foot.jet.gradient.norm_square());
  }



  Tensor<1, 2>
  SheetDistance::newton_step(const SheetFoot &foot) const
  {
    SymmetricTensor<2, 2> h      = foot.hessian();
    const double          metric = 1. + foot.jet.gradient.norm_square();
    const double          least  = least_eigenvalue(h);
    Tensor<1, 2>          step;
    if (least < 1e-2)
      {
        if (least < 0. && stationary(foot))
          {
            // At a maximum or saddle point: along the negative direction.
            step[0] = -h[0][1];
            step[1] = h[0][0] - least;
            if (step.norm() < 1e-12 * metric)
              step[0] = 1., step[1] = 0.;
            return 0.1 * std::min(pieces.mean_width(0), pieces.mean_width(1)) /
                   step.norm() * step;
          }
        // Absolute eigenvalues, none below a fraction of one.
        const double trace    = h[0][0] + h[1][1];
        const double greatest = trace - least;
        const double gap      = greatest - least;
        const double high     = std::max(std::abs(greatest), 1e-2);
        const double low      = std::max(std::abs(least), 1e-2);
        // h = least P + greatest (1 - P) with the projector P
        SymmetricTensor<2, 2> modified;
        for (unsigned int a = 0; a < 2; ++a)
          for (unsigned int b = a; b < 2; ++b)
            {
              const double unit = (a == b ? 1. : 0.);
              const double onto_greatest =
                gap > 0. ? (h[a][b] - least * unit) / gap : 0.;
              modified[a][b] = low * unit + (high - low) * onto_greatest;
            }
        h = modified;
      }
    const Tensor<1, 2> g   = foot.gradient();
    const double       det = h[0][0] * h[1][1] - h[0][1] * h[0][1];
    step[0]                = -(h[1][1] * g[0] - h[0][1] * g[1]) / det;
    step[1]                = -(h[0][0] * g[1] - h[0][1] * g[0]) / det;
    // Not farther than the model may hold.
    const double longest =
      2. * std::max(pieces.mean_width(0), pieces.mean_width(1));
    const double length = step.norm();
    if (length > longest)
      step *= longest / length;
    return step;
  }



  SheetFoot
  SheetDistance::minimize(const SheetFoot &start) const
  {
    const double width =
      std::min(pieces.mean_width(0), pieces.mean_width(1)) / 2.;
    SheetFoot here = start;
    for (unsigned int i = 0; i < 60; ++i)
      {
        const double least = least_eigenvalue(here.hessian());
        if (stationary(here) && least >= 0.)
          {
            here.converged = true;
            return here;
          }
        Tensor<1, 2> step      = newton_step(here);
        const double slope     = std::min(0., here.gradient() * step);
        const double distance2 = here.squared_distance();
        const double round_off = 2. * noise * (std::sqrt(distance2) + noise);
        bool         accepted  = false;
        SheetFoot    there;
        for (unsigned int halving = 0; halving < 40 && !accepted; ++halving)
          {
            there = foot(here.x + step[0], here.y + step[1]);
            ++here.iterations;
            accepted =
              there.squared_distance() <= distance2 + 2e-4 * slope + round_off;
            if (!accepted)
              step *= 0.5;
          }
        there.iterations = here.iterations;
        if (!accepted)
          {
            here.converged = step.norm() < step_tolerance * width && least > 0.;
            return here;
          }
        here = there;
        if (step.norm() <
            (least > healthy_hessian ? newton_tolerance : step_tolerance) *
              width)
          {
            here.converged = true;
            return here;
          }
      }
    return here;
  }
} // namespace asperity
