#ifndef asperity_campaign_run_outputs_h
#define asperity_campaign_run_outputs_h

#include <asperity/campaign/campaign_parameters.h>
#include <asperity/campaign/run_record.h>
#include <asperity/surrogate/sample_table.h>

#include <string>
#include <vector>

namespace asperity
{
  /** What is tabulated of a run. */
  struct OutputColumn
  {
    SampleOutput output;
    double RunRecord::*value;
  };

  /** That of the law stands first. */
  std::vector<OutputColumn>
  output_columns(const LawOutput law);

  std::vector<SampleOutput>
  outputs(const LawOutput law);

  /** Why a law does not learn from a run: it failed, its mean is no friction
   *  coefficient, or it is not positive where the law sees its logarithm. Empty
   *  if the law learns from it. */
  std::string
  why_not_learnt(const RunRecord &record, const LawParameters &law);
} // namespace asperity

#endif
