#include <asperity/contact/sheet_obstacle.h>
#include <asperity/splines/spline_fit.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ball.h"
#include "contact_examples.h"
#include "sheared.h"

namespace
{
  using namespace asperity;
  using dealii::Point;
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;
  using example::contact_options;
  using example::Interface;
  using example::set_strength;

  /** A curve of the x-z plane, the same for all y. */
  class Extruded : public RigidObstacle<3>
  {
  public:
    explicit Extruded(const std::shared_ptr<const RigidObstacle<2>> &section)
      : section(section)
    {}

    GapPoint<3>
    gap(const Point<3> &x, Point<2> &hint) const override
    {
      Point<1>          along(hint[0]);
      const GapPoint<2> plane = section->gap(Point<2>(x[0], x[2]), along);
      hint[0]                 = along[0];
      const auto raised       = [](const Tensor<1, 2> &v) {
        return Point<3>(v[0], 0., v[1]);
      };
      GapPoint<3> gap;
      gap.gap          = plane.gap;
      gap.normal       = raised(plane.normal);
      gap.direction[0] = raised(plane.direction[0]);
      gap.direction[1] = Point<3>(0., 1., 0.);
      gap.curvature    = {{plane.curvature[0], 0.}};
      return gap;
    }

  private:
    std::shared_ptr<const RigidObstacle<2>> section;
  };

  std::shared_ptr<const RigidObstacle<2>>
  wave()
  {
    return example::periodic_tool(
      [](const double x) { return 1. + 0.05 * std::sin(M_PI * x); }, 2., 24);
  }

  template <int dim>
  void
  accept(ContactAssembler<dim> &contact)
  {
    if (contact.shear() != nullptr)
      contact.shear()->accept();
  }

  /** A block 2 x 1.2 x 1, periodic along x and y. */
  std::shared_ptr<const SplineSpace<3>>
  block(const unsigned int n_x, const std::vector<double> &across)
  {
    return std::make_shared<SplineSpace<3>>(std::array<KnotVector, 3>{
      {KnotVector(2, example::equal_steps(0., 2., n_x), true),
       KnotVector(2, across, true),
       KnotVector(2, example::equal_steps(0., 1., 2))}});
  }

  class SpatialContact : public testing::TestWithParam<
                           std::tuple<ContactFormulation, InterfaceShear>>
  {
  protected:
    Interface interface {
      std::get<0>(GetParam()), std::get<1>(GetParam())
    };
  };

  /** Of contact and shear together, which random displacements move over the
   *  surface: |K d - (R(u + h d) - R(u - h d))/2h| over |K d|. */
  void
  expect_exact_tangent(ContactAssembler<3> &contact, const unsigned int n)
  {
    set_strength(contact, 1e4);
    std::mt19937                           generator(5);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    Vector                                 u(n), d(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        u(i) = 0.004 * uniform(generator);
        d(i) = uniform(generator);
      }
    const auto residual = [&](const Vector &at) {
      Vector R(n);
      contact.add(at, R, nullptr);
      return R;
    };
    residual(u);
    accept(contact);
    set_strength(contact, 1e4);
    for (unsigned int i = 0; i < n; ++i)
      u(i) += 0.008 * uniform(generator);

    dealii::DynamicSparsityPattern couplings(n);
    contact.add_couplings(couplings);
    dealii::SparsityPattern pattern;
    pattern.copy_from(couplings);
    dealii::SparseMatrix<double> tangent(pattern);
    Vector                       R(n), product(n), rest(n);
    contact.add(u, R, &tangent);
    tangent.vmult(product, d);
    if (contact.unsymmetric_tangent() != nullptr)
      contact.unsymmetric_tangent()->vmult_add(product, d);
    if (contact.shear() != nullptr)
      {
        const std::vector<double> sticking = contact.shear()->sticking();
        EXPECT_GT(*std::max_element(sticking.begin(), sticking.end()), 0.5);
        EXPECT_LT(*std::min_element(sticking.begin(), sticking.end()), 0.1);
      }
    const double step = 1e-8;
    Vector       plus(u), minus(u);
    plus.add(step, d);
    minus.add(-step, d);
    Vector difference = residual(plus);
    difference -= residual(minus);
    difference /= 2. * step;
    difference -= product;
    EXPECT_GT(product.linfty_norm(), 0.);
    EXPECT_LT(difference.linfty_norm(), 1e-6 * product.linfty_norm());
  }



  TEST_P(SpatialContact, tangent_is_the_derivative_of_the_residual)
  {
    const auto space = block(6, example::equal_steps(0., 1.2, 5));
    const auto ball =
      std::make_shared<example::Ball>(Point<3>(0.9, 0.7, 0.96), 2.);
    for (const std::shared_ptr<const RigidObstacle<3>> &obstacle :
         {std::shared_ptr<const RigidObstacle<3>>(ball),
          std::shared_ptr<const RigidObstacle<3>>(
            std::make_shared<Extruded>(wave()))})
      {
        ContactAssembler<3> contact(
          space, {}, Edge::top, obstacle, contact_options(interface, 1e6));
        expect_exact_tangent(contact, 3 * space->n_functions());
      }
  }



  TEST_P(SpatialContact, force_is_the_sum_of_the_nodal_forces)
  {
    const auto          space = block(6, example::equal_steps(0., 1.2, 5));
    ContactAssembler<3> contact(
      space,
      {},
      Edge::top,
      std::make_shared<example::Ball>(Point<3>(0.9, 0.7, 0.93), 2.),
      contact_options(interface, 1e6));
    set_strength(contact, 1e4);
    Vector u(3 * space->n_functions()), R(u.size());
    contact.add(u, R, nullptr);
    accept(contact);
    set_strength(contact, 1e4);
    for (unsigned int a = 0; a < space->n_functions(); ++a)
      {
        u(3 * a)     = 0.02;
        u(3 * a + 1) = -0.01;
      }
    R = 0.;
    contact.add(u, R, nullptr);
    Tensor<1, 3> sum;
    for (unsigned int i = 0; i < R.size(); ++i)
      sum[i % 3] -= R(i);
    const ContactState<3> state = contact.state();
    EXPECT_LT((state.force - sum).norm(), 1e-12 * sum.norm());
    if (contact.shear() == nullptr)
      return;
    // Against the slip, along both of its components.
    EXPECT_LT(state.shear_force[0], 0.);
    EXPECT_GT(state.shear_force[1], 0.);
    EXPECT_NEAR(-state.shear_force[1] / state.shear_force[0], 0.5, 0.05);
    for (const double work : contact.shear()->dissipation())
      EXPECT_GE(work, -1e-8);
  }



  // What is extruded along y and does not move along it has the forces of the
  // plane times its width.
  TEST_P(SpatialContact, extruded_tool_has_the_forces_of_the_plane)
  {
    const double width = 1.2;
    const auto   plane = std::make_shared<SplineSpace<2>>(
      KnotVector(2, example::equal_steps(0., 2., 8), true),
      KnotVector(2, example::equal_steps(0., 1., 2)));
    const auto          space = block(8, {0., 0.3, 0.5, width});
    ContactAssembler<2> flat(
      plane, {}, Edge::top, wave(), contact_options(interface, 1e6));
    ContactAssembler<3> contact(space,
                                {},
                                Edge::top,
                                std::make_shared<Extruded>(wave()),
                                contact_options(interface, 1e6));
    set_strength(flat, 1e4);
    set_strength(contact, 1e4);
    Vector u(2 * plane->n_functions()), u3(3 * space->n_functions());
    for (const double x : {0., 0.004, 0.03})
      {
        for (unsigned int a = 0; a < plane->n_functions(); ++a)
          {
            u(2 * a)     = x;
            u(2 * a + 1) = 0.01;
          }
        for (unsigned int a = 0; a < space->n_functions(); ++a)
          {
            u3(3 * a)     = x;
            u3(3 * a + 2) = 0.01;
          }
        Vector R(u.size()), R3(u3.size());
        flat.add(u, R, nullptr);
        contact.add(u3, R3, nullptr);
        const ContactState<2> s    = flat.state();
        const ContactState<3> s3   = contact.state();
        const double          size = width * s.force.norm();
        EXPECT_NEAR(s3.force[0], width * s.force[0], 1e-11 * size);
        EXPECT_NEAR(s3.force[1], 0., 1e-11 * size);
        EXPECT_NEAR(s3.force[2], width * s.force[1], 1e-11 * size);
        EXPECT_NEAR(s3.shear_force[0], width * s.shear_force[0], 1e-11 * size);
        EXPECT_NEAR(s3.contact_fraction, s.contact_fraction, 1e-12);
        EXPECT_NEAR(s3.max_pressure, s.max_pressure, 1e-9 * s.max_pressure);
        EXPECT_NEAR(s3.mean_gap, s.mean_gap, 1e-12);
        EXPECT_NEAR(s3.sticking, s.sticking, 1e-9);
        EXPECT_NEAR(contact.current_state(u3).length,
                    width * flat.current_state(u).length,
                    1e-12);
        accept(flat);
        accept(contact);
        set_strength(flat, 1e4);
        set_strength(contact, 1e4);
      }
  }



  TEST(SheetObstacle, of_an_extruded_curve_has_the_gap_of_the_curve)
  {
    const SplineCurve curve = interpolate_periodic_function(
      [](const double x) { return 1. + 0.05 * std::sin(M_PI * x); },
      0.,
      2.,
      24,
      3);
    const CurveObstacle plane(curve, CurveSide::right);
    const SheetObstacle sheet(extrude(curve, 1.2, 6));
    for (const Point<3> &x : {Point<3>(0.3, 0.1, 0.9),
                              Point<3>(1.1, 0.9, 1.02),
                              Point<3>(1.7, 1.5, 0.95)})
      {
        Point<1>          hint(x[0]);
        Point<2>          place(x[0], x[1]);
        const GapPoint<2> a = plane.gap(Point<2>(x[0], x[2]), hint);
        const GapPoint<3> b = sheet.gap(x, place);
        EXPECT_NEAR(b.gap, a.gap, 1e-12);
        EXPECT_NEAR(b.normal[0], a.normal[0], 1e-12);
        EXPECT_NEAR(b.normal[1], 0., 1e-12);
        EXPECT_NEAR(b.normal[2], a.normal[1], 1e-12);
        EXPECT_NEAR(place[0], hint[0], 1e-9);
        // One direction bends as the curve, the other one does not.
        const unsigned int bent =
          std::abs(b.curvature[0]) > std::abs(b.curvature[1]) ? 0 : 1;
        EXPECT_NEAR(b.curvature[bent], a.curvature[0], 1e-8);
        EXPECT_NEAR(b.curvature[1 - bent], 0., 1e-10);
        EXPECT_NEAR(std::abs(b.direction[1 - bent][1]), 1., 1e-10);
        EXPECT_NEAR(b.normal * b.direction[0], 0., 1e-12);
        EXPECT_NEAR(b.normal * b.direction[1], 0., 1e-12);
      }
  }



  INSTANTIATE_TEST_SUITE_P(
    Laws,
    SpatialContact,
    testing::Combine(testing::Values(ContactFormulation::mortar,
                                     ContactFormulation::gauss_point),
                     testing::Values(InterfaceShear::none,
                                     InterfaceShear::coulomb,
                                     InterfaceShear::shear_factor,
                                     InterfaceShear::limited_coulomb,
                                     InterfaceShear::wanheim_bay)));
} // namespace
