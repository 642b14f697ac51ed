#include "contact_examples.h"

#include <asperity/constitutive/hyperelasticity.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace example
{
  using namespace asperity;
  using dealii::Point;

  namespace
  {
    constexpr double hertz_radius = 500., punch_strain = 1e-3;
    constexpr double wave_amplitude = 2e-4;

    std::shared_ptr<const MaterialLaw>
    neo_hooke(const double poisson_ratio)
    {
      ElasticParameters elasticity;
      elasticity.young_modulus = 1.;
      elasticity.poisson_ratio = poisson_ratio;
      return std::make_shared<NeoHooke>(elasticity);
    }

    ContactOptions
    contact_options(const Discretization &discretization,
                    const double          element_length)
    {
      ContactOptions options;
      options.formulation = discretization.formulation;
      options.penalty     = discretization.penalty_factor / element_length;
      options.interface   = discretization.interface;
      return options;
    }

    /** 96 x 48 around the origin of x, the surface at y = 0. */
    HalfPlane
    half_plane(const Discretization                   &discretization,
               std::shared_ptr<const RigidObstacle<2>> obstacle)
    {
      constexpr double size = 48., coarse = 4.;
      auto             space = std::make_shared<SplineSpace<2>>(
        KnotVector(discretization.degree,
                   equal_steps(-size, size, 2 * size / coarse)),
        KnotVector(discretization.degree,
                   equal_steps(-size, 0., size / coarse)));
      HalfPlane body;
      body.element_length = coarse;
      for (unsigned int level = 1;
           body.element_length > 1.0001 / discretization.resolution;
           ++level)
        {
          body.element_length *= 0.5;
          const double width = 1.3 + 2. * body.element_length;
          const double depth = 0.3 + 3. * body.element_length;
          space->refine_to_level(
            level, [&](const Point<2> &low, const Point<2> &high) {
              return low[0] < width && high[0] > -width && high[1] > -depth;
            });
        }
      const double nu      = discretization.poisson_ratio;
      body.reduced_modulus = 1. / (1. - nu * nu);
      body.problem =
        std::make_unique<ContactProblem>(space,
                                         neo_hooke(nu),
                                         obstacle,
                                         contact_options(discretization,
                                                         body.element_length));
      return body;
    }
  } // namespace



  HalfPlane
  hertz(const Discretization &discretization)
  {
    HalfPlane body =
      half_plane(discretization,
                 std::make_shared<Cylinder>(Point<2>(), hertz_radius));
    body.force = M_PI * body.reduced_modulus / (4. * hertz_radius);
    body.depth = 3. * body.force;
    body.problem->options.tolerance = 1e-8 * body.force;
    return body;
  }



  HalfPlane
  flat_punch(const Discretization &discretization)
  {
    const SplineCurve punch(KnotVector(1, {0., 1., 2., 3.}),
                            {Point<2>(-1., 10.),
                             Point<2>(-1., 0.),
                             Point<2>(1., 0.),
                             Point<2>(1., 10.)});
    HalfPlane         body =
      half_plane(discretization,
                 std::make_shared<CurveObstacle>(punch, CurveSide::right));
    body.force                      = punch_strain * body.reduced_modulus;
    body.depth                      = 3. * body.force;
    body.problem->options.tolerance = 1e-8 * body.force;
    return body;
  }



  double
  hertz_pressure(const HalfPlane &body, const double x)
  {
    return 2. * body.force / M_PI * std::sqrt(std::max(0., 1. - x * x));
  }



  double
  punch_pressure(const double force, const double x)
  {
    return std::abs(x) < 1. ? force / (M_PI * std::sqrt(1. - x * x)) : 0.;
  }



  double
  pressure_error(const ContactProblem                &problem,
                 const double                         limit,
                 const std::function<double(double)> &exact)
  {
    const BasisTable<2> &table = problem.contact->table();
    double               error = 0., norm = 0.;
    for (unsigned int q = 0; q < table.JxW.size(); ++q)
      {
        const double x = table.position[q][0];
        if (std::abs(x) >= limit)
          continue;
        const double p = exact(x);
        error += std::pow(problem.contact->pressure()[q] - p, 2) * table.JxW[q];
        norm += p * p * table.JxW[q];
      }
    return std::sqrt(error / norm);
  }



  double
  pressure_mean(const ContactProblem                &problem,
                const std::function<double(double)> &f)
  {
    const BasisTable<2> &table = problem.contact->table();
    double               sum = 0., weight = 0.;
    for (unsigned int q = 0; q < table.JxW.size(); ++q)
      {
        const double force = problem.contact->pressure()[q] * table.JxW[q];
        sum += force * f(table.position[q][0]);
        weight += force;
      }
    return sum / weight;
  }



  Westergaard::Westergaard(const Discretization &discretization)
  {
    const unsigned int n = discretization.resolution;
    element_length       = 1. / n;
    auto space           = std::make_shared<SplineSpace<2>>(
      KnotVector(discretization.degree, equal_steps(-0.5, 0.5, n), true),
      KnotVector(discretization.degree, graded_rows(1., 1. / n, 1.5)));
    // The crest of the wave is at x = 0 and touches the block.
    const auto tool = periodic_tool(
      [](const double x) {
        return wave_amplitude * (1. - std::cos(2. * M_PI * x));
      },
      1.,
      96);
    problem                    = std::make_unique<ContactProblem>(space,
                                               neo_hooke(0.3),
                                               tool,
                                               contact_options(discretization,
                                                               element_length));
    full_pressure              = M_PI * wave_amplitude / (1. - 0.3 * 0.3);
    problem->options.tolerance = 1e-8 * full_pressure;
    depth                      = 0.3 * wave_amplitude;
  }



  bool
  Westergaard::press(const double half_width)
  {
    depth =
      problem->press(full_pressure * std::pow(std::sin(M_PI * half_width), 2),
                     depth);
    return std::isfinite(depth);
  }



  double
  Westergaard::half_width() const
  {
    return 0.5 * problem->contact->state().contact_fraction;
  }



  double
  Westergaard::mean_gap() const
  {
    return problem->contact->state().mean_gap;
  }



  double
  Westergaard::exact_mean_gap(const double half_width)
  {
    const double s = std::sin(M_PI * half_width);
    return 2. * wave_amplitude * (0.5 * (1. - s * s) + s * s * std::log(s));
  }



  double
  Westergaard::exact_pressure(const double half_width, const double x) const
  {
    const double s = std::sin(M_PI * half_width), t = std::sin(M_PI * x);
    return 2. * full_pressure * std::cos(M_PI * x) *
           std::sqrt(std::max(0., s * s - t * t));
  }



  namespace
  {
    /** Rms deviations from the forces while the tool slid over one element. */
    void
    measure_ripple(Ironing &result)
    {
      const unsigned int n        = result.vertical.size();
      double             vertical = 0., lateral = 0., sum = 0., absolute = 0.;
      result.vertical_force =
        std::accumulate(result.vertical.begin(), result.vertical.end(), 0.) / n;
      for (unsigned int k = 0; k < n; ++k)
        {
          vertical += std::pow(result.vertical[k] - result.vertical_force, 2);
          lateral += std::pow(result.lateral[k], 2);
          sum += result.lateral[k];
          absolute += std::abs(result.lateral[k]);
        }
      result.vertical_ripple = std::sqrt(vertical / n) / result.vertical_force;
      result.lateral_ripple  = std::sqrt(lateral / n) / result.vertical_force;
      result.lost_work       = std::abs(sum) / absolute;
    }
  } // namespace



  Ironing
  ironing(const Discretization &discretization,
          const unsigned int    steps_per_element,
          const IroningTool     tool)
  {
    const unsigned int n = std::lround(0.5 * discretization.resolution);
    const double       h = 3. / n, length = 9.;
    const bool         is_wave = (tool == IroningTool::wave_without_edge);
    const double       depth   = is_wave ? 0.6 : 0.3;
    std::shared_ptr<const RigidObstacle<2>> obstacle;
    if (is_wave)
      obstacle = periodic_tool(
        [=](const double x) {
          return 0.15 * (1. - std::cos(2. * M_PI * x / length));
        },
        length,
        96);
    else
      obstacle = std::make_shared<Cylinder>(Point<2>(0.5 * length, 0.), 3.);
    ContactProblem problem(
      std::make_shared<SplineSpace<2>>(
        KnotVector(discretization.degree, equal_steps(0., length, 3 * n), true),
        KnotVector(discretization.degree, equal_steps(-3., 0., n))),
      neo_hooke(0.32),
      obstacle,
      contact_options(discretization, h));
    problem.options.tolerance = 1e-10;
    Ironing result;
    for (unsigned int k = 1; k <= 10; ++k)
      if (!problem.solve(0., -0.1 * depth * k).converged)
        return result;
    for (unsigned int k = 0; k < steps_per_element; ++k)
      {
        const double x = h * k / steps_per_element;
        if (!problem.solve(x, -depth).converged)
          return result;
        const auto force = problem.contact->state().force;
        result.position.push_back(x);
        result.vertical.push_back(-force[1]);
        result.lateral.push_back(force[0]);
      }
    measure_ripple(result);
    result.contact_fraction = problem.contact->state().contact_fraction;
    result.iterations       = problem.statistics.iterations;
    result.converged        = true;
    return result;
  }
} // namespace example
