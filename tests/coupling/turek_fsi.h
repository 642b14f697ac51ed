#ifndef asperity_tests_coupling_turek_fsi_h
#define asperity_tests_coupling_turek_fsi_h

#include <asperity/constitutive/hyperelasticity.h>
#include <asperity/coupling/fluid_structure.h>
#include <asperity/flow/channel_meshes.h>

#include <cmath>
#include <memory>
#include <vector>

/**
 * The elastic flag behind a cylinder in a channel; S. Turek, J. Hron, Proposal
 * for numerical benchmarking of fluid-structure interaction (2006).
 */
namespace turek_fsi
{
  using namespace asperity;
  using dealii::Point;
  using dealii::Tensor;

  struct Case
  {
    double inflow;        ///< mean velocity [m/s]
    double shear_modulus; ///< of the flag [Pa]
    double flag_density;  ///< [kg/m^3]
    double frequency;     ///< of the swinging flag; 0: steady [1/s]
  };

  constexpr Case fsi1{0.2, 0.5e6, 1e3, 0.};
  constexpr Case fsi2{1., 0.5e6, 1e4, 1.93};
  constexpr Case fsi3{2., 2e6, 1e3, 5.46};

  struct Discretization
  {
    unsigned int refinements   = 0; ///< of the fluid's coarse mesh
    unsigned int wall_layers   = 0;
    unsigned int corner_layers = 0;
    unsigned int fluid_degree  = 2; ///< of velocity and geometry
    unsigned int degree        = 3; ///< of the flag's splines
    unsigned int spans_x       = 16;
    unsigned int spans_y       = 2;
  };

  /** The last span is four times as long as the first, at the cylinder. */
  inline std::vector<double>
  graded_spans(const unsigned int n)
  {
    std::vector<double> t(1, 0.);
    for (unsigned int i = 0; i < n; ++i)
      t.push_back(t.back() + std::pow(4., n > 1 ? i / (n - 1.) : 0.));
    for (double &x : t)
      x /= t.back();
    return t;
  }

  inline SplineBody
  make_flag(const Case &data, const Discretization &discretization)
  {
    std::vector<double> across(1, 0.);
    for (unsigned int i = 1; i <= discretization.spans_y; ++i)
      across.push_back(double(i) / discretization.spans_y);
    SplineBody body;
    const auto space = std::make_shared<SplineSpace>(
      KnotVector(discretization.degree, graded_spans(discretization.spans_x)),
      KnotVector(discretization.degree, across));
    body.space    = space;
    body.geometry = PatchGeometry::from_map(*space, [](const Point<2> &xi) {
      const double y   = 0.19 + 0.02 * xi[1];
      const double arc = 0.2 + std::sqrt(0.05 * 0.05 - (y - 0.2) * (y - 0.2));
      return Point<2>(arc + xi[0] * (0.6 - arc), y);
    });
    ElasticParameters elasticity;
    elasticity.density       = data.flag_density;
    elasticity.poisson_ratio = 0.4;
    elasticity.young_modulus = 2. * 1.4 * data.shear_modulus;
    body.law                 = std::make_shared<StVenantKirchhoff>(elasticity);
    body.clamped             = {Edge::left};
    body.wet                 = {Edge::bottom, Edge::right, Edge::top};
    return body;
  }

  inline FluidStructureOptions
  default_options(const Case &data)
  {
    FluidStructureOptions options;
    options.fluid.model.density             = 1e3;
    options.fluid.model.viscosity.viscosity = 1.;
    options.solid.load_floor                = 1.;
    if (data.frequency == 0.)
      {
        // Without rates a wall has no velocity that Robin's condition could
        // give way to.
        options.fluid.scheme              = FluidTimeScheme::steady;
        options.solid.dynamic             = false;
        options.coupling.scheme           = CouplingScheme::dirichlet_neumann;
        options.coupling.predictor_degree = 0;
      }
    else
      {
        options.fluid.scheme              = FluidTimeScheme::bdf2;
        options.coupling.tolerance        = 1e-5;
        options.coupling.predictor_degree = 2;
      }
    return options;
  }

  class TurekFsi
  {
  public:
    TurekFsi(const Case           &data,
             const Discretization &discretization,
             FluidStructureOptions options)
    {
      options.fluid.degree = options.fluid.geometry_degree =
        discretization.fluid_degree;
      make_channel_with_flag(mesh,
                             discretization.refinements,
                             discretization.wall_layers,
                             discretization.corner_layers);
      problem = std::make_unique<FluidStructure>(
        mesh,
        BoundaryIds{flag_bottom, flag_tip, flag_top},
        make_flag(data, discretization),
        options);
      const double U         = data.inflow;
      const bool   is_steady = data.frequency == 0.;
      const auto   inflow = [U, is_steady](const Point<2> &x, const double t) {
        const double ramp =
          is_steady || t >= 2. ? 1. : 0.5 * (1. - std::cos(M_PI * t / 2.));
        Tensor<1, 2> v;
        v[0] = 1.5 * U * ramp * x[1] * (0.41 - x[1]) / (0.205 * 0.205);
        return v;
      };
      const auto rest = [](const Point<2> &, const double) {
        return Tensor<1, 2>();
      };
      auto &boundary = problem->flow().boundary();
      boundary.set_velocity({channel_inlet}, inflow);
      boundary.set_velocity({channel_walls, channel_cylinder}, rest);
    }

    /** Displacement of the point A [m]. */
    Tensor<1, 2>
    tip() const
    {
      return problem->displacement({1., 0.5});
    }

    /** On cylinder and flag [N/m]. */
    Tensor<1, 2>
    drag_and_lift() const
    {
      return problem->flow().total_wall_force(
        {channel_cylinder, flag_bottom, flag_tip, flag_top});
    }

    dealii::Triangulation<2>        mesh;
    std::unique_ptr<FluidStructure> problem;
  };
} // namespace turek_fsi

#endif
