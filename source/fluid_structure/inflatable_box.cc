#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "problems.h"

// The closed box of the U. Kuettler, C. Foerster, W. A. Wall, Comput. Mech. 38
// (2006) 417-429 kind, that only an inflow leads into: 3.4 x 3.4 m outside,
// elastic walls of 0.2 m, a rigid channel of 1 m x 1.5 m through the middle of
// the left wall, which is clamped there.
namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    enum Boundary : dealii::types::boundary_id
    {
      inlet   = 0,
      channel = 1,
      wall    = 2
    };

    void
    generate_mesh(dealii::Triangulation<2> &mesh)
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
    }

    constexpr unsigned int                 n_pieces = 5;
    const std::array<double, n_pieces + 1> starts   = {
        {0., 1., 4., 7., 10., 11.}};

    /** Continuous, with a kink where pieces meet. */
    KnotVector
    wall_knots(const unsigned int degree, const unsigned int spans_a_metre)
    {
      std::vector<double> knots(degree + 1, 0.);
      for (unsigned int piece = 0; piece < n_pieces; ++piece)
        {
          const double       length = starts[piece + 1] - starts[piece];
          const unsigned int n      = std::lround(spans_a_metre * length);
          for (unsigned int i = 1; i < n; ++i)
            knots.push_back(starts[piece] + length * i / n);
          knots.insert(knots.end(),
                       piece + 1 == n_pieces ? degree + 1 : degree,
                       starts[piece + 1]);
        }
      return KnotVector::from_knots(degree, knots);
    }

    /** The wall unrolled, from the lower side of the channel round to the
     *  upper: straight pieces with mitred corners. */
    Point<2>
    wall_position(const Point<2> &xi)
    {
      static const std::array<Point<2>, n_pieces + 1> inner = {{{0.2, 1.2},
                                                                {0.2, 0.2},
                                                                {3.2, 0.2},
                                                                {3.2, 3.2},
                                                                {0.2, 3.2},
                                                                {0.2, 2.2}}};
      static const std::array<Point<2>, n_pieces + 1> outer = {
        {{0., 1.2}, {0., 0.}, {3.4, 0.}, {3.4, 3.4}, {0., 3.4}, {0., 2.2}}};
      unsigned int piece = 0;
      while (piece + 1 < n_pieces && xi[0] > starts[piece + 1])
        ++piece;
      const double s =
        (xi[0] - starts[piece]) / (starts[piece + 1] - starts[piece]);
      const Point<2> in  = inner[piece] + s * (inner[piece + 1] - inner[piece]);
      const Point<2> out = outer[piece] + s * (outer[piece + 1] - outer[piece]);
      // counter-clockwise, so eta to the left of xi is inwards
      return Point<2>(out + xi[1] * (in - out));
    }

    SplineBody
    make_wall(const FluidStructureParameters &parameters)
    {
      const BodyParameters &p      = parameters.body;
      const unsigned int    degree = p.degree.value_or(2);
      SplineBody            body;
      const auto            space = std::make_shared<SplineSpace<2>>(
        wall_knots(degree, p.spans_along.value_or(4)),
        KnotVector(degree, uniform_breaks(p.spans_across.value_or(2))));
      body.space    = space;
      body.geometry = PatchGeometry<2>::from_map(*space, wall_position);
      body.law      = parameters.material.make_law();
      body.clamped  = {Edge::left, Edge::right};
      body.wet      = {Edge::top};
      return body;
    }

    /** Share of the full inflow. */
    double
    ramp(const ProblemParameters &p, const double t)
    {
      const double rise =
        t < p.inflow_ramp ? std::sin(0.5 * M_PI * t / p.inflow_ramp) : 1.;
      if (!p.inflow_end || t < *p.inflow_end)
        return rise;
      const double fall = std::cos(M_PI * std::min(t - *p.inflow_end, 0.5));
      return rise * fall * fall;
    }
  } // namespace



  double
  inflow_of_box(const ProblemParameters &parameters, const double time)
  {
    return 2. / 3. * parameters.largest_inflow * ramp(parameters, time);
  }



  std::unique_ptr<FluidStructureProblem>
  make_inflatable_box(const FluidStructureParameters &parameters)
  {
    auto problem = std::make_unique<FluidStructureProblem>();
    make_or_read_mesh(problem->mesh,
                      parameters.problem.mesh_file,
                      {"inlet", "channel", "elastic wall"},
                      [&] { generate_mesh(problem->mesh); });
    problem->mesh.refine_global(parameters.fluid.refinements);
    FluidWalls walls;
    walls.wet       = {wall};
    problem->system = std::make_unique<FluidStructure>(problem->mesh,
                                                       walls,
                                                       make_wall(parameters),
                                                       options_of(parameters));
    auto &boundary  = problem->system->flow().boundary();
    boundary.set_velocity(
      {inlet}, [p = parameters.problem](const Point<2> &x, const double t) {
        const double s = x[1] - 1.2;
        Tensor<1, 2> v;
        v[0] = 4. * p.largest_inflow * s * (1. - s) * ramp(p, t);
        return v;
      });
    boundary.set_velocity({channel}, no_velocity());
    problem->watched = {5.5, 1.}; // the middle of the right wall
    problem->loaded  = {wall};
    return problem;
  }
} // namespace asperity
