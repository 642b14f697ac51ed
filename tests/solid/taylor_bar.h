#ifndef asperity_tests_solid_taylor_bar_h
#define asperity_tests_solid_taylor_bar_h

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

#include "motion.h"

namespace loaded_solid
{
  struct TaylorBarResult
  {
    double length;   ///< [m]
    double diameter; ///< of the struck end [m]

    /** In the middle of the first of 5 x 50 cells, next to the axis and the
     *  wall: what Abaqus/Explicit, whose cells have one point, reports on the
     *  published mesh [degC]. */
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
    const SolidAssembler                               &solid,
    const Point<2>                                     &parameter,
    const std::function<double(const MaterialState &)> &quantity)
  {
    const SplineSpace &space   = solid.space();
    const unsigned int cell    = space.find_cell(parameter);
    const auto         box     = space.cell_box(cell);
    const auto        &element = solid.table().elements[cell];
    const unsigned int n =
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

  /**
   * Taylor's bar of 42CrMo4, radius 3.2 mm, length 32.4 mm, that hits a rigid
   * wall without friction at 287 m/s and is followed for 80 us, with Johnson
   * and Cook's flow stress and adiabatic heating (the Taylor sample of DynELA,
   * O. Pantale). The wall is u_z = 0 on the struck end, as there.
   * @param n_r cells over the radius, n_z along the bar, finer to the wall
   */
  inline TaylorBarResult
  taylor_bar(const unsigned int degree,
             const unsigned int n_r,
             const unsigned int n_z,
             const unsigned int n_steps,
             const double       rho,
             const double       end_time = 80e-6)
  {
    const double       radius = 3.2e-3, length = 32.4e-3, speed = 287.;
    MaterialParameters material;
    material.law                         = MaterialLawName::johnson_cook;
    material.elasticity.density          = 7830.;
    material.elasticity.young_modulus    = 206.9e9;
    material.elasticity.poisson_ratio    = 0.3;
    material.heating.adiabatic           = true;
    material.heating.heat_capacity       = 460.;
    material.heating.heat_fraction       = 0.9;
    material.johnson_cook.A              = 806e6;
    material.johnson_cook.B              = 614e6;
    material.johnson_cook.n              = 0.168;
    material.johnson_cook.C              = 0.0089;
    material.johnson_cook.m              = 1.1;
    material.johnson_cook.reference_rate = 1.;
    material.johnson_cook.transition_temperature = 293.15;
    material.johnson_cook.melting_temperature    = 1813.15;
    Body body(
      make_space(degree, equal_spans(n_r), graded_spans(n_z, 4.)),
      [radius, length](const Point<2> &xi) {
        return Point<2>(radius * xi[0], length * xi[1]);
      },
      make_material_law(material),
      Kinematics::axisymmetric);
    MaterialState cold;
    cold.temperature = 293.15;
    body.solid.initialize(cold);
    body.prescribe(Edge::left, 0);
    body.prescribe(Edge::bottom, 1);

    Motion motion(body, rho);
    for (unsigned int i = 1; i < body.u.size(); i += 2)
      if (!body.is_prescribed[i])
        motion.method.v(i) = -speed;
    const double start  = motion.kinetic_energy();
    const double dt     = end_time / n_steps;
    const double weight = 7830. * dealii::numbers::PI * radius * radius *
                          length * speed / dt; // the impulse over a step
    for (unsigned int step = 0; step < n_steps; ++step)
      motion.step(dt, 1e-8 * weight);

    TaylorBarResult result;
    result.length   = length + body.displacement({0., 1.})[1];
    result.diameter = 2. * (radius + body.displacement({1., 0.})[0]);
    const Point<2> centre(0.5 / 5., 0.5 / 50.);
    result.temperature =
      interpolate_history(body.solid, centre, [](const MaterialState &point) {
        return point.temperature - 273.15;
      });
    result.plastic_strain =
      interpolate_history(body.solid, centre, [](const MaterialState &point) {
        return point.plastic_strain;
      });
    result.max_temperature = 0.;
    for (const MaterialState &point : body.solid.history())
      result.max_temperature =
        std::max(result.max_temperature, point.temperature - 273.15);
    result.kinetic_energy = motion.kinetic_energy() / start;
    result.iterations     = body.statistics.iterations;
    return result;
  }
} // namespace loaded_solid

#endif
