#include <asperity/coupling/quasi_newton.h>
#include <asperity/splines/closest_point.h>
#include <asperity/splines/spline_fit.h>

#include <deal.II/lac/full_matrix.h>

#include <constitutive/law_tools.h>
#include <coupling/piston.h>
#include <splines/brute_force.h>
#include <surrogate/calibration_example.h>

#include <random>

#include "sweeps.h"

namespace
{
  using namespace stability;
  using namespace asperity;

  AccelerationKind
  acceleration(const std::string &name)
  {
    return name == "relaxation" ? AccelerationKind::relaxation :
           name == "Aitken"     ? AccelerationKind::aitken :
                                  AccelerationKind::iqn_ils;
  }



  /** C3: twenty steps of a driven piston (Z_s = 1, dt = 1) on a chamber with a
   *  leak, against the same balance without iteration. */
  Values
  piston_over_robin_coefficient(const Cell &cell)
  {
    const double       Z_f = cell.number("Z_f"), alpha = cell.number("alpha");
    CouplingParameters parameters;
    parameters.acceleration.kind  = acceleration(cell.text("acceleration"));
    parameters.tolerance          = 1e-6;
    parameters.maximum_iterations = 100;
    parameters.robin_coefficient  = alpha;
    piston::Piston  solid;
    piston::Chamber fluid;
    solid.mass = solid.spring = 0.5;
    solid.drive = [](const double t) { return std::sin(0.4 * t); };
    fluid.leak  = 1. / Z_f;
    PartitionedStep step(solid, fluid, parameters);
    Values          values;
    double          d = 0., v = 0., largest = 0., error = 0., iterations = 0.;
    for (unsigned int i = 1; i <= 20; ++i)
      {
        const ConvergenceReport report = step.advance(1.);
        if (i == 1 && fluid.outputs.size() > 1)
          values["contraction"] = std::abs(fluid.outputs[1] - fluid.inputs[1]) /
                                  std::abs(fluid.outputs[0] - fluid.inputs[0]);
        if (!report.converged)
          throw Reported(report.reason);
        iterations += report.iterations / 20.;
        // m (v - v_old) + k (d_old + v) + Z_f v = drive
        v = std::isfinite(Z_f) ?
              (0.5 * v - 0.5 * d + solid.drive(i)) / (0.5 + 0.5 + Z_f) :
              0.;
        d += v;
        largest = std::max(largest, std::abs(d));
        error   = std::max(error, std::abs(solid.d - d));
      }
    // A piston that does not move is compared with the way of a free one.
    values["error"]      = error / (largest > 0. ? largest : 1.);
    values["iterations"] = iterations;
    return values;
  }



  /** C5: fixed-point maps that quasi-Newton has stumbled over; five steps with
   *  another solution each, unless the case says otherwise. */
  Values
  quasi_newton(const Cell &cell)
  {
    constexpr unsigned int                 n    = 8;
    const std::string                      kind = cell.text("case");
    std::mt19937                           generator(5);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    dealii::FullMatrix<double>             A(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        A(i, j) = uniform(generator) - (i == j ? 2. : 0.);
    QuasiNewton method(0.3, cell.count("reused"), cell.number("filter"));
    dealii::Vector<double> x(n), solution(n);
    Values                 values;
    for (unsigned int step = 0; step < 5; ++step)
      {
        for (unsigned int i = 0; i < n; ++i)
          if (kind != "rest" && !(kind == "steady" && step > 0))
            solution(i) = uniform(generator);
        method.start_step();
        double residual = 1.;
        for (unsigned int k = 0; k < 100 && residual > 1e-8; ++k)
          {
            dealii::Vector<double> e = x, Hx(n);
            e -= solution;
            A.vmult(Hx, e);
            if (kind == "one_direction")
              for (unsigned int i = 0; i < n; ++i)
                Hx(i) = i == 0 ? -3. * e(0) : 0.;
            if (kind == "constant")
              Hx = 0.;
            for (unsigned int i = 0; i < n; ++i)
              {
                if (kind == "kink")
                  Hx(i) += 2. * std::min(0., e(i));
                if (kind == "noise")
                  Hx(i) += 1e-9 * uniform(generator);
              }
            Hx += solution;
            dealii::Vector<double> r = Hx;
            r -= x;
            residual = r.l2_norm();
            if (!std::isfinite(residual))
              return {{"error", residual}};
            if (residual > 1e-8)
              x = method.next(x, Hx);
          }
        method.finish_step(residual <= 1e-8);
        if (residual > 1e-8)
          throw Reported("The coupling iteration has not converged: residual " +
                         std::to_string(residual) + " after 100 iterations.");
        x -= solution;
        values["error"] = std::max(values["error"], x.l2_norm());
        x += solution;
      }
    return values;
  }



  SplineCurve
  curve_of(const std::string &kind, const unsigned int degree)
  {
    if (kind == "open_end")
      return interpolate_periodic_function(
        [](const double x) { return 0.3 * std::sin(x); }, 0., 6., 24, degree);
    const auto wave = [&](const double x) {
      return kind == "asperity" ? 0.5 / (1. + 40. * std::pow(std::sin(x), 2)) :
                                  0.5 * std::sin(2. * x);
    };
    return interpolate_periodic_function(
      wave, 0., 2. * M_PI, kind == "asperity" ? 160 : 40, degree);
  }



  /** C11: points above the middle of a valley, at the centre of its curvature,
   *  in front of a sharp asperity, beside a corner: against brute force. */
  Values
  closest_point(const Cell &cell)
  {
    const std::string  kind   = cell.text("case");
    const double       offset = cell.number("offset");
    const unsigned int degree = cell.count("degree");
    SplineCurve        curve  = curve_of(kind, degree);
    double x = 3. * M_PI / 4., radius = 0.5; // a valley, 1/curvature
    if (kind == "asperity")
      x = M_PI, radius = 1. / 40.;
    if (kind == "corner")
      {
        curve  = SplineCurve(KnotVector(1, {0., 1., 2.}),
                            {{0., 0.}, {1., 0.}, {1., 1.}});
        x      = 0.9;
        radius = 0.3;
      }
    const ClosestPoint                     search(curve, CurveSide::right);
    BruteForce                             brute(curve, 64);
    std::mt19937                           generator(7);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    Values values{{"wrong", 0.}, {"uncertified", 0.}, {"error", 0.}};
    double guess = x;
    for (unsigned int i = 0; i < 100; ++i)
      {
        // Exactly above the extremum first, where two feet are equally near.
        const double shift = i == 0 ? 0. : 0.02 * radius * uniform(generator);
        dealii::Point<2> point = curve.value(x);
        point[0] += shift;
        point[1] += offset * radius;
        const double     exact = brute.distance(point);
        const Projection found =
          i % 2 == 0 ? search.project(point) : search.project(point, guess);
        guess              = found.parameter + 2. * uniform(generator);
        const double error = std::abs(found.distance) - exact;
        values["wrong"] += !(error < 1e-11 * (1. + exact));
        values["uncertified"] += !found.certified;
        values["error"] = std::max(values["error"], error);
      }
    return values;
  }



  /** The flow stress of Johnson and Cook with the constants of the default
   *  steel, floor included, and its heating in a step [Pa, K]. */
  double
  flow_stress(const double strain, const double rate, const double T)
  {
    const JohnsonCookParameters p;
    const double                t =
      std::min(1.,
               std::max(0.,
                        (T - p.transition_temperature) /
                          (p.melting_temperature - p.transition_temperature)));
    return (p.A + p.B * std::pow(strain, p.n)) *
           (1. + p.C * std::log(std::max(1., rate / p.reference_rate))) *
           std::max(1e-3, 1. - std::pow(t, p.m));
  }



  /** C18: one step from the yield surface; the stress against the formula at
   *  the end of the step, the tangent against differences. */
  Values
  return_map(const Cell &cell)
  {
    using namespace law_tools;
    const double  increment = cell.number("increment");
    const double  dt        = increment / cell.number("rate");
    const auto    law       = MaterialParameters().make_law();
    MaterialState old;
    old.temperature             = cell.number("celsius") + 273.15;
    old.plastic_strain          = 0.02;
    const double       three_mu = 3. * ElasticParameters().shear_modulus();
    const Tensor<2, 3> at_yield = isochoric_stretch(
      flow_stress(old.plastic_strain, 0., old.temperature) / three_mu);
    const double       k = 0.6 * increment, s = 0.8 * increment;
    const Tensor<2, 3> F =
      plane(std::exp(k), s, 0.1 * s, std::exp(-k), 1.) * at_yield;
    const MaterialResponse r = evaluate(*law, F, old, dt);
    if (r.status != LawStatus::ok)
      throw Reported("The return map found no stress.");
    // The strain is known to its last digit, which may be all of its growth.
    const double plastic = r.state.plastic_strain - old.plastic_strain,
                 digit   = 0.5 * std::numeric_limits<double>::epsilon() *
                         r.state.plastic_strain;
    const auto at_rate_of = [&](const double growth) {
      return flow_stress(r.state.plastic_strain,
                         std::fmax(0., growth) / dt,
                         r.state.temperature);
    };
    const double stress = mises_of(r.P, F);
    Values       values;
    values["stress"] =
      r.plastic ?
        std::fmax(0.,
                  std::fmax(at_rate_of(plastic - digit) / stress - 1.,
                            1. - at_rate_of(plastic + digit) / stress)) :
        0.;
    // Short against the increment, not so short that round-off shows.
    const double scale = std::fmin(increment, 1e-2);
    values["tangent"]  = tangent_error(*law, F, old, dt, 0.4 * scale);
    for (double h = 0.2; h > 1e-4 && values["tangent"] > 1e-7; h *= 0.5)
      values["tangent"] = std::fmin(values["tangent"],
                                    tangent_error(*law, F, old, dt, h * scale));
    return values;
  }



  /** C24: share of other runs in the 95 % interval of a law, as a function of
   *  its points, of their noise, and of a slab without points. */
  Answer
  interval_of_law(const Cell &cell)
  {
    using namespace calibration_example;
    const Truth   truth   = cell.text("truth") == "dry" ? dry : lubricated;
    const int     face    = std::stoi(cell.text("face"));
    const Quality quality = judge(truth,
                                  cell.number("noise"),
                                  cell.count("points"),
                                  [face](const double *z) {
                                    return face < 0 || is_off_face(face, z);
                                  });
    std::string   warning;
    for (const std::string &text : quality.warnings)
      if (text.find("No run lies") == 0 || text.find("Runs that are left") == 0)
        warning = text;
    return {{{"coverage", quality.coverage}, {"error", quality.error}},
            warning};
  }
} // namespace



namespace stability
{
  Sweeps
  point_sweeps()
  {
    return {{"C3", piston_over_robin_coefficient},
            {"C5", quasi_newton},
            {"C11", closest_point},
            {"C18", return_map},
            {"C24", interval_of_law}};
  }
} // namespace stability
