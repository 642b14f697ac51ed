#include <asperity/base/text.h>
#include <asperity/topography/file_content.h>
#include <asperity/topography/length_unit.h>
#include <asperity/topography/read_height_map.h>

#include <map>

// Gwyddion Simple Field: a text header, NULs up to a multiple of four bytes,
// then float32.
namespace asperity
{
  namespace
  {
    const std::string format = "GSF";

    /** Header lines "key = value" between the magic line and the NULs. */
    std::map<std::string, std::string>
    read_header(const FileContent &file, const std::size_t end)
    {
      std::map<std::string, std::string> header;
      const std::string                 &text = file.bytes();
      std::size_t position = std::min(text.find('\n'), end - 1) + 1;
      while (position < end)
        {
          const auto line_end = std::min(text.find('\n', position), end);
          const auto line     = text.substr(position, line_end - position);
          position            = line_end + 1;
          const auto equal    = line.find('=');
          if (equal == std::string::npos)
            file.fail(format,
                      "has the header line " + quoted_text(line) +
                        "; 'key = value' is expected");
          header[strip(line.substr(0, equal))] = strip(line.substr(equal + 1));
        }
      return header;
    }

    double
    unit(const FileContent &file,
         const std::string &name,
         const std::string &key,
         const double       given,
         HeightMap         &map)
    {
      if (!name.empty())
        {
          const double metre = metres_per(name);
          if (metre == 0.)
            file.fail(format,
                      "has " + key + " = " + quoted_text(name) +
                        "; a unit of length is expected for a height map");
          return metre;
        }
      if (given > 0.)
        return given;
      map.provenance.has_unit = false;
      map.provenance.warnings.push_back("The header has no " + key +
                                        ": metres are assumed.");
      return 1.;
    }
  } // namespace

  HeightMap
  read_gsf(const FileContent &file, const ReadOptions &options)
  {
    const auto header_end = file.bytes().find('\0');
    if (header_end == std::string::npos)
      file.fail(format, "is cut off inside its header");
    auto header = read_header(file, header_end);
    if (header.count("XRes") == 0 || header.count("YRes") == 0)
      file.fail(format, "has no XRes and YRes in its header");
    // One to four NULs: there is always at least one.
    const std::size_t start = header_end + 4 - header_end % 4;
    file.require(start, 0);

    HeightMap map =
      allocate_map(file,
                   format,
                   parse_integer(file, format, "XRes", header["XRes"]),
                   parse_integer(file, format, "YRes", header["YRes"]),
                   file.bytes().size() - start,
                   sizeof(float));
    check_surplus(file,
                  start + map.heights.size() * sizeof(float),
                  file.bytes().size(),
                  sizeof(float),
                  map);
    map.provenance.unit_source = "units in the file's header";
    const double xy_unit =
      unit(file, header["XYUnits"], "XYUnits", options.lateral_unit, map);
    const double z_unit =
      unit(file, header["ZUnits"], "ZUnits", options.height_unit, map);
    const auto length = [&](const std::string &key) {
      if (header.count(key) == 0)
        {
          map.provenance.has_unit = false;
          map.provenance.warnings.push_back("The header has no " + key +
                                            ": 1 is assumed.");
          return 1.;
        }
      const double value = parse_number(file, format, key, header[key]);
      if (value <= 0.)
        file.fail(format, "has a size " + key + " that is not positive");
      return value;
    };
    map.dx = length("XReal") * xy_unit / map.nx;
    map.dy = length("YReal") * xy_unit / map.ny;
    for (std::size_t i = 0; i < map.heights.size(); ++i)
      {
        const float raw = file.number<float>(start + i * sizeof(float));
        if (std::isfinite(raw))
          map.heights[i] = raw * z_unit;
      }
    map.provenance.description = header["Title"];
    return map;
  }
} // namespace asperity
