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



  GapPoint
  Ceiling::gap(const Point<2> &x, double &) const
  {
    GapPoint gap;
    gap.gap       = height - x[1];
    gap.normal[1] = -1.;
    return gap;
  }



  Cylinder::Cylinder(const Point<2> &center, const double radius)
    : center(center)
    , radius(radius)
  {}



  GapPoint
  Cylinder::gap(const Point<2> &x, double &) const
  {
    GapPoint     gap;
    const double distance = center.distance(x);
    gap.gap               = distance - radius;
    gap.normal            = (x - center) / distance;
    gap.curvature         = 1. / radius;
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
      levels.push_back(height * (1. - depth / depths.back()));
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



  ContactProblem::ContactProblem(std::shared_ptr<const SplineSpace>   space,
                                 std::shared_ptr<const MaterialLaw>   law,
                                 std::shared_ptr<const RigidObstacle> obstacle,
                                 const ContactOptions &contact_options,
                                 const Support         support)
    : u(2 * space->n_functions())
    , space(space)
    , solid(std::make_unique<SolidAssembler>(space, PatchGeometry(), law))
    , contact(std::make_unique<ContactAssembler>(space,
                                                 PatchGeometry(),
                                                 Edge::top,
                                                 obstacle,
                                                 contact_options))
  {
    std::vector<bool> is_prescribed(u.size(), false);
    for (const unsigned int a : space->edge_functions(Edge::bottom))
      {
        is_prescribed[2 * a + 1] = true;
        is_prescribed[2 * a]     = (support == Support::clamped_bottom);
      }
    if (support == Support::rollers)
      for (const unsigned int a : space->edge_functions(Edge::left))
        is_prescribed[2 * a] = true;
    equilibrium =
      std::make_unique<Equilibrium>(u.size(),
                                    std::vector<ForceTerm *>{solid.get(),
                                                             contact.get()},
                                    is_prescribed);
    options.maximum_iterations = 60;
  }



  ConvergenceReport
  ContactProblem::solve(const double x, const double y)
  {
    contact->set_obstacle_offset(Point<2>(x, y));
    last = newton(*equilibrium, u, options, statistics);
    return last;
  }



  double
  ContactProblem::press(const double force_wanted, const double depth)
  {
    double previous = 0., force_previous = 0., now = depth;
    for (unsigned int k = 0; k < 30; ++k)
      {
        if (!solve(0., -now).converged)
          break;
        const double f = force();
        if (std::abs(f - force_wanted) <= 1e-6 * force_wanted)
          return now;
        const double slope = (f - force_previous) / (now - previous);
        previous           = now;
        force_previous     = f;
        now                = f > 0. && slope > 0. ?
                               std::min(now + (force_wanted - f) / slope, 2. * now) :
                               2. * now;
      }
    return std::numeric_limits<double>::quiet_NaN();
  }



  double
  ContactProblem::force() const
  {
    return -contact->state().force[1];
  }
} // namespace example
