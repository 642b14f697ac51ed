#ifndef asperity_campaign_law_test_h
#define asperity_campaign_law_test_h

#include <asperity/surrogate/friction_law.h>
#include <asperity/surrogate/sample_table.h>

namespace asperity
{
  /** How well a law predicts runs that it was not trained on. */
  struct TestReport
  {
    unsigned int n_runs              = 0;
    double       mean_relative_error = 0.;
    double       largest_error       = 0.; ///< relative

    /** Share of runs inside the 95 % interval. */
    double coverage = 0.;
  };

  TestReport
  test_law(const FrictionLaw &law, const SampleData &tests);
} // namespace asperity

#endif
