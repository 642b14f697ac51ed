#include <asperity/topography/file_content.h>
#include <asperity/topography/read_height_map.h>
#include <asperity/topography/text_cells.h>

#include <algorithm>
#include <limits>
#include <map>

// Surface data files of ISO 25178-71, ASCII and binary.
namespace asperity
{
  namespace
  {
    const std::string ascii_format  = "SDF, ASCII";
    const std::string binary_format = "SDF, binary";

    void
    set_scales(const FileContent &file,
               const double       x,
               const double       y,
               HeightMap         &map)
    {
      if (!(x > 0. && std::isfinite(x)) ||
          (map.ny > 1 && !(y > 0. && std::isfinite(y))))
        file.fail(map.provenance.format,
                  "has a spacing (Xscale, Yscale) that is not positive");
      map.dx                     = x;
      map.dy                     = y > 0. && std::isfinite(y) ? y : x;
      map.provenance.unit_source = "SDF fixes metres";
    }

    void
    refuse_compression(const FileContent &file,
                       const std::string &format,
                       const std::int64_t compression)
    {
      if (compression != 0)
        file.fail(format,
                  "is compressed (Compression " + std::to_string(compression) +
                    "); export it without compression");
    }

    /** Heights of type T from @p offset on; z = raw * scale. */
    template <typename T>
    void
    read_raw(const FileContent &file,
             const std::size_t  offset,
             const double       scale,
             HeightMap         &map)
    {
      for (std::size_t i = 0; i < map.heights.size(); ++i)
        {
          const T    raw     = file.number<T>(offset + i * sizeof(T));
          const bool missing = std::numeric_limits<T>::is_integer ?
                                 std::numeric_limits<T>::is_signed &&
                                   raw == std::numeric_limits<T>::min() :
                                 !std::isfinite(static_cast<double>(raw));
          if (!missing)
            map.heights[i] = scale * static_cast<double>(raw);
        }
    }

    HeightMap
    read_binary(const FileContent &file)
    {
      const std::string &format = binary_format;
      // magic 8, manufacturer 10, creation 12, modification 12
      file.require(0, 81);
      const auto   nx          = file.number<std::uint16_t>(42);
      const auto   ny          = file.number<std::uint16_t>(44);
      const double x_scale     = file.number<double>(46);
      const double y_scale     = file.number<double>(54);
      const double z_scale     = file.number<double>(62);
      const int    compression = file.number<std::uint8_t>(78);
      const int    type        = file.number<std::uint8_t>(79);
      refuse_compression(file, format, compression);
      if (!std::isfinite(z_scale) || z_scale == 0.)
        file.fail(format, "has a height scale (Zscale) of zero or no number");

      static const std::map<int, unsigned int> sizes = {
        {0, 1}, {1, 2}, {2, 4}, {3, 4}, {4, 1}, {5, 2}, {6, 4}, {7, 8}};
      if (sizes.count(type) == 0)
        file.fail(format,
                  "has DataType " + std::to_string(type) +
                    "; 0 to 7 is expected");
      HeightMap map = allocate_map(
        file, format, nx, ny, file.bytes().size() - 81, sizes.at(type));
      set_scales(file, x_scale, y_scale, map);
      switch (type)
        {
          case 0:
            read_raw<std::uint8_t>(file, 81, z_scale, map);
            break;
          case 1:
            read_raw<std::uint16_t>(file, 81, z_scale, map);
            break;
          case 2:
            read_raw<std::uint32_t>(file, 81, z_scale, map);
            break;
          case 3:
            read_raw<float>(file, 81, z_scale, map);
            break;
          case 4:
            read_raw<std::int8_t>(file, 81, z_scale, map);
            break;
          case 5:
            read_raw<std::int16_t>(file, 81, z_scale, map);
            break;
          case 6:
            read_raw<std::int32_t>(file, 81, z_scale, map);
            break;
          default:
            read_raw<double>(file, 81, z_scale, map);
        }
      check_surplus(file,
                    81 + map.heights.size() * sizes.at(type),
                    file.bytes().size(),
                    sizes.at(type),
                    map);
      map.provenance.description = file.field(8, 10);
      return map;
    }

    /** The lines "key = value" up to the one that is "*"; moves @p position. */
    std::map<std::string, std::string>
    read_header(const FileContent &file, std::size_t &position)
    {
      const std::string                 &text = file.bytes();
      std::map<std::string, std::string> header;
      while (position < text.size())
        {
          const auto end  = std::min(text.find('\n', position), text.size());
          const auto line = strip(text.substr(position, end - position));
          position        = std::min(end + 1, text.size());
          if (line == "*")
            return header;
          const auto equal = line.find('=');
          if (equal != std::string::npos)
            header[strip(line.substr(0, equal))] =
              strip(line.substr(equal + 1));
        }
      file.fail(ascii_format, "is cut off inside its header");
    }

    /** The next word, or "" at the end of the file. */
    std::string
    next_word(const std::string &text, std::size_t &position)
    {
      const std::string blank(" \t\r\n\0", 5);
      const auto        first = text.find_first_not_of(blank, position);
      if (first == std::string::npos)
        return "";
      const auto last = std::min(text.find_first_of(blank, first), text.size());
      position        = last;
      return text.substr(first, last - first);
    }

    HeightMap
    read_ascii(const FileContent &file)
    {
      const std::string &format   = ascii_format;
      std::size_t        position = std::min(file.bytes().find('\n'), //
                                      file.bytes().size());
      auto               header   = read_header(file, position);
      const auto         number   = [&](const std::string &key) {
        return parse_number(file, format, key, header[key]);
      };
      const auto integer = [&](const std::string &key) {
        return parse_integer(file, format, key, header[key]);
      };
      if (header.count("Compression") != 0)
        refuse_compression(file, format, integer("Compression"));
      HeightMap map = allocate_map(file,
                                   format,
                                   integer("NumPoints"),
                                   integer("NumProfiles"),
                                   file.bytes().size() - position,
                                   1);
      set_scales(file, number("Xscale"), number("Yscale"), map);
      const double scale = number("Zscale");
      if (scale == 0.)
        file.fail(format, "has a height scale (Zscale) of zero");

      for (std::size_t i = 0; i < map.heights.size(); ++i)
        {
          const std::string word = next_word(file.bytes(), position);
          if (word.empty() || word == "*")
            file.fail(format,
                      "is cut off: its size states " +
                        std::to_string(map.heights.size()) +
                        " heights, and it lists " + std::to_string(i));
          if (!is_void_word(word))
            map.heights[i] =
              scale * parse_number(file,
                                   format,
                                   "height " + std::to_string(i + 1),
                                   word);
        }
      if (next_word(file.bytes(), position) != "*")
        file.fail(format,
                  "does not close its " + std::to_string(map.heights.size()) +
                    " heights with '*': it is cut off, or its size is wrong");
      map.provenance.description = header["ManufacID"];
      return map;
    }
  } // namespace

  HeightMap
  read_sdf(const FileContent &file, const ReadOptions &)
  {
    return file.starts_with("a") ? read_ascii(file) : read_binary(file);
  }
} // namespace asperity
