#include <asperity/base/errors.h>
#include <asperity/contact_zone/surface.h>
#include <asperity/isogeometric/edge_trace.h>
#include <asperity/isogeometric/spline_manifold.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold.h>

#include <cmath>

#include "problems.h"

// The first test case of J. Lee (2025), section 2.2, figure 2: fluid between
// the rough surfaces of a rigid tool and of an elastic chip, which the tool
// moves towards. Above and below the fluid has no vertical velocity, so it
// cannot leave, and the chip has to give way by just as much.
//
// As there the surfaces stand upright, the tool on the left: a surface y = s(x)
// of the other scenes, turned, is the curve (-s(Y), Y).
namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    enum Boundary : dealii::types::boundary_id
    {
      tool_side  = 0,
      chip_side  = 1,
      lower_side = 2,
      upper_side = 3
    };

    struct Geometry
    {
      Surface tool, chip; ///< as in other scenes, the tool above
      double  length = 0.;
    };

    Geometry
    make_geometry(const FluidStructureParameters &parameters)
    {
      Geometry geometry;
      geometry.tool = make_surface(parameters.tool, parameters.geometry.length);
      geometry.length = geometry.tool.period;
      geometry.chip   = make_surface(parameters.chip_surface, geometry.length);
      if (std::abs(geometry.chip.period - geometry.length) >
          1e-9 * geometry.length)
        throw InputError("The chip's surface has a period of " +
                         format_quantity(geometry.chip.period, "um", 6) +
                         "; expected that of the tool, " +
                         format_quantity(geometry.length, "um", 6) + ".");
      geometry.chip = geometry.chip.mapped(1., -geometry.chip.maximum());
      if (parameters.geometry.height <= -geometry.chip.minimum())
        throw InputError("The chip is " +
                         format_quantity(parameters.geometry.height, "um", 4) +
                         " high; expected more than its roughness, " +
                         format_quantity(-geometry.chip.minimum(), "um", 4) +
                         ".");
      geometry.tool =
        geometry.tool.mapped(1.,
                             parameters.geometry.initial_gap -
                               smallest_gap(geometry.chip, geometry.tool));
      return geometry;
    }

    /** Clamped at its back, x = H, and held in y above and below. */
    SplineBody
    make_chip(const FluidStructureParameters &parameters,
              const Geometry                 &geometry)
    {
      const BodyParameters &p      = parameters.body;
      const unsigned int    degree = p.degree.value_or(2);
      const double          back   = parameters.geometry.height;
      SplineBody            body;
      const auto            space = std::make_shared<SplineSpace<2>>(
        KnotVector(degree,
                   uniform_breaks(
                     p.spans_along.value_or(parameters.fluid.cells_along))),
        KnotVector(degree, uniform_breaks(p.spans_across.value_or(8))));
      body.space = space;
      body.geometry =
        PatchGeometry<2>::from_map(*space, [&](const Point<2> &xi) {
          const double y = geometry.length * xi[0];
          return Point<2>(back - xi[1] * (back + geometry.chip.height(y)), y);
        });
      body.law       = parameters.material.make_law();
      body.clamped   = {Edge::bottom};
      body.held_in_y = {Edge::left, Edge::right};
      body.wet       = {Edge::top};
      return body;
    }

    /** Inside, from (s, Y), s = 0 on the tool and 1 on the edge of the chip's
     *  patch. */
    class BetweenSurfaces : public dealii::ChartManifold<2, 2>
    {
    public:
      BetweenSurfaces(const Geometry &geometry, const SplineBody &body)
        : geometry(geometry)
        , space(body.space)
        , patch(body.geometry)
      {}

      std::unique_ptr<dealii::Manifold<2>>
      clone() const override
      {
        return std::make_unique<BetweenSurfaces>(*this);
      }

      Point<2>
      pull_back(const Point<2> &x) const override
      {
        const double left = tool(x[1]);
        return {(x[0] - left) / (chip(x[1]) - left), x[1]};
      }

      Point<2>
      push_forward(const Point<2> &s) const override
      {
        const double left = tool(s[1]);
        return {left + s[0] * (chip(s[1]) - left), s[1]};
      }

    private:
      double
      tool(const double y) const
      {
        return -geometry.tool.height(y);
      }

      double
      chip(const double y) const
      {
        const double xi = std::min(std::max(y / geometry.length, 0.), 1.);
        return patch.position(*space, {xi, 1.})[0];
      }

      Geometry                              geometry;
      std::shared_ptr<const SplineSpace<2>> space;
      PatchGeometry<2>                      patch;
    };

    /** Y -> (-s(Y), Y) */
    SplineCurve
    upright(const SplineCurve &surface)
    {
      std::vector<Point<2>> points;
      for (const Point<2> &point : surface.control_points())
        points.emplace_back(-point[1], point[0]);
      Tensor<1, 2> period;
      period[1] = surface.period()[0];
      return SplineCurve(surface.knot_vector(),
                         points,
                         surface.weights(),
                         period);
    }

    void
    make_mesh(const FluidParameters    &fluid,
              const Geometry           &geometry,
              const SplineBody         &body,
              dealii::Triangulation<2> &mesh)
    {
      const BetweenSurfaces between(geometry, body);
      dealii::GridGenerator::subdivided_hyper_rectangle(
        mesh,
        {fluid.cells_across, fluid.cells_along},
        Point<2>(),
        Point<2>(1., geometry.length),
        true);
      dealii::GridTools::transform(
        [&](const Point<2> &s) { return between.push_forward(s); }, mesh);
      constexpr dealii::types::manifold_id inside = 10;
      mesh.set_all_manifold_ids(inside);
      mesh.set_manifold(inside, between);
      set_spline_wall(mesh, tool_side, upright(geometry.tool.curve));
      set_spline_wall(mesh,
                      chip_side,
                      EdgeTrace(*body.space->hierarchy(), Edge::top)
                        .curve(body.geometry.offset));
      mesh.refine_global(fluid.refinements);
    }
  } // namespace



  std::unique_ptr<FluidStructureProblem>
  make_enclosed_domain(const FluidStructureParameters &parameters)
  {
    const ProblemParameters &p        = parameters.problem;
    const Geometry           geometry = make_geometry(parameters);
    const SplineBody         chip     = make_chip(parameters, geometry);
    auto problem = std::make_unique<FluidStructureProblem>();
    make_mesh(parameters.fluid, geometry, chip, problem->mesh);
    FluidWalls walls;
    walls.wet     = {chip_side};
    walls.moving  = {tool_side};
    walls.sliding = {lower_side, upper_side};
    walls.motion  = [way  = p.wall_displacement,
                    time = p.wall_duration](const double t) {
      Tensor<1, 2> d;
      d[0] = t < time ? 0.5 * way * (1. - std::cos(M_PI * t / time)) : way;
      return d;
    };
    problem->system  = std::make_unique<FluidStructure>(problem->mesh,
                                                       walls,
                                                       chip,
                                                       options_of(parameters));
    problem->watched = {0.5, 1.};
    problem->loaded  = {chip_side};
    return problem;
  }
} // namespace asperity
