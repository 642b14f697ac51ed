// How long a learnt model of fields takes for mu with its deviation and the
// trust in it, and for the fields: the first time, which finds nothing in the
// caches, and then.
//
//   ninja prediction_speed, then prediction_speed field_model.h5

#include <asperity/base/environment.h>
#include <asperity/base/mpi_session.h>
#include <asperity/learned_fields/field_model.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

using namespace asperity;

namespace
{
  struct Times
  {
    double first, median; // [ms]
  };

  constexpr unsigned int n_calls = 300;

  /** Of calls with 0 .. n_calls - 1. */
  template <typename Call>
  Times
  times_of(const Call &call)
  {
    using Clock = std::chrono::steady_clock;
    std::vector<double> times;
    for (unsigned int i = 0; i < n_calls; ++i)
      {
        const auto begin = Clock::now();
        call(i);
        times.push_back(
          std::chrono::duration<double, std::milli>(Clock::now() - begin)
            .count());
      }
    const double first = times[0];
    std::sort(times.begin(), times.end());
    return {first, times[n_calls / 2]};
  }

  void
  measure(const std::string &path)
  {
    const FieldModel             model  = FieldModel::load(path);
    const auto                  &inputs = model.mu_law().description().inputs;
    std::vector<FieldPrediction> all(n_calls);
    const Times                  of_mu = times_of([&](const unsigned int i) {
      std::vector<double> x;
      for (const LawInput &input : inputs)
        x.push_back(input.lower + (input.upper - input.lower) * i / n_calls);
      all[i] = model.predict(x);
    });
    double                       sum   = 0.;
    const Times of_fields              = times_of([&](const unsigned int i) {
      sum += model.decoder().decode(all[i].code).back();
    });
    std::printf("mu, deviation and trust: %.3f ms (first %.3f ms); all fields: "
                "%.2f ms (first %.2f ms); medians of %u, check sum %g\n",
                of_mu.median,
                of_mu.first,
                of_fields.median,
                of_fields.first,
                n_calls,
                sum);
  }
} // namespace

int
main(int argc, char **argv)
{
  use_one_thread_per_rank();
  const MpiSession mpi(argc, argv);
  if (argc != 2)
    {
      std::fprintf(stderr, "usage: prediction_speed field_model.h5\n");
      return 2;
    }
  try
    {
      measure(argv[1]);
    }
  catch (const std::exception &error)
    {
      std::fprintf(stderr, "%s\n", error.what());
      return 1;
    }
  return 0;
}
