#include <asperity/constitutive/hyperelasticity.h>
#include <asperity/contact/contact_assembler.h>
#include <asperity/contact/curve_obstacle.h>
#include <asperity/contact_zone/scene.h>
#include <asperity/lubricant/sealed_pocket.h>
#include <asperity/splines/spline_fit.h>

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
  using namespace asperity;
  using Vector = dealii::Vector<double>;

  constexpr double amplitude = 2e-4, E = 1., nu = 0.3;

  /** p* = pi E* h/lambda, the mean pressure that flattens the wave. */
  const double full_pressure = M_PI * E / (1. - nu * nu) * amplitude;

  /** Mean gap over 2 h at a half-width a, H. M. Westergaard (1939). */
  double
  mean_gap(const double a)
  {
    const double s = std::sin(M_PI * a), c = std::cos(M_PI * a);
    return 0.5 * c * c + s * s * std::log(s);
  }

  /**
   * A sine wave, rigid, of wavelength 1 on a floating elastic block; oil fills
   * what the void holds at the half-width 0.1, where the exact solution
   * superposes its pressure on Westergaard's:
   *
   *   P = p_f + p* sin^2(pi a),  ln(V(a) / V(0.1)) = - p_f / K.
   */
  class TrappedPocket
  {
  public:
    explicit TrappedPocket(const double modulus)
      : space(std::make_shared<SplineSpace<2>>(
          KnotVector(2, columns(), true),
          KnotVector(2, graded_rows(1., 1. / n_columns, 1.5))))
      , tool(interpolate_periodic_function(
          [](const double x) {
            return 1. + amplitude * (1. - std::cos(2. * M_PI * x));
          },
          0.,
          1.,
          96,
          3))
      , solid(space, {}, neo_hooke())
      , u(2 * space->n_functions())
    {
      ContactOptions options;
      options.penalty = 100. * E * n_columns;
      contact         = std::make_unique<ContactAssembler<2>>(
        space,
        PatchGeometry<2>(),
        Edge::top,
        std::make_shared<CurveObstacle>(tool, CurveSide::right),
        options);
      SealedPocketOptions pocket_options;
      pocket_options.density.law          = DensityLaw::constant_modulus;
      pocket_options.density.bulk_modulus = modulus;
      // Touching at the start the mean gap is half of 2 h.
      pocket_options.wetting = mean_gap(0.1) / 0.5;
      oil                    = std::make_unique<SealedPocket>(*space,
                                           PatchGeometry<2>(),
                                           tool,
                                           pocket_options);

      dealii::AffineConstraints<double> constraints;
      for (const unsigned int a : space->edge_functions(Edge::bottom))
        constraints.add_line(displacement_dof<2>(a, 0));
      constraints.close();
      equilibrium = std::make_unique<Equilibrium>(
        u.size(),
        std::vector<ForceTerm *>{&solid, contact.get(), oil.get()},
        constraints,
        LinearSolverKind::cholmod);
      equilibrium->set_support(2 * space->edge_functions(Edge::bottom)[0] + 1);
      bottom = tabulate_edge(*space,
                             PatchGeometry<2>(),
                             Edge::bottom,
                             dealii::QGauss<1>(3));
      // In touch, so that the contact can carry the first load.
      for (unsigned int a = 0; a < space->n_functions(); ++a)
        u(2 * a + 1) = 1e-3 * amplitude;
    }

    /** Presses with the mean pressure P. */
    ConvergenceReport
    press(const double P)
    {
      Vector load(u.size());
      for (const auto &element : bottom.elements)
        for (unsigned int q = 0; q < bottom.points_per_element; ++q)
          for (unsigned int a = 0; a < element.functions.size(); ++a)
            load(2 * element.functions[a] + 1) +=
              P * bottom.JxW[element.first_point + q] *
              element.values[q * element.functions.size() + a];
      equilibrium->set_load(load);
      NewtonOptions options;
      options.tolerance          = 1e-8 * full_pressure;
      options.maximum_iterations = 60;
      options.line_search_trials = 30;
      NewtonStatistics statistics;
      return newton(*equilibrium, u, options, statistics);
    }

    /** <sin^2> = sin^2(pi a)/4 of Westergaard's pressure: the half-width
     *  without the grid. */
    double
    half_width() const
    {
      double               sum = 0., moment = 0.;
      const BasisTable<2> &table = contact->table();
      for (std::size_t q = 0; q < table.JxW.size(); ++q)
        {
          const double force = contact->pressure()[q] * table.JxW[q];
          const double s     = std::sin(M_PI * table.position[q][0]);
          sum += force;
          moment += force * s * s;
        }
      return std::asin(2. * std::sqrt(moment / sum)) / M_PI;
    }

    std::unique_ptr<SealedPocket> oil;

  private:
    static constexpr unsigned int n_columns = 128;

    static std::vector<double>
    columns()
    {
      std::vector<double> x(n_columns + 1);
      for (unsigned int i = 0; i <= n_columns; ++i)
        x[i] = static_cast<double>(i) / n_columns;
      return x;
    }

    static std::shared_ptr<const MaterialLaw>
    neo_hooke()
    {
      ElasticParameters elasticity;
      elasticity.young_modulus = E;
      elasticity.poisson_ratio = nu;
      return std::make_shared<NeoHooke>(elasticity);
    }

    std::shared_ptr<SplineSpace<2>>      space;
    SplineCurve                          tool;
    SolidAssembler<2>                    solid;
    std::unique_ptr<ContactAssembler<2>> contact;
    std::unique_ptr<Equilibrium>         equilibrium;
    BasisTable<2>                        bottom;
    Vector                               u;
  };

  /** The exact solution: a and p_f/p* at P/p* = 0.2, 0.5, 1, 2. */
  struct TrappedPocketCase
  {
    double modulus; ///< K/p*
    double half_width[4], pressure[4];
  };

  class TrappedPocketTable : public testing::TestWithParam<TrappedPocketCase>
  {};

  TEST_P(TrappedPocketTable, follows_the_superposed_solution)
  {
    const TrappedPocketCase &exact = GetParam();
    TrappedPocket            pocket(exact.modulus * full_pressure);
    for (const double P : {0.02, 0.05, 0.1})
      ASSERT_TRUE(pocket.press(P * full_pressure).converged) << P;
    unsigned int i = 0;
    for (const double P : {0.2, 0.5, 1., 2.})
      {
        const ConvergenceReport report = pocket.press(P * full_pressure);
        ASSERT_TRUE(report.converged) << P << ": " << report.reason;
        EXPECT_NEAR(pocket.half_width(),
                    exact.half_width[i],
                    0.01 * exact.half_width[i])
          << P;
        EXPECT_NEAR(pocket.oil->state().mean_pressure / full_pressure,
                    exact.pressure[i],
                    0.01 * exact.pressure[i])
          << P;
        ++i;
      }
  }

  INSTANTIATE_TEST_SUITE_P(
    ,
    TrappedPocketTable,
    testing::Values(TrappedPocketCase{0.2,
                                      {.13003, .19655, .28253, .41003},
                                      {.04220, .16479, .39851, 1.07778}},
                    TrappedPocketCase{1.,
                                      {.11218, .14273, .18473, .25062},
                                      {.08086, .31206, .69934, 1.49805}},
                    TrappedPocketCase{2.,
                                      {.10699, .12545, .15240, .19723},
                                      {.09122, .35255, .78775, 1.66277}},
                    TrappedPocketCase{10.,
                                      {.10158, .10604, .11319, .12661},
                                      {.10156, .39306, .87879, 1.84995}}),
    [](const auto &info) {
      return "ModulusOver" +
             std::to_string(static_cast<int>(10. * info.param.modulus + 0.5)) +
             "TenthsOfFullPressure";
    });
} // namespace
