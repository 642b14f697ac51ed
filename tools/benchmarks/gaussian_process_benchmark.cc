// Times the Gaussian process on data that gaussian_process.py writes, which
// also times scikit-learn and makes the table.
//
// Usage: gaussian_process_benchmark KERNEL DATA.txt
//
// DATA.txt: number of points and inputs, then x and y of every point. Prints
// one "name value" a line.

#include <asperity/base/environment.h>
#include <asperity/surrogate/hyperparameter_search.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <string>

using namespace asperity;

namespace
{
  TrainingData
  read(const std::string &path)
  {
    std::ifstream in(path);
    std::size_t   n = 0;
    TrainingData  data;
    in >> n >> data.n_inputs;
    data.x.resize(n * data.n_inputs);
    data.y.resize(n);
    for (std::size_t j = 0; j < n; ++j)
      {
        for (std::size_t i = 0; i < data.n_inputs; ++i)
          in >> data.x[j * data.n_inputs + i];
        in >> data.y[j];
      }
    if (!in)
      {
        std::fprintf(stderr, "%s is no data file\n", path.c_str());
        std::exit(2);
      }
    return data;
  }

  /** Seconds of one call: the least of several measurements, since other
   *  programs only ever add to it. */
  double
  seconds(const std::function<void()> &call, const unsigned int n_calls)
  {
    double least = 1e30;
    for (unsigned int repetition = 0; repetition < 15; ++repetition)
      {
        const auto start = std::chrono::steady_clock::now();
        for (unsigned int i = 0; i < n_calls; ++i)
          call();
        const std::chrono::duration<double> time =
          std::chrono::steady_clock::now() - start;
        least = std::min(least, time.count() / n_calls);
      }
    return least;
  }

  /** Four sums in flight, so that nothing but the memory is waited for. */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
  __attribute__((target_clones("avx512f", "avx2", "default")))
#endif
  double
  sum_of(const std::size_t size, const double *const a)
  {
    const std::size_t quarter = size / 4;
    double            s0 = 0., s1 = 0., s2 = 0., s3 = 0.;
    for (std::size_t i = 0; i < quarter; ++i)
      {
        s0 += a[i];
        s1 += a[i + quarter];
        s2 += a[i + 2 * quarter];
        s3 += a[i + 3 * quarter];
      }
    return s0 + s1 + s2 + s3;
  }

  /** Of reading as many numbers as the triangular factor has, once, from where
   *  the processor keeps them when that is repeated. */
  double
  seconds_of_reading_factor(const std::size_t n)
  {
    const std::vector<double> factor(n * (n + 1) / 2, 1.);
    volatile double           sum = 0.;
    return seconds([&]() { sum = sum_of(factor.size(), factor.data()); }, 500);
  }

  /** Of this program alone, however busy the machine is. */
  double
  processor_seconds()
  {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  }
} // namespace

int
main(int argc, char **argv)
{
  use_one_thread_per_rank();
  if (argc != 3)
    {
      std::fprintf(stderr,
                   "Usage: gaussian_process_benchmark KERNEL DATA.txt\n");
      return 2;
    }
  KernelKind kernel = KernelKind::rbf;
  for (const KernelKind kind : {KernelKind::matern_3_2, KernelKind::matern_5_2})
    if (to_string(kind) == argv[1])
      kernel = kind;
  const TrainingData data = read(argv[2]);
  const std::size_t  n = data.y.size(), d = data.n_inputs;

  HyperparameterSearchOptions options;
  options.n_restarts = 0;
  HyperparameterSearchResult found;
  double                     training = 1e30;
  for (unsigned int repetition = 0; repetition < 3; ++repetition)
    {
      const double start = processor_seconds();
      found              = find_hyperparameters(kernel, data, options);
      training           = std::min(training, processor_seconds() - start);
    }
  const GaussianProcess process(kernel, found.hyperparameters, data);

  // between the training points, another one at each call
  std::vector<double> points = data.x;
  for (std::size_t i = 0; i + d < points.size(); ++i)
    points[i] = 0.5 * (points[i] + points[i + d]);
  std::size_t     next = 0;
  const auto      x    = [&]() { return &points[(next = (next + 1) % n) * d]; };
  volatile double sink;
  std::vector<double> gradient(d), means(n);
  double              variance;

  std::printf("log_likelihood %.10g\n", process.log_likelihood());
  std::printf("evaluations %u\n", found.n_evaluations);
  std::printf("training %g\n", training);
  std::printf("mean %g\n", seconds([&]() { sink = process.mean(x()); }, 2000));
  std::printf(
    "deviation %g\n",
    seconds([&]() { sink = process.evaluate(x(), &variance, nullptr); }, 500));
  std::printf(
    "gradient %g\n",
    seconds([&]() { sink = process.evaluate(x(), &variance, gradient.data()); },
            500));
  std::printf("batch %g\n",
              seconds([&]() { process.means(n, points.data(), means.data()); },
                      2) /
                static_cast<double>(n));
  std::printf("reading %g\n", seconds_of_reading_factor(n));
  (void)sink;
  return 0;
}
