#include <asperity/constitutive/hyperelasticity.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact_examples.h"

namespace
{
  using namespace asperity;
  using dealii::Point;
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;

  /** A ball above its lowest point. */
  class Ball : public RigidObstacle<3>
  {
  public:
    Ball(const Point<3> &lowest, const double radius)
      : lowest(lowest)
      , radius(radius)
    {}

    GapPoint<3>
    gap(const Point<3> &x, Point<2> &) const override
    {
      const Tensor<1, 3> s = x - lowest;
      Tensor<1, 3>       from_center(s);
      from_center[2] -= radius;
      const double distance = from_center.norm();
      GapPoint<3>  gap;
      gap.gap    = (s.norm_square() - 2. * radius * s[2]) / (distance + radius);
      gap.normal = from_center / distance;
      Tensor<1, 3> along;
      along[1]         = 1.;
      gap.direction[0] = along - (along * gap.normal) * gap.normal;
      gap.direction[0] /= gap.direction[0].norm();
      gap.direction[1] = cross_product_3d(gap.normal, gap.direction[0]);
      gap.curvature    = {{1. / radius, 1. / radius}};
      return gap;
    }

  private:
    Point<3> lowest;
    double   radius;
  };

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

  struct Interface
  {
    ContactFormulation formulation;
    InterfaceShear     law;
  };

  ContactOptions
  contact_options(const Interface &interface)
  {
    ContactOptions options;
    options.formulation                    = interface.formulation;
    options.penalty                        = 1e6;
    options.interface.stick_penalty        = 1.;
    options.interface.law                  = interface.law;
    options.interface.friction_coefficient = 0.3;
    options.interface.shear_factor         = 0.5;
    return options;
  }

  template <int dim>
  void
  set_strength(ContactAssembler<dim> &contact, const double k)
  {
    const std::size_t n = contact.pressure().size();
    if (contact.shear() != nullptr)
      contact.shear()->set_interface(std::vector<double>(n, k),
                                     std::vector<double>(n, 0.));
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
    const auto ball  = std::make_shared<Ball>(Point<3>(0.9, 0.7, 0.96), 2.);
    for (const std::shared_ptr<const RigidObstacle<3>> &obstacle :
         {std::shared_ptr<const RigidObstacle<3>>(ball),
          std::shared_ptr<const RigidObstacle<3>>(
            std::make_shared<Extruded>(wave()))})
      {
        ContactAssembler<3> contact(
          space, {}, Edge::top, obstacle, contact_options(interface));
        expect_exact_tangent(contact, 3 * space->n_functions());
      }
  }



  TEST_P(SpatialContact, force_is_the_sum_of_the_nodal_forces)
  {
    const auto          space = block(6, example::equal_steps(0., 1.2, 5));
    ContactAssembler<3> contact(space,
                                {},
                                Edge::top,
                                std::make_shared<Ball>(Point<3>(0.9, 0.7, 0.93),
                                                       2.),
                                contact_options(interface));
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
      plane, {}, Edge::top, wave(), contact_options(interface));
    ContactAssembler<3> contact(space,
                                {},
                                Edge::top,
                                std::make_shared<Extruded>(wave()),
                                contact_options(interface));
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



  /** A quarter of an elastic block under a ball that presses on its corner,
   *  refined there. Lengths in units of the block's edge. */
  struct QuarterOfBlock
  {
    QuarterOfBlock(const double radius, const double contact_radius)
      : space(std::make_shared<SplineSpace<3>>(std::array<KnotVector, 3>{
          {KnotVector(2, example::equal_steps(0., 1., 5)),
           KnotVector(2, example::equal_steps(0., 1., 5)),
           KnotVector(2, example::equal_steps(-1., 0., 5))}}))
      , law(std::make_shared<NeoHooke>(elasticity()))
      , u(0)
    {
      for (unsigned int level = 1; level <= 4; ++level)
        {
          const double reach =
            std::max(1.3 * contact_radius, 0.8 * std::pow(0.5, level));
          space->refine_to_level(level,
                                 [&](const Point<3> &low,
                                     const Point<3> &high) {
                                   return std::hypot(low[0], low[1]) < reach &&
                                          high[2] > -0.6 * reach;
                                 });
        }
      ContactOptions options;
      options.penalty = 3e9;
      solid =
        std::make_unique<SolidAssembler<3>>(space, PatchGeometry<3>(), law);
      contact =
        std::make_unique<ContactAssembler<3>>(space,
                                              PatchGeometry<3>(),
                                              Edge::top,
                                              std::make_shared<Ball>(Point<3>(),
                                                                     radius),
                                              options);
      dealii::AffineConstraints<double>                constraints;
      const std::vector<std::pair<Edge, unsigned int>> held = {
        {Edge::left, 0}, {Edge::front, 1}, {Edge::bottom, 2}};
      for (const auto &[face, component] : held)
        for (const unsigned int a : space->edge_functions(face))
          constraints.add_line(displacement_dof<3>(a, component));
      constraints.close();
      u.reinit(3 * space->n_functions());
      equilibrium =
        std::make_unique<Equilibrium>(u.size(),
                                      std::vector<ForceTerm *>{solid.get(),
                                                               contact.get()},
                                      constraints,
                                      DirectSolverKind::cholmod);
    }

    static ElasticParameters
    elasticity()
    {
      ElasticParameters parameters;
      parameters.young_modulus = 1e6;
      parameters.poisson_ratio = 0.3;
      return parameters;
    }

    /** @return the force of the whole block */
    double
    press(const double depth)
    {
      Tensor<1, 3> offset;
      offset[2] = -depth;
      contact->set_obstacle_offset(offset);
      NewtonOptions options;
      options.tolerance          = 1e-4;
      options.maximum_iterations = 60;
      NewtonStatistics        statistics;
      const ConvergenceReport report =
        newton(*equilibrium, u, options, statistics);
      EXPECT_TRUE(report.converged) << report.reason;
      return -4. * contact->state().force[2];
    }

    std::shared_ptr<SplineSpace<3>>      space;
    std::shared_ptr<const MaterialLaw>   law;
    std::unique_ptr<SolidAssembler<3>>   solid;
    std::unique_ptr<ContactAssembler<3>> contact;
    std::unique_ptr<Equilibrium>         equilibrium;
    Vector                               u;
  };



  // H. Hertz: a^3 = 3 F R/(4 E*), p0 = 3 F/(2 pi a^2), and
  // p^2 = p0^2 (1 - r^2/a^2), of which a line through p^2 over r^2 tells p0 and
  // a; K. L. Johnson, Contact Mechanics (1985), section 4.2.
  TEST(SpatialHertz, ball_presses_on_a_block_as_on_a_half_space)
  {
    const double   radius = 2., a_wanted = 0.1;
    QuarterOfBlock block(radius, a_wanted);
    const double   E_star = 1e6 / (1. - 0.09);
    const double   force  = block.press(a_wanted * a_wanted / radius);
    const double   a      = std::cbrt(0.75 * force * radius / E_star);
    const double   p0     = 1.5 * force / (M_PI * a * a);
    double         n = 0., x = 0., y = 0., xx = 0., xy = 0.;
    const auto    &points = block.contact->positions();
    for (std::size_t q = 0; q < points.size(); ++q)
      {
        const double r = std::hypot(points[q][0], points[q][1]);
        if (r > 0.8 * a)
          continue;
        const double p = block.contact->pressure()[q],
                     w = block.contact->table().JxW[q];
        n += w;
        x += w * r * r;
        y += w * p * p;
        xx += w * r * r * r * r;
        xy += w * r * r * p * p;
      }
    const double slope = (n * xy - x * y) / (n * xx - x * x);
    const double level = (y - slope * x) / n;
    EXPECT_NEAR(std::sqrt(level), p0, 0.01 * p0);
    EXPECT_NEAR(std::sqrt(-level / slope), a, 0.01 * a);
    EXPECT_NEAR(a, a_wanted, 0.1 * a_wanted);
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
