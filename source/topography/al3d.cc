#include <asperity/topography/file_content.h>
#include <asperity/topography/read_height_map.h>

#include <algorithm>
#include <map>

// Alicona's format: a table of text tags, then float32 metres in padded rows.
namespace asperity
{
  namespace
  {
    const std::string format = "AL3D";

    constexpr std::size_t magic_size = 17;
    constexpr std::size_t key_size   = 20;
    constexpr std::size_t value_size = 30;
    constexpr std::size_t tag_size   = key_size + value_size + 2;

    std::map<std::string, std::string>
    read_tags(const FileContent &file)
    {
      std::map<std::string, std::string> tags;
      // Version and TagCount come first and are not counted.
      std::int64_t n = 2;
      for (std::int64_t i = 0; i < n; ++i)
        {
          const std::size_t at  = magic_size + i * tag_size;
          const std::string key = file.field(at, key_size);
          tags[key]             = file.field(at + key_size, value_size);
          if (i == 1)
            n += parse_integer(file, format, "TagCount", tags["TagCount"]);
          if (n < 2 || n > 10000)
            file.fail(format, "has a TagCount that is not plausible");
        }
      return tags;
    }
  } // namespace

  HeightMap
  read_al3d(const FileContent &file, const ReadOptions &)
  {
    auto       tags    = read_tags(file);
    const auto integer = [&](const std::string &key) {
      return parse_integer(file, format, key, tags[key]);
    };
    const auto number = [&](const std::string &key) {
      return parse_number(file, format, key, tags[key]);
    };
    const std::int64_t offset = integer("DepthImageOffset");
    if (offset <= 0 || offset > static_cast<std::int64_t>(file.bytes().size()))
      file.fail(format,
                "has no height image, or is cut off before it "
                "(DepthImageOffset " +
                  std::to_string(offset) + ")");
    // Pictures of other kinds may follow, or stand before.
    std::int64_t end_of_image = file.bytes().size();
    for (const auto &[key, value] : tags)
      if (key.size() > 6 && key.compare(key.size() - 6, 6, "Offset") == 0)
        if (double other = 0.; parse_decimal(value, other) && other > offset)
          end_of_image = std::min<double>(end_of_image, other);
    HeightMap map = allocate_map(file,
                                 format,
                                 integer("Cols"),
                                 integer("Rows"),
                                 end_of_image - offset,
                                 sizeof(float));
    map.dx        = number("PixelSizeXMeter");
    map.dy        = number("PixelSizeYMeter");
    if (map.dx <= 0. || map.dy <= 0.)
      file.fail(format, "has a pixel size that is not positive");

    const double      invalid   = tags.count("InvalidPixelValue") != 0 ?
                                    number("InvalidPixelValue") :
                                    std::numeric_limits<double>::infinity();
    const std::size_t row_bytes = (map.nx * sizeof(float) + 7) / 8 * 8;
    for (unsigned int row = 0; row < map.ny; ++row)
      for (unsigned int column = 0; column < map.nx; ++column)
        {
          const float raw = file.number<float>(offset + row * row_bytes +
                                               column * sizeof(float));
          // The tag's text has fewer digits than the float in the image.
          if (std::isfinite(raw) &&
              std::abs(raw - invalid) > 1e-6 * std::abs(invalid))
            map(column, row) = raw;
        }
    check_surplus(
      file, offset + map.ny * row_bytes, end_of_image, sizeof(float), map);
    map.provenance.unit_source = "AL3D fixes metres";
    map.provenance.description = "Alicona, " + tags["CreatingApplication"];
    return map;
  }
} // namespace asperity
