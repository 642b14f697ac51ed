#include "run_outputs.h"

#include <utility>

namespace asperity
{
  std::vector<OutputColumn>
  output_columns(const LawOutput law)
  {
    std::vector<OutputColumn> columns = {
      {{"mu", "-"}, &RunRecord::mu},
      {{"mu_end", "-"}, &RunRecord::mu_end},
      {{"spread", "-"}, &RunRecord::spread},
      {{"contact_fraction", "-"}, &RunRecord::contact_fraction},
      {{"oil_pressure", "Pa"}, &RunRecord::oil_pressure},
      {{"oil_load_share", "-"}, &RunRecord::oil_load_share},
      {{"sliding_distance", "m"}, &RunRecord::sliding_distance},
      {{"max_plastic_strain", "-"}, &RunRecord::max_plastic_strain},
      {{"max_temperature", "K"}, &RunRecord::max_temperature}};
    if (law == LawOutput::mu_end)
      std::swap(columns[0], columns[1]);
    return columns;
  }



  std::vector<SampleOutput>
  outputs(const LawOutput law)
  {
    std::vector<SampleOutput> result;
    for (const OutputColumn &column : output_columns(law))
      result.push_back(column.output);
    return result;
  }



  std::string
  why_not_learnt(const RunRecord &record, const LawParameters &law)
  {
    if (!record.done)
      return record.reason;
    if (!record.no_result.empty())
      return "The mean of this run is no friction coefficient: " +
             record.no_result + ".";
    const double value = record.*output_columns(law.output)[0].value;
    if (law.output_scale == Scale::logarithmic && !(value > 0.))
      return "The friction coefficient of this run is " +
             format_quantity(value, "1", 3) +
             ", which has no logarithm (Friction law/Output scale).";
    return "";
  }
} // namespace asperity
