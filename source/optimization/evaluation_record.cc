#include <asperity/base/atomic_file.h>
#include <asperity/base/csv.h>
#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/optimization/evaluation_record.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <ostream>

namespace asperity
{
  namespace
  {
    /** As csv_cells() reads it back. */
    std::string
    quoted_cell(const std::string &text)
    {
      std::string result = "\"";
      for (const char c : printable(text))
        result += c == '"' ? std::string("\"\"") : std::string(1, c);
      return result + '"';
    }

    bool
    is_number(const std::string &cell, double &value)
    {
      const char *const end    = cell.data() + cell.size();
      const auto        result = std::from_chars(cell.data(), end, value);
      return result.ec == std::errc() && result.ptr == end;
    }
  } // namespace



  void
  SearchBox::check() const
  {
    if (names.empty())
      throw InputError("A search needs at least one variable.");
    if (lower.size() != size() || upper.size() != size())
      throw InputError("Every variable of a search needs two bounds.");
    for (std::size_t i = 0; i < size(); ++i)
      if (!(lower[i] < upper[i]) || !std::isfinite(upper[i] - lower[i]))
        throw InputError("The variable " + quoted_name(names[i]) +
                         " of a search ranges from " +
                         shortest_decimal(lower[i]) + " to " +
                         shortest_decimal(upper[i]) + ", which is no range.");
  }



  EvaluationRecord::EvaluationRecord(const SearchBox   &box,
                                     const std::string &path,
                                     const std::string &description,
                                     const bool         writes)
    : box_(box)
    , path(path)
    , description(printable(description))
    , writes(writes)
  {
    box.check();
    if (!path.empty() && std::filesystem::exists(path))
      read();
  }



  const Evaluation &
  EvaluationRecord::evaluate(const Objective           &objective,
                             const std::vector<double> &point)
  {
    const auto found = place.find(point);
    if (found != place.end())
      return entries_[found->second].evaluation;
    Evaluation evaluation;
    try
      {
        evaluation = objective(point);
        if (evaluation.failure.empty() && !std::isfinite(evaluation.value))
          evaluation.failure = "The objective is no number.";
      }
    catch (const ComputationError &error)
      {
        evaluation.failure = error.what();
      }
    evaluation.failure = printable(evaluation.failure);
    add({point, evaluation});
    if (!path.empty() && writes)
      write();
    return entries_.back().evaluation;
  }



  void
  EvaluationRecord::add(const Entry &entry)
  {
    place[entry.point] = entries_.size();
    entries_.push_back(entry);
  }



  void
  EvaluationRecord::write() const
  {
    write_atomically(path, [&](std::ostream &out) {
      out << "# " << description << '\n';
      for (const std::string &name : box_.names)
        out << quoted_cell(name) << ',';
      out << "value,failure\n";
      for (const Entry &entry : entries_)
        {
          for (const double x : entry.point)
            out << shortest_decimal(x) << ',';
          if (entry.evaluation.has_failed())
            out << ',' << quoted_cell(entry.evaluation.failure) << '\n';
          else
            out << shortest_decimal(entry.evaluation.value) << ",\n";
        }
    });
  }



  void
  EvaluationRecord::read()
  {
    std::ifstream in(path);
    std::string   line;
    unsigned int  number = 0;
    const auto    refuse = [&](const std::string &what) {
      throw InputError("The record of evaluations " + quoted_name(path) +
                       ", line " + std::to_string(number) + ": " + what);
    };
    const auto next = [&]() {
      ++number;
      return static_cast<bool>(std::getline(in, line));
    };
    if (!next() || line != "# " + description)
      refuse("these are evaluations of another objective than " +
             quoted_name(description) + "; name another file or remove it.");
    std::vector<std::string> expected = box_.names;
    for (std::string &name : expected)
      name = printable(name);
    expected.insert(expected.end(), {"value", "failure"});
    if (!next() || csv_cells(line) != expected)
      refuse("the columns " + quoted_name(join(expected, ", ")) +
             " are expected.");
    while (next())
      {
        const auto cells = csv_cells(line);
        Entry      entry;
        entry.point.resize(box_.size());
        bool valid = cells.size() == expected.size();
        for (std::size_t i = 0; valid && i < box_.size(); ++i)
          valid = is_number(cells[i], entry.point[i]);
        if (valid)
          {
            entry.evaluation.failure = cells.back();
            valid                    = entry.evaluation.has_failed() ||
                    is_number(cells[box_.size()], entry.evaluation.value);
          }
        if (!valid)
          refuse(quoted_text(line) + " is no evaluation.");
        add(entry);
      }
  }
} // namespace asperity
