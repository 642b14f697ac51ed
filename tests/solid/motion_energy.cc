#include <asperity/solid/motion_energy.h>
#include <asperity/time_integration/generalized_alpha.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <gtest/gtest.h>

using namespace asperity;

namespace
{
  constexpr double stiffness = 9., mass = 4.;

  /** A mass on a spring, in free motion seen from a frame that moves. */
  struct Oscillator
  {
    explicit Oscillator(const double rho)
      : motion(rho)
    {
      dealii::DynamicSparsityPattern one(1);
      one.add(0, 0);
      pattern.copy_from(one);
      matrix.reinit(pattern);
      matrix.set(0, 0, mass);
      motion.u.reinit(1);
      motion.v.reinit(1);
      motion.a.reinit(1);
      motion.v(0) = 0.3;
    }

    double
    total() const
    {
      return 0.5 * (mass * motion.v(0) * motion.v(0) +
                    stiffness * motion.u(0) * motion.u(0));
    }

    MotionEnergy::End
    end() const
    {
      MotionEnergy::End end{motion.u, motion.v, motion.u};
      end.forces *= -stiffness;
      return end;
    }

    void
    step(const double dt)
    {
      const MotionEnergy::End before = end();
      // m (m_f u + b) + (1 - alpha_f) k u + alpha_f k u_n = 0
      dealii::Vector<double> u = motion.constant(dt);
      u *= -mass;
      u.add(-motion.alpha_f() * stiffness, motion.u);
      u /= mass * motion.mass_factor(dt) + (1. - motion.alpha_f()) * stiffness;
      motion.advance(u, dt);
      energy.add(matrix, before, end());
    }

    GeneralizedAlpha             motion;
    dealii::SparsityPattern      pattern;
    dealii::SparseMatrix<double> matrix;
    MotionEnergy                 energy;
  };
} // namespace

TEST(MotionEnergy, of_a_spring_is_what_damping_takes)
{
  for (const double rho : {0., 0.5, 0.8, 1.})
    {
      Oscillator   oscillator(rho);
      const double start = oscillator.total();
      for (unsigned int i = 0; i < 40; ++i)
        oscillator.step(0.5);
      // The work of a linear force is that of the trapezoidal rule.
      EXPECT_NEAR(oscillator.energy.lost,
                  start - oscillator.total(),
                  1e-13 * start);
      if (rho == 1.)
        {
          EXPECT_NEAR(oscillator.energy.lost, 0., 1e-13 * start);
        }
      else
        {
          EXPECT_GT(oscillator.energy.lost, 0.);
        }
      EXPECT_DOUBLE_EQ(oscillator.energy.start, start); // all of it is kinetic
      EXPECT_LE(oscillator.energy.change, start);
    }
}

TEST(MotionEnergy, warns_of_a_loss_beside_motion_and_friction)
{
  MotionEnergy energy;
  energy.change = 1.;
  energy.lost   = 0.03;
  EXPECT_EQ(energy.warning(0.), "");
  energy.lost = 0.12;
  EXPECT_EQ(energy.warning(0.).find(
              "The time steps have taken away 12 % of the energy"),
            0u);
  EXPECT_NE(energy.warning(0.).find("raise Protocol/Ramp steps"),
            std::string::npos);
  EXPECT_EQ(energy.warning(3.), ""); // 3 %
  EXPECT_EQ(MotionEnergy().warning(0.), "");
}
