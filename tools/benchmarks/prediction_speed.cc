// How long a learnt model of fields takes for mu with its deviation and the
// trust in it, and for the fields.
//
//   ninja prediction_speed, then prediction_speed field_model.h5

#include <asperity/base/environment.h>
#include <asperity/base/mpi_session.h>
#include <asperity/learned_fields/field_model.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

using namespace asperity;

namespace
{
  /** Median over calls with 0 .. n - 1 [ms]. */
  template <typename Call>
  double
  median_time(const unsigned int n, const Call &call)
  {
    using Clock = std::chrono::steady_clock;
    std::vector<double> times;
    for (unsigned int i = 0; i < n; ++i)
      {
        const auto begin = Clock::now();
        call(i);
        times.push_back(
          std::chrono::duration<double, std::milli>(Clock::now() - begin)
            .count());
      }
    std::sort(times.begin(), times.end());
    return times[n / 2];
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
  const FieldModel             model  = FieldModel::load(argv[1]);
  const auto                  &inputs = model.mu_law().description().inputs;
  constexpr unsigned int       n      = 300;
  std::vector<FieldPrediction> all(n);
  const double of_mu     = median_time(n, [&](const unsigned int i) {
    std::vector<double> x;
    for (const LawInput &input : inputs)
      x.push_back(input.lower + (input.upper - input.lower) * i / n);
    all[i] = model.predict(x);
  });
  double       sum       = 0.;
  const double of_fields = median_time(n, [&](const unsigned int i) {
    sum += model.decoder().decode(all[i].code).back();
  });
  std::printf("mu, deviation and trust: %.3f ms; all fields: %.2f ms (medians "
              "of %u; check sum %g)\n",
              of_mu,
              of_fields,
              n,
              sum);
  return 0;
}
