#ifndef asperity_source_surrogate_sample_format_h
#define asperity_source_surrogate_sample_format_h

#include <asperity/surrogate/sample_table.h>

#include <string>
#include <vector>

namespace asperity
{
  /** What writer, reader and checks of a sample table agree on. */
  namespace SampleFormat
  {
    /** The headings of all columns: id, role, status, inputs, outputs,
     *  deviation of the first output, reason. */
    std::vector<std::string>
    headings(const SampleTable &table);

    /** Ordered by id. */
    std::vector<const Sample *>
    in_order(const std::vector<Sample> &samples);
  } // namespace SampleFormat
} // namespace asperity

#endif
