#ifndef asperity_tests_solid_thick_cylinder_h
#define asperity_tests_solid_thick_cylinder_h

#include "loaded_solid.h"

namespace loaded_solid
{
  /** A perfectly plastic cylinder of radii 10 and 20 mm whose inner radius is
   *  driven out to a = 85 mm in plane strain: nearly isochoric, so that
   *  elements which lock show it. */
  struct ThickCylinder
  {
    static constexpr double inner = 10e-3, outer = 20e-3; ///< [m]
    static constexpr double shear_modulus = 3.8e9;        ///< [Pa]
    static constexpr double bulk_modulus  = 40e9;         ///< [Pa]
    static constexpr double yield_stress  = 0.5e9;        ///< [Pa]

    static std::shared_ptr<const MaterialLaw>
    law()
    {
      const double       K = bulk_modulus, G = shear_modulus;
      MaterialParameters material;
      material.elasticity.young_modulus = 9. * K * G / (3. * K + G);
      material.elasticity.poisson_ratio =
        (3. * K - 2. * G) / (2. * (3. * K + G));
      material.choose(VoceParameters{yield_stress, yield_stress, 0., 0.});
      return material.make_law();
    }

    /** Pressure [Pa] on the inner face of a rigid-plastic cylinder. */
    static double
    rigid_plastic_pressure(const double a)
    {
      const double a2 = a * a - inner * inner;
      return yield_stress / std::sqrt(3.) *
             std::log((outer * outer + a2) / (a * a));
    }

    /**
     * The same with elastic volume changes, when all of the wall flows: with
     * the Kirchhoff stress at yield, tau_theta - tau_r = 2 k and s_z = 0, and
     * m = ln J,
     *   sigma_r = (K m - k) exp(-m),  r dsigma_r/dr = 2 k exp(-m)
     *   => (K + k) m - K m^2/2 + 2 k ln(b/r) = the same at r = b, m_b = k/K,
     * and b follows from the mass, integral of r exp(-m) = (b0^2 - a0^2)/2.
     */
    static double
    elastic_plastic_pressure(const double a)
    {
      const double K = bulk_modulus, k = yield_stress / std::sqrt(3.);
      const auto   log_J = [&](const double r, const double b) {
        const double c =
          (K + k) * k / K - 0.5 * k * k / K - 2. * k * std::log(b / r);
        return c / K * 2. /
               ((1. + k / K) +
                std::sqrt((1. + k / K) * (1. + k / K) - 2. * c / K));
      };
      const auto mass = [&](const double b) {
        const unsigned int n   = 1000; // midpoint rule
        double             sum = 0.;
        for (unsigned int i = 0; i < n; ++i)
          {
            const double r = a + (b - a) * (i + 0.5) / n;
            sum += r * std::exp(-log_J(r, b)) * (b - a) / n;
          }
        return sum;
      };
      double low = a, high = a + outer;
      for (unsigned int i = 0; i < 60; ++i)
        {
          const double b = 0.5 * (low + high);
          (mass(b) < 0.5 * (outer * outer - inner * inner) ? low : high) = b;
        }
      const double m = log_J(a, low);
      return -(K * m - k) * std::exp(-m);
    }

    /** By the isogeometric solid as a ring in axisymmetry. */
    static double
    ring_pressure(const unsigned int degree,
                  const unsigned int n,
                  const unsigned int n_steps,
                  const double       a)
    {
      Body body(
        make_space(degree, equal_spans(n), equal_spans(1)),
        [](const Point<2> &xi) {
          return Point<2>(inner + (outer - inner) * xi[0],
                          (outer - inner) * xi[1]);
        },
        law(),
        Kinematics::axisymmetric);
      for (unsigned int i = 1; i < body.u.size(); i += 2)
        body.constraints.add_line(i);
      body.prescribe(Edge::left, 0);
      Vector target(body.u.size());
      for (unsigned int step = 1; step <= n_steps; ++step)
        {
          for (const unsigned int b : body.space->edge_functions(Edge::left))
            target(2 * b) = (a - inner) * step / n_steps;
          body.solve(1e-1, &target);
        }
      Vector forces(body.u.size());
      body.equilibrium().forces(body.u, forces);
      double radial = 0.;
      for (const unsigned int b : body.space->edge_functions(Edge::left))
        radial += forces(2 * b);
      return radial / (2. * dealii::numbers::PI * a * (outer - inner));
    }

    /** By the isogeometric solid as a quarter of the section in the plane; n
     *  cells in the wall and 2 n around. */
    static double
    quarter_pressure(const unsigned int degree,
                     const unsigned int n,
                     const unsigned int n_steps,
                     const double       a)
    {
      Body body(
        make_space(degree, equal_spans(n), equal_spans(2 * n)),
        [](const Point<2> &xi) {
          const double R     = inner + (outer - inner) * xi[0];
          const double angle = 0.5 * dealii::numbers::PI * xi[1];
          return Point<2>(R * std::cos(angle), R * std::sin(angle));
        },
        law());
      body.prescribe(Edge::bottom, 1);
      body.prescribe(Edge::top, 0);
      body.clamp(Edge::left);
      const Vector X      = body.control_points();
      Vector       target = X;
      for (unsigned int step = 1; step <= n_steps; ++step)
        {
          target = 0.;
          for (const unsigned int b : body.space->edge_functions(Edge::left))
            for (unsigned int c = 0; c < 2; ++c)
              target(2 * b + c) =
                X(2 * b + c) * (a / inner - 1.) * step / n_steps;
          body.solve(1e-1, &target);
        }
      // Work of the inner edge: R . dx = p dA, with the area s^2 A0 inside.
      Vector forces(body.u.size());
      body.equilibrium().forces(body.u, forces);
      double work = 0.;
      for (const unsigned int b : body.space->edge_functions(Edge::left))
        for (unsigned int c = 0; c < 2; ++c)
          work += forces(2 * b + c) * X(2 * b + c);
      return work / (0.5 * dealii::numbers::PI * a * inner);
    }
  };
} // namespace loaded_solid

#endif
