#include <asperity/base/text.h>
#include <asperity/topography/read_height_map.h>
#include <asperity/topography/text_header.h>
#include <asperity/topography/text_list.h>

#include <cmath>

// Text: a matrix of heights, or a list of points "x z" or "x y z". Which one it
// is, which separator and which decimal sign it uses, is seen from its lines.
namespace asperity
{
  namespace
  {
    /** "a, b and c" */
    std::string
    enumerate(const std::vector<std::string> &parts)
    {
      std::string text;
      for (std::size_t i = 0; i < parts.size(); ++i)
        text += (i == 0                ? "" :
                 i + 1 == parts.size() ? " and " :
                                         ", ") +
                parts[i];
      return text;
    }

    /** Refuses a text of which @p missing entries are not known. */
    [[noreturn]] void
    ask_for(const FileContent              &file,
            const std::string              &format,
            const TextHeader               &header,
            const std::string              &what,
            const std::vector<std::string> &missing)
    {
      std::string found;
      for (const std::string &line : header.not_understood)
        found +=
          (found.empty() ? " (of its header, " : ", ") + quoted_text(line);
      if (!found.empty())
        found += " is no length that is understood)";
      file.fail(format,
                what + found + "; give " + enumerate(missing) +
                  " in the subsection Topography of a parameter file");
    }

    /** The user may repeat what the header says, but not contradict it. */
    void
    compare(const FileContent           &file,
            const std::string           &entry,
            const double                 given,
            const std::optional<double> &stated,
            const TextHeader            &header)
    {
      if (given > 0. && stated && std::abs(given / *stated - 1.) > 0.01)
        file.fail("text",
                  "says in its header (" + quoted_text(header.lines.front()) +
                    ", ...) that " + entry + " is " + std::to_string(*stated) +
                    " m or m per unit, and the parameter file gives another; "
                    "leave out the entry, or correct the header");
    }

    double
    height_unit(const FileContent &file,
                const TextHeader  &header,
                const ReadOptions &options)
    {
      compare(
        file, "Height unit", options.height_unit, header.height_unit, header);
      return header.height_unit.value_or(options.height_unit);
    }

    void
    note_source(const TextHeader &header, HeightMap &map)
    {
      map.provenance.unit_source = "given by the user";
      if (header.lines.empty())
        return;
      map.provenance.unit_source = "lines of the header";
      std::string note           = "Reading: the header says ";
      for (const std::string &line : header.lines)
        note +=
          (&line == &header.lines.front() ? "" : ", ") + quoted_text(line);
      map.provenance.notes.push_back(note + ".");
    }

    HeightMap
    map_of_points(const FileContent &file,
                  const TextTable   &table,
                  const PointList   &list,
                  const TextHeader  &header,
                  const ReadOptions &options)
    {
      const std::string format =
        list.height_column == 1 ? "text, x z" : "text, x y z";
      const double z_unit = height_unit(file, header, options);
      if (!(z_unit > 0.) || !(options.lateral_unit > 0.))
        {
          std::vector<std::string> missing;
          if (!(z_unit > 0.))
            missing.push_back("the unit of its heights (Height unit)");
          if (!(options.lateral_unit > 0.))
            missing.push_back("that of its coordinates (Lateral unit)");
          ask_for(file, format, header, "carries no unit", missing);
        }
      HeightMap map =
        allocate_map(file, format, list.nx, list.ny, list.nx * list.ny, 1);
      map.dx = list.dx * options.lateral_unit;
      map.dy = list.dy * options.lateral_unit;
      for (std::size_t row = 0; row < table.n_rows(); ++row)
        map.heights[list.place[row]] = table(row, list.height_column) * z_unit;
      if (table.n_columns > list.height_column + 1)
        map.provenance.warnings.push_back(
          "The list holds " + std::to_string(table.n_columns) +
          " columns; x, y and z are read from the first three.");
      return map;
    }

    /** Whether the values from the first to the last one are equally spaced,
     *  and so many that heights hardly would be by chance. */
    template <class Values>
    bool
    are_coordinates(const Values     &value,
                    const std::size_t first,
                    const std::size_t end)
    {
      if (end < first + 6)
        return false;
      const double step = value(first + 1) - value(first);
      for (std::size_t i = first + 1; i < end; ++i)
        if (!(std::abs(value(i) - value(i - 1) - step) <=
              1e-3 * std::abs(step)))
          return false;
      return step != 0.;
    }

    /** Where a matrix has coordinates instead of heights; empty if nowhere. The
     *  corner does not continue them, or the next line does not go on alike, as
     *  they would on a plane. */
    std::string
    edges_with_coordinates(const TextTable &table)
    {
      const std::size_t nx = table.n_columns, ny = table.n_rows();
      const auto        row = [&](const std::size_t j) {
        return [&table, j](const std::size_t i) { return table(j, i); };
      };
      const auto column = [&](const std::size_t i) {
        return [&table, i](const std::size_t j) { return table(j, i); };
      };
      if (are_coordinates(row(0), 1, nx) && !are_coordinates(row(0), 0, nx) &&
          are_coordinates(column(0), 1, ny) &&
          !are_coordinates(column(0), 0, ny))
        return "first row and first column";
      if (ny > 1 && are_coordinates(row(0), 0, nx) &&
          !are_coordinates(row(1), 0, nx))
        return "first row";
      if (nx > 1 && are_coordinates(column(0), 0, ny) &&
          !are_coordinates(column(1), 0, ny))
        return "first column";
      return "";
    }

    /** Refuses what would be heights of something else in a matrix. */
    void
    check_matrix(const FileContent &file, TextTable &table)
    {
      if (table.blocks.size() > 1 && table.blocks.size() < table.n_rows())
        {
          const TextTable::Block &second = table.blocks[1];
          if (second.comment.empty())
            file.fail("text, matrix",
                      "has a blank line within its matrix (line " +
                        std::to_string(second.separator_line) +
                        "), as between two channels; one matrix is expected");
          table.keep_first_block();
        }
      const std::string edges = edges_with_coordinates(table);
      if (!edges.empty())
        file.fail("text, matrix",
                  "has coordinates in its " + edges +
                    "; a matrix of heights alone is expected");
    }

    void
    compare_size(const FileContent                 &file,
                 const std::string                 &what,
                 const std::optional<std::int64_t> &stated,
                 const std::size_t                  found)
    {
      if (stated && *stated != static_cast<std::int64_t>(found))
        file.fail("text, matrix",
                  "says in its header that it has " + std::to_string(*stated) +
                    " " + what + ", and holds " + std::to_string(found));
    }

    HeightMap
    map_of_matrix(const FileContent &file,
                  const TextTable   &table,
                  const TextHeader  &header,
                  const ReadOptions &options)
    {
      const std::string format = "text, matrix";
      const std::size_t nx = table.n_columns, ny = table.n_rows();
      compare_size(file, "columns (x-pixels)", header.nx, nx);
      compare_size(file, "rows (y-pixels)", header.ny, ny);
      std::optional<double> dx, dy;
      if (header.length_x)
        dx = *header.length_x / nx;
      if (header.length_y)
        dy = *header.length_y / ny;
      compare(file, "Spacing x", options.spacing_x, dx, header);
      compare(file, "Spacing y", options.spacing_y, dy, header);
      const double             z_unit    = height_unit(file, header, options);
      const double             spacing_x = dx.value_or(options.spacing_x);
      const double             spacing_y = dy.value_or(options.spacing_y);
      std::vector<std::string> missing;
      if (!(z_unit > 0.))
        missing.push_back("the unit of its heights (Height unit)");
      if (!(spacing_x > 0. && spacing_y > 0.))
        missing.push_back("the spacing of its samples (Spacing x, and Spacing "
                          "y if it differs)");
      if (!missing.empty())
        ask_for(file,
                format,
                header,
                z_unit > 0. ?
                  "holds " + std::to_string(nx) + " x " + std::to_string(ny) +
                    " heights without coordinates" :
                  "carries no unit",
                missing);
      HeightMap map = allocate_map(file, format, nx, ny, nx * ny, 1);
      map.dx        = spacing_x;
      map.dy        = spacing_y;
      for (std::size_t i = 0; i < map.heights.size(); ++i)
        map.heights[i] = table.values[i] * z_unit;
      return map;
    }
  } // namespace

  HeightMap
  read_text(const FileContent &file, const ReadOptions &options)
  {
    TextTable  table = read_text_table(file);
    const auto list  = find_point_list(file, table);
    if (!list)
      check_matrix(file, table);
    const TextHeader header = read_text_header(table.header);
    HeightMap map = list ? map_of_points(file, table, *list, header, options) :
                           map_of_matrix(file, table, header, options);
    note_source(header, map);
    for (const std::string &note : table.notes)
      map.provenance.notes.push_back(note);
    for (const std::string &warning : table.warnings)
      map.provenance.warnings.push_back(warning);
    return map;
  }
} // namespace asperity
