#include <gtest/gtest.h>

#include "../constitutive/law_tools.h"
#include "loaded_solid.h"

namespace
{
  using namespace loaded_solid;
  using asperity::law_tools::all_laws;

  /** Two levels beyond the first, in a corner. */
  std::shared_ptr<SplineSpace<2>>
  hierarchical_space(const unsigned int degree)
  {
    auto space = make_space(degree, equal_spans(4), equal_spans(3));
    space->refine_to_level(2, [](const Point<2> &low, const Point<2> &high) {
      return low[0] < 0.2 && high[1] > 0.8;
    });
    return space;
  }

  std::shared_ptr<const MaterialLaw>
  neo_hooke()
  {
    return all_laws()[3];
  }
} // namespace



TEST(SolidAssembler,
     tangent_is_the_derivative_of_the_force_for_every_law_and_kinematics)
{
  const auto space = hierarchical_space(2);
  for (const auto &law : all_laws())
    for (const auto kinematics :
         {Kinematics::plane_strain, Kinematics::axisymmetric})
      {
        Body body(space, bent_rectangle, law, kinematics);
        body.solid.set_time_step(1e-3);
        // A step that yields (in the plastic laws), and another upon it, so
        // that the history is not trivial. Strains are some per cent.
        const unsigned int n = body.u.size();
        Vector             R(n);
        ASSERT_TRUE(body.solid.add(random_vector(n, 5e-3), R, nullptr));
        body.solid.accept();
        Vector       u         = random_vector(n, 1e-2);
        const Vector direction = random_vector(n, 1.);
        EXPECT_LT(tangent_error(body.solid, u, direction, 1e-8), 2e-6)
          << law->name()
          << (kinematics == Kinematics::axisymmetric ? ", axisymmetric" :
                                                       ", plane strain");
      }
}



TEST(SolidAssembler, rigid_motion_gives_no_force)
{
  const auto space = hierarchical_space(3);
  for (const auto &law : all_laws())
    {
      Body         body(space, bent_rectangle, law);
      const Vector X     = body.control_points();
      const double angle = 2.;
      Vector       u(X.size()), R(X.size());
      for (unsigned int a = 0; a < X.size(); a += 2)
        {
          u(a) =
            std::cos(angle) * X(a) - std::sin(angle) * X(a + 1) - X(a) + 3.;
          u(a + 1) =
            std::sin(angle) * X(a) + std::cos(angle) * X(a + 1) - X(a + 1) - 4.;
        }
      ASSERT_TRUE(body.solid.add(u, R, nullptr));
      // against the force of a strain of order one
      EXPECT_LT(R.linfty_norm(), 1e-12 * law->young_modulus()) << law->name();
    }
}



TEST(SolidAssembler, stiffness_reaches_matrices_of_any_pattern)
{
  const auto                     space = hierarchical_space(2);
  SolidAssembler<2>              solid(space,
                          PatchGeometry<2>::from_map(*space, bent_rectangle),
                          neo_hooke());
  const unsigned int             n = 2 * space->n_functions();
  const Vector                   u = random_vector(n, 1e-2);
  Vector                         R(n);
  dealii::DynamicSparsityPattern own(n), full(n);
  solid.add_couplings(own);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      full.add(i, j);
  dealii::SparsityPattern patterns[2];
  patterns[0].copy_from(own);
  patterns[1].copy_from(full);
  Matrix K[2];
  // There and back again: what was found for one pattern is not of the other.
  for (const unsigned int k : {0, 1, 0})
    {
      K[k].reinit(patterns[k]);
      ASSERT_TRUE(solid.add(u, R, &K[k]));
    }
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      ASSERT_EQ(K[0].el(i, j), K[1].el(i, j));
}



TEST(SolidAssembler, inverted_elements_have_no_force)
{
  Body         body(hierarchical_space(2), bent_rectangle, neo_hooke());
  const Vector X = body.control_points();
  Vector       u(X.size()), R(X.size());
  for (unsigned int a = 0; a < X.size(); a += 2)
    u(a) = -2. * X(a);
  EXPECT_FALSE(body.solid.add(u, R, nullptr));
}



TEST(SolidAssembler, mass_matrix_sums_to_the_mass)
{
  const double pi = dealii::numbers::PI;
  for (const auto kinematics :
       {Kinematics::plane_strain, Kinematics::axisymmetric})
    {
      Body body(
        hierarchical_space(2),
        [](const Point<2> &xi) {
          return Point<2>(1. + 2. * xi[0], 3. * xi[1]);
        },
        neo_hooke(),
        kinematics);
      auto mass = body.equilibrium().make_matrix();
      body.solid.assemble_mass(*mass);
      Vector unit(body.u.size()), product(body.u.size());
      for (unsigned int a = 1; a < unit.size(); a += 2)
        unit(a) = 1.;
      mass->vmult(product, unit);
      const double volume =
        kinematics == Kinematics::axisymmetric ? pi * 8. * 3. : 6.;
      EXPECT_NEAR(unit * product / (7800. * volume), 1., 1e-13);
    }
}



TEST(SolidAssembler, body_force_sums_to_weight_and_acts_at_the_centre_of_mass)
{
  Body body(
    hierarchical_space(2),
    [](const Point<2> &xi) { return Point<2>(2. * xi[0], 3. * xi[1]); },
    neo_hooke());
  Tensor<1, 2> force;
  force[1] = -5.;
  body.solid.add_body_force(force, body.load);
  const Vector X      = body.control_points();
  double       weight = 0., moment = 0.;
  for (unsigned int a = 0; a < X.size(); a += 2)
    {
      weight += body.load(a + 1);
      moment += X(a) * body.load(a + 1);
    }
  EXPECT_NEAR(weight, -30., 1e-12);
  EXPECT_NEAR(moment, -30., 1e-12);
}



TEST(SolidAssembler, finite_strain_patch_test_on_hierarchical_meshes)
{
  // Edges that follow a linear map make the whole body follow it.
  const double F[2][2] = {{1.3, 0.4}, {-0.2, 0.9}};
  for (unsigned int degree = 1; degree <= 4; ++degree)
    for (const auto &law : {all_laws()[2], all_laws()[3]})
      {
        const auto   space = hierarchical_space(degree);
        Body         body(space, bent_rectangle, law);
        const Vector X = body.control_points();
        Vector       exact(X.size());
        for (unsigned int a = 0; a < X.size(); a += 2)
          for (unsigned int i = 0; i < 2; ++i)
            exact(a + i) = F[i][0] * X(a) + F[i][1] * X(a + 1) - X(a + i);
        for (const Edge edge : four_edges)
          body.clamp(edge);
        for (const double part : {0.5, 1.})
          {
            Vector target = exact;
            target *= part;
            body.solve(1e-4, &target);
          }
        // One more step of Newton, whose tolerance is absolute.
        Vector R(X.size()), d(X.size());
        body.equilibrium().linearize(body.u, R);
        body.equilibrium().direction(R, d);
        body.u += d;
        // Values at points: coefficients of a hierarchical basis of high
        // degree are less well conditioned than what they stand for.
        double error = 0.;
        for (const auto &X_q : body.solid.table().parameter)
          {
            const Tensor<1, 2> x = body.displacement(X_q),
                               P = body.geometry.position(*space, X_q);
            for (unsigned int i = 0; i < 2; ++i)
              error = std::max(error,
                               std::abs(x[i] + P[i] - F[i][0] * P[0] -
                                        F[i][1] * P[1]));
          }
        EXPECT_LT(error, 1e-12) << "degree " << degree << ", " << law->name();
      }
}



TEST(Equilibrium, reactions_balance_the_load)
{
  Body body(hierarchical_space(2), bent_rectangle, neo_hooke());
  body.clamp(Edge::left);
  body.add_pressure(Edge::top, [](const Point<2> &X) { return 1e8 * X[0]; });
  Tensor<1, 2> weight;
  weight[1] = -1e8;
  body.solid.add_body_force(weight, body.load);
  body.solve(1e-2);
  Vector forces(body.u.size());
  ASSERT_TRUE(body.equilibrium().forces(body.u, forces));
  forces -= body.load;
  for (unsigned int i = 0; i < forces.size(); ++i)
    if (!body.constraints.is_constrained(i))
      {
        EXPECT_NEAR(forces(i), 0., 1e-2); // of some 10^8 N/m
      }
}



TEST(Equilibrium, contraction_under_a_follower_load_is_quadratic)
{
  Body body(hierarchical_space(2), bent_rectangle, neo_hooke());
  body.clamp(Edge::left);
  body.add_pressure(Edge::top, [](const Point<2> &) { return 2e9; });
  Vector              u(body.u.size()), R(body.u.size()), d(body.u.size());
  std::vector<double> size;
  ASSERT_TRUE(body.equilibrium().linearize(u, R));
  for (unsigned int i = 0; i < 9; ++i)
    {
      ASSERT_TRUE(body.equilibrium().direction(R, d));
      size.push_back(d.linfty_norm());
      u += d;
      ASSERT_TRUE(body.equilibrium().linearize(u, R));
    }
  // The order from the steps between 1e-1 and 1e-13, where neither the first
  // iterates nor round-off disturb.
  double order = 0.;
  for (unsigned int i = 1; i + 1 < size.size(); ++i)
    if (size[i] < 1e-1 && size[i + 1] > 1e-13)
      order = std::max(order,
                       std::log(size[i + 1] / size[i]) /
                         std::log(size[i] / size[i - 1]));
  EXPECT_GT(order, 1.7);
  EXPECT_LT(size.back(), 1e-13);
}
