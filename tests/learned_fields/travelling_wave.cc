#include <asperity/learned_fields/train_decoder.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace asperity;

// A wave that travels is a curve: each of its harmonics needs two modes, but
// all of them follow from the phase.

namespace
{
  constexpr unsigned int n_places    = 64;
  constexpr unsigned int n_harmonics = 12;
  constexpr double       ratio       = 0.5; ///< of successive harmonics

  /** sum over m of q^m cos m(x - phase) */
  std::vector<double>
  wave(const double phase)
  {
    std::vector<double> u(n_places, 0.);
    for (unsigned int i = 0; i < n_places; ++i)
      for (unsigned int m = 1; m <= n_harmonics; ++m)
        u[i] +=
          std::pow(ratio, m) * std::cos(m * (2. * M_PI * i / n_places - phase));
    return u;
  }

  double
  norm(const std::vector<double> &u)
  {
    double sum = 0.;
    for (const double value : u)
      sum += value * value;
    return std::sqrt(sum);
  }

  /** Over the norm, at phases between those that are learnt. */
  double
  error_of(const FieldDecoder &decoder, const unsigned int n_learnt)
  {
    double sum = 0.;
    for (unsigned int i = 0; i < n_learnt; ++i)
      {
        const auto u          = wave(2. * M_PI * (i + 0.5) / n_learnt);
        auto       difference = decoder.decode(decoder.encode(u));
        for (unsigned int k = 0; k < n_places; ++k)
          difference[k] -= u[k];
        sum += norm(difference) / norm(u) / n_learnt;
      }
    return sum;
  }
} // namespace

TEST(TravellingWave, is_better_met_by_a_manifold_than_by_as_many_modes)
{
  constexpr unsigned int n_learnt = 32;
  std::vector<double>    all;
  for (unsigned int i = 0; i < n_learnt; ++i)
    {
      const auto u = wave(2. * M_PI * i / n_learnt);
      all.insert(all.end(), u.begin(), u.end());
    }
  const std::vector<double>     weights(n_places, 1.);
  const OrthogonalDecomposition modes(all, n_learnt, weights);
  // What r modes leave are the harmonics beyond r/2, by Parseval's theorem
  // a share q^(r/2) of the norm.
  for (const unsigned int r : {2, 4, 8})
    EXPECT_NEAR(error_of(PodDecoder(modes, weights, r), n_learnt),
                std::pow(ratio, r / 2),
                2e-4)
      << r;
  const PodDecoder                 linear(modes, weights, 2 * n_harmonics);
  std::vector<std::vector<double>> coefficients;
  for (unsigned int i = 0; i < n_learnt; ++i)
    coefficients.push_back(linear.encode(wave(2. * M_PI * i / n_learnt)));
  testing::internal::CaptureStdout();
  const auto manifold = train_manifold(linear, coefficients, 2, 6000);
  testing::internal::GetCapturedStdout();
  EXPECT_LT(error_of(*manifold, n_learnt), 0.1 * ratio);
}
