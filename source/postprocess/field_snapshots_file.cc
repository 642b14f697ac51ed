#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/base/version.h>
#include <asperity/postprocess/field_snapshots.h>
#include <asperity/postprocess/hdf5_file.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace asperity
{
  namespace
  {
    const char *const format_name = "asperity fields, version 1";

    /** Columns of the table `snapshots`, in order. */
    constexpr unsigned int n_numbers = 8;

    std::string
    word(const PlaceKind kind)
    {
      return kind == PlaceKind::nodes  ? "nodes" :
             kind == PlaceKind::points ? "points" :
             kind == PlaceKind::edge   ? "edge" :
                                         "whole";
    }

    /** "0: contact pressure [Pa]". A slash of a unit would be one of HDF5's
     *  paths. */
    std::string
    table_name(const std::size_t snapshot, const std::string &field)
    {
      std::string name = std::to_string(snapshot) + ": " + field;
      if (const auto slash = name.find('/'); slash != std::string::npos)
        name.replace(slash, 1, " per ");
      return name;
    }

    Hdf5Table
    rows_of(const std::vector<double> &values, const std::size_t n_columns)
    {
      return {values.size() / n_columns, n_columns, values};
    }

    /** "points 2 stress [Pa]", one a line. */
    std::string
    to_text(const std::vector<FieldKind> &fields)
    {
      std::string text;
      for (const FieldKind &kind : fields)
        text += word(kind.places) + " " + std::to_string(kind.n_components) +
                " " + kind.name + "\n";
      return text;
    }

    [[noreturn]] void
    fail(const std::string &path, const std::string &what)
    {
      throw InputError("The file " + quoted_name(path) + " " + what +
                       "; the fields of a run, as Output/Field times writes "
                       "them, are expected.");
    }

    std::vector<FieldKind>
    parse_fields(const std::string &text, const std::string &path)
    {
      std::vector<FieldKind> fields;
      for (const std::string &line : split(text, '\n'))
        {
          if (line.empty())
            continue; // behind the last one
          const std::size_t first  = line.find(' '),
                            second = line.find(' ', first + 1);
          if (first == std::string::npos || second == std::string::npos)
            fail(path, "has a field " + quoted_text(line));
          FieldKind kind{line.substr(second + 1),
                         PlaceKind::whole,
                         static_cast<unsigned int>(
                           std::strtoul(&line[first], nullptr, 10))};
          for (const PlaceKind places :
               {PlaceKind::nodes, PlaceKind::points, PlaceKind::edge})
            if (line.substr(0, first) == word(places))
              kind.places = places;
          if (kind.n_components < 1 || kind.n_components > 9)
            fail(path, "has a field " + quoted_text(line));
          fields.push_back(kind);
        }
      return fields;
    }

    unsigned int
    count(const double value, const std::string &path)
    {
      if (!(value >= 0. && value < 1e9) || value != std::floor(value))
        fail(path, "counts " + format_number(value));
      return static_cast<unsigned int>(value);
    }

    FieldSnapshot
    numbers_of(const double *row, const std::string &path)
    {
      FieldSnapshot s;
      s.time             = row[0];
      s.sliding_distance = row[1];
      s.direction        = row[2];
      s.pressure         = row[3];
      s.T_x              = row[4];
      s.T_y              = row[5];
      s.mu               = row[6];
      s.step             = count(row[7], path);
      return s;
    }

    const std::vector<double> &
    values_of(const Hdf5Content &content,
              const std::size_t  snapshot,
              const FieldKind   &kind,
              const FieldPlaces &places,
              const std::string &path)
    {
      const Hdf5Table &table =
        content.table(table_name(snapshot, kind.name), kind.n_components, path);
      if (table.n_rows != places.n_places(kind.places))
        fail(path,
             "has " + std::to_string(table.n_rows) + " values of " +
               quoted_name(kind.name) + " at " +
               std::to_string(places.n_places(kind.places)) + " places");
      if (!std::all_of(table.values.begin(),
                       table.values.end(),
                       [](const double x) { return std::isfinite(x); }))
        fail(path,
             "has a number of " + quoted_name(kind.name) +
               " that is not finite");
      return table.values;
    }

    void
    check_places(const FieldPlaces &places, const std::string &path)
    {
      const std::size_t gauss = places.n_gauss * places.n_gauss,
                        nodes = (places.n_subdivisions + 1) *
                                (places.n_subdivisions + 1);
      const std::size_t n_points = places.n_places(PlaceKind::points);
      if (places.n_gauss == 0 || places.n_gauss > 20 ||
          places.n_subdivisions > 20 || n_points == 0 ||
          n_points % gauss != 0 ||
          places.n_places(PlaceKind::nodes) != nodes * (n_points / gauss))
        fail(path, "has places that make no cells");
      if (places.n_places(PlaceKind::edge) < 2 || !(places.period > 0.))
        fail(path, "has no edge");
    }
  } // namespace



  Hdf5Content
  FieldSnapshots::content() const
  {
    Hdf5Content content;
    content.texts["format"]   = format_name;
    content.texts["program"]  = version_line();
    content.texts["fields"]   = to_text(fields);
    content.tables["nodes"]   = rows_of(places.nodes, 3);
    content.tables["points"]  = rows_of(places.points, 3);
    content.tables["edge"]    = rows_of(places.edge, 3);
    content.tables["shares"]  = rows_of(shares, 1);
    content.tables["numbers"] = {1,
                                 4,
                                 {places.period,
                                  1. * places.n_subdivisions,
                                  1. * places.n_gauss,
                                  is_quasi_static ? 1. : 0.}};
    std::vector<double> numbers;
    for (std::size_t i = 0; i < snapshots.size(); ++i)
      {
        const FieldSnapshot &s = snapshots[i];
        numbers.insert(numbers.end(),
                       {s.time,
                        s.sliding_distance,
                        s.direction,
                        s.pressure,
                        s.T_x,
                        s.T_y,
                        s.mu,
                        1. * s.step});
        for (std::size_t f = 0; f < fields.size(); ++f)
          content.tables[table_name(i, fields[f].name)] =
            rows_of(s.values[f], fields[f].n_components);
      }
    content.tables["snapshots"] = rows_of(numbers, n_numbers);
    return content;
  }



  void
  FieldSnapshots::write(const std::string &path) const
  {
    content().write(path);
  }



  FieldSnapshots
  FieldSnapshots::read(const std::string &path)
  {
    const Hdf5Content content = Hdf5Content::read(path, "fields of a run");
    if (content.text("format", path) != format_name)
      fail(path, "has the format " + quoted_text(content.text("format", path)));
    return from_content(content, path);
  }



  FieldSnapshots
  FieldSnapshots::from_content(const Hdf5Content &content,
                               const std::string &path)
  {
    FieldSnapshots result;
    result.fields        = parse_fields(content.text("fields", path), path);
    result.places.nodes  = content.table("nodes", 3, path).values;
    result.places.points = content.table("points", 3, path).values;
    result.places.edge   = content.table("edge", 3, path).values;
    result.shares        = content.table("shares", 1, path).values;
    const std::vector<double> &numbers =
      content.table("numbers", 4, path).values;
    if (numbers.size() != 4)
      fail(path, "has no numbers");
    result.places.period         = numbers[0];
    result.places.n_subdivisions = count(numbers[1], path);
    result.places.n_gauss        = count(numbers[2], path);
    result.is_quasi_static       = numbers[3] != 0.;
    check_places(result.places, path);
    const Hdf5Table &rows = content.table("snapshots", n_numbers, path);
    for (std::size_t i = 0; i < rows.n_rows; ++i)
      {
        const double *row = &rows.values[n_numbers * i];
        FieldSnapshot s   = numbers_of(row, path);
        for (const FieldKind &kind : result.fields)
          s.values.push_back(values_of(content, i, kind, result.places, path));
        result.snapshots.push_back(s);
      }
    return result;
  }
} // namespace asperity
