#include <asperity/base/csv.h>
#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/experiment/measured_friction.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

namespace asperity
{
  namespace
  {
    const std::vector<std::string> own_headings = {"mu",
                                                   "deviation of mu",
                                                   "series",
                                                   "source"};

    /** What a column holds. */
    struct Column
    {
      std::string heading;
      std::string symbol; ///< of an input, else empty
      std::string unit;   ///< of an input
    };

    /** Lines of a file, and the sentences for what is wrong with them. */
    class Reader
    {
    public:
      explicit Reader(const std::string &path)
        : path(path)
        , in(path, std::ios::binary)
      {
        if (!in)
          throw InputError("The measurements " + path +
                           " cannot be opened; a comma-separated file is "
                           "expected.");
      }

      /** The cells of the next line that is no comment and not empty. */
      bool
      next(std::vector<std::string> &cells)
      {
        for (std::string text; std::getline(in, text);)
          {
            ++line;
            text = trim(text);
            if (line == 1 && text.rfind("\xef\xbb\xbf", 0) == 0)
              text.erase(0, 3);
            if (text.empty() || text[0] == '#')
              continue;
            try
              {
                cells = csv_cells(text);
              }
            catch (const InputError &error)
              {
                fail(error.what());
              }
            for (std::string &cell : cells)
              cell = trim(cell);
            return true;
          }
        return false;
      }

      /** @param found and expectation in one sentence */
      [[noreturn]] void
      fail(const std::string &found_and_expected) const
      {
        throw InputError("Line " + std::to_string(line) +
                         " of the measurements " + path + ": " +
                         found_and_expected + ".");
      }

      Column
      column(const std::string &heading) const
      {
        if (std::find(own_headings.begin(), own_headings.end(), heading) !=
            own_headings.end())
          return {heading, "", ""};
        const auto bracket = heading.rfind(" [");
        if (bracket == std::string::npos || bracket == 0 ||
            heading.back() != ']')
          fail("the heading " + quoted_name(heading) + " was found, but " +
               join(own_headings, ", ") +
               ", or an input with its unit, such as 'v [m/min]', is expected");
        Column result = {heading,
                         heading.substr(0, bracket),
                         heading.substr(bracket + 2,
                                        heading.size() - bracket - 3)};
        check_dimension(result);
        return result;
      }

      double
      number(const std::string &cell, const Column &column) const
      {
        try
          {
            return parse_number(cell);
          }
        catch (const InputError &error)
          {
            fail("in the column " + quoted_name(column.heading) + " " +
                 error.what());
          }
      }

      double
      positive(const std::string &cell, const Column &column) const
      {
        const double value = number(cell, column);
        if (!(value > 0.))
          fail("in the column " + quoted_name(column.heading) + " " +
               quoted_text(cell) +
               " was found, but a positive number is expected");
        return value;
      }

      unsigned int line = 0;

    private:
      void
      check_dimension(const Column &column) const
      {
        static const std::map<std::string, Dimension> known = {
          {"p", Dimension::stress},
          {"v", Dimension::velocity},
          {"T", Dimension::temperature}};
        Dimension found = Dimension::none;
        try
          {
            found = dimension_of(column.unit);
          }
        catch (const InputError &error)
          {
            fail("in the heading " + quoted_name(column.heading) + " " +
                 error.what());
          }
        const auto entry = known.find(column.symbol);
        if (entry != known.end() && entry->second != found)
          fail("the heading " + quoted_name(column.heading) +
               " was found, but a unit of a " + to_string(entry->second) +
               " is expected");
      }

      const std::string path;
      std::ifstream     in;
    };

    std::vector<Column>
    read_headings(Reader &reader)
    {
      std::vector<std::string> headings;
      if (!reader.next(headings))
        reader.fail("the file ends before its headings, but a line such as "
                    "'v [m/min],mu' is expected");
      std::vector<Column>   result;
      std::set<std::string> seen;
      for (const std::string &heading : headings)
        {
          result.push_back(reader.column(heading));
          const Column &column = result.back();
          if (!seen
                 .insert(column.symbol.empty() ? column.heading : column.symbol)
                 .second)
            reader.fail("two columns are called " + quoted_name(heading) +
                        ", but different names are expected");
        }
      if (seen.count("mu") == 0)
        reader.fail("the headings have no column 'mu', but the friction "
                    "coefficient is expected");
      return result;
    }

    MeasuredPoint
    read_point(const Reader                   &reader,
               const std::vector<Column>      &columns,
               const std::vector<std::string> &cells)
    {
      if (cells.size() != columns.size())
        reader.fail(std::to_string(cells.size()) + " columns were found, but " +
                    std::to_string(columns.size()) + " are expected");
      MeasuredPoint point;
      point.line = reader.line;
      for (std::size_t i = 0; i < cells.size(); ++i)
        {
          const Column      &column = columns[i];
          const std::string &cell   = cells[i];
          if (column.heading == "mu")
            point.mu = reader.positive(cell, column);
          else if (column.heading == "series")
            point.series = cell;
          else if (column.heading == "source")
            point.source = cell;
          else if (column.heading == "deviation of mu")
            {
              if (!cell.empty())
                point.deviation = reader.positive(cell, column);
            }
          else if (cell.empty())
            point.x.emplace_back();
          else
            point.x.emplace_back(
              to_si(reader.number(cell, column), column.unit));
        }
      return point;
    }
  } // namespace



  MeasuredFriction
  MeasuredFriction::read(const std::string &path)
  {
    Reader                    reader(path);
    const std::vector<Column> columns = read_headings(reader);
    MeasuredFriction          result;
    result.path_ = path;
    for (const Column &column : columns)
      if (!column.symbol.empty())
        {
          result.inputs_.push_back(column.symbol);
          result.units_.push_back(column.unit);
        }
    for (std::vector<std::string> cells; reader.next(cells);)
      result.points_.push_back(read_point(reader, columns, cells));
    if (result.points_.empty())
      reader.fail("the file ends behind its headings, but a measurement is "
                  "expected");
    return result;
  }



  const std::string &
  MeasuredFriction::path() const
  {
    return path_;
  }



  const std::vector<std::string> &
  MeasuredFriction::inputs() const
  {
    return inputs_;
  }



  const std::vector<std::string> &
  MeasuredFriction::units() const
  {
    return units_;
  }



  const std::vector<MeasuredPoint> &
  MeasuredFriction::points() const
  {
    return points_;
  }



  std::optional<std::size_t>
  MeasuredFriction::column(const std::string &symbol) const
  {
    const auto found = std::find(inputs_.begin(), inputs_.end(), symbol);
    if (found == inputs_.end())
      return {};
    return static_cast<std::size_t>(found - inputs_.begin());
  }



  double
  MeasuredFriction::value(const MeasuredPoint &point,
                          const std::string   &symbol) const
  {
    const auto where = column(symbol);
    if (!where)
      throw InputError("The measurements " + path_ + " have no column " +
                       quoted_name(symbol) + "; they have " +
                       (inputs_.empty() ? "no inputs" : join(inputs_, ", ")) +
                       ".");
    if (!point.x[*where])
      throw InputError("Line " + std::to_string(point.line) +
                       " of the measurements " + path_ + " has no " + symbol +
                       ", but a number is expected.");
    return *point.x[*where];
  }



  std::vector<std::string>
  MeasuredFriction::series() const
  {
    std::vector<std::string> result;
    for (const MeasuredPoint &point : points_)
      if (!point.series.empty() &&
          std::find(result.begin(), result.end(), point.series) == result.end())
        result.push_back(point.series);
    return result;
  }



  void
  MeasuredFriction::choose(const std::string &names)
  {
    const std::vector<std::string> known  = series();
    const std::vector<std::string> chosen = split(names, ',');
    if (chosen.empty() && known.size() > 1)
      throw InputError("The measurements " + path_ + " are of the series " +
                       join(known, ", ") +
                       "; one or more of them are expected, as in --series " +
                       quoted_text(known.front()) + ".");
    for (const std::string &name : chosen)
      if (std::find(known.begin(), known.end(), name) == known.end())
        throw InputError("The measurements " + path_ + " have no series " +
                         quoted_name(name) + "; they have " +
                         (known.empty() ? "none" : join(known, ", ")) + ".");
    if (!chosen.empty())
      points_.erase(std::remove_if(points_.begin(),
                                   points_.end(),
                                   [&](const MeasuredPoint &point) {
                                     return std::find(chosen.begin(),
                                                      chosen.end(),
                                                      point.series) ==
                                            chosen.end();
                                   }),
                    points_.end());
  }



  std::vector<double>
  MeasuredFriction::deviations() const
  {
    std::vector<double> result;
    for (const MeasuredPoint &point : points_)
      if (point.deviation)
        result.push_back(*point.deviation);
    if (!result.empty() && result.size() != points_.size())
      throw InputError("Of the measurements " + path_ + ", " +
                       std::to_string(result.size()) + " of " +
                       std::to_string(points_.size()) +
                       " have a deviation of mu; all or none are expected.");
    return result;
  }
} // namespace asperity
