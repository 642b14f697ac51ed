#include <asperity/surrogate/gaussian_process.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>

#include "../files.h"
#include "sample_data.h"

using namespace asperity;

namespace
{
  const std::vector<double> test_points =
    {0.5, 0.5, 0.5, 0.1, 0.9, 0.3, 1.2, -0.1, 0.4};

  /** What tests/surrogate/reference_gaussian_process.py prints. */
  std::vector<double>
  numbers_of(const GaussianProcess &process, const std::vector<double> &points)
  {
    std::vector<double> result = {process.log_likelihood()};
    for (const double derivative : process.log_likelihood_gradient())
      result.push_back(derivative);
    for (std::size_t i = 0; i < points.size(); i += process.data().n_inputs)
      {
        result.push_back(process.mean(&points[i]));
        result.push_back(std::sqrt(process.variance(&points[i])));
      }
    return result;
  }

  /** A line of the input of reference_gaussian_process.py. */
  void
  write_problem(const GaussianProcess     &process,
                const std::vector<double> &points,
                std::ostream              &out)
  {
    const TrainingData    &data = process.data();
    const Hyperparameters &h    = process.hyperparameters();
    out << std::setprecision(17) << to_string(process.kernel()) << ' '
        << data.y.size() << ' ' << data.n_inputs << ' '
        << points.size() / data.n_inputs << ' ' << h.signal_variance << ' '
        << h.noise_variance;
    for (const auto *list : {&h.length_scales, &data.x, &data.y, &points})
      for (const double number : *list)
        out << ' ' << number;
    out << '\n';
  }
} // namespace



// 25 points of the R_3 sequence; the numbers were printed by
// reference_gaussian_process.py with scikit-learn 1.2.1 for the same input.
TEST(ScikitLearn, stored_numbers)
{
  const std::vector<std::vector<double>> expected = {{11.78777395316079,
                                                      -3.358854666106609,
                                                      7.310556079938824,
                                                      3.504367774517476,
                                                      3.3474135591162977,
                                                      0.5591989537200014,
                                                      1.14244355153647,
                                                      0.022819693314040466,
                                                      0.44180915749053035,
                                                      0.06574650250211662,
                                                      0.27092527981931847,
                                                      0.257292256045634},
                                                     {-6.99980189413483,
                                                      -9.894316406704055,
                                                      7.9004915656976555,
                                                      6.286326839735217,
                                                      7.652986302686678,
                                                      -0.12975310288704123,
                                                      1.1600292748579835,
                                                      0.16069755915858785,
                                                      0.4195190445865116,
                                                      0.3085188867478324,
                                                      0.4441706593571211,
                                                      0.7476516858497808},
                                                     {0.5653369736640173,
                                                      -8.657331783258183,
                                                      10.718588014588784,
                                                      7.615461335108947,
                                                      8.934452846369428,
                                                      -0.35845514791147454,
                                                      1.1577824157666772,
                                                      0.07224951774830339,
                                                      0.42837625182970895,
                                                      0.19048738150146954,
                                                      0.3677718452770751,
                                                      0.590142921924819}};
  for (std::size_t k = 0; k < all_kernels.size(); ++k)
    {
      const GaussianProcess process(all_kernels[k],
                                    three_inputs,
                                    sample(25, 3, smooth));
      EXPECT_EQ(process.jitter(), 0.);
      const std::vector<double> found = numbers_of(process, test_points);
      ASSERT_EQ(found.size(), expected[k].size());
      for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i], expected[k][i], 1e-10) << "number " << i;
    }
}



TEST(ScikitLearn, numbers_of_this_machine)
{
  if (std::system("/usr/bin/python3 -c 'import sklearn' 2>/dev/null") != 0)
    GTEST_SKIP() << "scikit-learn is not installed (python3-sklearn)";
  const std::string folder = test_folder(), in = folder + "/problems.txt",
                    out = folder + "/numbers.txt";
  std::vector<double> found;
  std::ofstream       problems(in);
  for (const KernelKind kernel : all_kernels)
    for (const std::size_t n_inputs : {1, 2, 3, 6})
      {
        Hyperparameters h{2.3, {}, 1e-5};
        for (std::size_t i = 0; i < n_inputs; ++i)
          h.length_scales.push_back(0.4 + 0.3 * i);
        const GaussianProcess process(kernel, h, sample(60, n_inputs, wavy));
        std::vector<double>   points;
        for (std::size_t j = 500; j < 520; ++j)
          for (const double x : evenly_spread_point(j, n_inputs))
            points.push_back(1.2 * x - 0.1); // also outside of the data
        write_problem(process, points, problems);
        for (const double number : numbers_of(process, points))
          found.push_back(number);
      }
  problems.close();
  const std::string script =
    ASPERITY_SOURCE_DIR "/tests/surrogate/reference_gaussian_process.py";
  ASSERT_EQ(std::system((script + " <" + in + " >" + out).c_str()), 0);

  std::ifstream       file(out);
  std::vector<double> expected;
  for (double number; file >> number;)
    expected.push_back(number);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i],
                expected[i],
                1e-8 * std::max(1., std::abs(expected[i])))
      << "number " << i;
}
