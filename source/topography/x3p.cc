#include <asperity/base/md5.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/topography/file_content.h>
#include <asperity/topography/read_height_map.h>
#include <asperity/topography/text_cells.h>
#include <asperity/topography/xml.h>
#include <asperity/topography/zip_archive.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    const std::string format = "X3P";

    struct Axis
    {
      char   type      = 'I';
      char   data      = 'D';
      double increment = 1.;
      double offset    = 0.;

      bool has_increment = false;

      bool
      has_whole_numbers() const
      {
        return data == 'I' || data == 'L';
      }
    };

    /** As @p parse_number, but empty or absent elements give @p otherwise. */
    double
    optional_number(const FileContent &file,
                    const Tree        &tree,
                    const std::string &name,
                    const double       otherwise)
    {
      const std::string text = strip(tree.get<std::string>(name, ""));
      return text.empty() ? otherwise : parse_number(file, format, name, text);
    }

    Axis
    read_axis(const FileContent &file,
              const Tree        &axes,
              const std::string &name)
    {
      const auto tree = axes.get_child_optional(name);
      if (!tree)
        file.fail(format, "describes no axis " + name + " in its main.xml");
      Axis       axis;
      const auto type = strip(tree->get<std::string>("AxisType", ""));
      const auto data = strip(tree->get<std::string>("DataType", "D"));
      if (type != "I" && type != "A")
        file.fail(format,
                  "has " + quoted_text(type) + " as type of axis " + name +
                    "; I (incremental) or A (absolute) is expected");
      if (data != "I" && data != "L" && data != "F" && data != "D")
        file.fail(format,
                  "has " + quoted_text(data) + " as data type of axis " + name +
                    "; I, L, F or D is expected");
      axis.type = type[0];
      axis.data = data[0];
      axis.has_increment =
        !strip(tree->get<std::string>("Increment", "")).empty();
      axis.increment = optional_number(file, *tree, "Increment", 1.);
      axis.offset    = optional_number(file, *tree, "Offset", 0.);
      return axis;
    }

    /**
     * Metres per unit of the stored heights. The schema (iso5436_2.xsd) gives
     * an increment to incremental axes and to whole numbers; real heights on
     * an absolute axis are metres, as the reference implementation reads them.
     */
    double
    height_scale(const FileContent &file, const Axis &z, HeightMap &map)
    {
      if (z.type == 'I' || z.has_whole_numbers())
        {
          if (!z.has_increment)
            file.fail(format,
                      "has heights in steps (AxisType " +
                        std::string(1, z.type) + ", DataType " +
                        std::string(1, z.data) +
                        ") without the Increment that gives them a length");
          return z.increment;
        }
      if (z.has_increment && z.increment != 1.)
        map.provenance.warnings.push_back(
          "The Increment " + format_number(z.increment) +
          " of the absolute axis CZ with real heights (DataType " +
          std::string(1, z.data) +
          ") is not applied: by ISO 25178-72 such heights are metres.");
      return 1.;
    }

    void
    compare_md5(HeightMap         &map,
                const std::string &stated,
                const std::string &bytes)
    {
      std::string lower = strip(stated);
      std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
      });
      if (!lower.empty() && lower != md5(bytes))
        map.provenance.warnings.push_back(
          "The MD5 checksum of the heights is not the one that main.xml "
          "states: the file was changed after it was measured.");
    }

    unsigned int
    size_of(const char type)
    {
      return type == 'I' ? 2 : type == 'D' ? 8 : 4;
    }

    double
    raw_value(const char *bytes, const char type)
    {
      // Integers are signed (openGPS reference implementation).
      const auto get = [bytes](auto value) {
        std::memcpy(&value, bytes, sizeof(value));
        return static_cast<double>(value);
      };
      switch (type)
        {
          case 'I':
            return get(std::int16_t());
          case 'L':
            return get(std::int32_t());
          case 'F':
            return get(float());
          default:
            return get(double());
        }
    }

    /** The bits of valid.bin, one a point, or an empty string. */
    std::string
    read_valid_bits(const FileContent &file,
                    const ZipArchive  &archive,
                    const Tree        &link,
                    const std::size_t  n)
    {
      const auto name  = strip(link.get<std::string>("ValidPointsLink", ""));
      const auto entry = archive.find(name);
      if (name.empty())
        return "";
      if (entry.empty())
        file.fail(format,
                  "lacks its list of valid points " + quoted_text(name));
      const std::string valid = archive.read(entry, n / 8 + 1024);
      if (valid.size() < (n + 7) / 8)
        file.fail(format, "has too few bits in " + quoted_name(entry));
      return valid;
    }

    /** Points along x and y. */
    struct MatrixSize
    {
      std::int64_t nx = 0;
      std::int64_t ny = 0;
    };

    /** Heights of bindata/data.bin, missing points of valid.bin. */
    HeightMap
    read_binary(const FileContent &file,
                const ZipArchive  &archive,
                const Tree        &link,
                const Axis        &z,
                const MatrixSize  &size)
    {
      const auto name  = strip(link.get<std::string>("PointDataLink", ""));
      const auto entry = archive.find(name);
      if (name.empty() || entry.empty())
        file.fail(format, "lacks its heights " + quoted_text(name));
      HeightMap         map   = allocate_map(file,
                                   format,
                                   size.nx,
                                   size.ny,
                                   archive.stated_size(entry),
                                   size_of(z.data));
      const std::size_t n     = map.heights.size();
      const double      scale = height_scale(file, z, map);
      const std::size_t need  = n * size_of(z.data);
      const std::string bytes = archive.read(entry, need);
      if (bytes.size() < need)
        file.fail(format,
                  "is cut off: " + std::to_string(n) + " points need " +
                    std::to_string(need) + " bytes, and " + quoted_name(entry) +
                    " has " + std::to_string(bytes.size()));
      compare_md5(map,
                  link.get<std::string>("MD5ChecksumPointData", ""),
                  bytes);

      const std::string valid = read_valid_bits(file, archive, link, n);
      for (std::size_t i = 0; i < n; ++i)
        {
          const double raw =
            raw_value(bytes.data() + i * size_of(z.data), z.data);
          const bool is_valid =
            valid.empty() ||
            ((static_cast<unsigned char>(valid[i / 8]) >> (i % 8)) & 1u);
          // Alicona's exporter writes infinity for a missing point.
          if (is_valid && std::isfinite(raw))
            map.heights[i] = z.offset + scale * raw;
        }
      return map;
    }

    /** Heights as a list of Datum elements, an empty one is missing. */
    HeightMap
    read_list(const FileContent &file,
              const Tree        &list,
              const Axis        &z,
              const MatrixSize  &size)
    {
      HeightMap map =
        allocate_map(file, format, size.nx, size.ny, list.size(), 1);
      const double scale = height_scale(file, z, map);
      std::size_t  i     = 0;
      for (const auto &[name, datum] : list)
        {
          if (name != "Datum")
            continue;
          if (i == map.heights.size())
            file.fail(format, "lists more heights than its size states");
          std::string text = strip(datum.get_value<std::string>());
          // A list carries x;y;z where axes are absolute: the last one counts.
          const auto split = text.find_last_of(";");
          if (split != std::string::npos)
            text = strip(text.substr(split + 1));
          if (!is_void_word(text))
            map.heights[i] =
              z.offset + scale * parse_number(file, format, "Datum", text);
          ++i;
        }
      if (i < map.heights.size())
        file.fail(format,
                  "is cut off: its size states " +
                    std::to_string(map.heights.size()) +
                    " heights, and it lists " + std::to_string(i));
      return map;
    }

    std::string
    description(const Tree &root)
    {
      std::string text;
      for (const char *key : {"Record2.Instrument.Manufacturer",
                              "Record2.Instrument.Model",
                              "Record2.ProbingSystem.Identification",
                              "Record2.Creator",
                              "Record2.Date",
                              "Record2.Comment"})
        {
          const auto part = strip(root.get<std::string>(key, ""));
          // The epoch stands for an unknown date.
          if (!part.empty() && part != "not available" &&
              part != "1970-01-01T00:00:00")
            text += (text.empty() ? "" : "; ") + part;
        }
      return text;
    }

    void
    refuse_what_is_no_height_map(const FileContent &file,
                                 const std::string &feature,
                                 const Axis        &x,
                                 const Axis        &y)
    {
      if (feature == "PCL")
        file.fail(format,
                  "holds a point cloud (FeatureType PCL); heights on a regular "
                  "grid (SUR or PRF) are expected");
      if (feature != "SUR" && feature != "PRF")
        file.fail(format,
                  "has FeatureType " + quoted_text(feature) +
                    "; SUR or PRF is expected");
      for (const auto &[axis, name] : {std::make_pair(x, "X"), {y, "Y"}})
        if (axis.type == 'A')
          file.fail(format,
                    std::string("has absolute coordinates along ") + name +
                      " (AxisType A); an incremental axis is expected");
    }

    /** The root has the name ISO5436_2 with some prefix, or ISO5436. */
    const Tree &
    find_root(const FileContent &file, const Tree &document)
    {
      for (const auto &[name, tree] : document)
        if (name.find("ISO5436") != std::string::npos)
          return tree;
      file.fail(format, "has a main.xml without the element ISO5436_2");
    }

    /** A profile may state its size as a list. */
    MatrixSize
    read_size(const FileContent &file, const Tree &record)
    {
      const auto list = record.get_optional<std::string>("ListDimension");
      if (list)
        return {parse_integer(file, format, "ListDimension", *list), 1};
      const auto size = [&](const std::string &name) {
        const std::string key = "MatrixDimension.Size" + name;
        return parse_integer(file,
                             format,
                             "Size" + name,
                             record.get<std::string>(key, ""));
      };
      if (size("Z") != 1)
        file.fail(format, "has more than one layer; SizeZ 1 is expected");
      return {size("X"), size("Y")};
    }

    void
    set_spacing(const ReadOptions &options,
                const Axis        &x,
                const Axis        &y,
                HeightMap         &map)
    {
      map.dx                     = std::abs(x.increment);
      map.dy                     = std::abs(y.increment);
      map.provenance.unit_source = "X3P fixes metres";
      if (x.increment == 1. && (map.ny == 1 || y.increment == 1.))
        {
          // A metre between samples: nobody set the increment.
          map.provenance.has_unit    = false;
          map.provenance.unit_source = "none: Increment is 1 in x and y";
          map.provenance.warnings.push_back(
            "Increment 1 in x and y: the file carries no unit.");
          if (options.lateral_unit > 0. && options.height_unit > 0.)
            {
              map.dx *= options.lateral_unit;
              map.dy *= options.lateral_unit;
              for (double &height : map.heights)
                height *= options.height_unit;
              map.provenance.has_unit    = true;
              map.provenance.unit_source = "given by the user";
            }
        }
    }
  } // namespace

  HeightMap
  read_x3p(const FileContent &file, const ReadOptions &options)
  {
    const ZipArchive  archive(file, format);
    const std::string main_xml = archive.find("main.xml");
    if (main_xml.empty())
      file.fail(format, "is a ZIP archive without a main.xml");
    const Tree document =
      parse_xml(file, format, archive.read(main_xml, std::size_t(1) << 26));
    const Tree &root = find_root(file, document);
    const auto  axes = root.get_child_optional("Record1.Axes");
    if (!axes)
      file.fail(format, "describes no axes in its main.xml");
    const std::string feature =
      strip(root.get<std::string>("Record1.FeatureType", ""));
    const Axis x = read_axis(file, *axes, "CX");
    const Axis y = read_axis(file, *axes, "CY");
    const Axis z = read_axis(file, *axes, "CZ");
    refuse_what_is_no_height_map(file, feature, x, y);

    const auto record = root.get_child_optional("Record3");
    if (!record)
      file.fail(format, "lacks Record3 with the heights in its main.xml");
    const auto link = record->get_child_optional("DataLink");
    const auto list = record->get_child_optional("DataList");
    if (!link && !list)
      file.fail(format, "has neither DataLink nor DataList in its main.xml");
    if (x.increment == 0. || y.increment == 0.)
      file.fail(format, "has an Increment of zero; a spacing is expected");
    const MatrixSize size = read_size(file, *record);
    HeightMap        map  = link ? read_binary(file, archive, *link, z, size) :
                                   read_list(file, *list, z, size);
    set_spacing(options, x, y, map);
    map.provenance.description = description(root);
    return map;
  }
} // namespace asperity
