#include <asperity/lubricant/film_walls.h>
#include <asperity/mesh_motion/column_layout.h>
#include <asperity/mesh_motion/column_mesh.h>
#include <asperity/mesh_motion/elastic_mesh_update.h>
#include <asperity/mesh_motion/mesh_quality.h>

#include <deal.II/fe/mapping_q_eulerian.h>

#include <flow/flow_examples.h>
#include <mesh_motion/example_surfaces.h>

#include <algorithm>
#include <cmath>

#include "sweeps.h"

namespace
{
  using namespace stability;
  using namespace asperity;
  using dealii::Point;
  using dealii::Tensor;
  using flow_examples::NavierStokes;
  using Vector = dealii::Vector<double>;

  FluidElement
  element(const Cell &cell)
  {
    return cell.text("element") == "Taylor-Hood" ? FluidElement::taylor_hood :
                                                   FluidElement::equal_order;
  }



  FluidTimeScheme
  scheme(const Cell &cell)
  {
    return cell.text("scheme") == "BDF2" ? FluidTimeScheme::bdf2 :
                                           FluidTimeScheme::implicit_euler;
  }



  void
  solve(NavierStokes &flow)
  {
    const ConvergenceReport report = flow.solve();
    if (!report.converged)
      throw Reported(report.reason);
  }



  /** C20: steady vortices of Taylor from their interpolated velocity, three
   *  steps; the error of the pressure over that of the same mesh in a steady
   *  flow, of the velocity likewise. */
  Values
  small_steps(const Cell &cell)
  {
    const flow_examples::Vortices vortices;
    const unsigned int            n    = cell.count("cells");
    const auto                    mesh = flow_examples::rectangle(n, n);
    flow_examples::FlowError      errors[2];
    for (const bool steady : {true, false})
      {
        FluidOptions options    = vortices.options();
        options.element         = element(cell);
        options.degree          = 2;
        options.geometry_degree = 2;
        options.scheme =
          steady ? FluidTimeScheme::steady : FluidTimeScheme::implicit_euler;
        NavierStokes flow(*mesh, options);
        flow.boundary().set_velocity({0, 2, 3}, vortices.velocity_function());
        flow.boundary().set_traction({1},
                                     [&](const Point<2>     &x,
                                         const Tensor<1, 2> &normal,
                                         const double        t) {
                                       return vortices.traction(x, normal, t);
                                     });
        if (!steady)
          flow.set_initial_velocity(vortices.velocity_function());
        for (unsigned int step = 0; step < (steady ? 1 : 3); ++step)
          {
            if (!steady)
              flow.begin_step(cell.number("step"));
            solve(flow);
            if (!steady)
              flow.accept();
          }
        errors[steady] = vortices.error(flow, 0.);
      }
    return {{"pressure", errors[0].pressure / errors[1].pressure},
            {"velocity", errors[0].velocity / errors[1].velocity}};
  }



  /** C21: a uniform flow through a mesh that sways inside and at its walls. */
  Values
  uniform_flow(const Cell &cell)
  {
    constexpr double pi        = dealii::numbers::PI;
    const double     amplitude = cell.number("amplitude");
    const auto       mesh      = flow_examples::rectangle(6, 6);
    FluidOptions     options;
    options.model.density             = 1.;
    options.model.viscosity.viscosity = 0.01;
    options.scheme                    = scheme(cell);
    options.element                   = element(cell);
    options.tolerance                 = 1e-12;
    NavierStokes flow(*mesh, options);
    const auto   uniform = flow_examples::constant(0.8, -0.3);
    flow.boundary().set_velocity({0, 2, 3}, uniform);
    flow.set_initial_velocity(uniform);
    Values values;
    for (unsigned int step = 0; step < 5; ++step)
      {
        // steps of different length, as after a cut
        flow.begin_step(cell.number("step") * (step == 2 ? 0.7 : 1.));
        const double t = flow.time() / cell.number("step");
        if (!flow.set_mesh_displacement(
              flow_examples::displacement(flow, [&](const Point<2> &X) {
                const double s = amplitude * std::sin(2. * pi * X[0] + 0.3) *
                                 std::sin(2. * pi * X[1] + 0.7) *
                                 std::sin(0.3 * t);
                return X + flow_examples::vector(s, s);
              })))
          throw Reported("The moving mesh has an inverted cell.");
        solve(flow);
        flow.accept();
        const auto error = flow_examples::error_of(
          flow, uniform, [](const Point<2> &, double) { return 0.; }, 0.);
        values["velocity"] = std::max(values["velocity"], error.velocity);
        values["pressure"] = std::max(values["pressure"], error.pressure);
      }
    return values;
  }



  SplineCurve
  slid_chip(const double distance)
  {
    SplineCurve           chip   = example::flat(0.);
    std::vector<Point<2>> points = chip.control_points();
    for (Point<2> &p : points)
      p[0] += distance;
    chip.set_control_points(points);
    return chip;
  }



  /** Whether a mesh that came back is that of the start, and what its cells
   *  were in between. */
  Values
  returned(const MeshWatch &watch,
           const Vector    &start,
           const Vector    &away,
           const Vector    &back,
           const double     distance)
  {
    const ConvergenceReport report = watch.check(away);
    if (!report.converged)
      throw Reported(report.reason);
    Vector drift = back;
    drift -= start;
    return {{"drift", drift.linfty_norm() / distance},
            {"quality", watch.quality(away).smallest_scaled_jacobian}};
  }



  /** C15: the mesh in the gap of R0, by columns or elastic, after the chip has
   *  slid to and fro. */
  Values
  sliding_mesh(const Cell &cell)
  {
    using example::um;
    const double      distance = cell.number("distance") * um;
    const SplineCurve chip     = example::flat(0.),
                      tool     = example::surface(example::tool_height);
    ColumnMesh columns(
      chip,
      tool,
      {columns_on_spans(chip.knot_vector(),
                        160,
                        film_density(chip, tool, Tensor<1, 2>())),
       graded_rows(6),
       0.005 * um});
    Tensor<1, 2> shift;
    shift[1] = cell.number("opening") * um;
    columns.update(chip, shift);
    const Vector start = columns.displacement();
    if (cell.text("mesh") == "columns")
      {
        const MeshWatch watch(columns.dofs(), dealii::MappingQ1<2>());
        const auto      report = columns.update(slid_chip(distance), shift);
        if (!report.converged)
          throw Reported(report.reason);
        const Vector away = columns.displacement();
        columns.update(chip, shift);
        return returned(watch, start, away, columns.displacement(), distance);
      }
    const dealii::MappingQEulerian<2, Vector> mapping(2, columns.dofs(), start);
    ElasticMeshOptions                        options;
    options.stiffening_exponent = std::stod(cell.text("mesh"));
    options.prescribed = {ColumnMesh::chip_wall, ColumnMesh::tool_wall};
    options.periodic   = {{ColumnMesh::left_side, ColumnMesh::right_side}};
    const ElasticMeshUpdate update(columns.dofs(), mapping, options);
    const MeshWatch         watch(columns.dofs(), mapping);
    Vector                  boundary(start.size());
    const Vector            rest = update.update(boundary);
    for (const auto &node : columns.chip_nodes())
      boundary(node.dof_x) = distance;
    const Vector away = update.update(boundary);
    for (const auto &node : columns.chip_nodes())
      boundary(node.dof_x) = 0.;
    return returned(watch, rest, away, update.update(boundary), distance);
  }



  /** C22: a slider of gap 2 to 1 whose oil follows Barus; load against
   *  int -ln(1 - alpha q)/alpha, q the pressure of a Newtonian oil. */
  Answer
  piezoviscous_slider(const Cell &cell)
  {
    const double       alpha = cell.number("alpha");
    const unsigned int n     = cell.count("cells");
    FilmWalls          walls;
    for (unsigned int i = 0; i <= n; ++i)
      walls.x.push_back(double(i) / n);
    walls.gap         = [](const double x) { return 2. - x; };
    walls.lower_speed = 1.;
    LubricantParameters oil;
    oil.compressibility.law            = DensityLaw::incompressible;
    oil.viscosity.viscosity            = 1.;
    oil.viscosity.pressure_law         = PressureLaw::barus;
    oil.viscosity.pressure_coefficient = alpha;
    FilmEnds ends;
    ends.periodic = false;
    const ReynoldsFilm      film(oil, n, ends);
    std::vector<FilmState>  states(n);
    const ConvergenceReport report =
      film.solve(walls.geometry(), FilmStep(), states);
    if (!report.converged)
      throw Reported(report.reason);
    if (const std::string warning = film.warning(walls.geometry(), states);
        !warning.empty())
      throw Reported(warning);
    // q = 6 U (h_1 - h)(h - h_2)/((h_1 + h_2)/... h^2): of the film 2 to 1
    double exact = 0.;
    for (unsigned int i = 0; i < 100000; ++i)
      {
        const double h = 2. - (i + 0.5) / 100000.;
        const double q = 2. * (2. - h) * (h - 1.) / (h * h);
        exact += (alpha > 0. ? -std::log(1. - alpha * q) / alpha : q) / 100000.;
      }
    return {{{"load",
              std::abs(film_forces(film, walls, states).load / exact - 1.)}},
            film.coarseness(walls.geometry(), states)};
  }
} // namespace



namespace stability
{
  Sweeps
  flow_sweeps()
  {
    return {{"C15", sliding_mesh},
            {"C20", small_steps},
            {"C21", uniform_flow},
            {"C22", piezoviscous_slider}};
  }
} // namespace stability
