#include <asperity/heat/fourier_basis.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace asperity;
} // namespace



TEST(FourierBasis, has_the_waves_of_the_period)
{
  const FourierBasis<2> basis({{3.}}, {{40}});
  ASSERT_EQ(basis.size(), 81u);
  const std::vector<double>     x = {0., 0.2, 2.9, -7.3};
  std::vector<dealii::Point<1>> places;
  for (const double at : x)
    places.emplace_back(at);
  const FourierValues<2> values(basis, places);
  for (unsigned int q = 0; q < x.size(); ++q)
    {
      EXPECT_EQ(values(q, 0), 1.);
      for (unsigned int k = 1; k <= 40; ++k)
        {
          const double phase = 2. * M_PI * k * x[q] / 3.;
          EXPECT_NEAR(values(q, 2 * k - 1), std::cos(phase), 1e-12);
          EXPECT_NEAR(values(q, 2 * k), std::sin(phase), 1e-12);
          EXPECT_NEAR(basis.wave_number(2 * k), 2. * M_PI * k / 3., 1e-12);
          EXPECT_EQ(basis.wave_number(2 * k - 1), basis.wave_number(2 * k));
        }
    }
}



namespace
{
  /** Checks the projection of each function by the rectangle rule, which is
   *  exact below half as many waves as points.
   *  @param places of the rule */
  template <int dim>
  void
  expect_orthogonal(const FourierBasis<dim>                   &basis,
                    const std::vector<dealii::Point<dim - 1>> &places)
  {
    const FourierValues<dim> f(basis, places);
    for (unsigned int b = 0; b < basis.size(); ++b)
      {
        dealii::Vector<double> one(basis.size());
        one(b)                              = 1.;
        const dealii::Vector<double> values = f.at_points(one);
        dealii::Vector<double>       sums   = f.sums(values);
        for (unsigned int a = 0; a < basis.size(); ++a)
          EXPECT_NEAR(basis.norm(a) * sums(a) * basis.area() / places.size(),
                      a == b ? 1. : 0.,
                      1e-14)
            << a << " " << b;
        for (unsigned int q = 0; q < places.size(); ++q)
          EXPECT_NEAR(values(q), f(q, b), 1e-14);
      }
  }
} // namespace



TEST(FourierBasis, projects_its_own_functions_to_themselves)
{
  std::vector<dealii::Point<1>> along;
  std::vector<dealii::Point<2>> on_face;
  for (unsigned int i = 0; i < 16; ++i)
    {
      along.emplace_back(2. * i / 16.);
      for (unsigned int j = 0; j < 6; ++j)
        on_face.emplace_back(2. * i / 16., 3. * j / 6.);
    }
  expect_orthogonal(FourierBasis<2>({{2.}}, {{3}}), along);
  expect_orthogonal(FourierBasis<3>({{2., 3.}}, {{3, 2}}), on_face);
}



TEST(FourierBasis, has_products_of_waves_along_two_directions)
{
  const FourierBasis<3>  basis({{2., 3.}}, {{3, 2}});
  const dealii::Point<2> at(0.3, -1.9);
  const FourierValues<3> f(basis, {at, dealii::Point<2>(0., 0.)});
  ASSERT_EQ(basis.size(), 35u);
  EXPECT_EQ(basis.area(), 6.);
  // cos(2 kappa_x x) sin(kappa_y y) is number 3 of the first, 2 of the second
  const unsigned int m = 3 + 7 * 2;
  EXPECT_NEAR(f(0, m),
              std::cos(2. * M_PI * at[0]) * std::sin(2. * M_PI * at[1] / 3.),
              1e-14);
  EXPECT_NEAR(basis.wave_number(m),
              2. * M_PI * std::hypot(2. / 2., 1. / 3.),
              1e-14);
  EXPECT_NEAR(basis.norm(m), 4. / 6., 1e-14);
  EXPECT_NEAR(basis.norm(3), 2. / 6., 1e-14);
  EXPECT_NEAR(basis.norm(0), 1. / 6., 1e-14);
}
