#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/surrogate/sample_table.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>

#include "sample_format.h"

namespace asperity
{
  namespace
  {
    void
    check_name(const std::string &name, const std::string &what)
    {
      if (name.empty() || name != trim(name) ||
          name.find_first_of(",;\"#\n\r") != std::string::npos)
        throw InputError("The sample table was given the " + what + " " +
                         quoted_name(name) +
                         ", but a name without comma, semicolon, quote, "
                         "number sign and line break is expected.");
    }

    void
    check_input(const LawInput &input)
    {
      check_name(input.symbol, "symbol of an input");
      check_name(input.name, "input");
      try
        {
          dimension_of(input.unit);
        }
      catch (const InputError &error)
        {
          throw InputError("The input " + quoted_name(input.name) +
                           " of the sample table is measured in " + input.unit +
                           ", but " + error.what() + ".");
        }
    }

    void
    check_sizes(const Sample     &sample,
                const std::size_t n_inputs,
                const std::size_t n_outputs)
    {
      const bool        done = sample.status == SampleStatus::done;
      const std::string run  = "Run " + std::to_string(sample.id);
      if (sample.x.size() != n_inputs)
        throw InputError(run + " of the sample table has " +
                         std::to_string(sample.x.size()) +
                         " values of inputs, but " + std::to_string(n_inputs) +
                         " are expected.");
      if (sample.outputs.size() != (done ? n_outputs : 0))
        throw InputError(
          run + " of the sample table has " +
          std::to_string(sample.outputs.size()) + " values of outputs, but " +
          std::to_string(done ? n_outputs : 0) +
          " are expected of a run that " + (done ? "is done." : "failed."));
    }

    void
    check_values(const Sample &sample)
    {
      const std::string run = "Run " + std::to_string(sample.id);
      for (const auto *values : {&sample.x, &sample.outputs})
        for (const double value : *values)
          if (!std::isfinite(value))
            throw InputError(run + " of the sample table has a value that is "
                                   "not a finite number.");
      if (!(sample.deviation >= 0.) || !std::isfinite(sample.deviation))
        throw InputError(run + " of the sample table has the deviation " +
                         shortest_decimal(sample.deviation) +
                         ", but a finite number that is not negative is "
                         "expected.");
      if (sample.status == SampleStatus::failed && trim(sample.reason).empty())
        throw InputError(run + " of the sample table failed without a reason; "
                               "a sentence is expected.");
    }
  } // namespace



  SampleTable::SampleTable(const std::vector<LawInput>     &inputs,
                           const std::vector<SampleOutput> &outputs)
    : inputs_(inputs)
    , outputs_(outputs)
  {
    if (inputs.empty() || outputs.empty())
      throw InputError("A sample table with " + std::to_string(inputs.size()) +
                       " inputs and " + std::to_string(outputs.size()) +
                       " outputs was asked for; at least one of each is "
                       "expected.");
    for (const LawInput &input : inputs)
      check_input(input);
    for (const SampleOutput &output : outputs)
      {
        check_name(output.name, "output");
        check_name(output.unit, "unit");
      }
    std::set<std::string> seen;
    for (const std::string &heading : SampleFormat::headings(*this))
      if (!seen.insert(heading).second)
        throw InputError("Two columns of the sample table would be called " +
                         quoted_name(heading) +
                         "; different names are expected.");
  }



  void
  SampleTable::add(const Sample &sample)
  {
    check_sizes(sample, inputs_.size(), outputs_.size());
    check_values(sample);
    if (find(sample.id) != nullptr)
      throw InputError("Run " + std::to_string(sample.id) +
                       " stands twice in the sample table; each number may "
                       "stand once.");
    samples_.push_back(sample);
  }



  const std::vector<Sample> &
  SampleTable::samples() const
  {
    return samples_;
  }



  const std::vector<LawInput> &
  SampleTable::inputs() const
  {
    return inputs_;
  }



  const std::vector<SampleOutput> &
  SampleTable::outputs() const
  {
    return outputs_;
  }



  const Sample *
  SampleTable::find(const unsigned int id) const
  {
    for (const Sample &sample : samples_)
      if (sample.id == id)
        return &sample;
    return nullptr;
  }



  std::size_t
  SampleTable::count(const SampleRole role, const SampleStatus status) const
  {
    return std::count_if(samples_.begin(),
                         samples_.end(),
                         [&](const Sample &sample) {
                           return sample.role == role &&
                                  sample.status == status;
                         });
  }



  SampleData
  SampleTable::data(const SampleRole role, const std::string &output) const
  {
    std::vector<std::string> names;
    for (const SampleOutput &known : outputs_)
      names.push_back(known.name);
    const auto found = std::find(names.begin(), names.end(), output);
    if (found == names.end())
      throw InputError("The sample table has no output " + quoted_name(output) +
                       "; it has " + join(names, ", ") + ".");
    const std::size_t column = found - names.begin();

    SampleData data;
    bool       is_known = false;
    for (const Sample *sample : SampleFormat::in_order(samples_))
      if (sample->role == role && sample->status == SampleStatus::done)
        {
          data.id.push_back(sample->id);
          data.x.insert(data.x.end(), sample->x.begin(), sample->x.end());
          data.y.push_back(sample->outputs[column]);
          data.deviation.push_back(sample->deviation);
          is_known = is_known || sample->deviation > 0.;
        }
    if (column != 0 || !is_known)
      data.deviation.clear();
    return data;
  }



  void
  SampleTable::write(const std::string &path) const
  {
    write_atomically(path, [&](std::ostream &out) { write(out); });
  }
} // namespace asperity
