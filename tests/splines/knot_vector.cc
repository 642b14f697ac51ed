#include <asperity/base/errors.h>
#include <asperity/splines/bezier_extraction.h>
#include <asperity/splines/knot_vector.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace asperity;

namespace
{
  /** Open, periodic and with repeated knots, those of finite elements among
   *  them; uneven spans. */
  std::vector<KnotVector>
  knot_vectors(const unsigned int p)
  {
    std::vector<double> breakpoints = {-1.};
    for (unsigned int i = 0; i < p + 4; ++i)
      breakpoints.push_back(breakpoints.back() + 0.3 + 0.25 * std::sin(7. * i));
    std::vector<double> repeated(p + 1, 0.);
    repeated.push_back(0.5);
    for (unsigned int i = 0; i < p; ++i)
      repeated.push_back(1.25);
    repeated.push_back(1.5);
    repeated.insert(repeated.end(), p + 1, 2.);
    return {KnotVector(p, breakpoints),
            KnotVector(p, breakpoints, true),
            KnotVector(p, {0., 1.}),
            KnotVector(p, breakpoints, false, p),
            KnotVector(p, breakpoints, true, p),
            KnotVector(p, breakpoints, true, (p + 1) / 2),
            KnotVector::from_knots(p, repeated)};
  }



  double
  bernstein(const unsigned int p, const unsigned int b, const double x)
  {
    return std::exp(std::lgamma(p + 1.) - std::lgamma(b + 1.) -
                    std::lgamma(p - b + 1.)) *
           std::pow(x, b) * std::pow(1. - x, p - b);
  }



  double
  point_in(const KnotVector &knots, const unsigned int span, const double x)
  {
    return (1. - x) * knots.breakpoints()[span] +
           x * knots.breakpoints()[span + 1];
  }
} // namespace



TEST(KnotVector, partition_of_unity_and_its_derivatives_vanish)
{
  for (unsigned int p = 1; p <= 10; ++p)
    for (const KnotVector &knots : knot_vectors(p))
      for (unsigned int span = 0; span < knots.n_spans(); ++span)
        for (const double x : {0., 0.3, 1.})
          {
            const auto N =
              knots.evaluate(span, point_in(knots, span, x), p + 1);
            for (unsigned int k = 0; k <= p + 1; ++k)
              {
                double sum = 0., scale = 1.;
                for (const double value : N[k])
                  {
                    sum += value;
                    scale = std::max(scale, std::abs(value));
                  }
                EXPECT_NEAR(sum, k == 0 ? 1. : 0., 1e-13 * scale);
              }
          }
}



TEST(KnotVector, derivatives_equal_finite_differences)
{
  const double h = 1e-4;
  for (unsigned int p = 1; p <= 6; ++p)
    for (const KnotVector &knots : knot_vectors(p))
      for (unsigned int span = 0; span < knots.n_spans(); ++span)
        {
          const double t     = point_in(knots, span, 0.4);
          const auto   N     = knots.evaluate(span, t, p);
          const auto   left  = knots.evaluate(span, t - h, p);
          const auto   right = knots.evaluate(span, t + h, p);
          for (unsigned int k = 0; k < p; ++k)
            for (unsigned int j = 0; j <= p; ++j)
              {
                double scale = 1.;
                for (const double value : N[std::min(p, k + 3)])
                  scale = std::max(scale, std::abs(value));
                EXPECT_NEAR((right[k][j] - left[k][j]) / (2. * h),
                            N[k + 1][j],
                            // the neglected term is h^2/6 times the third one
                            h * h * scale + 1e-9 * std::abs(N[k][j] / h));
              }
        }
}



TEST(KnotVector, greville_abscissae_reproduce_the_identity)
{
  for (unsigned int p = 1; p <= 10; ++p)
    for (const KnotVector &knots : knot_vectors(p))
      {
        const std::vector<double> greville = knots.greville();
        const double              period   = knots.back() - knots.front();
        for (unsigned int span = 0; span < knots.n_spans(); ++span)
          {
            const double t         = point_in(knots, span, 0.7);
            const auto   N         = knots.evaluate(span, t, 1);
            const auto   functions = knots.span_functions(span);
            double       value = 0., slope = 0.;
            for (unsigned int j = 0; j <= p; ++j)
              {
                const bool   turned = knots.is_wrapped(span, j);
                const double control =
                  greville[functions[j]] + (turned ? period : 0.);
                value += N[0][j] * control;
                slope += N[1][j] * control;
              }
            EXPECT_NEAR(value, t, 1e-13);
            EXPECT_NEAR(slope, 1., 1e-11);
          }
      }
}



TEST(KnotVector, spans_are_found_wrapped_and_clamped)
{
  const KnotVector open(2, {0., 1., 3., 4.});
  EXPECT_EQ(open.find_span(-1.), 0u);
  EXPECT_EQ(open.find_span(0.), 0u);
  EXPECT_EQ(open.find_span(1.), 1u);
  EXPECT_EQ(open.find_span(4.), 2u);
  EXPECT_EQ(open.find_span(5.), 2u);
  EXPECT_EQ(open.n_basis(), 5u);

  const KnotVector periodic(2, {0., 1., 3., 4.}, true);
  EXPECT_EQ(periodic.n_basis(), 3u);
  EXPECT_EQ(periodic.find_span(4.), 0u);
  EXPECT_EQ(periodic.find_span(-0.5), 2u);
  EXPECT_EQ(periodic.find_span(-1e-18), 0u);
  EXPECT_DOUBLE_EQ(periodic.wrap(-7.5), 0.5);
  EXPECT_DOUBLE_EQ(periodic.wrap(4.), 0.);
  EXPECT_EQ(periodic.span_functions(2), (std::vector<unsigned int>{2, 0, 1}));
}



TEST(KnotVector, periodic_functions_are_smooth_across_the_period)
{
  for (unsigned int p = 1; p <= 6; ++p)
    {
      const KnotVector knots = knot_vectors(p)[1];
      const auto       last =
        knots.evaluate(knots.n_spans() - 1, knots.back(), p - 1);
      const auto first   = knots.evaluate(0, knots.front(), p - 1);
      const auto i_last  = knots.span_functions(knots.n_spans() - 1);
      const auto i_first = knots.span_functions(0);
      for (unsigned int k = 0; k < p; ++k)
        {
          std::vector<double> jump(knots.n_basis());
          double              scale = 1.;
          for (unsigned int j = 0; j <= p; ++j)
            {
              jump[i_last[j]] += last[k][j];
              jump[i_first[j]] -= first[k][j];
              scale = std::max(scale, std::abs(last[k][j]));
            }
          for (const double value : jump)
            EXPECT_NEAR(value, 0., 1e-12 * scale);
        }
    }
}



TEST(BezierExtraction, bernstein_times_operator_is_the_spline)
{
  for (unsigned int p = 1; p <= 10; ++p)
    for (const KnotVector &knots : knot_vectors(p))
      {
        const auto C = bezier_extraction(knots);
        ASSERT_EQ(C.size(), knots.n_spans());
        for (unsigned int span = 0; span < knots.n_spans(); ++span)
          for (const double x : {0., 0.2, 0.55, 1.})
            {
              const auto N = knots.evaluate(span, point_in(knots, span, x));
              for (unsigned int a = 0; a <= p; ++a)
                {
                  double value = 0.;
                  for (unsigned int b = 0; b <= p; ++b)
                    value += C[span](a, b) * bernstein(p, b, x);
                  EXPECT_NEAR(value, N[0][a], 2e-14);
                }
            }
      }
}



TEST(BezierExtraction, coarse_functions_are_sums_of_fine_ones)
{
  for (unsigned int p = 1; p <= 10; ++p)
    for (const KnotVector &coarse : knot_vectors(p))
      {
        const KnotVector fine = coarse.dyadic_refinement();
        const auto       S    = two_scale_relation(coarse, fine);
        ASSERT_EQ(S.size(), 2 * coarse.n_spans());
        for (unsigned int span = 0; span < fine.n_spans(); ++span)
          for (const double x : {0., 0.35, 1.})
            {
              const double t = point_in(fine, span, x);
              const auto   M = coarse.evaluate(span / 2, t);
              const auto   N = fine.evaluate(span, t);
              for (unsigned int a = 0; a <= p; ++a)
                {
                  double value = 0.;
                  for (unsigned int b = 0; b <= p; ++b)
                    value += S[span](a, b) * N[0][b];
                  EXPECT_NEAR(value, M[0][a], 2e-14);
                }
            }
      }
}



// Uniform B-splines: the mask is the row p + 1 of Pascal's triangle over 2^p.
TEST(BezierExtraction, uniform_two_scale_mask_is_binomial)
{
  for (unsigned int p = 1; p <= 10; ++p)
    {
      std::vector<double> breakpoints;
      for (unsigned int i = 0; i <= 3 * p + 4; ++i)
        breakpoints.push_back(i);
      const KnotVector coarse(p, breakpoints, true);
      const auto S = two_scale_relation(coarse, coarse.dyadic_refinement());
      const unsigned int span = coarse.n_spans() + 1; // odd or even, all alike
      for (unsigned int a = 0; a <= p; ++a)
        for (unsigned int b = 0; b <= p; ++b)
          {
            // fine function index minus twice the coarse one, in the numbering
            // by the first knot of the support
            const int k = (int(span) - int(p) + int(b)) -
                          2 * (int(span / 2) - int(p) + int(a));
            const double exact =
              (k < 0 || k > int(p) + 1) ?
                0. :
                std::round(std::exp(std::lgamma(p + 2.) - std::lgamma(k + 1.) -
                                    std::lgamma(p + 2. - k))) /
                  std::pow(2., p);
            EXPECT_NEAR(S[span](a, b), exact, 1e-15);
          }
    }
}



TEST(KnotVector, wrong_knots_are_refused)
{
  EXPECT_THROW(KnotVector(0, {0., 1.}), InputError);
  EXPECT_THROW(KnotVector(2, {0.}), InputError);
  EXPECT_THROW(KnotVector(2, {0., 1., 1., 2.}), InputError);
  EXPECT_THROW(KnotVector(2, {0., NAN, 2.}), InputError);
  EXPECT_THROW(KnotVector(3, {0., 1., 2., 3.}, true), InputError);
  EXPECT_THROW(KnotVector::from_knots(2, {0., 0., 1., 1.}), InputError);
  EXPECT_THROW(KnotVector::from_knots(2, {0., 0., 0.5, 1., 1., 1.}),
               InputError);
  EXPECT_THROW(KnotVector::from_knots(1, {0., 0., 2., 1., 3., 3.}), InputError);
  EXPECT_THROW(KnotVector::from_knots(1, {0., 0., 1., 1., 2., 2.}), InputError);
}
