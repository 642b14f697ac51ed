#include <asperity/base/text.h>
#include <asperity/topography/file_content.h>
#include <asperity/topography/length_unit.h>
#include <asperity/topography/read_height_map.h>

#include <zlib.h>

#include <algorithm>
#include <vector>

// Digital Surf (MountainsMap) files, plain and compressed.
namespace asperity
{
  namespace
  {
    constexpr std::size_t header_size = 512;

    // Offsets of the header's fields in bytes.
    namespace at
    {
      constexpr std::size_t objects        = 14;
      constexpr std::size_t type           = 18;
      constexpr std::size_t object_name    = 20;
      constexpr std::size_t operator_name  = 50;
      constexpr std::size_t special_points = 86;
      constexpr std::size_t bits           = 98;
      constexpr std::size_t z_min          = 100;
      constexpr std::size_t nx             = 108;
      constexpr std::size_t ny             = 112;
      constexpr std::size_t dx             = 120;
      constexpr std::size_t dy             = 124;
      constexpr std::size_t dz             = 128;
      constexpr std::size_t x_unit         = 180;
      constexpr std::size_t y_unit         = 196;
      constexpr std::size_t z_unit         = 212;
      constexpr std::size_t comment_length = 334;
      constexpr std::size_t private_length = 336;
      constexpr std::size_t z_offset       = 474;
    } // namespace at

    double
    unit(const FileContent &file,
         const std::string &format,
         const std::size_t  offset,
         const std::string &axis,
         const double       given,
         HeightMap         &map)
    {
      const std::string name  = file.field(offset, 16);
      const double      metre = metres_per(name);
      if (metre > 0.)
        return metre;
      if (!name.empty())
        file.fail(format,
                  "has " + quoted_text(name) + " as unit along " + axis +
                    "; a unit of length is expected");
      if (given > 0.)
        return given;
      map.provenance.has_unit = false;
      map.provenance.warnings.push_back("No unit along " + axis +
                                        " in the header: metres are assumed.");
      return 1.;
    }

    /** Where a packed stream lies in the file, and what it unpacks to. */
    struct PackedStream
    {
      std::size_t begin      = 0;
      std::size_t length     = 0;
      std::size_t raw_length = 0;
    };

    /** u32 n, n times (u32 raw length, u32 packed length), then the streams. */
    std::vector<PackedStream>
    find_streams(const FileContent &file, const std::size_t start)
    {
      const std::size_t n = file.number<std::uint32_t>(start);
      file.require(start + 4, 8 * n);
      std::vector<PackedStream> streams(n);
      std::size_t               begin = start + 4 + 8 * n;
      for (std::size_t i = 0; i < n; ++i)
        {
          streams[i] = {begin,
                        file.number<std::uint32_t>(start + 8 + 8 * i),
                        file.number<std::uint32_t>(start + 4 + 8 * i)};
          file.require(begin, streams[i].length);
          begin += streams[i].length;
        }
      return streams;
    }

    std::size_t
    raw_length(const FileContent               &file,
               const std::string               &format,
               const std::vector<PackedStream> &streams)
    {
      std::size_t sum = 0;
      for (const PackedStream &stream : streams)
        sum += stream.raw_length;
      check_unpacked_size(file, format, sum);
      return sum;
    }

    std::string
    inflate_streams(const FileContent               &file,
                    const std::string               &format,
                    const std::vector<PackedStream> &streams)
    {
      std::string raw(raw_length(file, format, streams), '\0');
      std::size_t position = 0;
      for (const PackedStream &stream : streams)
        {
          uLongf    length = stream.raw_length;
          const int status =
            uncompress(reinterpret_cast<Bytef *>(raw.data() + position),
                       &length,
                       reinterpret_cast<const Bytef *>(file.bytes().data()) +
                         stream.begin,
                       stream.length);
          if (status != Z_OK || length != stream.raw_length)
            file.fail(format, "has damaged compressed heights");
          position += length;
        }
      return raw;
    }

    void
    check_kind(const FileContent &file,
               const std::string &format,
               const std::size_t  start,
               HeightMap         &map)
    {
      const int objects = file.number<std::uint16_t>(at::objects);
      const int type    = file.number<std::uint16_t>(at::type);
      // Gwyddion writes the type of a profile (1) for surfaces.
      if (type != 2 && type != 1)
        file.fail(format,
                  "holds an object of type " + std::to_string(type) +
                    "; a surface (type 2) is expected");
      if (objects > 1)
        map.provenance.warnings.push_back("The file holds " +
                                          std::to_string(objects) +
                                          " objects; the first one is read.");
      else if (!file.starts_with("DSCOMPRESSED"))
        {
          const std::size_t bytes = file.number<std::uint16_t>(at::bits) / 8;
          check_surplus(file,
                        start + map.heights.size() * bytes,
                        file.bytes().size(),
                        bytes,
                        map);
        }
    }

    /** Raw heights to metres; zmin-2 marks a missing point. */
    template <typename T>
    void
    convert(const FileContent &file,
            const char        *raw,
            const double       scale,
            const double       offset,
            HeightMap         &map)
    {
      const bool special = file.number<std::uint16_t>(at::special_points) != 0;
      const auto missing =
        std::int64_t(file.number<std::int32_t>(at::z_min)) - 2;
      for (std::size_t i = 0; i < map.heights.size(); ++i)
        {
          T value;
          std::memcpy(&value, raw + i * sizeof(T), sizeof(T));
          if (!special || value != missing)
            map.heights[i] = scale * value + offset;
        }
    }
  } // namespace

  HeightMap
  read_sur(const FileContent &file, const ReadOptions &options)
  {
    const bool        compressed = file.starts_with("DSCOMPRESSED");
    const std::string format = compressed ? "SUR, compressed" : "SUR, plain";
    file.require(0, header_size);
    const int bits = file.number<std::uint16_t>(at::bits);
    if (bits != 16 && bits != 32)
      file.fail(format,
                "has " + std::to_string(bits) +
                  " bits a point; 16 or 32 is expected");
    const auto        comment = file.number<std::uint16_t>(at::comment_length);
    const auto        secret  = file.number<std::uint16_t>(at::private_length);
    const std::size_t start   = header_size + comment + secret;
    file.require(start, 0);

    std::vector<PackedStream> streams;
    if (compressed)
      streams = find_streams(file, start);
    const std::size_t available = compressed ?
                                    raw_length(file, format, streams) :
                                    file.bytes().size() - start;
    HeightMap         map       = allocate_map(file,
                                 format,
                                 file.number<std::int32_t>(at::nx),
                                 file.number<std::int32_t>(at::ny),
                                 available,
                                 bits / 8);
    const std::size_t need      = map.heights.size() * (bits / 8);
    if (compressed && available > need)
      file.fail(format, "holds more compressed heights than its size states");
    check_kind(file, format, start, map);
    map.provenance.unit_source = "units in the file's header";
    map.dx                     = file.number<float>(at::dx) *
             unit(file, format, at::x_unit, "x", options.lateral_unit, map);
    map.dy = file.number<float>(at::dy) *
             unit(file, format, at::y_unit, "y", options.lateral_unit, map);
    const double z_unit =
      unit(file, format, at::z_unit, "z", options.height_unit, map);
    const double dz = file.number<float>(at::dz);
    if (!(map.dx > 0. && std::isfinite(map.dx)) ||
        !(map.dy > 0. && std::isfinite(map.dy)) ||
        !(dz != 0. && std::isfinite(dz)))
      file.fail(format, "has a spacing that is not positive");

    const float       z_offset = file.number<float>(at::z_offset);
    const double      offset = std::isfinite(z_offset) ? z_offset * z_unit : 0.;
    const std::string raw =
      compressed ? inflate_streams(file, format, streams) : std::string();
    const char *data = compressed ? raw.data() : file.bytes().data() + start;
    if (bits == 16)
      convert<std::int16_t>(file, data, dz * z_unit, offset, map);
    else
      convert<std::int32_t>(file, data, dz * z_unit, offset, map);
    map.provenance.description      = file.field(at::object_name, 30);
    const std::string operator_name = file.field(at::operator_name, 30);
    if (!operator_name.empty())
      map.provenance.description += "; " + operator_name;
    return map;
  }
} // namespace asperity
