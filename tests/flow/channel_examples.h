#ifndef asperity_tests_fluid_channel_examples_h
#define asperity_tests_fluid_channel_examples_h

#include <asperity/flow/channel_meshes.h>

#include "flow_examples.h"

namespace flow_examples
{
  constexpr double channel_height = 0.41;

  /** Parabola of mean velocity U that enters the channel. */
  inline FluidFunction
  channel_inflow(const std::function<double(double)> &U)
  {
    return [U](const Point<2> &x, const double t) {
      const double s = x[1] / channel_height;
      return vector(6. * U(t) * s * (1. - s), 0.);
    };
  }

  /** The flow past a cylinder, with or without the flag. */
  struct ChannelFlow
  {
    ChannelFlow(const bool                           with_flag,
                const unsigned int                   n_refinements,
                const unsigned int                   n_wall_layers,
                FluidOptions                         options,
                const std::function<double(double)> &U)
    {
      if (with_flag)
        make_channel_with_flag(mesh, n_refinements, n_wall_layers);
      else
        make_channel_with_cylinder(mesh, n_refinements, n_wall_layers);
      flow  = std::make_unique<NavierStokes>(mesh, options);
      walls = with_flag ?
                BoundaryIds{channel_cylinder, flag_bottom, flag_tip, flag_top} :
                BoundaryIds{channel_cylinder};
      flow->boundary().set_velocity({channel_inlet}, channel_inflow(U));
      flow->boundary().set_velocity({channel_walls}, constant(0., 0.));
      flow->boundary().set_velocity(walls, constant(0., 0.));
    }

    /** Drag and lift [N/m]. */
    Tensor<1, 2>
    force() const
    {
      return flow->total_wall_force(walls);
    }

    Mesh                          mesh;
    std::unique_ptr<NavierStokes> flow;
    BoundaryIds                   walls;
  };

  inline FluidOptions
  channel_options(const double density, const double kinematic_viscosity)
  {
    FluidOptions options;
    options.model.density             = density;
    options.model.viscosity.viscosity = density * kinematic_viscosity;
    return options;
  }

  struct DfgCoefficients
  {
    double       drag, lift, pressure_difference;
    unsigned int n_dofs, iterations;
  };

  /** DFG 2D-1: Re = 20, U = 0.2 m/s, rho = 1, nu = 1e-3. */
  inline DfgCoefficients
  dfg_2d_1(const unsigned int n_refinements,
           const unsigned int n_wall_layers,
           const unsigned int degree  = 2,
           const FluidElement element = FluidElement::taylor_hood)
  {
    FluidOptions options    = channel_options(1., 1e-3);
    options.scheme          = FluidTimeScheme::steady;
    options.degree          = degree;
    options.geometry_degree = std::max(2U, degree);
    options.element         = element;
    const double      U     = 0.2;
    const ChannelFlow channel(
      false, n_refinements, n_wall_layers, options, [U](double) { return U; });
    const unsigned int iterations = solve(*channel.flow).iterations;
    const double       scale      = 2. / (U * U * 0.1);
    return {scale * channel.force()[0],
            scale * channel.force()[1],
            channel.flow->pressure_at({0.15, 0.2}) -
              channel.flow->pressure_at({0.25, 0.2}),
            channel.flow->space().dofs().n_dofs(),
            iterations};
  }

  /** CFD1 (U = 0.2) and CFD2 (U = 1) of Turek and Hron, rho = 1000, nu = 1e-3.
   */
  inline Tensor<1, 2>
  turek_hron_cfd(const double       U,
                 const unsigned int n_refinements,
                 const unsigned int n_wall_layers,
                 const unsigned int degree = 2)
  {
    FluidOptions options    = channel_options(1000., 1e-3);
    options.scheme          = FluidTimeScheme::steady;
    options.degree          = degree;
    options.geometry_degree = degree;
    const ChannelFlow channel(
      true, n_refinements, n_wall_layers, options, [U](double) { return U; });
    solve(*channel.flow);
    return channel.force();
  }

  /** The cavity of U. Ghia, K. N. Ghia, C. T. Shin, J. Comput. Phys. 48 (1982)
   *  387: unit square, lid velocity 1; n x n cells, graded to the walls. */
  struct LidCavity
  {
    LidCavity(const unsigned int n)
    {
      std::vector<double> spans(n);
      const auto          node = [n](const unsigned int i) {
        const double s = double(i) / n;
        return s - 0.8 / (2. * dealii::numbers::PI) *
                     std::sin(2. * dealii::numbers::PI * s);
      };
      for (unsigned int i = 0; i < n; ++i)
        spans[i] = node(i + 1) - node(i);
      dealii::GridGenerator::subdivided_hyper_rectangle(
        mesh,
        std::vector<std::vector<double>>{spans, spans},
        Point<2>(0., 0.),
        Point<2>(1., 1.),
        true);
    }

    /** Solves from the given start, if its size fits. */
    void
    solve_at(const double Reynolds)
    {
      const Vector start = flow == nullptr ? Vector() : flow->solution();
      FluidOptions options;
      options.model.density             = 1.;
      options.model.viscosity.viscosity = 1. / Reynolds;
      options.scheme                    = FluidTimeScheme::steady;
      flow = std::make_unique<NavierStokes>(mesh, options);
      flow->boundary().set_velocity({0, 1, 2}, constant(0., 0.));
      flow->boundary().set_velocity({3}, constant(1., 0.));
      if (start.size() > 0)
        flow->set_solution(start);
      solve(*flow);
    }

    Mesh                          mesh;
    std::unique_ptr<NavierStokes> flow;
  };
} // namespace flow_examples

#endif
