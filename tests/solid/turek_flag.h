#ifndef asperity_tests_solid_turek_flag_h
#define asperity_tests_solid_turek_flag_h

#include <algorithm>

#include "motion.h"

namespace loaded_solid
{
  /**
   * The elastic flag of S. Turek, J. Hron (Proposal for numerical benchmarking
   * of fluid-structure interaction, 2006) under its own weight: 0.35 x 0.02 m,
   * its left end on the cylinder of radius 0.05 m around (0.2, 0.2).
   * @param shear_modulus 0.5e6 Pa in CSM1 and CSM3, 2e6 Pa in CSM2
   */
  inline std::unique_ptr<Body>
  turek_flag(const unsigned int degree,
             const unsigned int n_x,
             const unsigned int n_y,
             const double       shear_modulus)
  {
    MaterialParameters material;
    material.choose(StVenantKirchhoffParameters());
    material.elasticity.density       = 1000.;
    material.elasticity.poisson_ratio = 0.4;
    material.elasticity.young_modulus = 2. * 1.4 * shear_modulus;
    // finer towards the cylinder, where the corners are
    auto body = std::make_unique<Body>(
      make_space(degree, graded_spans(n_x, 4.), equal_spans(n_y)),
      [](const Point<2> &xi) {
        const double y   = 0.19 + 0.02 * xi[1];
        const double arc = 0.2 + std::sqrt(0.05 * 0.05 - (y - 0.2) * (y - 0.2));
        return Point<2>(arc + xi[0] * (0.6 - arc), y);
      },
      material.make_law());
    body->clamp(Edge::left);
    Tensor<1, 2> weight;
    weight[1] = -2. * 1000.;
    body->solid.add_body_force(weight, body->load);
    return body;
  }

  /** Displacement [m] of the middle of the free end, point A = (0.6, 0.2). */
  inline Tensor<1, 2>
  flag_tip(const Body &flag)
  {
    return flag.displacement({1., 0.5});
  }

  /** CSM1 and CSM2. */
  inline Tensor<1, 2>
  hanging_flag_tip(const unsigned int degree,
                   const unsigned int n_x,
                   const unsigned int n_y,
                   const double       shear_modulus)
  {
    auto flag = turek_flag(degree, n_x, n_y, shear_modulus);
    flag->solve(1e-7); // of a weight of 14 N/m
    return flag_tip(*flag);
  }

  /** Strain energy [J/m] of St. Venant and Kirchhoff, in the flag of CSM3. */
  inline double
  stored_energy(const Body &flag)
  {
    const double         mu = 0.5e6, lambda = 2. * mu * 0.4 / (1. - 2. * 0.4);
    const BasisTable<2> &table  = flag.solid.table();
    double               energy = 0.;
    for (const auto &entry : table.elements)
      {
        const ElementView<2> element(table, entry);
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          {
            Tensor<2, 2> F;
            F[0][0] = F[1][1] = 1.;
            add_gradient(element, q, flag.u, F);
            Tensor<2, 2> E = 0.5 * transpose(F) * F;
            E[0][0] -= 0.5;
            E[1][1] -= 0.5;
            energy +=
              (0.5 * lambda * trace(E) * trace(E) + mu * scalar_product(E, E)) *
              element.JxW(q);
          }
      }
    return energy;
  }

  /** What is known of the motion of a flag after every step. */
  struct FlagMotion
  {
    std::vector<Tensor<1, 2>> tip; ///< displacement [m]

    /** Largest change of kinetic, stored and potential energy together, over
     *  the largest work of the weight. */
    double energy_error = 0.;
  };

  /** CSM3, from rest at t = 0. */
  inline FlagMotion
  swinging_flag(const unsigned int degree,
                const unsigned int n_x,
                const unsigned int n_y,
                const double       dt,
                const double       end_time,
                const double       rho)
  {
    auto   flag = turek_flag(degree, n_x, n_y, 0.5e6);
    Motion motion(*flag, rho);
    motion.start_with_load(1e-8);
    FlagMotion         result;
    double             largest_error = 0., largest_work = 0.;
    const unsigned int n = std::lround(end_time / dt);
    result.tip.resize(1);
    for (unsigned int i = 0; i < n; ++i)
      {
        motion.step(dt, 1e-7);
        result.tip.push_back(flag_tip(*flag));
        const double work   = flag->load * flag->u;
        const double energy = motion.kinetic_energy() + stored_energy(*flag);
        largest_work        = std::max(largest_work, work);
        largest_error       = std::max(largest_error, std::abs(energy - work));
      }
    result.energy_error = largest_error / largest_work;
    return result;
  }

  /** Half the sum and half the difference of the extremes of a signal. */
  struct Swing
  {
    double mean, amplitude; ///< [m]
  };

  /**
   * The swing of one component over the samples [begin, end), whose neighbours
   * must exist; extremes are the vertices of parabolas through three samples.
   */
  inline Swing
  swing_of(const std::vector<Tensor<1, 2>> &tip,
           const unsigned int               component,
           const unsigned int               begin,
           const unsigned int               end)
  {
    double low = INFINITY, high = -INFINITY;
    for (unsigned int i = begin; i < end; ++i)
      {
        const double before = tip[i - 1][component],
                     after  = tip[i + 1][component];
        const double slope  = 0.5 * (after - before);
        const double second = after - 2. * tip[i][component] + before;
        double       value  = tip[i][component];
        if (std::abs(slope) <= std::abs(second))
          value -= 0.5 * slope * slope / second;
        low  = std::min(low, value);
        high = std::max(high, value);
      }
    return {0.5 * (high + low), 0.5 * (high - low)};
  }

  constexpr double flag_period = 0.91; ///< rounded down [s]

  /** The swing of the last period, as the benchmark reports it. */
  inline Swing
  last_swing(const std::vector<Tensor<1, 2>> &tip,
             const unsigned int               component,
             const double                     dt)
  {
    const unsigned int period = flag_period / dt + 2;
    return swing_of(tip, component, tip.size() - period, tip.size() - 1);
  }

  /** Mean of the swings of the whole periods of a run: higher modes, which
   *  nothing damps, shift the extremes of a single period to and fro. */
  inline Swing
  mean_swing(const std::vector<Tensor<1, 2>> &tip,
             const unsigned int               component,
             const double                     dt)
  {
    const unsigned int period    = std::lround(flag_period / dt);
    const unsigned int n_periods = (tip.size() - 2) / period;
    Swing              mean{0., 0.};
    for (unsigned int k = 0; k < n_periods; ++k)
      {
        const Swing swing =
          swing_of(tip, component, 1 + k * period, 1 + (k + 1) * period);
        mean.mean += swing.mean / n_periods;
        mean.amplitude += swing.amplitude / n_periods;
      }
    return mean;
  }

  /** Frequency [Hz] from the downward crossings of the mean deflection. */
  inline double
  swing_frequency(const std::vector<Tensor<1, 2>> &tip, const double dt)
  {
    const double        mean = mean_swing(tip, 1, dt).mean;
    std::vector<double> crossing;
    for (unsigned int i = 0; i + 1 < tip.size(); ++i)
      {
        const double a = tip[i][1] - mean, b = tip[i + 1][1] - mean;
        if (a > 0. && b <= 0.)
          crossing.push_back((i + a / (a - b)) * dt);
      }
    return (crossing.size() - 1.) / (crossing.back() - crossing.front());
  }
} // namespace loaded_solid

#endif
