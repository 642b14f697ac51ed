#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include "../constitutive/law_tools.h"
#include "loaded_solid.h"

namespace
{
  using namespace loaded_solid;
  using asperity::law_tools::all_laws;

  /** The unit box, refined in a corner at the top. */
  std::shared_ptr<SplineSpace<3>>
  hierarchical_box(const unsigned int degree)
  {
    const auto knots = [degree](const unsigned int n) {
      return KnotVector(degree, equal_spans(n));
    };
    auto space = std::make_shared<SplineSpace<3>>(
      std::array<KnotVector, 3>{{knots(2), knots(1), knots(2)}});
    space->refine_to_level(1, [](const Point<3> &low, const Point<3> &high) {
      return low[0] < 0.4 && high[2] > 0.6;
    });
    return space;
  }

  /** Coefficients of a field of the identity map's parameters. */
  Vector
  coefficients(const SplineSpace<3>                                &space,
               const std::function<Tensor<1, 3>(const Point<3> &)> &field)
  {
    const auto c = space.project(
      [&](const Point<3> &xi) {
        const Tensor<1, 3> v = field(xi);
        return std::vector<double>{v[0], v[1], v[2]};
      },
      3);
    Vector u(3 * space.n_functions());
    for (unsigned int a = 0; a < space.n_functions(); ++a)
      for (unsigned int i = 0; i < 3; ++i)
        u(3 * a + i) = c[i][a];
    return u;
  }

  /** |K d - (R(u + h d) - R(u - h d))/2h| over |K d|. */
  double
  tangent_error(SolidAssembler<3> &solid,
                const Vector      &u,
                const Vector      &d,
                const double       h)
  {
    dealii::DynamicSparsityPattern couplings(u.size());
    solid.add_couplings(couplings);
    dealii::SparsityPattern pattern;
    pattern.copy_from(couplings);
    Matrix tangent(pattern);
    Vector R(u.size()), product(u.size()), plus(u), minus(u);
    EXPECT_TRUE(solid.add(u, R, &tangent));
    tangent.vmult(product, d);
    plus.add(h, d);
    minus.add(-h, d);
    Vector high(u.size()), low(u.size());
    EXPECT_TRUE(solid.add(plus, high, nullptr));
    EXPECT_TRUE(solid.add(minus, low, nullptr));
    high -= low;
    high /= 2. * h;
    high -= product;
    return high.linfty_norm() / product.linfty_norm();
  }
} // namespace



TEST(SpatialSolid, tangent_is_the_derivative_of_the_force_for_every_law)
{
  for (const unsigned int degree : {1, 2})
    for (const auto &law : all_laws())
      {
        const auto        space = hierarchical_box(degree);
        SolidAssembler<3> solid(space, bent(*space), law);
        solid.set_time_step(1e-3);
        // A step that yields (in the plastic laws), and another upon it.
        const unsigned int n = 3 * space->n_functions();
        Vector             R(n);
        ASSERT_TRUE(solid.add(random_vector(n, 5e-3), R, nullptr));
        solid.accept();
        EXPECT_LT(tangent_error(
                    solid, random_vector(n, 1e-2), random_vector(n, 1.), 1e-8),
                  5e-6)
          << law->name() << ", degree " << degree;
      }
}



TEST(SpatialSolid, rigid_motion_gives_no_force)
{
  const auto   space = hierarchical_box(2);
  Tensor<2, 3> Q; // about the axis (1, 1, 1) by 120 degrees
  Q[0][2] = Q[1][0] = Q[2][1] = 1.;
  const Vector u              = coefficients(*space, [&](const Point<3> &X) {
    return Q * X - X + Point<3>(3., -4., 5.);
  });
  for (const auto &law : all_laws())
    {
      SolidAssembler<3> solid(space, {}, law);
      Vector            R(u.size());
      ASSERT_TRUE(solid.add(u, R, nullptr));
      EXPECT_LT(R.linfty_norm(), 1e-12 * law->young_modulus()) << law->name();
    }
}



// Under a homogeneous deformation no inner function feels a force, and the
// stress is that of the law everywhere.
TEST(SpatialSolid, finite_strain_patch_test_on_hierarchical_meshes)
{
  const auto   space = hierarchical_box(2);
  Tensor<2, 3> H;
  H[0][0] = 0.1, H[0][1] = -0.05, H[0][2] = 0.2, H[1][0] = 0.03;
  H[1][1] = -0.04, H[1][2] = 0.06, H[2][0] = 0.1, H[2][2] = 0.08;
  const Vector u =
    coefficients(*space, [&](const Point<3> &X) { return H * X; });
  std::vector<bool> inner(space->n_functions(), true);
  for (const Edge face : all_edges<3>())
    for (const unsigned int a : space->edge_functions(face))
      inner[a] = false;
  for (const auto &law : all_laws())
    {
      SolidAssembler<3> solid(space, {}, law);
      solid.set_time_step(1e-3);
      Vector R(u.size());
      ASSERT_TRUE(solid.add(u, R, nullptr));
      double largest = 0.;
      for (unsigned int i = 0; i < R.size(); ++i)
        if (inner[i / 3])
          largest = std::max(largest, std::abs(R(i)));
      EXPECT_LT(largest, 1e-12 * law->young_modulus()) << law->name();
      const auto &mises = solid.mises_stress();
      EXPECT_NEAR(*std::min_element(mises.begin(), mises.end()),
                  *std::max_element(mises.begin(), mises.end()),
                  1e-9 * law->young_modulus());
    }
}



// A body that is extruded along y and does not move along it is in plane
// strain: each column of functions feels the plane force times its thickness.
TEST(SpatialSolid, extruded_body_has_the_forces_of_plane_strain)
{
  const unsigned int degree = 2;
  const double       width  = 0.7;
  const auto plane = make_space(degree, equal_spans(4), graded_spans(3, 0.5));
  const auto space = std::make_shared<SplineSpace<3>>(
    std::array<KnotVector, 3>{{KnotVector(degree, equal_spans(4)),
                               KnotVector(degree, {0., 0.2, 0.3, width}, true),
                               KnotVector(degree, graded_spans(3, 0.5))}});
  const auto field = [](const double x, const double z) {
    return std::array<double, 2>{
      {0.02 * std::sin(3. * x) * z, 0.03 * x * z * z - 0.04 * z}};
  };
  const auto c = plane->project(
    [&](const Point<2> &X) {
      const auto f = field(X[0], X[1]);
      return std::vector<double>{f[0], f[1]};
    },
    2);
  Vector u(2 * plane->n_functions());
  for (unsigned int a = 0; a < plane->n_functions(); ++a)
    for (unsigned int i = 0; i < 2; ++i)
      u(2 * a + i) = c[i][a];
  const Vector u3 = coefficients(*space, [&](const Point<3> &X) {
    const auto f = field(X[0], X[2]);
    return Point<3>(f[0], 0., f[1]);
  });
  for (const auto &law : all_laws())
    {
      SolidAssembler<2> flat(plane, {}, law);
      SolidAssembler<3> solid(space, {}, law);
      flat.set_time_step(1e-3);
      solid.set_time_step(1e-3);
      Vector R(u.size()), R3(u3.size());
      ASSERT_TRUE(flat.add(u, R, nullptr));
      ASSERT_TRUE(solid.add(u3, R3, nullptr));
      // against displacements of the plane, which are sums over columns
      const double size = R.l2_norm() * width;
      EXPECT_NEAR(R3 * u3, width * (R * u), 1e-9 * std::abs(R * u) * width)
        << law->name();
      Tensor<1, 3> sum;
      for (unsigned int i = 0; i < R3.size(); ++i)
        sum[i % 3] += R3(i);
      EXPECT_LT(sum.norm(), 1e-11 * size) << law->name();
      double across = 0.;
      for (unsigned int a = 0; a < space->n_functions(); ++a)
        across += std::abs(R3(3 * a + 1));
      EXPECT_LT(across, 1e-9 * size) << law->name();
    }
}



TEST(SpatialSolid, mass_matrix_sums_to_the_mass)
{
  const auto                     space = hierarchical_box(2);
  SolidAssembler<3>              solid(space, {}, all_laws()[0]);
  const unsigned int             n = 3 * space->n_functions();
  dealii::DynamicSparsityPattern couplings(n);
  solid.add_couplings(couplings);
  dealii::SparsityPattern pattern;
  pattern.copy_from(couplings);
  Matrix mass(pattern);
  solid.assemble_mass(mass);
  for (unsigned int i = 0; i < 3; ++i)
    {
      Vector ones(n), product(n);
      for (unsigned int a = 0; a < space->n_functions(); ++a)
        ones(3 * a + i) = 1.;
      mass.vmult(product, ones);
      EXPECT_NEAR(product * ones,
                  all_laws()[0]->density(),
                  1e-12 * all_laws()[0]->density());
    }
}
