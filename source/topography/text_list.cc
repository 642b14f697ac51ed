#include <asperity/topography/text_list.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    std::vector<double>
    column(const TextTable &table, const std::size_t index)
    {
      std::vector<double> values(table.n_rows());
      for (std::size_t row = 0; row < values.size(); ++row)
        values[row] = table(row, index);
      return values;
    }

    bool
    all_finite(const std::vector<double> &values)
    {
      return std::all_of(values.begin(), values.end(), [](const double value) {
        return std::isfinite(value);
      });
    }

    /** Sorted; values closer than a quarter of the mean distance are one. */
    std::vector<double>
    distinct(std::vector<double> values)
    {
      std::sort(values.begin(), values.end());
      const double        range = values.back() - values.front();
      const double        close = 0.25 * range / values.size();
      std::vector<double> result;
      for (const double value : values)
        if (result.empty() || value - result.back() > close)
          result.push_back(value);
      return result;
    }

    /** The step of values in order, or 0 if one is off by more than 2 % of it
     *  or if there is no second one. */
    double
    regular_step(const std::vector<double> &values)
    {
      if (values.size() < 2)
        return 0.;
      const double step =
        (values.back() - values.front()) / (values.size() - 1);
      for (std::size_t i = 0; i < values.size(); ++i)
        if (!(std::abs(values[i] - values.front() - i * step) <=
              0.02 * std::abs(step)))
          return 0.;
      return step;
    }

    /** One coordinate of all points: the lines of the grid that they lie on. */
    struct GridAxis
    {
      explicit GridAxis(const std::vector<double> &values)
      {
        if (!all_finite(values))
          return;
        const std::vector<double> lines = distinct(values);
        const double              step  = regular_step(lines);
        if (step == 0. && lines.size() > 1)
          return;
        size    = lines.size();
        spacing = step;
        for (const double value : values)
          index.push_back(
            step > 0. ? std::lround((value - lines.front()) / step) : 0);
      }

      /** 0 if the values are not equally spaced. */
      std::size_t              size    = 0;
      double                   spacing = 0.;
      std::vector<std::size_t> index;
    };

    /** Two rows at one place of the grid, or nothing. */
    std::optional<std::pair<std::size_t, std::size_t>>
    find_repeated_place(const PointList &list)
    {
      std::vector<std::size_t> row_at(list.nx * list.ny, list.place.size());
      for (std::size_t row = 0; row < list.place.size(); ++row)
        {
          std::size_t &other = row_at[list.place[row]];
          if (other < list.place.size())
            return {{other, row}};
          other = row;
        }
      return {};
    }

    std::string
    name_of_lines(const TextTable &table, const std::size_t n)
    {
      return "holds " + std::to_string(n) + " columns in " +
             std::to_string(table.n_rows()) + " rows";
    }

    /** Columns x z. */
    std::optional<PointList>
    find_profile(const TextTable &table, std::string &reason)
    {
      const auto x    = column(table, 0);
      reason          = "are not equally spaced as the x of a profile x z are";
      const bool fits = all_finite(x) && regular_step(x) != 0.;
      if (!fits || table.n_rows() < 3)
        return {};
      PointList list;
      list.nx            = x.size();
      list.ny            = 1;
      list.dx            = std::abs(regular_step(x));
      list.dy            = list.dx;
      list.height_column = 1;
      for (std::size_t row = 0; row < x.size(); ++row)
        list.place.push_back(regular_step(x) > 0. ? row : x.size() - 1 - row);
      return list;
    }

    /** Columns x y z and perhaps further ones. */
    std::optional<PointList>
    find_grid(const TextTable &table, std::string &reason)
    {
      GridAxis x(column(table, 0)), y(column(table, 1));
      if (x.size == 1 && y.size > 1)
        std::swap(x, y);
      const std::size_t n = table.n_rows();
      reason = "do not lie on a regular grid as the points of a list x y z do";
      if (x.size < 2 || y.size < 1 || n < 2)
        return {};
      // A few numbers of a matrix may lie on a grid by chance.
      const double least_filled = table.n_columns == 3 && n > 9 ? 0.05 : 0.5;
      if (static_cast<double>(n) <= least_filled * x.size * y.size)
        {
          reason = "fill less than " +
                   std::to_string(std::lround(100. * least_filled)) +
                   " % of a grid of " + std::to_string(x.size) + " x " +
                   std::to_string(y.size) + " points";
          return {};
        }
      PointList list;
      list.nx            = x.size;
      list.ny            = y.size;
      list.dx            = x.spacing;
      list.dy            = y.size > 1 ? y.spacing : x.spacing;
      list.height_column = 2;
      for (std::size_t row = 0; row < n; ++row)
        list.place.push_back(y.index[row] * x.size + x.index[row]);
      if (const auto pair = find_repeated_place(list))
        {
          reason = "name the point of line " +
                   std::to_string(table.line_of_row[pair->first]) +
                   " again in line " +
                   std::to_string(table.line_of_row[pair->second]);
          return {};
        }
      return list;
    }
  } // namespace

  std::optional<PointList>
  find_point_list(const FileContent &file, const TextTable &table)
  {
    const std::size_t n = table.n_columns;
    if (n < 2)
      return {};
    std::string reason;
    const auto  list =
      n == 2 ? find_profile(table, reason) : find_grid(table, reason);
    if (list)
      return list;
    if (n <= 4 && table.n_rows() >= 3 * n)
      file.fail("text",
                name_of_lines(table, n) + " that " + reason +
                  "; a list x z or x y z on a regular grid, or a matrix with "
                  "more columns is expected");
    return {};
  }
} // namespace asperity
