#include <asperity/base/errors.h>
#include <asperity/postprocess/surface_picture.h>

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

using namespace asperity;
using dealii::Point;

namespace
{
  std::string
  message_of(const SurfacePicture &picture)
  {
    std::ostringstream out;
    try
      {
        write_surface(out, picture, 0., 0);
      }
    catch (const ComputationError &error)
      {
        return error.what();
      }
    return out.str();
  }

  SurfacePicture
  two_squares()
  {
    SurfacePicture picture;
    for (unsigned int square = 0; square < 2; ++square)
      for (unsigned int corner = 0; corner < 4; ++corner)
        picture.points.emplace_back(square + corner % 2,
                                    corner / 2,
                                    0.1 * square);
    picture.scalars = {{"gap [m]", std::vector<double>(8, 1.)}};
    return picture;
  }
} // namespace



TEST(SurfacePicture, says_which_field_is_wrong)
{
  SurfacePicture picture = two_squares();
  EXPECT_EQ(message_of(picture).rfind("<?xml", 0), 0u);
  picture.scalars[0].second.pop_back();
  EXPECT_EQ(
    message_of(picture),
    "The field 'gap [m]' of a surface has 7 values, but the surface has "
    "8 points.");
  picture.scalars[0].second.push_back(std::numeric_limits<double>::quiet_NaN());
  EXPECT_NE(message_of(picture).find("'gap [m]' holds a number that is not "
                                     "finite"),
            std::string::npos);
}



// n Gauss points tell a polynomial of degree n - 1 in each direction.
TEST(SurfacePicture, reaches_the_edges_from_gauss_points)
{
  const auto polynomial = [](const double x, const double y) {
    return 1. + 2. * x - 3. * x * y + x * x * y * y;
  };
  const unsigned int      n = 3;
  const dealii::QGauss<2> gauss(n);
  std::vector<double>     values;
  for (const Point<2> &at : gauss.get_points())
    values.push_back(polynomial(at[0], at[1]));
  const std::vector<double> free = from_gauss_points(values, n, false),
                            kept = from_gauss_points(values, n, true);
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
      {
        const double exact = polynomial(0.5 * i, 0.5 * j);
        EXPECT_NEAR(free[j * n + i], exact, 1e-13);
        EXPECT_NEAR(kept[j * n + i], std::clamp(exact, *low, *high), 1e-13);
      }
}
