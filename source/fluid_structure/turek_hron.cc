#include <asperity/flow/channel_meshes.h>

#include <deal.II/grid/manifold_lib.h>

#include <cmath>

#include "problems.h"

// The elastic flag behind a cylinder in a channel; S. Turek, J. Hron, Proposal
// for numerical benchmarking of fluid-structure interaction (2006).
namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /** The last span is four times as long as the first, at the cylinder. */
    std::vector<double>
    graded_breaks(const unsigned int n)
    {
      std::vector<double> breaks(1, 0.);
      for (unsigned int i = 0; i < n; ++i)
        breaks.push_back(breaks.back() +
                         std::pow(4., n > 1 ? i / (n - 1.) : 0.));
      for (double &x : breaks)
        x /= breaks.back();
      return breaks;
    }

    SplineBody
    make_flag(const FluidStructureParameters &parameters)
    {
      const BodyParameters &p      = parameters.body;
      const unsigned int    degree = p.degree.value_or(3);
      SplineBody            body;
      const auto            space = std::make_shared<SplineSpace<2>>(
        KnotVector(degree, graded_breaks(p.spans_along.value_or(16))),
        KnotVector(degree, uniform_breaks(p.spans_across.value_or(2))));
      body.space = space;
      body.geometry =
        PatchGeometry<2>::from_map(*space, [](const Point<2> &xi) {
          const double y = 0.19 + 0.02 * xi[1];
          const double arc =
            0.2 + std::sqrt(0.05 * 0.05 - (y - 0.2) * (y - 0.2));
          return Point<2>(arc + xi[0] * (0.6 - arc), y);
        });
      body.law     = parameters.material.make_law();
      body.clamped = {Edge::left};
      body.wet     = {Edge::bottom, Edge::right, Edge::top};
      return body;
    }

    void
    make_mesh(const FluidStructureParameters &parameters,
              dealii::Triangulation<2>       &mesh)
    {
      const FluidParameters &fluid = parameters.fluid;
      const std::string     &file  = parameters.problem.mesh_file;
      make_or_read_mesh(mesh,
                        file,
                        {"inlet",
                         "outlet",
                         "walls of the channel",
                         "cylinder",
                         "lower side of the flag",
                         "tip of the flag",
                         "upper side of the flag"},
                        [&] {
                          make_channel_with_flag(mesh,
                                                 fluid.refinements,
                                                 fluid.wall_layers,
                                                 fluid.corner_layers);
                        });
      if (file.empty())
        return;
      constexpr dealii::types::manifold_id arcs = 1;
      for (const auto &face : mesh.active_face_iterators())
        if (face->at_boundary() && face->boundary_id() == channel_cylinder)
          face->set_manifold_id(arcs);
      mesh.set_manifold(arcs, dealii::PolarManifold<2>(Point<2>(0.2, 0.2)));
      mesh.refine_global(fluid.refinements);
    }

    FluidFunction
    inflow(const ProblemParameters &p, const bool is_steady)
    {
      const double peak = p.largest_inflow;
      const double time = is_steady ? 0. : p.inflow_ramp;
      return [peak, time](const Point<2> &x, const double t) {
        const double ramp =
          t >= time ? 1. : 0.5 * (1. - std::cos(M_PI * t / time));
        Tensor<1, 2> v;
        v[0] = peak * ramp * x[1] * (0.41 - x[1]) / (0.205 * 0.205);
        return v;
      };
    }

    /** The swing is unstable from rest, but takes seconds to grow from
     *  round-off. */
    FluidFunction
    shaking(const ProblemParameters &p)
    {
      if (p.shaking == 0.)
        return {};
      return [start     = p.inflow_ramp,
              frequency = p.shaking_frequency,
              amplitude = p.shaking](const Point<2> &, const double t) {
        const double periods = (t - start) * frequency;
        Tensor<1, 2> b;
        if (periods > 0. && periods < 2.)
          b[1] = amplitude * std::sin(2. * M_PI * periods);
        return b;
      };
    }
  } // namespace



  std::unique_ptr<FluidStructureProblem>
  make_turek_hron(const FluidStructureParameters &parameters)
  {
    auto problem = std::make_unique<FluidStructureProblem>();
    make_mesh(parameters, problem->mesh);
    FluidStructureOptions options  = options_of(parameters);
    options.fluid.model.body_force = shaking(parameters.problem);
    FluidWalls walls;
    walls.wet       = {flag_bottom, flag_tip, flag_top};
    problem->system = std::make_unique<FluidStructure>(problem->mesh,
                                                       walls,
                                                       make_flag(parameters),
                                                       options);
    auto &boundary  = problem->system->flow().boundary();
    boundary.set_velocity({channel_inlet},
                          inflow(parameters.problem,
                                 parameters.fluid.scheme ==
                                   FluidTimeScheme::steady));
    boundary.set_velocity({channel_walls, channel_cylinder}, no_velocity());
    problem->watched = {1., 0.5}; // A in the publication
    problem->loaded  = {channel_cylinder, flag_bottom, flag_tip, flag_top};
    return problem;
  }
} // namespace asperity
