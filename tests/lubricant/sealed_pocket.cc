#include <asperity/lubricant/sealed_pocket.h>
#include <asperity/splines/spline_fit.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace asperity;
  using Vector = dealii::Vector<double>;

  /** A block 4 x 1 with a wavy top under a wavy tool, and a displacement that
   *  bends its top. */
  class VoidBetweenWaves : public testing::Test
  {
  protected:
    VoidBetweenWaves()
      : space(KnotVector(2, {0., 0.4, 1., 1.5, 2., 2.7, 3.2, 4.}, true),
              KnotVector(2, {0., 0.5, 1.}))
      , geometry(PatchGeometry<2>::from_map(
          space,
          [](const dealii::Point<2> &p) {
            return dealii::Point<2>(p[0] + 0.1 * std::sin(M_PI * p[0]),
                                    p[1] *
                                      (1. + 0.1 * std::cos(0.5 * M_PI * p[0])));
          }))
      , tool(interpolate_periodic_function(
          [](const double x) { return 1.5 + 0.2 * std::sin(M_PI * x); },
          0.,
          4.,
          16,
          3))
      , u(2 * space.n_functions())
    {
      for (unsigned int i = 0; i < u.size(); ++i)
        u(i) = 0.05 * std::sin(1. + 7. * i) + (i % 2 == 0 ? 1.3 : 0.);
    }

    /** Central difference of a function of u along d. */
    template <typename Function>
    double
    difference(const Function &f, const Vector &d, const double step) const
    {
      Vector plus = u, minus = u;
      plus.add(step, d);
      minus.add(-step, d);
      return (f(plus) - f(minus)) / (2. * step);
    }

    Vector
    direction(const double phase) const
    {
      Vector d(u.size());
      for (unsigned int i = 0; i < d.size(); ++i)
        d(i) = std::cos(phase + 3. * i);
      return d;
    }

    dealii::SparsityPattern
    pattern(const VoidVolume &void_volume) const
    {
      dealii::DynamicSparsityPattern couplings(u.size());
      void_volume.add_couplings(couplings);
      dealii::SparsityPattern result;
      result.copy_from(couplings);
      return result;
    }

    SplineSpace<2>   space;
    PatchGeometry<2> geometry;
    SplineCurve      tool;
    Vector           u;
  };

  TEST_F(VoidBetweenWaves, stretches_add_up_to_the_period)
  {
    VoidVolume void_volume(space, geometry, tool);
    void_volume.measure(u);
    const double all = void_volume.volume(void_volume.period());
    EXPECT_NEAR(void_volume.volume({0, 3}) + void_volume.volume({3, 4}),
                all,
                1e-13);
    EXPECT_NEAR(void_volume.volume({5, 4}) + void_volume.volume({2, 3}),
                all,
                1e-13);
  }

  TEST_F(VoidBetweenWaves, a_lift_lowers_the_volume_by_its_area)
  {
    VoidVolume   void_volume(space, geometry, tool);
    const double before = void_volume.volume(void_volume.period());
    Vector       lift(u.size());
    for (unsigned int a = 0; a < space.n_functions(); ++a)
      {
        lift(2 * a)     = 17.3; // sliding changes nothing
        lift(2 * a + 1) = 0.1;
      }
    void_volume.measure(lift);
    EXPECT_NEAR(void_volume.volume(void_volume.period()),
                before - 0.1 * 4.,
                1e-12);
  }

  TEST_F(VoidBetweenWaves, derivatives_are_those_of_finite_differences)
  {
    VoidVolume   void_volume(space, geometry, tool);
    const auto   sparsity = pattern(void_volume);
    const Vector d1 = direction(0.), d2 = direction(2.);
    const std::vector<VoidVolume::Stretch> stretches = {void_volume.period(),
                                                        {1, 3},
                                                        {5, 4}};
    for (const auto &stretch : stretches)
      {
        void_volume.measure(u);
        Vector g(u.size());
        void_volume.add_gradient(stretch, 1., g);
        dealii::SparseMatrix<double> H(sparsity);
        void_volume.add_hessian(stretch, 1., H);
        const auto volume = [&](const Vector &v) {
          void_volume.measure(v);
          return void_volume.volume(stretch);
        };
        EXPECT_NEAR(difference(volume, d1, 1e-4), g * d1, 1e-7);
        const auto slope = [&](const Vector &v) {
          void_volume.measure(v);
          Vector gradient(v.size());
          void_volume.add_gradient(stretch, 1., gradient);
          return gradient * d1;
        };
        EXPECT_NEAR(difference(slope, d2, 1e-4),
                    H.matrix_scalar_product(d1, d2),
                    1e-6);
        EXPECT_NEAR(H.matrix_scalar_product(d2, d1),
                    H.matrix_scalar_product(d1, d2),
                    1e-12);
      }
  }

  class PocketLaw : public VoidBetweenWaves,
                    public testing::WithParamInterface<DensityLaw>
  {};

  TEST_P(PocketLaw, tangent_is_that_of_finite_differences)
  {
    SealedPocketOptions options;
    options.density.law           = GetParam();
    options.density.bulk_modulus  = 3.;
    options.density.ambient_ratio = 0.99; // warm oil
    options.penalty_modulus       = 10.;
    options.wetting               = 1.;
    // A lift compresses the oil; Dowson-Higginson counts in Pa.
    Vector lifted(u.size());
    for (unsigned int a = 0; a < space.n_functions(); ++a)
      lifted(2 * a + 1) = 0.03;
    u.sadd(0.2, lifted);

    SealedPocket                   pocket(space, geometry, tool, options);
    dealii::DynamicSparsityPattern couplings(u.size());
    pocket.add_couplings(couplings);
    dealii::SparsityPattern sparsity;
    sparsity.copy_from(couplings);
    dealii::SparseMatrix<double> K(sparsity);
    Vector                       R(u.size());
    ASSERT_TRUE(pocket.add(u, R, &K));
    const LubricantState state = pocket.state();
    EXPECT_GT(state.mean_pressure, 0.);
    EXPECT_NEAR(state.pressure_force[0], 0., 1e-12 * state.mean_pressure);
    EXPECT_NEAR(state.mean_pressure,
                state.max_pressure,
                1e-12 * state.max_pressure);

    const Vector d1 = direction(0.), d2 = direction(2.);
    double       tangent = K.matrix_scalar_product(d1, d2);
    for (const RankOneTerm &dense : pocket.rank_one_terms())
      tangent += dense.factor * (dense.vector * d1) * (dense.vector * d2);
    const auto residual = [&](const Vector &v) {
      Vector r(v.size());
      pocket.add(v, r, nullptr);
      return r * d1;
    };
    EXPECT_NEAR(difference(residual, d2, 1e-5),
                tangent,
                1e-5 * std::abs(tangent));
  }

  INSTANTIATE_TEST_SUITE_P(,
                           PocketLaw,
                           testing::Values(DensityLaw::incompressible,
                                           DensityLaw::murnaghan,
                                           DensityLaw::dowson_higginson,
                                           DensityLaw::constant_modulus));

  TEST_F(VoidBetweenWaves, oil_with_room_to_spare_carries_nothing)
  {
    SealedPocketOptions options;
    options.wetting = 0.5;
    SealedPocket pocket(space, geometry, tool, options);
    Vector       R(u.size());
    ASSERT_TRUE(pocket.add(Vector(u.size()), R, nullptr));
    EXPECT_EQ(R.l2_norm(), 0.);
    EXPECT_TRUE(pocket.rank_one_terms().empty());
    const LubricantState state = pocket.state();
    EXPECT_EQ(state.max_pressure, 0.);
    EXPECT_NEAR(state.reference_volume, 0.5 * state.void_volume, 1e-14);
    for (const double parameter : {0., 1.3, 3.9})
      EXPECT_NEAR(pocket.coverage({parameter, 0.}), 0.5, 1e-14);
  }

  TEST_F(VoidBetweenWaves, oil_that_warms_up_in_a_full_void_is_compressed)
  {
    SealedPocketOptions options;
    SealedPocket        pocket(space, geometry, tool, options);
    Vector              R(u.size());
    const double        mass = pocket.state().reference_volume;
    LubricantParameters oil;
    oil.compressibility.ambient_ratio = 0.96;
    pocket.set_oil(oil);
    ASSERT_TRUE(pocket.add(Vector(u.size()), R, nullptr));
    // Murnaghan: K_0/K' ((1/0.96)^K' - 1)
    EXPECT_NEAR(pocket.state().max_pressure,
                1.6e8 * (std::pow(1. / 0.96, 10.) - 1.),
                1.);
    EXPECT_EQ(pocket.state().reference_volume, mass);
    EXPECT_NEAR(pocket.state().oil_volume, pocket.state().void_volume, 1e-12);
    EXPECT_NEAR(pocket.coverage({2., 0.}), 1., 1e-12);
  }

  TEST_F(VoidBetweenWaves, a_void_that_is_gone_gives_no_residual)
  {
    SealedPocket pocket(space, geometry, tool, {});
    Vector       lift(u.size()), R(u.size());
    for (unsigned int a = 0; a < space.n_functions(); ++a)
      lift(2 * a + 1) = 1.;
    EXPECT_FALSE(pocket.add(lift, R, nullptr));
  }
} // namespace
