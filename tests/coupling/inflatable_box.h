#ifndef asperity_tests_coupling_inflatable_box_h
#define asperity_tests_coupling_inflatable_box_h

#include <asperity/constitutive/hyperelasticity.h>
#include <asperity/coupling/fluid_structure.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace inflatable_box
{
  using namespace asperity;
  using dealii::Point;
  using dealii::Tensor;

  enum Boundary : dealii::types::boundary_id
  {
    inlet   = 0,
    channel = 1,
    wall    = 2
  };

  /**
   * The closed box of the U. Kuettler, C. Foerster, W. A. Wall, Comput. Mech.
   * 38 (2006) 417-429 kind, that only an inflow leads into: 3.4 x 3.4 m
   * outside, elastic walls of 0.2 m, a rigid channel of 1 m x 1.5 m through the
   * middle of the left wall, which is clamped there. Parabolic inflow with a
   * peak of 1 m/s, from rest to full in 1 s; it may be shut again.
   */
  class InflatableBox
  {
  public:
    /**
     * @param n_spans of the wall's spline per metre, roughly
     * @param shut time at which the inflow begins to cease [s]; nothing flows
     *   from half a second later on
     */
    InflatableBox(const unsigned int           refinements,
                  const unsigned int           n_spans,
                  const FluidStructureOptions &options,
                  const double                 shut = INFINITY)
    {
      make_mesh(refinements);
      problem        = std::make_unique<FluidStructure>(mesh,
                                                 BoundaryIds{wall},
                                                 make_body(n_spans),
                                                 options);
      auto &boundary = problem->flow().boundary();
      boundary.set_velocity({inlet}, [shut](const Point<2> &x, const double t) {
        const double s = x[1] - 1.2;
        Tensor<1, 2> v;
        v[0] = 4. * s * (1. - s) * ramp(t, shut);
        return v;
      });
      boundary.set_velocity({channel}, [](const Point<2> &, const double) {
        return Tensor<1, 2>();
      });
    }

    static double
    ramp(const double t, const double shut)
    {
      const double rise = t < 1. ? std::sin(0.5 * M_PI * t) : 1.;
      if (t < shut)
        return rise;
      const double fall = std::cos(M_PI * std::min(t - shut, 0.5));
      return rise * fall * fall;
    }

    /** Inflow at a time [m^2/s]: two thirds of the peak. */
    static double
    inflow(const double t, const double shut = INFINITY)
    {
      return 2. / 3. * ramp(t, shut);
    }

    /** As the published case. */
    static FluidStructureOptions
    default_options()
    {
      FluidStructureOptions options;
      options.fluid.model.density             = 1.1;
      options.fluid.model.viscosity.viscosity = 0.1606;
      options.fluid.scheme                    = FluidTimeScheme::implicit_euler;
      options.solid.spectral_radius           = 0.5;
      options.solid.load_floor                = 1.;
      options.coupling.tolerance              = 1e-7;
      return options;
    }

    dealii::Triangulation<2>        mesh;
    std::unique_ptr<FluidStructure> problem;

  private:
    void
    make_mesh(const unsigned int refinements)
    {
      dealii::Triangulation<2> box, pipe;
      dealii::GridGenerator::subdivided_hyper_rectangle(box,
                                                        {3, 3},
                                                        Point<2>(0.2, 0.2),
                                                        Point<2>(3.2, 3.2));
      dealii::GridGenerator::subdivided_hyper_rectangle(pipe,
                                                        {2, 1},
                                                        Point<2>(-1.3, 1.2),
                                                        Point<2>(0.2, 2.2));
      dealii::GridGenerator::merge_triangulations(box, pipe, mesh);
      for (const auto &face : mesh.active_face_iterators())
        if (face->at_boundary())
          {
            const Point<2> x = face->center();
            face->set_boundary_id(x[0] < -1.3 + 1e-9 ? inlet :
                                  x[0] < 0.2 - 1e-9  ? channel :
                                                       wall);
          }
      mesh.refine_global(refinements);
    }

    /** The wall unrolled, from the lower side of the channel round to the
     *  upper: five straight pieces with mitred corners. */
    static SplineBody
    make_body(const unsigned int n_spans)
    {
      const std::array<Point<2>, 6> inner = {{{0.2, 1.2},
                                              {0.2, 0.2},
                                              {3.2, 0.2},
                                              {3.2, 3.2},
                                              {0.2, 3.2},
                                              {0.2, 2.2}}};
      const std::array<Point<2>, 6> outer = {
        {{0., 1.2}, {0., 0.}, {3.4, 0.}, {3.4, 3.4}, {0., 3.4}, {0., 2.2}}};
      const std::array<double, 6> start = {{0., 1., 4., 7., 10., 11.}};

      const unsigned int  degree = 2;
      std::vector<double> knots(degree + 1, 0.);
      for (unsigned int piece = 0; piece < 5; ++piece)
        {
          const double       length = start[piece + 1] - start[piece];
          const unsigned int n      = std::lround(n_spans * length);
          for (unsigned int i = 1; i < n; ++i)
            knots.push_back(start[piece] + length * i / n);
          // continuous, with a kink
          knots.insert(knots.end(),
                       piece == 4 ? degree + 1 : degree,
                       start[piece + 1]);
        }
      SplineBody body;
      const auto space =
        std::make_shared<SplineSpace>(KnotVector::from_knots(degree, knots),
                                      KnotVector(degree, {0., 0.5, 1.}));
      body.space    = space;
      body.geometry = PatchGeometry::from_map(*space, [&](const Point<2> &xi) {
        unsigned int piece = 0;
        while (piece < 4 && xi[0] > start[piece + 1])
          ++piece;
        const double s =
          (xi[0] - start[piece]) / (start[piece + 1] - start[piece]);
        const Point<2> in =
          inner[piece] + s * (inner[piece + 1] - inner[piece]);
        const Point<2> out =
          outer[piece] + s * (outer[piece + 1] - outer[piece]);
        // counter-clockwise, so eta to the left of xi is inwards
        return Point<2>(out + xi[1] * (in - out));
      });
      ElasticParameters elasticity;
      elasticity.density       = 1e3;
      elasticity.young_modulus = 7e5;
      elasticity.poisson_ratio = 0.45;
      body.law                 = std::make_shared<NeoHooke>(elasticity);
      body.clamped             = {Edge::left, Edge::right};
      body.wet                 = {Edge::top};
      return body;
    }
  };
} // namespace inflatable_box

#endif
