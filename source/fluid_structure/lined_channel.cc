#include <asperity/base/errors.h>

#include <deal.II/grid/grid_generator.h>

#include <cmath>

#include "problems.h"

// The plane counterpart of the pressure wave in an elastic tube (J.-F. Gerbeau,
// M. Vidrascu, M2AN 37 (2003) 631-647): half a channel with a soft elastic
// lining on a rigid wall, and a pulse of pressure at the inlet. The first and
// the last of the cells have no lining, so that no node of the lining is one of
// an open end.
//
// A long wave presses the lining like a spring, p = M eta/H. With the balance
// of volume and momentum of the fluid, h dv/dx + d eta/dt = 0 and rho dv/dt +
// dp/dx = 0, the pulse travels at c = sqrt(M h/(rho H)). Waves that are not
// long, of wave number k, are slower by sqrt(tanh(k h)/(k h)).
namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    enum Boundary : dealii::types::boundary_id
    {
      inlet  = 0,
      outlet = 1,
      axis   = 2,
      lining = 3,
      rigid  = 4
    };

    constexpr double length = 0.1, height = 2e-3, thickness = 0.5e-3; // [m]

    void
    generate_mesh(const unsigned int        n_along,
                  const unsigned int        n_across,
                  dealii::Triangulation<2> &mesh)
    {
      dealii::GridGenerator::subdivided_hyper_rectangle(
        mesh, {n_along, n_across}, Point<2>(), Point<2>(length, height), true);
      const double end = length / n_along;
      for (const auto &face : mesh.active_face_iterators())
        if (face->at_boundary() && face->boundary_id() == lining &&
            std::abs(face->center()[0] - 0.5 * length) > 0.5 * length - end)
          face->set_boundary_id(rigid);
    }

    SplineBody
    make_lining(const FluidStructureParameters &parameters)
    {
      const BodyParameters &p       = parameters.body;
      const unsigned int    n_cells = parameters.fluid.cells_along;
      const unsigned int    degree  = p.degree.value_or(2);
      const double          end     = length / n_cells;
      SplineBody            body;
      const auto            space = std::make_shared<SplineSpace<2>>(
        KnotVector(degree, uniform_breaks(p.spans_along.value_or(n_cells - 2))),
        KnotVector(degree, uniform_breaks(p.spans_across.value_or(2))));
      body.space = space;
      body.geometry =
        PatchGeometry<2>::from_map(*space, [&](const Point<2> &xi) {
          return Point<2>(end + (length - 2. * end) * xi[0],
                          height + thickness * xi[1]);
        });
      body.law     = parameters.material.make_law();
      body.clamped = {Edge::left, Edge::right, Edge::top};
      body.wet     = {Edge::bottom};
      return body;
    }
  } // namespace



  double
  wave_speed_of_lined_channel(const FluidStructureParameters &parameters)
  {
    const ElasticParameters &elasticity = parameters.material.elasticity;
    const double             modulus =
      elasticity.lame_lambda() + 2. * elasticity.shear_modulus();
    return std::sqrt(modulus * height / (parameters.fluid.density * thickness));
  }



  std::unique_ptr<FluidStructureProblem>
  make_lined_channel(const FluidStructureParameters &parameters)
  {
    const FluidParameters &fluid   = parameters.fluid;
    auto                   problem = std::make_unique<FluidStructureProblem>();
    make_or_read_mesh(
      problem->mesh,
      parameters.problem.mesh_file,
      {"inlet", "outlet", "axis", "lining", "rigid wall at both ends"},
      [&] {
        generate_mesh(fluid.cells_along, fluid.cells_across, problem->mesh);
      });
    problem->mesh.refine_global(fluid.refinements);
    FluidWalls walls;
    walls.wet       = {lining};
    problem->system = std::make_unique<FluidStructure>(problem->mesh,
                                                       walls,
                                                       make_lining(parameters),
                                                       options_of(parameters));
    auto &boundary  = problem->system->flow().boundary();
    boundary.set_traction({inlet},
                          [p = parameters.problem](const Point<2> &,
                                                   const Tensor<1, 2> &n,
                                                   const double        t) {
                            const double s =
                              std::sin(M_PI * t / p.pulse_duration);
                            return t < p.pulse_duration ? -p.pulse * s * s * n :
                                                          0. * n;
                          });
    boundary.set_velocity({axis}, no_velocity(), {{false, true}});
    boundary.set_velocity({rigid}, no_velocity());
    problem->watched = {0.25, 0.};
    problem->loaded  = {lining};
    return problem;
  }
} // namespace asperity
