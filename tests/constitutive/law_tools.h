#ifndef asperity_tests_constitutive_law_tools_h
#define asperity_tests_constitutive_law_tools_h

#include <asperity/constitutive/material_parameters.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace asperity::law_tools
{
  /** F of pure stretch in the plane, isochoric, with equivalent strain e. */
  inline PlaneTensor
  isochoric_stretch(const double e)
  {
    const double k = 0.5 * std::sqrt(3.) * e;
    return {{std::exp(k), 0., 0., std::exp(-k), 1.}};
  }



  inline MaterialResponse
  evaluate(const MaterialLaw   &law,
           const PlaneTensor   &F,
           const MaterialState &old = {},
           const double         dt  = 0.)
  {
    MaterialResponse response;
    law.evaluate(F, old, dt, true, response);
    return response;
  }



  /** sqrt(3/2) |dev(P F^T)|, from the definition. */
  inline double
  mises_of(const PlaneTensor &P, const PlaneTensor &F)
  {
    const double t11 = P[0] * F[0] + P[1] * F[1];
    const double t12 = P[0] * F[2] + P[1] * F[3];
    const double t22 = P[2] * F[2] + P[3] * F[3];
    const double t33 = P[4] * F[4];
    return std::sqrt(0.5 *
                       ((t11 - t22) * (t11 - t22) + (t22 - t33) * (t22 - t33) +
                        (t33 - t11) * (t33 - t11)) +
                     3. * t12 * t12);
  }



  inline double
  determinant(const std::array<double, 4> &Cp_inverse)
  {
    return (Cp_inverse[0] * Cp_inverse[1] - Cp_inverse[2] * Cp_inverse[2]) *
           Cp_inverse[3];
  }



  inline double
  largest(const PlaneTangent &tangent)
  {
    double value = 0.;
    for (const auto &row : tangent)
      for (const double entry : row)
        value = std::fmax(value, std::abs(entry));
    return value;
  }



  /**
   * Derivative at 0 of a function of the step by central differences,
   * extrapolated to step 0 (C. J. F. Ridders, Adv. Eng. Software 4 (1982) 75),
   * so that it is accurate both near a kink and far from it. The steps are
   * powers of two: adding them to a number of the order of 1 rounds nothing.
   */
  inline double
  derivative_at_zero(const std::function<double(double)> &f,
                     const double                         first_step)
  {
    constexpr int    n_rows    = 5;
    constexpr double reduction = 2.;
    double           table[n_rows][n_rows];
    double           best  = 0.;
    double           error = std::numeric_limits<double>::max();
    double           h     = std::exp2(std::floor(std::log2(first_step)));
    for (int row = 0; row < n_rows; ++row, h /= reduction)
      {
        table[row][0] = (f(h) - f(-h)) / (2. * h);
        double factor = reduction * reduction;
        for (int k = 1; k <= row; ++k, factor *= reduction * reduction)
          {
            table[row][k] =
              (factor * table[row][k - 1] - table[row - 1][k - 1]) /
              (factor - 1.);
            const double change =
              std::fmax(std::abs(table[row][k] - table[row][k - 1]),
                        std::abs(table[row][k] - table[row - 1][k - 1]));
            if (change <= error)
              {
                error = change;
                best  = table[row][k];
              }
          }
      }
    return best;
  }



  /**
   * The largest difference between the tangent of a law and finite
   * differences of its stress, relative to the largest entry; infinite if any
   * evaluation fails.
   */
  inline double
  tangent_error(const MaterialLaw   &law,
                const PlaneTensor   &F,
                const MaterialState &old,
                const double         dt,
                const double         first_step = 1e-4)
  {
    const MaterialResponse response = evaluate(law, F, old, dt);
    bool                   failed   = (response.status != LawStatus::ok);
    double                 error    = 0.;
    for (int row = 0; row < 5; ++row)
      for (int column = 0; column < 5; ++column)
        {
          const auto stress = [&](const double h) {
            PlaneTensor shifted = F;
            shifted[column] += h;
            MaterialResponse r;
            law.evaluate(shifted, old, dt, false, r);
            failed = failed || r.status != LawStatus::ok;
            return r.P[row];
          };
          const double difference = derivative_at_zero(stress, first_step);
          error =
            std::fmax(error,
                      std::abs(difference - response.tangent[row][column]));
          failed = failed || !std::isfinite(difference) ||
                   !std::isfinite(response.tangent[row][column]);
        }
    return failed ? std::numeric_limits<double>::infinity() :
                    error / largest(response.tangent);
  }



  /** Every law of the factory, with constants that show all of its terms. */
  inline std::vector<std::shared_ptr<const MaterialLaw>>
  all_laws()
  {
    std::vector<std::shared_ptr<const MaterialLaw>> laws;
    MaterialParameters                              parameters;
    parameters.hardening = {300e6, 500e6, 17., 1e8};
    for (const auto name : {MaterialLawName::johnson_cook,
                            MaterialLawName::saturation_hardening,
                            MaterialLawName::hencky,
                            MaterialLawName::neo_hooke,
                            MaterialLawName::st_venant_kirchhoff})
      {
        parameters.law = name;
        laws.push_back(make_material_law(parameters));
      }
    return laws;
  }



  /** Identity plus uniformly distributed noise. */
  class RandomDeformation
  {
  public:
    explicit RandomDeformation(const unsigned int seed)
      : generator(seed)
    {}

    PlaneTensor
    near(const PlaneTensor &F, const double size)
    {
      PlaneTensor result = F;
      for (double &component : result)
        component += size * distribution(generator);
      return result;
    }

    double
    number()
    {
      return distribution(generator);
    }

  private:
    std::mt19937                           generator;
    std::uniform_real_distribution<double> distribution{-1., 1.};
  };



  constexpr PlaneTensor identity = {{1., 0., 0., 1., 1.}};
} // namespace asperity::law_tools

#endif
