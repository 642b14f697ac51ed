#ifndef asperity_tests_fluid_flow_examples_h
#define asperity_tests_fluid_flow_examples_h

#include <asperity/flow/navier_stokes.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>

#include <cmath>
#include <memory>
#include <stdexcept>

namespace flow_examples
{
  using namespace asperity;
  using dealii::Point;
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;
  using Mesh   = dealii::Triangulation<2>;

  /** Boundary ids of a rectangle: left 0, right 1, bottom 2, top 3. */
  inline std::unique_ptr<Mesh>
  rectangle(const unsigned int n_x,
            const unsigned int n_y,
            const Point<2>    &corner  = {0., 0.},
            const Point<2>    &corner2 = {1., 1.})
  {
    auto mesh = std::make_unique<Mesh>();
    dealii::GridGenerator::subdivided_hyper_rectangle(
      *mesh, {n_x, n_y}, corner, corner2, true);
    return mesh;
  }

  inline Tensor<1, 2>
  vector(const double x, const double y)
  {
    Tensor<1, 2> v;
    v[0] = x;
    v[1] = y;
    return v;
  }

  inline FluidFunction
  constant(const double x, const double y)
  {
    return [x, y](const Point<2> &, const double) { return vector(x, y); };
  }

  /** Solves or says why not. */
  inline ConvergenceReport
  solve(NavierStokes &flow)
  {
    const ConvergenceReport report = flow.solve();
    if (!report.converged)
      throw std::runtime_error("The flow has no solution: " + report.reason);
    return report;
  }

  /** Nodal displacement of the mesh: X -> motion(X) - X. */
  inline Vector
  displacement(const NavierStokes                              &flow,
               const std::function<Point<2>(const Point<2> &)> &motion)
  {
    const auto  &dofs = flow.space().geometry_dofs();
    const auto  &fe   = dofs.get_fe();
    const Vector X    = flow.reference_positions();
    Vector       d(X.size());
    std::vector<dealii::types::global_dof_index> index(fe.n_dofs_per_cell());
    for (const auto &cell : dofs.active_cell_iterators())
      {
        cell->get_dof_indices(index);
        for (unsigned int a = 0; a < fe.base_element(0).n_dofs_per_cell(); ++a)
          {
            const unsigned int i = index[fe.component_to_system_index(0, a)];
            const unsigned int j = index[fe.component_to_system_index(1, a)];
            const Point<2>     x = motion({X(i), X(j)});
            d(i)                 = x[0] - X(i);
            d(j)                 = x[1] - X(j);
          }
      }
    return d;
  }

  /** L2 norms of the error of velocity and pressure on the present mesh. */
  struct FlowError
  {
    double velocity = 0., pressure = 0.;
  };

  inline FlowError
  error_of(const NavierStokes                                    &flow,
           const FluidFunction                                   &v,
           const std::function<double(const Point<2> &, double)> &p,
           const double                                           time)
  {
    const dealii::QGauss<2>                  quadrature(6);
    dealii::FEValues<2>                      values(flow.mapping(),
                               flow.space().dofs().get_fe(),
                               quadrature,
                               dealii::update_values |
                                 dealii::update_quadrature_points |
                                 dealii::update_JxW_values);
    const dealii::FEValuesExtractors::Vector velocity(0);
    const dealii::FEValuesExtractors::Scalar pressure(2);
    std::vector<Tensor<1, 2>>                v_h(quadrature.size());
    std::vector<double>                      p_h(quadrature.size());
    FlowError                                error;
    for (const auto &cell : flow.space().cells())
      {
        values.reinit(cell);
        values[velocity].get_function_values(flow.solution(), v_h);
        values[pressure].get_function_values(flow.solution(), p_h);
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            const Point<2> &x   = values.quadrature_point(q);
            const double    e_p = p_h[q] - p(x, time);
            error.velocity +=
              (v_h[q] - v(x, time)).norm_square() * values.JxW(q);
            error.pressure += e_p * e_p * values.JxW(q);
          }
      }
    error.velocity = std::sqrt(error.velocity);
    error.pressure = std::sqrt(error.pressure);
    return error;
  }

  /**
   * The vortices of G. I. Taylor with an amplitude f(t),
   *   v = f (-cos x sin y, sin x cos y), p = -rho f^2 (cos 2x + cos 2y)/4,
   * x, y times pi and shifted by 0.2 pi; the body force (f'/f + 2 pi^2 nu) v
   * makes them a solution for every f, none is needed for
   * f = exp(-2 pi^2 nu t).
   */
  struct Vortices
  {
    double density   = 1.;
    double viscosity = 0.1;

    std::function<double(double)> f  = [](const double) { return 1.; };
    std::function<double(double)> df = [](const double) { return 0.; };

    static constexpr double pi = dealii::numbers::PI;

    Tensor<1, 2>
    velocity(const Point<2> &x, const double t) const
    {
      const double X = pi * (x[0] + 0.2), Y = pi * (x[1] + 0.2);
      return f(t) *
             vector(-std::cos(X) * std::sin(Y), std::sin(X) * std::cos(Y));
    }

    double
    pressure(const Point<2> &x, const double t) const
    {
      const double X = pi * (x[0] + 0.2), Y = pi * (x[1] + 0.2);
      return -0.25 * density * f(t) * f(t) *
             (std::cos(2. * X) + std::cos(2. * Y));
    }

    Tensor<1, 2>
    body_force(const Point<2> &x, const double t) const
    {
      return (df(t) / f(t) + 2. * pi * pi * viscosity / density) *
             velocity(x, t);
    }

    /** sigma n */
    Tensor<1, 2>
    traction(const Point<2> &x, const Tensor<1, 2> &n, const double t) const
    {
      const double X = pi * (x[0] + 0.2), Y = pi * (x[1] + 0.2);
      Tensor<2, 2> sigma; // v_x,x = -v_y,y and v_x,y = -v_y,x: no shear
      sigma[0][0] = 2. * viscosity * f(t) * pi * std::sin(X) * std::sin(Y);
      sigma[1][1] = -sigma[0][0];
      sigma[0][0] -= pressure(x, t);
      sigma[1][1] -= pressure(x, t);
      return sigma * n;
    }

    FluidOptions
    options() const
    {
      FluidOptions options;
      options.model.density             = density;
      options.model.viscosity.viscosity = viscosity;
      options.model.body_force = [*this](const Point<2> &x, const double t) {
        return body_force(x, t);
      };
      options.flux_tolerance = 1e-2; // curved velocities, interpolated
      return options;
    }

    FluidFunction
    velocity_function() const
    {
      return
        [*this](const Point<2> &x, const double t) { return velocity(x, t); };
    }

    FlowError
    error(const NavierStokes &flow, const double t) const
    {
      return error_of(
        flow,
        velocity_function(),
        [this](const Point<2> &x, const double t) { return pressure(x, t); },
        t);
    }
  };
} // namespace flow_examples

#endif
