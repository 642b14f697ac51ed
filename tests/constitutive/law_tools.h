#ifndef asperity_tests_constitutive_law_tools_h
#define asperity_tests_constitutive_law_tools_h

#include <asperity/constitutive/material_parameters.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace asperity::law_tools
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  /** A step [s] that is short enough for the rate to count. */
  constexpr double short_step = 1e-7;

  /** A tensor of plane kinematics. */
  inline Tensor<2, 3>
  plane(const double xx,
        const double xy,
        const double yx,
        const double yy,
        const double zz)
  {
    Tensor<2, 3> F;
    F[0][0] = xx;
    F[0][1] = xy;
    F[1][0] = yx;
    F[1][1] = yy;
    F[2][2] = zz;
    return F;
  }



  /** Row and column of each component that plane kinematics has. */
  constexpr std::array<std::array<int, 2>, 5> components = {
    {{{0, 0}}, {{0, 1}}, {{1, 0}}, {{1, 1}}, {{2, 2}}}};

  /** Row and column of each component of any tensor. */
  constexpr std::array<std::array<int, 2>, 9> all_components = {{{{0, 0}},
                                                                 {{0, 1}},
                                                                 {{0, 2}},
                                                                 {{1, 0}},
                                                                 {{1, 1}},
                                                                 {{1, 2}},
                                                                 {{2, 0}},
                                                                 {{2, 1}},
                                                                 {{2, 2}}}};



  /** F of pure stretch in the plane, isochoric, with equivalent strain e. */
  inline Tensor<2, 3>
  isochoric_stretch(const double e)
  {
    const double k = 0.5 * std::sqrt(3.) * e;
    return plane(std::exp(k), 0., 0., std::exp(-k), 1.);
  }



  inline MaterialResponse
  evaluate(const MaterialLaw   &law,
           const Tensor<2, 3>  &F,
           const MaterialState &old = {},
           const double         dt  = 0.)
  {
    MaterialResponse response;
    law.evaluate(F, old, dt, true, response);
    return response;
  }



  /** The same without relying on plane kinematics. */
  inline MaterialResponse
  evaluate_general(const MaterialLaw   &law,
                   const Tensor<2, 3>  &F,
                   const MaterialState &old = {},
                   const double         dt  = 0.)
  {
    MaterialResponse response;
    law.evaluate_general(1, &F, &old, dt, true, &response);
    return response;
  }



  /** sqrt(3/2) |dev(P F^T)|, from the definition. */
  inline double
  mises_of(const Tensor<2, 3> &P, const Tensor<2, 3> &F)
  {
    const Tensor<2, 3> t = P * transpose(F);
    const double       a = t[0][0] - t[1][1];
    const double       b = t[1][1] - t[2][2];
    const double       c = t[2][2] - t[0][0];
    return std::sqrt(
      0.5 * (a * a + b * b + c * c) +
      3. * (t[0][1] * t[0][1] + t[1][2] * t[1][2] + t[2][0] * t[2][0]));
  }



  /** The largest entry. */
  inline double
  largest(const Tensor<4, 3> &tangent)
  {
    double value = 0.;
    for (const auto &[i, J] : all_components)
      for (const auto &[k, L] : all_components)
        value = std::fmax(value, std::abs(tangent[i][J][k][L]));
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
   * The largest difference between the tangent that a function of F answers
   * and finite differences of its stress, relative to the largest entry;
   * infinite if any evaluation fails.
   *
   * @param some_components of P and F that are compared
   */
  template <std::size_t n>
  double
  tangent_error(
    const std::function<MaterialResponse(const Tensor<2, 3> &)> &respond,
    const std::array<std::array<int, 2>, n> &some_components,
    const Tensor<2, 3>                      &F,
    const double                             first_step = 1e-4)
  {
    const MaterialResponse response = respond(F);
    bool                   failed   = (response.status != LawStatus::ok);
    double                 error    = 0.;
    for (const auto &row : some_components)
      for (const auto &column : some_components)
        {
          const auto stress = [&](const double h) {
            Tensor<2, 3> shifted = F;
            shifted[column[0]][column[1]] += h;
            const MaterialResponse r = respond(shifted);
            failed                   = failed || r.status != LawStatus::ok;
            return r.P[row[0]][row[1]];
          };
          const double difference = derivative_at_zero(stress, first_step);
          const double entry =
            response.tangent[row[0]][row[1]][column[0]][column[1]];
          error = std::fmax(error, std::abs(difference - entry));
          failed =
            failed || !std::isfinite(difference) || !std::isfinite(entry);
        }
    return failed ? std::numeric_limits<double>::infinity() :
                    error / largest(response.tangent);
  }



  /** That of a law in plane kinematics. */
  inline double
  tangent_error(const MaterialLaw   &law,
                const Tensor<2, 3>  &F,
                const MaterialState &old,
                const double         dt,
                const double         first_step = 1e-4)
  {
    return tangent_error(
      [&](const Tensor<2, 3> &any_F) { return evaluate(law, any_F, old, dt); },
      components,
      F,
      first_step);
  }



  /** Every law there is, with constants that show all of its terms. */
  inline std::vector<std::shared_ptr<const MaterialLaw>>
  all_laws()
  {
    MaterialLaws constants;
    std::get<VoceParameters>(constants) = {300e6, 500e6, 17., 1e8};
    std::vector<std::shared_ptr<const MaterialLaw>> laws;
    std::apply(
      [&](const auto &...law) {
        (laws.push_back(law.make_law(ElasticParameters(), HeatingParameters())),
         ...);
      },
      constants);
    return laws;
  }



  /** Identity plus uniformly distributed noise. */
  class RandomDeformation
  {
  public:
    explicit RandomDeformation(const unsigned int seed)
      : generator(seed)
    {}

    Tensor<2, 3>
    near(const Tensor<2, 3> &F, const double size)
    {
      Tensor<2, 3> result = F;
      for (const auto &[i, J] : components)
        result[i][J] += size * distribution(generator);
      return result;
    }

    /** The same with all components. */
    Tensor<2, 3>
    near_in_space(const Tensor<2, 3> &F, const double size)
    {
      Tensor<2, 3> result = F;
      for (const auto &[i, J] : all_components)
        result[i][J] += size * distribution(generator);
      return result;
    }

    /** About any axis: that of a random quaternion. */
    Tensor<2, 3>
    rotation()
    {
      double       a = number(), b = number(), c = number(), d = number();
      const double length = std::sqrt(a * a + b * b + c * c + d * d);
      a /= length;
      b /= length;
      c /= length;
      d /= length;
      Tensor<2, 3> Q = plane(1. - 2. * (c * c + d * d),
                             2. * (b * c - d * a),
                             2. * (b * c + d * a),
                             1. - 2. * (b * b + d * d),
                             1. - 2. * (b * b + c * c));
      Q[0][2]        = 2. * (b * d + c * a);
      Q[2][0]        = 2. * (b * d - c * a);
      Q[1][2]        = 2. * (c * d - b * a);
      Q[2][1]        = 2. * (c * d + b * a);
      return Q;
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



  const Tensor<2, 3> identity = plane(1., 0., 0., 1., 1.);



  /** A state after 5 % of any deformation within 0.1 us, which laws that yield
   *  do. */
  inline MaterialState
  deformed_state_in_space(const MaterialLaw &law, RandomDeformation &random)
  {
    return evaluate_general(law, random.near_in_space(identity, 0.05), {}, 1e-7)
      .state;
  }
} // namespace asperity::law_tools

#endif
