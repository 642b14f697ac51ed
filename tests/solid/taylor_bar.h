#ifndef asperity_tests_solid_taylor_bar_h
#define asperity_tests_solid_taylor_bar_h

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

#include "motion.h"

namespace loaded_solid
{
  /**
   * Taylor's bar of 42CrMo4 that hits a rigid wall without friction, with
   * Johnson and Cook's flow stress and adiabatic heating: the axisymmetric
   * impact sample of DynELA (O. Pantale, github.com/pantale/DynELA-v.-4.0,
   * Documentation/ImpactSamples.tex). The wall is u_z = 0 on the struck end,
   * as there.
   */
  namespace taylor
  {
    constexpr double radius      = 3.2e-3;    ///< [m]
    constexpr double length      = 32.4e-3;   ///< [m]
    constexpr double speed       = 287.;      ///< [m/s]
    constexpr double density     = 7830.;     ///< [kg/m^3]
    constexpr double end_time    = 80e-6;     ///< [s]
    constexpr double room        = 293.15;    ///< temperature at the start [K]
    constexpr double cells[2]    = {5., 50.}; ///< of the published mesh
    constexpr double zero_degree = 273.15;    ///< Celsius [K]

    inline MaterialParameters
    steel()
    {
      MaterialParameters steel;
      steel.elasticity.density       = density;
      steel.elasticity.young_modulus = 206.9e9;
      steel.elasticity.poisson_ratio = 0.3;
      steel.heating.adiabatic        = true;
      steel.heating.heat_capacity    = 460.;
      steel.heating.heat_fraction    = 0.9;
      JohnsonCookParameters johnson_cook;
      johnson_cook.A                      = 806e6;
      johnson_cook.B                      = 614e6;
      johnson_cook.n                      = 0.168;
      johnson_cook.C                      = 0.0089;
      johnson_cook.m                      = 1.1;
      johnson_cook.reference_rate         = 1.;
      johnson_cook.transition_temperature = room;
      johnson_cook.melting_temperature    = 1540. + zero_degree;
      steel.choose(johnson_cook);
      return steel;
    }
  } // namespace taylor

  struct TaylorBarResult
  {
    double length;   ///< [m]
    double diameter; ///< of the struck end [m]

    /** In the middle of the first cell of the published mesh, next to the axis
     *  and the wall: where Abaqus/Explicit has that cell's one point [degC]. */
    double temperature;
    double plastic_strain; ///< at the same point

    double       max_temperature; ///< over all quadrature points [degC]
    double       kinetic_energy;  ///< left, over that of the start
    unsigned int iterations;      ///< of Newton's method, in total
  };

  /** Lagrange interpolation of a quantity of the history between the
   *  quadrature points of the cell that holds a parameter. */
  inline double
  interpolate_history(
    const SolidAssembler<2>                            &solid,
    const Point<2>                                     &parameter,
    const std::function<double(const MaterialState &)> &quantity)
  {
    const SplineSpace<2> &space   = solid.space();
    const unsigned int    cell    = space.find_cell(parameter);
    const auto            box     = space.cell_box(cell);
    const auto           &element = solid.table().elements[cell];
    const unsigned int    n =
      std::lround(std::sqrt(solid.table().points_per_element));
    const dealii::QGauss<1> gauss(n);
    const auto lagrange = [&](const unsigned int i, const unsigned int d) {
      const double x =
        (parameter[d] - box.first[d]) / (box.second[d] - box.first[d]);
      double value = 1.;
      for (unsigned int j = 0; j < n; ++j)
        if (j != i)
          value *=
            (x - gauss.point(j)[0]) / (gauss.point(i)[0] - gauss.point(j)[0]);
      return value;
    };
    double value = 0.;
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        value += lagrange(i, 0) * lagrange(j, 1) *
                 quantity(solid.history()[element.first_point + j * n + i]);
    return value;
  }

  inline TaylorBarResult
  measure_taylor_bar(const Body &bar)
  {
    const auto temperature = [](const MaterialState &point) {
      return point.temperature - taylor::zero_degree;
    };
    const Point<2>  centre(0.5 / taylor::cells[0], 0.5 / taylor::cells[1]);
    TaylorBarResult result;
    result.length      = taylor::length + bar.displacement({0., 1.})[1];
    result.diameter    = 2. * (taylor::radius + bar.displacement({1., 0.})[0]);
    result.temperature = interpolate_history(bar.solid, centre, temperature);
    result.plastic_strain =
      interpolate_history(bar.solid, centre, [](const MaterialState &point) {
        return point.plastic_strain;
      });
    result.max_temperature = 0.;
    for (const MaterialState &point : bar.solid.history())
      result.max_temperature =
        std::max(result.max_temperature, temperature(point));
    return result;
  }

  /**
   * @param n_r equal cells over the radius
   * @param n_z cells along the bar, four times as fine at the wall as at the
   *   free end
   * @param n_steps equal time steps
   * @param rho spectral radius of generalized-alpha
   */
  inline TaylorBarResult
  taylor_bar(const unsigned int degree,
             const unsigned int n_r,
             const unsigned int n_z,
             const unsigned int n_steps,
             const double       rho)
  {
    Body body(
      make_space(degree, equal_spans(n_r), graded_spans(n_z, 4.)),
      [](const Point<2> &xi) {
        return Point<2>(taylor::radius * xi[0], taylor::length * xi[1]);
      },
      taylor::steel().make_law(),
      Kinematics::axisymmetric);
    MaterialState cold;
    cold.temperature = taylor::room;
    body.solid.initialize(cold);
    body.prescribe(Edge::left, 0);
    body.prescribe(Edge::bottom, 1);

    Motion motion(body, rho);
    Vector velocity(body.u.size());
    for (unsigned int i = 1; i < body.u.size(); i += 2)
      if (!body.constraints.is_constrained(i))
        velocity(i) = -taylor::speed;
    motion.start_with_velocity(velocity);
    const double start = motion.kinetic_energy();
    const double dt    = taylor::end_time / n_steps;
    const double mass = taylor::density * dealii::numbers::PI * taylor::radius *
                        taylor::radius * taylor::length;
    for (unsigned int step = 0; step < n_steps; ++step)
      // of the force that would stop the bar within a step
      motion.step(dt, 1e-8 * mass * taylor::speed / dt);

    TaylorBarResult result = measure_taylor_bar(body);
    result.kinetic_energy  = motion.kinetic_energy() / start;
    result.iterations      = body.statistics.iterations;
    return result;
  }
} // namespace loaded_solid

#endif
