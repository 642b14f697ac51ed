#ifndef asperity_tests_coupling_lined_channel_h
#define asperity_tests_coupling_lined_channel_h

#include <asperity/constitutive/hyperelasticity.h>
#include <asperity/coupling/fluid_structure.h>

#include <deal.II/grid/grid_generator.h>

#include <cmath>
#include <memory>
#include <vector>

namespace lined_channel
{
  using namespace asperity;
  using dealii::Point;
  using dealii::Tensor;

  /**
   * The plane counterpart of the pressure wave in an elastic tube (J.-F.
   * Gerbeau, M. Vidrascu, M2AN 37 (2003) 631-647): half a channel of height h,
   * with a soft elastic lining of thickness H on a rigid wall, and a pulse of
   * pressure at the inlet. The first and the last of the cells have no lining,
   * so that no node of the lining is one of an open end.
   *
   * A long wave presses the lining like a spring, p = M eta/H with the modulus
   * of uniaxial strain M = E (1 - nu)/((1 + nu) (1 - 2 nu)). With the balance
   * of volume and momentum of the fluid, h dv/dx + d eta/dt = 0 and rho dv/dt +
   * dp/dx = 0, the pulse travels at
   *   c = sqrt(M h/(rho H)),
   * the plane form of Moens and Korteweg's speed. Waves that are not long, of
   * wave number k, are slower by sqrt(tanh(k h)/(k h)).
   */
  struct LinedChannel
  {
    double       length = 0.1, height = 2e-3, lining = 0.5e-3; ///< [m]
    double       fluid_density = 1e3, viscosity = 1e-4;        ///< SI
    double       solid_density = 1200., poisson_ratio = 0.3;
    double       modulus    = 7562.5; ///< M [Pa]: c = 5.5 m/s
    double       pulse      = 20.;    ///< [Pa]
    double       pulse_time = 5e-3;   ///< [s]
    unsigned int cells      = 50;

    double
    wave_speed() const
    {
      return std::sqrt(modulus * height / (fluid_density * lining));
    }

    /** Length without lining at either end [m]. */
    double
    end() const
    {
      return length / cells;
    }

    FluidStructureOptions
    options() const
    {
      FluidStructureOptions options;
      options.fluid.model.density             = fluid_density;
      options.fluid.model.viscosity.viscosity = viscosity;
      options.solid.load_floor                = pulse * lining;
      return options;
    }

    SplineBody
    body() const
    {
      std::vector<double> along(1, 0.);
      for (unsigned int i = 1; i <= cells - 2; ++i)
        along.push_back(double(i) / (cells - 2));
      SplineBody body;
      const auto space =
        std::make_shared<SplineSpace>(KnotVector(2, along),
                                      KnotVector(2, {0., 0.5, 1.}));
      body.space    = space;
      body.geometry = PatchGeometry::from_map(*space, [&](const Point<2> &xi) {
        return Point<2>(end() + (length - 2. * end()) * xi[0],
                        height + lining * xi[1]);
      });
      ElasticParameters elasticity;
      elasticity.density       = solid_density;
      elasticity.poisson_ratio = poisson_ratio;
      elasticity.young_modulus = modulus * (1. + poisson_ratio) *
                                 (1. - 2. * poisson_ratio) /
                                 (1. - poisson_ratio);
      body.law     = std::make_shared<StVenantKirchhoff>(elasticity);
      body.clamped = {Edge::left, Edge::right, Edge::top};
      body.wet     = {Edge::bottom};
      return body;
    }

    /** @param mesh empty; must outlive the result */
    std::unique_ptr<FluidStructure>
    problem(dealii::Triangulation<2>    &mesh,
            const FluidStructureOptions &options) const
    {
      enum Side : dealii::types::boundary_id
      {
        inlet  = 0,
        outlet = 1,
        axis   = 2,
        wall   = 3,
        rigid  = 4
      };
      dealii::GridGenerator::subdivided_hyper_rectangle(
        mesh, {cells, 2}, Point<2>(), Point<2>(length, height), true);
      for (const auto &face : mesh.active_face_iterators())
        if (face->at_boundary() && face->boundary_id() == wall &&
            std::abs(face->center()[0] - 0.5 * length) > 0.5 * length - end())
          face->set_boundary_id(rigid);
      auto  problem  = std::make_unique<FluidStructure>(mesh,
                                                      BoundaryIds{wall},
                                                      body(),
                                                      options);
      auto &boundary = problem->flow().boundary();
      boundary.set_traction({inlet},
                            [p = pulse, T = pulse_time](const Point<2> &,
                                                        const Tensor<1, 2> &n,
                                                        const double        t) {
                              const double s = std::sin(M_PI * t / T);
                              return t < T ? -p * s * s * n : 0. * n;
                            });
      const auto rest = [](const Point<2> &, const double) {
        return Tensor<1, 2>();
      };
      boundary.set_velocity({axis}, rest, {{false, true}});
      boundary.set_velocity({rigid}, rest);
      return problem;
    }
  };
} // namespace lined_channel

#endif
