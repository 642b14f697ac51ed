#include "contact_problem.h"

#include <asperity/splines/spline_fit.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace example
{
  using namespace asperity;
  using dealii::Point;

  Ceiling::Ceiling(const double height)
    : height(height)
  {}



  GapPoint<2>
  Ceiling::gap(const Point<2> &x, Point<1> &) const
  {
    GapPoint<2> gap;
    gap.gap          = height - x[1];
    gap.normal[1]    = -1.;
    gap.direction[0] = turned(gap.normal);
    return gap;
  }



  Cylinder::Cylinder(const Point<2> &lowest_point, const double radius)
    : lowest_point(lowest_point)
    , radius(radius)
  {}



  GapPoint<2>
  Cylinder::gap(const Point<2> &x, Point<1> &) const
  {
    // From the lowest point, since distance - radius would lose the digits of a
    // gap that is small beside the radius.
    const auto             s = x - lowest_point;
    const dealii::Point<2> from_center(s[0], s[1] - radius);
    const double           distance = from_center.norm();
    GapPoint<2>            gap;
    gap.gap    = (s.norm_square() - 2. * radius * s[1]) / (distance + radius);
    gap.normal = from_center / distance;
    gap.direction[0] = turned(gap.normal);
    gap.curvature[0] = 1. / radius;
    return gap;
  }



  std::shared_ptr<const CurveObstacle>
  periodic_tool(const std::function<double(double)> &height,
                const double                         period,
                const unsigned int                   n_spans)
  {
    return std::make_shared<CurveObstacle>(
      interpolate_periodic_function(height, 0., period, n_spans, 3),
      CurveSide::right);
  }



  std::vector<double>
  graded_rows(const double height, const double top, const double growth)
  {
    std::vector<double> depths(1, 0.);
    for (double row = top; depths.back() < height; row *= growth)
      depths.push_back(depths.back() + row);
    std::vector<double> levels;
    for (const double depth : depths)
      levels.push_back(-height * depth / depths.back());
    std::reverse(levels.begin(), levels.end());
    return levels;
  }



  std::vector<double>
  equal_steps(const double begin, const double end, const unsigned int n)
  {
    std::vector<double> steps(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
      steps[i] = begin + (end - begin) * i / n;
    return steps;
  }



  ContactProblem::ContactProblem(
    std::shared_ptr<const SplineSpace<2>>   space,
    std::shared_ptr<const MaterialLaw>      law,
    std::shared_ptr<const RigidObstacle<2>> obstacle,
    const ContactOptions                   &contact_options,
    const Support                           support,
    const PatchGeometry<2>                 &geometry)
    : u(2 * space->n_functions())
    , space(space)
    , solid(std::make_unique<SolidAssembler<2>>(space, geometry, law))
    , contact(std::make_unique<ContactAssembler<2>>(space,
                                                    geometry,
                                                    Edge::top,
                                                    obstacle,
                                                    contact_options))
  {
    dealii::AffineConstraints<double> constraints;
    for (const unsigned int a : space->edge_functions(Edge::bottom))
      {
        constraints.add_line(displacement_dof<2>(a, 1));
        if (support == Support::clamped_bottom)
          constraints.add_line(displacement_dof<2>(a, 0));
      }
    if (support == Support::rollers)
      for (const unsigned int a : space->edge_functions(Edge::left))
        constraints.add_line(displacement_dof<2>(a, 0));
    constraints.close();
    equilibrium =
      std::make_unique<Equilibrium>(u.size(),
                                    std::vector<ForceTerm *>{solid.get(),
                                                             contact.get()},
                                    constraints);
    options.maximum_iterations = 60;
    options.line_search_trials = 30;
  }



  ConvergenceReport
  ContactProblem::solve(const double x, const double y)
  {
    contact->set_obstacle_offset(Point<2>(x, y));
    last = newton(*equilibrium, u, options, statistics);
    return last;
  }



  bool
  ContactProblem::move(const double from, const double to)
  {
    const dealii::Vector<double> start = u;
    for (const unsigned int n_steps : {1, 4, 16})
      {
        u = start;
        for (unsigned int k = 1; k <= n_steps; ++k)
          if (!solve(0., -(from + (to - from) * k / n_steps)).converged)
            break;
        if (last.converged)
          return true;
      }
    return false;
  }



  double
  ContactProblem::press(const double force_wanted, const double depth)
  {
    double previous = 0., force_previous = 0., now = depth;
    while (move(previous, now))
      {
        const double f = force();
        if (std::abs(f - force_wanted) <= 1e-6 * force_wanted)
          return now;
        const double slope = (f - force_previous) / (now - previous);
        const double next =
          f > 0. && slope > 0. ?
            std::min(now + (force_wanted - f) / slope, 2. * now) :
            2. * now;
        previous       = now;
        force_previous = f;
        now            = next;
      }
    return std::numeric_limits<double>::quiet_NaN();
  }



  double
  ContactProblem::force() const
  {
    return -contact->state().force[1];
  }
} // namespace example
