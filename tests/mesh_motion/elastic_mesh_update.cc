#include <asperity/base/errors.h>
#include <asperity/mesh_motion/elastic_mesh_update.h>
#include <asperity/mesh_motion/mesh_quality.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{
  using namespace asperity;
  using dealii::Point;
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;

  /** The unit square, or its image, with the displacement space on it. */
  struct Square
  {
    dealii::Triangulation<2> mesh;
    dealii::FESystem<2>      fe{dealii::FE_Q<2>(2), 2};
    dealii::DoFHandler<2>    dofs;
    dealii::MappingQ<2>      mapping{2};

    explicit Square(const std::vector<double> &heights,
                    const bool                 distorted = false)
    {
      dealii::GridGenerator::subdivided_hyper_rectangle(
        mesh,
        {std::vector<double>(4, 0.25), heights},
        Point<2>(),
        Point<2>(1., 1.),
        true);
      if (distorted)
        {
          mesh.begin_active()->set_refine_flag();
          mesh.execute_coarsening_and_refinement();
          dealii::GridTools::distort_random(0.2, mesh, false, 7);
        }
      dofs.reinit(mesh);
      dofs.distribute_dofs(fe);
    }

    Vector
    nodal(const std::function<Tensor<1, 2>(const Point<2> &)> &field) const
    {
      std::vector<Point<2>> points(dofs.n_dofs());
      dealii::DoFTools::map_dofs_to_support_points(mapping, dofs, points);
      const auto y_dofs = dealii::DoFTools::extract_dofs(
        dofs, dealii::ComponentMask(std::vector<bool>{false, true}));
      Vector result(dofs.n_dofs());
      for (unsigned int i = 0; i < result.size(); ++i)
        result(i) = field(points[i])[y_dofs.is_element(i)];
      return result;
    }
  };



  ElasticMeshOptions
  all_prescribed(const double exponent)
  {
    ElasticMeshOptions options;
    options.stiffening_exponent = exponent;
    options.prescribed          = {0, 1, 2, 3};
    return options;
  }



  double
  distance(const Vector &a, const Vector &b)
  {
    Vector difference = a;
    difference -= b;
    return difference.linfty_norm();
  }



  Tensor<1, 2>
  linear_field(const Point<2> &X)
  {
    return Point<2>(0.1 + 0.2 * X[0] - 0.3 * X[1],
                    -0.4 + 0.1 * X[0] + 0.15 * X[1]);
  }
} // namespace



TEST(ElasticMeshUpdate, passes_the_patch_test)
{
  // Without stiffening on any mesh, hanging nodes included; with it where all
  // cells are alike.
  const Square distorted(std::vector<double>(4, 0.25), true);
  const Square uniform(std::vector<double>(4, 0.25));
  for (const auto &[square, exponent] :
       {std::pair<const Square *, double>{&distorted, 0.}, {&uniform, 1.5}})
    {
      const ElasticMeshUpdate emum(square->dofs,
                                   square->mapping,
                                   all_prescribed(exponent));
      const Vector            exact = square->nodal(linear_field);
      EXPECT_LT(distance(emum.update(exact), exact), 1e-13);
    }
}



TEST(ElasticMeshUpdate, rigid_motion_stays_rigid_with_any_stiffening)
{
  const Square            square(std::vector<double>(4, 0.25), true);
  const ElasticMeshUpdate emum(square.dofs, square.mapping, all_prescribed(2.));
  const Vector exact = square.nodal([](const Point<2> &X) -> Tensor<1, 2> {
    return Point<2>(3. - 0.5 * X[1], -1. + 0.5 * X[0]); // infinitesimal
  });
  EXPECT_LT(distance(emum.update(exact), exact), 1e-12);
}



TEST(ElasticMeshUpdate, stiffening_follows_its_formula)
{
  // Rows of heights h1, h2 pulled apart, free along x: springs in series of
  // the stiffness h^-(1 + chi), so the interface takes the share
  // h1^(1 + chi) / (h1^(1 + chi) + h2^(1 + chi)) of the displacement.
  const double h1 = 0.2, h2 = 0.8, U = 0.1;
  const Square square({h1, h2});
  for (const double exponent : {0., 0.5, 1., 2.})
    {
      ElasticMeshOptions options;
      options.stiffening_exponent = exponent;
      options.prescribed          = {2};
      options.sliding_in_x        = {3};
      options.periodic            = {{0, 1}};
      const ElasticMeshUpdate emum(square.dofs, square.mapping, options);
      const Vector            pulled =
        emum.update(square.nodal([U](const Point<2> &X) -> Tensor<1, 2> {
          return Point<2>(0., X[1] > 0.9 ? U : 0.);
        }));
      const double power = 1. + exponent;
      const double share =
        std::pow(h1, power) / (std::pow(h1, power) + std::pow(h2, power));
      const Vector expected = square.nodal([&](const Point<2> &X) {
        const double y = X[1] < h1 ? share * X[1] / h1 :
                                     share + (1. - share) * (X[1] - h1) / h2;
        return Tensor<1, 2>(Point<2>(0., U * y));
      });
      EXPECT_LT(distance(pulled, expected), 1e-14);
    }
}



TEST(ElasticMeshUpdate, cyclic_motion_returns_to_the_same_mesh)
{
  const Square            square(std::vector<double>(4, 0.25), true);
  const ElasticMeshUpdate emum(square.dofs, square.mapping, all_prescribed(1.));
  const auto              boundary = [&square](const double phase) {
    return square.nodal([phase](const Point<2> &X) -> Tensor<1, 2> {
      return Point<2>(0.2 * std::sin(phase) * X[1] * X[1],
                      0.1 * (std::sin(phase + X[0]) - std::sin(X[0])));
    });
  };
  const Vector start = emum.update(boundary(0.4));
  for (unsigned int k = 1; k < 40; ++k)
    {
      const double phase = 0.4 + 2. * M_PI * k / 20.;
      const Vector d     = emum.update(boundary(phase));
      EXPECT_EQ(distance(d, start) < 1e-12, k % 20 == 0) << k;
    }
}



TEST(ElasticMeshUpdate, a_mesh_that_is_not_held_is_refused)
{
  const Square       square({0.5, 0.5});
  ElasticMeshOptions options;
  options.periodic = {{0, 1}};
  EXPECT_THROW(ElasticMeshUpdate(square.dofs, square.mapping, options),
               InputError);
  options.sliding_in_x = {2, 3};
  EXPECT_THROW(ElasticMeshUpdate(square.dofs, square.mapping, options),
               InputError);
}



TEST(MeshWatch, measures_shear_and_stretch_of_known_mappings)
{
  const Square    square(std::vector<double>(4, 0.25));
  const MeshWatch watch(square.dofs, square.mapping, 0.3);
  const auto      quality = [&](const double shear, const double stretch) {
    return watch.quality(square.nodal([=](const Point<2> &X) -> Tensor<1, 2> {
      return Point<2>(shear * X[1], (stretch - 1.) * X[1]);
    }));
  };
  EXPECT_NEAR(quality(0., 1.).smallest_scaled_jacobian, 1., 1e-14);
  EXPECT_NEAR(quality(0., 1.).largest_aspect_ratio, 1., 1e-13);
  EXPECT_NEAR(quality(0., .1).largest_aspect_ratio, 10., 1e-12);
  // columns (1, 0) and (shear, stretch)
  EXPECT_NEAR(quality(3., 1.).smallest_scaled_jacobian,
              1. / std::sqrt(10.),
              1e-14);
  EXPECT_NEAR(quality(0., -2.).smallest_scaled_jacobian, -1., 1e-14);
}



TEST(MeshWatch, names_the_worst_place)
{
  const Square    square(std::vector<double>(4, 0.25));
  const MeshWatch watch(square.dofs, square.mapping, 0.3);
  const auto      sheared = [&square](const double factor) {
    return square.nodal([factor](const Point<2> &X) -> Tensor<1, 2> {
      return Point<2>(0.,
                      factor * (X[0] > 0.75 ? std::pow(X[0] - 0.75, 2) : 0.));
    });
  };
  // slope at X = 1: 0.5 factor
  const ConvergenceReport fine = watch.check(sheared(4.));
  EXPECT_TRUE(fine.converged);
  EXPECT_NEAR(fine.residual, 1. / std::sqrt(5.), 1e-13);
  const ConvergenceReport bad = watch.check(sheared(8.));
  EXPECT_FALSE(bad.converged);
  EXPECT_NEAR(bad.residual, 1. / std::sqrt(17.), 1e-13);
  EXPECT_FALSE(bad.reason.empty());
  EXPECT_NEAR(watch.quality(sheared(8.)).worst_place[0], 1., 1e-13);
  EXPECT_EQ(watch.quality(sheared(8.)).worst_cell % 4, 3u);
}
