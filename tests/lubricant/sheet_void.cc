#include <asperity/base/errors.h>
#include <asperity/lubricant/sheet_pockets.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

// Volumes between a patch and a sheet. Expected values are sums, lifts and
// finite differences.

namespace
{
  using namespace asperity;
  using dealii::Point;
  using Vector = dealii::Vector<double>;

  KnotVector
  knots(const unsigned int degree, const double length, const unsigned int n)
  {
    std::vector<double> breakpoints(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
      breakpoints[i] = length * i / n;
    return KnotVector(degree, breakpoints, true);
  }

  /** A block 4 x 3 x 1 whose top is bent, under an uneven sheet. */
  class VoidUnderSheet : public testing::Test
  {
  protected:
    VoidUnderSheet()
      : space(std::array<KnotVector, 3>{
          {knots(2, 4., 5), knots(2, 3., 4), KnotVector(2, {0., 0.5, 1.})}})
      , geometry(PatchGeometry<3>::from_map(
          space,
          [](const Point<3> &p) {
            return Point<3>(p[0],
                            p[1],
                            p[2] * (1. + 0.1 * std::cos(0.5 * M_PI * p[0]) *
                                           std::sin(2. * M_PI * p[1] / 3.)));
          }))
      , tool({{knots(3, 4., 7), knots(3, 3., 6)}}, heights())
      , u(3 * space.n_functions())
    {
      for (unsigned int i = 0; i < u.size(); ++i)
        u(i) = 0.05 * std::sin(1. + 7. * i) + (i % 3 == 0 ? 5.3 : -0.4);
      for (unsigned int e = 0; e < 20; ++e)
        thirds.push_back(e == 7 || e == 8 ? 1 : e % 5 < 2 ? 2 : 0);
    }

    static std::vector<double>
    heights()
    {
      std::vector<double> values;
      for (unsigned int i = 0; i < 42; ++i)
        values.push_back(2. + 0.2 * std::sin(1. + 5. * i));
      return values;
    }

    Vector
    direction(const double phase) const
    {
      Vector d(u.size());
      for (unsigned int i = 0; i < d.size(); ++i)
        d(i) = std::cos(phase + 3. * i);
      return d;
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

    SplineSpace<3>   space;
    PatchGeometry<3> geometry;
    SplineSheet      tool;
    Vector           u;

    /** An inner region, a stripe along y, and what goes around. */
    std::vector<unsigned int> thirds;
  };



  TEST_F(VoidUnderSheet, integral_of_the_tool_has_its_heights_as_derivative)
  {
    const SheetIntegral integral(tool);
    const double        h = 1e-5;
    for (const Point<2> &at :
         {Point<2>(0.3, 0.2), Point<2>(-1.7, 5.1), Point<2>(9.9, -0.6)})
      {
        const auto value = [&](const double dx, const double dy) {
          return integral.at(at + Point<2>(dx, dy));
        };
        EXPECT_NEAR((value(h, 0.).P - value(-h, 0.).P) / (2. * h),
                    tool.value(at),
                    1e-9);
        EXPECT_NEAR((value(0., h).P - value(0., -h).P) / (2. * h),
                    value(0., 0.).P_y,
                    1e-8);
        EXPECT_NEAR((value(0., h).P_y - value(0., -h).P_y) / (2. * h),
                    value(0., 0.).P_yy,
                    1e-8);
        EXPECT_NEAR(value(4., 0.).P - value(0., 0.).P,
                    integral.over_period(at[1]).P,
                    1e-12);
        EXPECT_NEAR(value(4., 0.).P_y - value(0., 0.).P_y,
                    integral.over_period(at[1]).P_y,
                    1e-12);
      }
  }



  TEST_F(VoidUnderSheet, a_lift_lowers_the_volume_by_its_area)
  {
    SheetVoid                       sheet_void(space, geometry, tool);
    const std::vector<unsigned int> all(20, 0);
    const double                    before = sheet_void.volumes(all, 1)[0];
    EXPECT_NEAR(before, 12. * (tool.mean() - 1.), 1e-3); // of the projection
    Vector lift(u.size());
    for (unsigned int a = 0; a < space.n_functions(); ++a)
      {
        lift(3 * a)     = 17.3; // sliding changes nothing
        lift(3 * a + 1) = -8.1;
        lift(3 * a + 2) = 0.1;
      }
    sheet_void.measure(lift);
    EXPECT_NEAR(sheet_void.volumes(all, 1)[0], before - 0.1 * 12., 1e-12);
    EXPECT_NEAR(sheet_void.gap(0),
                tool.value(Point<2>(17.3, -8.1)) - 1.1,
                1e-2);
  }



  // Edges are integrated by a rule that does not know the knots of the tool.
  TEST_F(VoidUnderSheet, regions_add_up_to_the_period)
  {
    SheetVoid sheet_void(space, geometry, tool);
    sheet_void.measure(u);
    const double all =
      sheet_void.volumes(std::vector<unsigned int>(20, 0), 1)[0];
    double sum = 0.;
    for (const double volume : sheet_void.volumes(thirds, 3))
      sum += volume;
    EXPECT_NEAR(sum, all, 5e-6 * all);
  }



  TEST_F(VoidUnderSheet, derivatives_are_those_of_finite_differences)
  {
    SheetVoid                      sheet_void(space, geometry, tool);
    dealii::DynamicSparsityPattern couplings(u.size());
    sheet_void.add_couplings(couplings);
    dealii::SparsityPattern pattern;
    pattern.copy_from(couplings);
    const Vector d1 = direction(0.), d2 = direction(2.);
    for (const auto &region : {std::vector<unsigned int>(20, 0), thirds})
      {
        const unsigned int  n = region == thirds ? 3 : 1;
        std::vector<double> factors(n, 0.);
        for (unsigned int of = 0; of < n; ++of)
          {
            const auto gradient = [&](const Vector &at) {
              sheet_void.measure(at);
              Vector g(u.size());
              sheet_void.add_gradient(region, of, 2., g);
              return g;
            };
            EXPECT_NEAR(difference(
                          [&](const Vector &at) {
                            sheet_void.measure(at);
                            return 2. * sheet_void.volumes(region, n)[of];
                          },
                          d1,
                          1e-5),
                        gradient(u) * d1,
                        1e-7);
            factors.assign(n, 0.);
            factors[of] = 2.;
            dealii::SparseMatrix<double> K(pattern);
            sheet_void.measure(u);
            sheet_void.add_hessian(region, factors, K);
            EXPECT_NEAR(
              difference([&](const Vector &at) { return gradient(at) * d2; },
                         d1,
                         1e-5),
              K.matrix_scalar_product(d2, d1),
              1e-6);
          }
      }
  }


  // The oil of a patch, whose tangent is that of the matrix and of a dense
  // part.

  class PocketsUnderSheet : public VoidUnderSheet,
                            public testing::WithParamInterface<DensityLaw>
  {
  protected:
    /** A unit vector at 30 degrees to x. */
    const dealii::Tensor<1, 3> motion{{std::sqrt(0.75), 0.5, 0.}};
  };

  TEST_P(PocketsUnderSheet, tangent_is_that_of_finite_differences)
  {
    SealedPocketOptions options;
    options.density.law           = GetParam();
    options.density.bulk_modulus  = 3.;
    options.density.ambient_ratio = 0.99; // warm oil
    options.penalty_modulus       = 10.;
    for (unsigned int i = 0; i < u.size(); ++i)
      u(i) = 0.2 * (u(i) + (i % 3 == 2 ? 0.6 : 0.));
    for (const double sealing_gap : {0., 1.02})
      {
        options.sealing_gap = sealing_gap;
        SheetPockets pockets(space, geometry, tool, motion, options);
        pockets.begin_step(u, 1, 0., 1.);
        dealii::DynamicSparsityPattern couplings(u.size());
        pockets.add_couplings(couplings);
        dealii::SparsityPattern sparsity;
        sparsity.copy_from(couplings);
        dealii::SparseMatrix<double> K(sparsity);
        Vector                       R(u.size());
        ASSERT_TRUE(pockets.add(u, R, &K));
        const LubricantState state = pockets.state();
        EXPECT_GT(state.max_pressure, 0.);
        EXPECT_EQ(state.n_pockets > 1, sealing_gap > 0.);
        const Vector d1 = direction(0.), d2 = direction(2.);
        double       tangent = K.matrix_scalar_product(d1, d2);
        for (const RankOneTerm &dense : pockets.rank_one_terms())
          tangent += dense.factor * (dense.vector * d1) * (dense.vector * d2);
        const auto residual = [&](const Vector &v) {
          Vector r(v.size());
          pockets.add(v, r, nullptr);
          return r * d1;
        };
        EXPECT_NEAR(difference(residual, d2, 1e-5),
                    tangent,
                    1e-5 * std::abs(tangent));

        // The forces are what holds the chip, per metre of the width.
        dealii::Tensor<1, 3> force;
        for (unsigned int i = 0; i < R.size(); ++i)
          force[i % 3] -= R(i) / 3.;
        const double small = 1e-12 * state.max_pressure;
        EXPECT_NEAR(state.pressure_force[0], force * motion, small);
        EXPECT_NEAR(state.pressure_force[1], force[2], small);
        EXPECT_NEAR(state.transverse,
                    motion[0] * force[1] - motion[1] * force[0],
                    small);
      }
  }

  INSTANTIATE_TEST_SUITE_P(,
                           PocketsUnderSheet,
                           testing::Values(DensityLaw::incompressible,
                                           DensityLaw::murnaghan,
                                           DensityLaw::dowson_higginson,
                                           DensityLaw::constant_modulus));



  /** A flat block 4 x 3 x 1 under a tool with a large and a small pit. */
  class BlockUnderPits : public VoidUnderSheet
  {
  protected:
    BlockUnderPits()
      : flat(PatchGeometry<3>::from_map(space,
                                        [](const Point<3> &p) { return p; }))
      , pits({{knots(1, 4., 10), knots(1, 3., 4)}}, depths())
    {
      options.density.law     = DensityLaw::incompressible;
      options.penalty_modulus = 100.;
      options.sealing_gap     = 0.1;
    }

    /** At the breakpoints: those of the block and, along x, the middles
     * between, since a bend inside of an edge is not integrated exactly. */
    static std::vector<double>
    depths()
    {
      std::vector<double> values(40, 1.05);
      for (const unsigned int i : {2, 3, 4})
        values[i + 10] = 1.5;
      values[8 + 10 * 3] = 1.3;
      return values;
    }

    Vector
    lift(const double distance) const
    {
      Vector lifted(u.size());
      for (unsigned int a = 0; a < space.n_functions(); ++a)
        lifted(3 * a + 2) = distance;
      return lifted;
    }

    PatchGeometry<3>     flat;
    SplineSheet          pits;
    SealedPocketOptions  options;
    dealii::Tensor<1, 3> along_x{{1., 0., 0.}};
  };

  TEST_F(BlockUnderPits, have_a_pressure_each)
  {
    SheetPockets pockets(space, flat, pits, along_x, options);
    Vector       R(u.size());
    const double distance = 0.01;
    ASSERT_EQ(pockets.state().n_pockets, 2u);
    ASSERT_TRUE(pockets.add(lift(distance), R, nullptr));
    // Elements by their pressure, and the mean depth of each by the trapezoidal
    // rule between the breakpoints of the tool.
    std::map<double, double> areas, volumes;
    for (unsigned int e = 0; e < 20; ++e)
      {
        const Point<2> begin(0.8 * (e % 5), 0.75 * (e / 5));
        const double   p = pockets.pressure(begin + Point<2>(0.4, 0.375));
        areas[p] += 0.6;
        for (unsigned int k = 0; k < 9; ++k)
          volumes[p] +=
            0.6 / 16. * (k % 3 == 1 ? 2. : 1.) * (k / 3 == 1 ? 2. : 1.) *
            (pits.value(begin + Point<2>(0.4 * (k % 3), 0.375 * (k / 3))) - 1.);
        EXPECT_NEAR(pockets.coverage(begin), 1., 1e-12);
      }
    ASSERT_EQ(areas.size(), 2u);
    double force = 0.;
    for (const auto &[p, area] : areas)
      {
        EXPECT_NEAR(p, 100. * distance * area / volumes[p], 1e-10) << area;
        force -= p * area / 3.;
      }
    EXPECT_NEAR(pockets.state().pressure_force[1], force, 1e-12);
    EXPECT_EQ(pockets.state().max_pressure, areas.rbegin()->first);
  }

  TEST_F(BlockUnderPits, tell_when_they_go_through_the_period)
  {
    SheetPockets pockets(space, flat, pits, along_x, options);
    const auto   step = [&](const unsigned int number, const double distance) {
      Vector R(u.size());
      pockets.begin_step(lift(distance), number, 0., 1.);
      ASSERT_TRUE(pockets.add(lift(distance), R, nullptr));
      pockets.accept(lift(distance));
    };
    step(1, 0.);
    EXPECT_TRUE(pockets.events().empty());
    step(2, -0.1);
    const std::vector<std::string> expected = {
      "step 2: pocket B has become part of A",
      "step 2: pocket A goes through the period along x",
      "step 2: pocket A goes through the period along y"};
    EXPECT_EQ(pockets.events(), expected);
    step(3, 0.);
    ASSERT_EQ(pockets.events().size(), 6u);
    EXPECT_EQ(pockets.events()[4],
              "step 3: pocket A no longer goes through the period along x");
  }

  TEST_F(BlockUnderPits, need_a_pocket_for_a_film_of_oil)
  {
    options.sealing_gap = 1.;
    options.oil_film    = 0.1;
    EXPECT_THROW(SheetPockets(space, flat, pits, along_x, options), InputError);
  }
} // namespace
