#include <asperity/base/errors.h>
#include <asperity/splines/refinement.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace asperity;
using dealii::Point;
using dealii::Tensor;

namespace
{
  SplineCurve
  test_curve(const unsigned int degree,
             const bool         rational,
             const bool         periodic)
  {
    const KnotVector      knots(degree,
                           {0., 0.2, 0.3, 0.7, 1.1, 1.2, 1.9, 2.4, 2.6, 3.},
                           periodic);
    std::vector<Point<2>> points;
    std::vector<double>   weights;
    for (unsigned int i = 0; i < knots.n_basis(); ++i)
      {
        points.emplace_back(i + 0.3 * std::sin(9. * i), std::cos(5. * i));
        if (rational)
          weights.push_back(1. + 0.7 * std::sin(2. * i));
      }
    Tensor<1, 2> period;
    if (periodic)
      period = Point<2>(9., 0.5);
    return SplineCurve(knots, points, weights, period);
  }



  double
  largest_difference(const SplineCurve &a, const SplineCurve &b)
  {
    double largest = 0.;
    for (double t = 0.; t < 3.; t += 0.0173)
      largest = std::max(largest, (a.value(t) - b.value(t)).norm());
    return largest;
  }
} // namespace



TEST(Refinement, knot_insertion_leaves_the_curve_unchanged)
{
  for (unsigned int degree = 1; degree <= 8; ++degree)
    for (const bool rational : {false, true})
      {
        const SplineCurve   open  = test_curve(degree, rational, false);
        std::vector<double> knots = {1.5, 0.1, 0.25, 2.99};
        for (unsigned int i = 1; i < degree; ++i)
          knots.push_back(1.2); // up to the full multiplicity
        const SplineCurve fine = insert_knots(open, knots);
        EXPECT_EQ(fine.control_points().size(),
                  open.control_points().size() + knots.size());
        EXPECT_LT(largest_difference(open, fine), 1e-13);

        const SplineCurve periodic = test_curve(degree, rational, true);
        const SplineCurve turns =
          insert_knots(periodic, {0.1, 2.99, 2.7, 0.01, 1.});
        EXPECT_EQ(turns.knot_vector().n_spans(), 14u);
        EXPECT_LT(largest_difference(periodic, turns), 1e-13);
        EXPECT_LT((turns.value(31.4) - periodic.value(31.4)).norm(), 1e-12);
      }
}



TEST(Refinement, degree_elevation_leaves_the_curve_unchanged)
{
  for (unsigned int degree = 1; degree <= 7; ++degree)
    for (const bool rational : {false, true})
      {
        const SplineCurve curve = test_curve(degree, rational, false);
        SplineCurve       high  = elevate_degree(curve);
        EXPECT_EQ(high.degree(), degree + 1);
        EXPECT_LT(largest_difference(curve, high), 1e-13);
        high = elevate_degree(elevate_degree(insert_knots(high, {0.5})));
        EXPECT_EQ(high.degree(), degree + 3);
        EXPECT_LT(largest_difference(curve, high), 1e-13);
      }
}



TEST(Refinement, a_clamped_turn_of_a_periodic_curve_is_the_same)
{
  for (unsigned int degree = 1; degree <= 7; ++degree)
    {
      const SplineCurve periodic = test_curve(degree, degree % 2, true);
      const SplineCurve open     = clamp(periodic);
      EXPECT_FALSE(open.is_periodic());
      EXPECT_LT(largest_difference(periodic, open), 1e-13);
      EXPECT_LT((open.control_points()[0] - periodic.value(0.)).norm(), 1e-13);
      EXPECT_LT(largest_difference(periodic, elevate_degree(open)), 1e-13);
    }
}



// New control points are averages of old ones, so the hull never grows.
TEST(Refinement, transfer_factors_are_convex)
{
  const KnotVector knots = test_curve(4, false, false).knot_vector();
  for (const BasisTransfer &transfer :
       {knot_insertion(knots, {0.1, 0.2, 2.5}), degree_elevation(knots)})
    for (const auto &row : transfer.rows)
      {
        double sum = 0.;
        for (const auto &term : row)
          {
            EXPECT_GE(term.factor, 0.);
            sum += term.factor;
          }
        EXPECT_NEAR(sum, 1., 1e-14);
      }
}



TEST(Refinement, knots_that_cannot_be_inserted_are_refused)
{
  const SplineCurve open     = test_curve(2, false, false);
  const SplineCurve periodic = test_curve(2, false, true);
  EXPECT_THROW(insert_knots(open, {0.}), InputError);
  EXPECT_THROW(insert_knots(open, {3.5}), InputError);
  EXPECT_THROW(insert_knots(open, {0.2, 0.2}), InputError);
  EXPECT_THROW(insert_knots(periodic, {0.2}), InputError);
  EXPECT_THROW(elevate_degree(periodic), InputError);
}
