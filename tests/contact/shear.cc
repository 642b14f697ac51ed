#include <asperity/constitutive/hyperelasticity.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

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

  constexpr double k = 2e4;

  class Shear : public testing::TestWithParam<
                  std::tuple<ContactFormulation, InterfaceShear>>
  {
  protected:
    Interface interface {
      std::get<0>(GetParam()), std::get<1>(GetParam())
    };
  };

  /** A wave that half of an edge touches, at two displacements in turn. */
  struct WavyEdge
  {
    explicit WavyEdge(const Interface &interface)
      : space(std::make_shared<SplineSpace<2>>(
          KnotVector(2, example::equal_steps(0., 2., 16), true),
          KnotVector(2, example::equal_steps(0., 1., 3))))
      , contact(space,
                {},
                Edge::top,
                example::periodic_tool(
                  [](const double x) { return 1. + 0.05 * std::sin(M_PI * x); },
                  2.,
                  24),
                contact_options(interface, 1e6))
      , u(2 * space->n_functions())
      , direction(u)
    {
      set_strength(contact, 1e4);
      std::mt19937                           generator(5);
      std::uniform_real_distribution<double> uniform(-1., 1.);
      for (unsigned int i = 0; i < u.size(); ++i)
        {
          u(i)         = 0.004 * uniform(generator);
          direction(i) = uniform(generator);
        }
      residual(u);
      contact.shear()->accept();
      set_strength(contact, 1e4); // with the pressures of that step
      for (unsigned int i = 0; i < u.size(); ++i)
        u(i) += 0.008 * uniform(generator);
    }

    Vector
    residual(const Vector &at)
    {
      Vector R(at.size());
      contact.add(at, R, nullptr);
      return R;
    }

    std::shared_ptr<const SplineSpace<2>> space;
    ContactAssembler<2>                   contact;
    Vector                                u, direction;
  };

  TEST_P(Shear, tangent_is_the_derivative_of_the_residual_in_stick_and_slip)
  {
    WavyEdge                       edge(interface);
    dealii::DynamicSparsityPattern couplings(edge.u.size());
    edge.contact.add_couplings(couplings);
    dealii::SparsityPattern pattern;
    pattern.copy_from(couplings);
    dealii::SparseMatrix<double> tangent(pattern);
    Vector R(edge.u.size()), product(edge.u.size()), rest(edge.u.size());
    edge.contact.add(edge.u, R, &tangent);
    tangent.vmult(product, edge.direction);
    edge.contact.unsymmetric_tangent()->vmult(rest, edge.direction);
    EXPECT_GT(rest.linfty_norm(), 0.);
    product += rest;
    const std::vector<double> sticking = edge.contact.shear()->sticking();
    EXPECT_GT(*std::max_element(sticking.begin(), sticking.end()), 0.9);
    double sliding = 0.;
    for (unsigned int q = 0; q < sticking.size(); ++q)
      if (sticking[q] < 0.1)
        sliding =
          std::max(sliding, std::abs(edge.contact.shear()->at_points()[q]));
    EXPECT_GT(sliding, 0.);

    const double step = 1e-8;
    Vector       plus(edge.u), minus(edge.u);
    plus.add(step, edge.direction);
    minus.add(-step, edge.direction);
    Vector difference = edge.residual(plus);
    EXPECT_EQ(edge.contact.shear()->sticking(), sticking);
    difference -= edge.residual(minus);
    EXPECT_EQ(edge.contact.shear()->sticking(), sticking);
    difference /= 2. * step;
    difference -= product;
    EXPECT_LT(difference.linfty_norm(), 1e-6 * product.linfty_norm());
  }

  TEST_P(Shear, force_is_the_sum_of_the_nodal_forces)
  {
    WavyEdge     edge(interface);
    const Vector R = edge.residual(edge.u);
    Tensor<1, 2> sum;
    for (unsigned int i = 0; i < R.size(); ++i)
      sum[i % 2] -= R(i);
    const ContactState<2> state = edge.contact.state();
    EXPECT_LT((state.force - sum).norm(), 1e-12 * sum.norm());
    EXPECT_GT(state.shear_force.norm(), 1e-3 * sum.norm());
    for (const double work : edge.contact.shear()->dissipation())
      EXPECT_GE(work, -1e-12 * k);
  }

  /** A block 2 x 1, periodic, under a flat ceiling that has come down. */
  struct Block
  {
    explicit Block(const Interface &interface)
      : problem(std::make_shared<SplineSpace<2>>(
                  KnotVector(2, example::equal_steps(0., 2., 8), true),
                  KnotVector(2, example::equal_steps(0., 1., 4))),
                std::make_shared<NeoHooke>(example::elasticity()),
                std::make_shared<example::Ceiling>(1.),
                contact_options(interface, 1e8))
    {
      set_strength(*problem.contact, k);
      problem.options.tolerance = 1e-6;
      EXPECT_TRUE(problem.solve(0., -0.03).converged);
      problem.contact->shear()->accept();
    }

    /** Moves the ceiling to x and returns the force on the block over 2. */
    double
    drag_to(const double x)
    {
      EXPECT_TRUE(problem.solve(x, -0.03).converged) << problem.last.reason;
      for (unsigned int q = 0; q < problem.contact->table().JxW.size(); ++q)
        dissipated += problem.contact->shear()->dissipation()[q] *
                      problem.contact->table().JxW[q];
      problem.contact->shear()->accept();
      return problem.contact->state().force[0] / 2.;
    }

    double
    pressure() const
    {
      return problem.force() / 2.;
    }

    /** What a part of the edge bears at most. */
    double
    limit(const InterfaceShear law) const
    {
      InterfaceParameters parameters;
      parameters.law                  = law;
      parameters.friction_coefficient = 0.3;
      parameters.shear_factor         = 0.5;
      return InterfaceLaw(parameters).strength({pressure(), k}).value;
    }

    example::ContactProblem problem;
    double                  dissipated = 0.;
  };

  // Simple shear of a neo-Hooke block: tau = G times the shift of its top over
  // its reference height, whatever its thickness.
  TEST_P(Shear, a_pressed_block_sticks_and_then_slides_at_the_limit_of_the_law)
  {
    Block        block(interface);
    const double G     = example::elasticity().shear_modulus();
    const double limit = block.limit(interface.law);
    ASSERT_GT(limit, 1e3);
    const double stick = 0.5 * limit / G;
    // The penalty lets the edge lag by tau/epsilon_t.
    const double lag = 0.5 * limit / 1e8;
    EXPECT_NEAR(block.drag_to(stick + lag), 0.5 * limit, 1e-6 * limit);
    EXPECT_EQ(block.problem.contact->state().sticking, 1.);
    for (const double slip : {0.01, 0.1, 1.3})
      {
        EXPECT_NEAR(block.drag_to(limit / G + slip), limit, 1e-8 * limit);
        EXPECT_EQ(block.problem.contact->state().sticking, 0.);
      }
  }

  TEST_P(Shear, reversal_unloads_the_block_before_it_slides_back)
  {
    Block        block(interface);
    const double G     = example::elasticity().shear_modulus();
    const double limit = block.limit(interface.law);
    block.drag_to(0.2);
    // The block and the penalty give way.
    const double turn = 0.2 - limit / G - limit / 1e8;
    EXPECT_NEAR(block.drag_to(turn), 0., 1e-6 * limit);
    EXPECT_EQ(block.problem.contact->state().sticking, 1.);
    EXPECT_NEAR(block.drag_to(-0.2), -limit, 1e-8 * limit);
  }

  TEST_P(Shear, work_of_a_cycle_is_what_the_interface_dissipates)
  {
    Block        block(interface);
    double       work = 0., x = 0., force = 0.;
    const double step = 0.005;
    const auto   go   = [&](const double to) {
      const int n = std::lround(std::abs(to - x) / step);
      for (int i = 1; i <= n; ++i)
        {
          const double next       = x + (to - x) / (n - i + 1);
          const double next_force = 2. * block.drag_to(next);
          work += 0.5 * (force + next_force) * (next - x);
          x     = next;
          force = next_force;
        }
    };
    go(0.1);
    block.dissipated = work = 0.;
    go(-0.1);
    go(0.1);
    // A step that turns from stick to slip is a corner of the trapezoidal rule.
    EXPECT_NEAR(work, block.dissipated, 0.02 * work);
    EXPECT_GT(work, 0.);
  }

  // What has borne p touches the less, the wider it is open: 1 + (p/k)^2 -
  // g/delta, here 5 - g/delta, within 0 and 1; what has borne nothing 1 -
  // g/delta.
  TEST(ShearOfOpenGap, falls_with_the_gap_from_what_the_pressure_has_closed)
  {
    for (const auto formulation :
         {ContactFormulation::mortar, ContactFormulation::gauss_point})
      for (const double p : {1e4, 0.})
        {
          const double penalty = 1e6, strength = 5e3, slip = 0.1;
          const auto   space = std::make_shared<SplineSpace<2>>(
            KnotVector(2, example::equal_steps(0., 2., 16), true),
            KnotVector(2, example::equal_steps(0., 1., 3)));
          const ContactOptions options =
            contact_options({formulation, InterfaceShear::shear_factor},
                            penalty);
          ContactAssembler<2> contact(space,
                                      {},
                                      Edge::top,
                                      std::make_shared<example::Ceiling>(1.),
                                      options);
          Vector              u(2 * space->n_functions()), R(u.size());
          const auto          move = [&](const double x, const double y) {
            for (unsigned int i = 0; i < u.size(); i += 2)
              {
                u(i)     = x;
                u(i + 1) = y;
              }
            R = 0.;
            contact.add(u, R, nullptr);
          };
          set_strength(contact, strength);
          move(0., p / penalty);
          contact.shear()->accept();
          set_strength(contact, strength);
          const double delta  = options.interface.transition * 2. / 16.;
          const double closed = p > 0. ? 4. : 0.;
          for (const double open : {-0.5, 0., 0.25, 0.5, 1., 1.5})
            {
              move(slip, -(closed + open) * delta);
              const double t    = std::clamp(1. - open, 0., 1.);
              const double part = t * t * (3. - 2. * t);
              for (const double tau : contact.shear()->at_points())
                EXPECT_NEAR(std::abs(tau),
                            0.5 * strength * part,
                            1e-8 * strength)
                  << p << " " << open;
            }
        }
  }

  std::string
  name_of_case(
    const testing::TestParamInfo<std::tuple<ContactFormulation, InterfaceShear>>
      &info)
  {
    const std::string laws[] = {
      "None", "Coulomb", "ShearFactor", "LimitedCoulomb", "WanheimBay"};
    return std::string(std::get<0>(info.param) == ContactFormulation::mortar ?
                         "Mortar" :
                         "GaussPoint") +
           laws[static_cast<unsigned int>(std::get<1>(info.param))];
  }

  INSTANTIATE_TEST_SUITE_P(
    ,
    Shear,
    testing::Combine(testing::Values(ContactFormulation::mortar,
                                     ContactFormulation::gauss_point),
                     testing::Values(InterfaceShear::coulomb,
                                     InterfaceShear::shear_factor,
                                     InterfaceShear::limited_coulomb,
                                     InterfaceShear::wanheim_bay)),
    name_of_case);
  // R. D. Mindlin, J. Appl. Mech. 16 (1949) 259: a cylinder under a tangential
  // force Q < mu P sticks on |x| < c with c^2/a^2 = 1 - Q/(mu P).
  TEST(ShearOfHertzContact, sticks_where_cattaneo_and_mindlin_say)
  {
    example::Discretization discretization;
    discretization.penalty_factor                 = 10.;
    discretization.poisson_ratio                  = 0.49; // uncoupled at 1/2
    discretization.interface.law                  = InterfaceShear::coulomb;
    discretization.interface.friction_coefficient = 0.2;
    discretization.interface.stick_penalty        = 1.; // what sticks is rigid
    example::HalfPlane body  = example::hertz(discretization);
    const double       depth = body.problem->press(body.force, body.depth);
    ASSERT_TRUE(std::isfinite(depth)) << body.problem->last.reason;
    ContactAssembler<2> &contact = *body.problem->contact;
    // What the pressing has left behind is not of their theory.
    contact.shear()->accept();
    ShearTraction<2>::History history = contact.shear()->history();
    history.tractions.assign(history.tractions.size(), 0.);
    contact.shear()->set_history(history);
    const double full = 0.2 * body.force;
    for (double Q = 0., x = 0.; Q < 0.5 * full;)
      {
        x += 0.03 * body.depth;
        ASSERT_TRUE(body.problem->solve(x, -depth).converged)
          << body.problem->last.reason;
        contact.shear()->accept();
        Q = contact.state().shear_force[0];
      }
    const double Q = contact.state().shear_force[0];
    const double c = std::sqrt(1. - Q / full);
    ASSERT_GT(c, 0.4);
    // The mean of both sides: what is odd comes from the tilt of the edge under
    // its own shear, which their theory leaves out.
    const std::vector<double> &shear = contact.shear()->at_points();
    const unsigned int         n     = shear.size();
    double                     error = 0., norm = 0., stuck = 0.;
    for (unsigned int q = 0; q < n; ++q)
      {
        const double x     = contact.table().position[q][0];
        const double JxW   = contact.table().JxW[q];
        const double exact = 0.2 * (example::hertz_pressure(body, x) -
                                    c * example::hertz_pressure(body, x / c));
        const double mean  = -0.5 * (shear[q] + shear[n - 1 - q]);
        error += std::pow(mean - exact, 2) * JxW;
        norm += exact * exact * JxW;
        stuck += contact.shear()->sticking()[q] * JxW;
      }
    EXPECT_NEAR(0.5 * stuck, c, 2. * body.element_length);
    EXPECT_LT(std::sqrt(error / norm), 0.05);
  }
} // namespace
