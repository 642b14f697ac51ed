#include <asperity/campaign/law_test.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  TestReport
  test_law(const FrictionLaw &law, const SampleData &tests)
  {
    TestReport        report;
    const std::size_t d = law.description().inputs.size();
    report.n_runs       = tests.y.size();
    unsigned int inside = 0;
    for (std::size_t i = 0; i < tests.y.size(); ++i)
      {
        const LawPrediction prediction = law.predict(&tests.x[i * d]);
        const double        error =
          std::abs(prediction.mean - tests.y[i]) / std::abs(tests.y[i]);
        report.mean_relative_error += error / tests.y.size();
        report.largest_error = std::max(report.largest_error, error);
        if (prediction.lower <= tests.y[i] && tests.y[i] <= prediction.upper)
          ++inside;
      }
    if (report.n_runs > 0)
      report.coverage = static_cast<double>(inside) / report.n_runs;
    return report;
  }
} // namespace asperity
