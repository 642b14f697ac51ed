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
    material.law                      = MaterialLawName::st_venant_kirchhoff;
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
      make_material_law(material));
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

  struct Oscillation
  {
    double mean[2], amplitude[2]; ///< of the last period [m]
    double frequency;             ///< [Hz]
  };

  /** CSM3, from rest to the given time. */
  inline Oscillation
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
    std::vector<Tensor<1, 2>> tip(1);
    const unsigned int        n = std::lround(end_time / dt);
    for (unsigned int i = 0; i < n; ++i)
      {
        motion.step(dt, 1e-7);
        tip.push_back(flag_tip(*flag));
      }
    Oscillation        result;
    const unsigned int period = std::min<unsigned int>(n, 0.91 / dt + 2);
    for (unsigned int c = 0; c < 2; ++c)
      {
        double low = INFINITY, high = -INFINITY;
        // vertices of parabolas through three values
        for (unsigned int i = n - period + 1; i < n; ++i)
          {
            const double slope = 0.5 * (tip[i + 1][c] - tip[i - 1][c]);
            const double second =
              tip[i + 1][c] - 2. * tip[i][c] + tip[i - 1][c];
            double value = tip[i][c];
            if (std::abs(slope) <= std::abs(second))
              value -= 0.5 * slope * slope / second;
            low  = std::min(low, value);
            high = std::max(high, value);
          }
        if (n * dt < 1.)
          high = std::max(high, 0.); // the start from rest
        result.mean[c]      = 0.5 * (high + low);
        result.amplitude[c] = 0.5 * (high - low);
      }
    // downward crossings of the mean deflection
    std::vector<double> crossing;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double a = tip[i][1] - result.mean[1],
                     b = tip[i + 1][1] - result.mean[1];
        if (a > 0. && b <= 0.)
          crossing.push_back((i + a / (a - b)) * dt);
      }
    result.frequency =
      crossing.size() > 1 ?
        (crossing.size() - 1) / (crossing.back() - crossing.front()) :
        0.;
    return result;
  }
} // namespace loaded_solid

#endif
