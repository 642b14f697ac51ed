#include "sample_format.h"

#include <asperity/base/atomic_file.h>
#include <asperity/base/csv.h>
#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <ostream>

namespace asperity
{
  namespace
  {
    const std::string first_line =
      "# Asperity sample table, version 1; values in SI units";
    const std::string input_start = "# input: ";

    std::string
    to_string(const SampleRole role)
    {
      return role == SampleRole::test ? "test" : "training";
    }

    std::string
    to_string(const SampleStatus status)
    {
      return status == SampleStatus::done ? "done" : "failed";
    }

    /** Always in quotes, in one line. */
    std::string
    csv_cell(const std::string &text)
    {
      std::string result = "\"";
      for (const char c : text)
        result += c == '"'               ? std::string("\"\"") :
                  c == '\n' || c == '\r' ? std::string(" ") :
                                           std::string(1, c);
      return result + "\"";
    }

    std::string
    row_of(const Sample &sample, const std::size_t n_outputs)
    {
      const bool  done = sample.status == SampleStatus::done;
      std::string row  = std::to_string(sample.id) + "," +
                        to_string(sample.role) + "," + to_string(sample.status);
      for (const double value : sample.x)
        row += "," + shortest_decimal(value);
      for (std::size_t i = 0; i < n_outputs; ++i)
        row += "," + (done ? shortest_decimal(sample.outputs[i]) : "");
      row += "," + (done ? shortest_decimal(sample.deviation) : "");
      return row + "," + (sample.reason.empty() ? "" : csv_cell(sample.reason));
    }

    /** Lines of a table, and the sentences for what is wrong with them. */
    class Reader
    {
    public:
      explicit Reader(const std::string &path)
        : path(path)
        , in(path, std::ios::binary)
      {
        if (!in)
          throw InputError("The sample table " + path +
                           " cannot be opened; a file that a campaign wrote "
                           "is expected.");
      }

      bool
      next_line(std::string &line)
      {
        ++line_number;
        if (!std::getline(in, line))
          return false;
        if (!line.empty() && line.back() == '\r')
          line.pop_back();
        return true;
      }

      /** @p found and expectation in one sentence. */
      [[noreturn]] void
      fail(const std::string &found_and_expected) const
      {
        throw InputError("Line " + std::to_string(line_number) +
                         " of the sample table " + path + ": " +
                         found_and_expected + ".");
      }

      double
      number(const std::string &field, const std::string &heading) const
      {
        try
          {
            return parse_number(field);
          }
        catch (const InputError &error)
          {
            fail("in the column " + quoted_name(heading) + " " + error.what());
          }
      }

      template <typename Kind>
      Kind
      one_of(const std::string &field,
             const Kind         first,
             const Kind         second) const
      {
        if (field == to_string(first))
          return first;
        if (field == to_string(second))
          return second;
        fail(quoted_text(field) + " was found, but " +
             quoted_name(to_string(first)) + " or " +
             quoted_name(to_string(second)) + " is expected");
      }

      LawInput
      input(const std::string &line) const
      {
        const auto parts = split(line.substr(input_start.size()), ';');
        if (parts.size() != 6)
          fail("an input with " + std::to_string(parts.size()) +
               " parts was found, but symbol; entry; unit; lower end; upper "
               "end; scale are expected");
        LawInput input;
        input.symbol = parts[0];
        input.name   = parts[1];
        input.unit   = parts[2];
        input.lower  = number(parts[3], "lower end");
        input.upper  = number(parts[4], "upper end");
        input.scale  = one_of(parts[5], Scale::linear, Scale::logarithmic);
        return input;
      }

      /** The outputs behind the fixed columns and those of the inputs. */
      std::vector<SampleOutput>
      outputs(const std::string &line, const std::size_t n_inputs) const
      {
        const auto                headings = split(line, ',');
        std::vector<SampleOutput> result;
        for (std::size_t i = 3 + n_inputs; i + 2 < headings.size(); ++i)
          {
            const std::string &heading = headings[i];
            const auto         bracket = heading.rfind(" [");
            if (bracket == std::string::npos || heading.back() != ']')
              fail("the heading " + quoted_name(heading) +
                   " was found, but a name with its unit in brackets is "
                   "expected");
            result.push_back(
              {heading.substr(0, bracket),
               heading.substr(bracket + 2, heading.size() - bracket - 3)});
          }
        return result;
      }

      /** Runs a check that does not know the file, and adds it. */
      template <typename Call>
      auto
      in_context(const Call &call) const
      {
        try
          {
            return call();
          }
        catch (const InputError &error)
          {
            std::string message = error.what();
            if (message.back() == '.')
              message.pop_back();
            fail(message);
          }
      }

      Sample
      sample(const std::string              &line,
             const std::vector<std::string> &headings,
             const std::size_t               n_inputs) const
      {
        const auto        field = in_context([&]() { return csv_cells(line); });
        const std::size_t n_fields = headings.size();
        if (field.size() != n_fields)
          fail(std::to_string(field.size()) + " columns were found, but " +
               std::to_string(n_fields) + " are expected");
        Sample       sample;
        const double id = number(field[0], headings[0]);
        sample.id = static_cast<unsigned int>(id >= 0. && id < 4e9 ? id : 0);
        if (sample.id != id)
          fail(quoted_text(field[0]) +
               " was found as the number of a run, but a whole number that is "
               "not negative is expected");
        sample.role = one_of(field[1], SampleRole::training, SampleRole::test);
        sample.status =
          one_of(field[2], SampleStatus::done, SampleStatus::failed);
        for (std::size_t i = 3; i < 3 + n_inputs; ++i)
          sample.x.push_back(number(field[i], headings[i]));
        for (std::size_t i = 3 + n_inputs; i + 1 < n_fields; ++i)
          if (sample.status == SampleStatus::done)
            sample.outputs.push_back(number(field[i], headings[i]));
          else if (!field[i].empty())
            fail(quoted_text(field[i]) + " was found in the column " +
                 quoted_name(headings[i]) +
                 ", but nothing is expected of a run that failed");
        if (sample.status == SampleStatus::done)
          {
            sample.deviation = sample.outputs.back();
            sample.outputs.pop_back();
          }
        sample.reason = field.back();
        return sample;
      }

    private:
      std::string   path;
      std::ifstream in;
      unsigned int  line_number = 0;
    };
  } // namespace



  namespace SampleFormat
  {
    std::vector<std::string>
    headings(const SampleTable &table)
    {
      std::vector<std::string> result = {"id", "role", "status"};
      for (const LawInput &input : table.inputs())
        {
          const std::string si =
            accepted_units(dimension_of(input.unit)).front();
          result.push_back(input.symbol + " [" + (si == "1" ? "-" : si) + "]");
        }
      for (const SampleOutput &output : table.outputs())
        result.push_back(output.name + " [" + output.unit + "]");
      const SampleOutput &first = table.outputs().front();
      result.push_back("deviation of " + first.name + " [" + first.unit + "]");
      result.push_back("reason");
      return result;
    }



    std::vector<const Sample *>
    in_order(const std::vector<Sample> &samples)
    {
      std::vector<const Sample *> result;
      for (const Sample &sample : samples)
        result.push_back(&sample);
      std::sort(result.begin(),
                result.end(),
                [](const Sample *first, const Sample *second) {
                  return first->id < second->id;
                });
      return result;
    }
  } // namespace SampleFormat



  void
  SampleTable::write(std::ostream &out) const
  {
    out << first_line << '\n';
    for (const LawInput &input : inputs_)
      out << input_start << input.symbol << "; " << input.name << "; "
          << input.unit << "; " << shortest_decimal(input.lower) << "; "
          << shortest_decimal(input.upper) << "; " << to_string(input.scale)
          << '\n';
    out << join(SampleFormat::headings(*this), ",") << '\n';
    for (const Sample *sample : SampleFormat::in_order(samples_))
      out << row_of(*sample, outputs_.size()) << '\n';
  }



  SampleTable
  SampleTable::read(const std::string &path)
  {
    Reader      reader(path);
    std::string line;
    // what stands in a file that is no table is nobody's business
    if (!reader.next_line(line) || line != first_line)
      reader.fail(std::string("the line is not that of a sample table; '") +
                  first_line + "' is expected");
    std::vector<LawInput> inputs;
    while (reader.next_line(line) && line.rfind(input_start, 0) == 0)
      inputs.push_back(reader.input(line));

    const auto  outputs = reader.outputs(line, inputs.size());
    SampleTable table =
      reader.in_context([&]() { return SampleTable(inputs, outputs); });
    const auto headings = SampleFormat::headings(table);
    if (line != join(headings, ","))
      reader.fail(quoted_text(line) + " was found, but the headings " +
                  quoted_name(join(headings, ",")) + " are expected");
    while (reader.next_line(line))
      {
        const Sample sample = reader.sample(line, headings, inputs.size());
        reader.in_context([&]() { table.add(sample); });
      }
    return table;
  }
} // namespace asperity
