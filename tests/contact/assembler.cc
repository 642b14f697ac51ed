#include <asperity/splines/spline_fit.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact_problem.h"

namespace
{
  using namespace asperity;
  using dealii::Point;
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;

  constexpr double penalty = 300.;

  double
  tool_height(const double x)
  {
    return 0.99 + 0.05 * std::sin(M_PI * x + 0.4) +
           0.02 * std::cos(3. * M_PI * x);
  }

  SplineCurve
  tool_curve()
  {
    return interpolate_periodic_function(tool_height, 0., 2., 40, 4);
  }

  /** A curved edge, refined to one side, in contact with a flat or a wavy tool;
   *  one of the four of (formulation, tool). */
  class ContactTerm
    : public testing::TestWithParam<std::tuple<ContactFormulation, bool>>
  {
  protected:
    ContactTerm()
    {
      auto refined = std::make_shared<SplineSpace<2>>(
        KnotVector(2, example::equal_steps(0., 2., 8)),
        KnotVector(2, example::equal_steps(0., 1., 4)));
      refined->refine_to_level(1, [](const Point<2> &low, const Point<2> &) {
        return low[0] < 0.7 && low[1] > 0.7;
      });
      space    = refined;
      geometry = PatchGeometry<2>::from_map(*space, [](const Point<2> &p) {
        return Point<2>(p[0] + 0.05 * p[1] * p[1],
                        p[1] * (1. + 0.02 * p[0] * (2. - p[0])));
      });
      std::shared_ptr<const RigidObstacle<2>> obstacle;
      if (std::get<1>(GetParam()))
        obstacle =
          std::make_shared<CurveObstacle>(tool_curve(), CurveSide::right);
      else
        obstacle = std::make_shared<example::Ceiling>(1.01);
      ContactOptions options;
      options.formulation = std::get<0>(GetParam());
      options.penalty     = penalty;
      contact             = std::make_unique<ContactAssembler<2>>(
        space, geometry, Edge::top, obstacle, options);
      Tensor<1, 2> offset;
      offset[0] = 0.13;
      offset[1] = 0.01;
      contact->set_obstacle_offset(offset);

      u.reinit(2 * space->n_functions());
      direction.reinit(u);
      std::mt19937                           generator(3);
      std::uniform_real_distribution<double> uniform(-1., 1.);
      for (unsigned int i = 0; i < u.size(); ++i)
        {
          u(i)         = 0.004 * uniform(generator);
          direction(i) = uniform(generator);
        }
      std::vector<double> multipliers = contact->multipliers();
      for (double &lambda : multipliers)
        lambda = 1.5 * (1. + uniform(generator));
      contact->set_multipliers(multipliers);
    }

    Vector
    residual(const Vector &at)
    {
      Vector R(at.size());
      contact->add(at, R, nullptr);
      return R;
    }

    /** Pressures of the last evaluation: a value a function or a point. */
    std::vector<double>
    active_pressures()
    {
      const std::vector<double> multipliers = contact->multipliers();
      contact->augment();
      const std::vector<double> pressures = contact->multipliers();
      contact->set_multipliers(multipliers);
      return pressures;
    }

    std::vector<bool>
    active_set()
    {
      std::vector<bool> active;
      for (const double p : active_pressures())
        active.push_back(p > 0.);
      return active;
    }

    /** The potential in the class's documentation, from the gaps alone. */
    double
    potential(const Vector &at)
    {
      residual(at);
      const BasisTable<2>       &table  = contact->table();
      const std::vector<double> &lambda = contact->multipliers();
      double                     sum    = 0.;
      const auto add = [&](const double weight, const double l, double g) {
        const double p = std::max(0., l - penalty * g);
        sum += weight * p * p / (2. * penalty);
      };
      if (std::get<0>(GetParam()) == ContactFormulation::gauss_point)
        {
          for (unsigned int q = 0; q < table.JxW.size(); ++q)
            add(table.JxW[q], lambda[q], contact->gaps()[q].gap);
          return sum;
        }
      const auto          functions = space->edge_functions(Edge::top);
      std::vector<double> W(space->n_functions()), Wg(space->n_functions());
      for (const auto &element : table.elements)
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          for (unsigned int a = 0; a < element.functions.size(); ++a)
            {
              const unsigned int point = element.first_point + q;
              const double       NJ =
                element.values[q * element.functions.size() + a] *
                table.JxW[point];
              W[element.functions[a]] += NJ;
              Wg[element.functions[a]] += NJ * contact->gaps()[point].gap;
            }
      for (unsigned int i = 0; i < functions.size(); ++i)
        add(W[functions[i]], lambda[i], Wg[functions[i]] / W[functions[i]]);
      return sum;
    }

    std::shared_ptr<const SplineSpace<2>> space;
    PatchGeometry<2>                      geometry;
    std::unique_ptr<ContactAssembler<2>>  contact;
    Vector                                u, direction;
  };

  // x = A X with A = (1.4, 0.3; -0.2, 0.9): lengths along the edge, whose
  // tangent in the reference is (1, 0.04 (1 - xi)), change by |A t|/|t|.
  TEST_P(ContactTerm, stretch_is_that_of_an_affine_motion)
  {
    const auto motion =
      PatchGeometry<2>::from_map(*space, [](const Point<2> &p) {
        const double x = p[0] + 0.05 * p[1] * p[1],
                     y = p[1] * (1. + 0.02 * p[0] * (2. - p[0]));
        return p + Point<2>(0.4 * x + 0.3 * y, -0.2 * x - 0.1 * y);
      });
    for (unsigned int a = 0; a < space->n_functions(); ++a)
      for (unsigned int c = 0; c < 2; ++c)
        u(displacement_dof<2>(a, c)) = motion.offset[a][c];
    const std::vector<double> stretch = contact->stretch(u);
    for (unsigned int q = 0; q < stretch.size(); ++q)
      {
        const double slope = 0.04 * (1. - contact->table().parameter[q][0]);
        EXPECT_NEAR(stretch[q],
                    std::hypot(1.4 + 0.3 * slope, -0.2 + 0.9 * slope) /
                      std::hypot(1., slope),
                    1e-12);
      }
  }

  // Where everything touches, per present length: the pressure divided by the
  // stretch 1.4 of x = 1.4 X, and the stretched edge.
  TEST_P(ContactTerm, state_per_present_length_counts_the_stretch)
  {
    const auto motion =
      PatchGeometry<2>::from_map(*space, [](const Point<2> &p) {
        const double x = p[0] + 0.05 * p[1] * p[1],
                     y = p[1] * (1. + 0.02 * p[0] * (2. - p[0]));
        return p + Point<2>(0.4 * x, 0.4 * y);
      });
    for (unsigned int a = 0; a < space->n_functions(); ++a)
      for (unsigned int c = 0; c < 2; ++c)
        u(displacement_dof<2>(a, c)) = motion.offset[a][c];
    residual(u);
    const auto touches = contact->touching();
    ASSERT_GT(std::count(touches.begin(), touches.end(), true), 3);
    double length = 0., force = 0., largest = 0.;
    for (unsigned int q = 0; q < touches.size(); ++q)
      {
        length += touches[q] ? 1.4 * contact->table().JxW[q] : 0.;
        force += contact->pressure()[q] * contact->table().JxW[q];
        largest = std::max(largest, contact->pressure()[q]);
      }
    const CurrentContact now = contact->current_state(u);
    EXPECT_NEAR(now.length, length, 1e-12);
    EXPECT_NEAR(now.mean_pressure * length, force, 1e-12 * force);
    EXPECT_NEAR(now.max_pressure, largest / 1.4, 1e-12 * largest);
  }

  TEST_P(ContactTerm, residual_is_the_derivative_of_the_potential)
  {
    const double step   = 1e-5;
    const Vector R      = residual(u);
    const auto   active = active_set();
    Vector       plus(u), minus(u);
    plus.add(step, direction);
    minus.add(-step, direction);
    const double difference =
      (potential(plus) - potential(minus)) / (2. * step);
    EXPECT_NEAR(R * direction, difference, 1e-7 * R.l2_norm());
    // Some of the edge is in contact, some is not.
    EXPECT_GT(std::count(active.begin(), active.end(), true), 3);
    EXPECT_GT(std::count(active.begin(), active.end(), false), 1);
  }

  TEST_P(ContactTerm, tangent_is_the_derivative_of_the_residual)
  {
    dealii::DynamicSparsityPattern couplings(u.size());
    contact->add_couplings(couplings);
    dealii::SparsityPattern pattern;
    pattern.copy_from(couplings);
    dealii::SparseMatrix<double> tangent(pattern);
    Vector                       R(u.size()), product(u.size());
    contact->add(u, R, &tangent);
    const auto active = active_set();
    tangent.vmult(product, direction);

    const double step = 1e-6;
    Vector       plus(u), minus(u);
    plus.add(step, direction);
    minus.add(-step, direction);
    Vector difference = residual(plus);
    ASSERT_EQ(active_set(), active) << "the step crosses a kink";
    difference -= residual(minus);
    ASSERT_EQ(active_set(), active) << "the step crosses a kink";
    difference /= 2. * step;
    difference -= product;
    EXPECT_LT(difference.linfty_norm(), 1e-7 * product.linfty_norm());
    for (unsigned int i = 0; i < u.size(); ++i)
      for (auto entry = tangent.begin(i); entry != tangent.end(i); ++entry)
        ASSERT_NEAR(entry->value(),
                    tangent(entry->column(), i),
                    1e-12 * tangent.linfty_norm());
  }

  TEST_P(ContactTerm, forces_and_moments_on_body_and_obstacle_balance)
  {
    const Vector R = residual(u);
    // Coefficients of the reference positions: exact, as the map is the
    // identity plus an offset in the space.
    const auto X = space->project(
      [](const Point<2> &p) {
        return std::vector<double>{p[0], p[1]};
      },
      2);
    Tensor<1, 2> body_force;
    double       body_moment = 0., scale = 0.;
    for (unsigned int a = 0; a < space->n_functions(); ++a)
      {
        const Tensor<1, 2> f = Point<2>(-R(2 * a), -R(2 * a + 1));
        const double       x = X[0][a] + geometry.offset[a][0] + u(2 * a);
        const double       y = X[1][a] + geometry.offset[a][1] + u(2 * a + 1);
        body_force += f;
        body_moment += x * f[1] - y * f[0];
        scale += f.norm();
      }
    // On the obstacle, at the closest points, found anew.
    const ClosestPoint search(tool_curve(), CurveSide::right);
    const Tensor<1, 2> offset = Point<2>(0.13, 0.01);
    Tensor<1, 2>       obstacle_force;
    double             obstacle_moment = 0.;
    for (unsigned int q = 0; q < contact->positions().size(); ++q)
      {
        const Point<2> x = contact->positions()[q];
        Point<2>       foot(x[0], 1.01 + offset[1]);
        Tensor<1, 2>   normal = Point<2>(0., -1.);
        if (std::get<1>(GetParam()))
          {
            const Projection p = search.project(x - offset);
            foot               = p.point + offset;
            normal             = p.normal;
          }
        const Tensor<1, 2> f =
          -contact->pressure()[q] * contact->table().JxW[q] * normal;
        obstacle_force += f;
        obstacle_moment += foot[0] * f[1] - foot[1] * f[0];
      }
    ASSERT_GT(scale, 0.1);
    EXPECT_LT((body_force + obstacle_force).norm(), 1e-12 * scale);
    EXPECT_NEAR(body_moment, -obstacle_moment, 1e-12 * scale);
    EXPECT_LT((contact->state().force - body_force).norm(), 1e-12 * scale);
  }

  TEST_P(ContactTerm, no_force_acts_where_every_gap_is_open)
  {
    contact->set_multipliers(
      std::vector<double>(contact->multipliers().size()));
    Tensor<1, 2> offset;
    offset[1] = 0.2;
    contact->set_obstacle_offset(offset);
    EXPECT_EQ(residual(u).linfty_norm(), 0.);
    const ContactState<2> state = contact->state();
    EXPECT_EQ(state.contact_fraction, 0.);
    EXPECT_EQ(state.max_pressure, 0.);
    EXPECT_LT(state.max_penetration, 1e-300);
    EXPECT_GT(state.mean_gap, 0.05);
  }

  INSTANTIATE_TEST_SUITE_P(
    ,
    ContactTerm,
    testing::Combine(testing::Values(ContactFormulation::mortar,
                                     ContactFormulation::gauss_point),
                     testing::Bool()),
    [](const auto &info) {
      return std::string(std::get<0>(info.param) == ContactFormulation::mortar ?
                           "Mortar" :
                           "GaussPoint") +
             (std::get<1>(info.param) ? "OnWavyTool" : "OnFlatTool");
    });
} // namespace
