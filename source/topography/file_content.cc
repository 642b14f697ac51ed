#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/topography/file_content.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace asperity
{
  namespace
  {
    // 2^28 points are 2 GB of heights, far more than instruments record.
    constexpr std::int64_t max_points = std::int64_t(1) << 28;
  } // namespace

  FileContent::FileContent(const std::string &file)
    : file(file)
  {
    std::error_code error;
    if (!std::filesystem::exists(file, error))
      throw InputError("The surface file " + quoted_name(file) +
                       " does not exist.");
    if (!std::filesystem::is_regular_file(file, error))
      throw InputError(quoted_name(file) +
                       " is not a file; a surface is expected.");
    const auto size = std::filesystem::file_size(file, error);
    if (error || size > (std::uintmax_t(1) << 32))
      throw InputError("The surface file " + quoted_name(file) +
                       " is larger than 4 GiB; crop it before it is read.");

    std::ifstream in(file, std::ios::binary);
    content.resize(size);
    in.read(content.data(), size);
    if (!in)
      throw InputError("The surface file " + quoted_name(file) +
                       " cannot be read.");
    if (content.empty())
      throw InputError("The surface file " + quoted_name(file) + " is empty.");
  }

  FileContent::FileContent(const std::string &name, const std::string &bytes)
    : file(name)
    , content(bytes)
  {
    if (content.empty())
      throw InputError("The surface file " + quoted_name(file) + " is empty.");
  }

  std::string
  FileContent::field(const std::size_t offset, const std::size_t length) const
  {
    require(offset, length);
    const std::string text = content.substr(offset, length);
    return strip(text.substr(0, text.find('\0')));
  }

  void
  FileContent::require(const std::size_t offset, const std::size_t length) const
  {
    if (offset > content.size() || length > content.size() - offset)
      throw InputError("The surface file " + quoted_name(file) +
                       " is cut off: it has " + std::to_string(content.size()) +
                       " bytes, and its header asks for " +
                       std::to_string(length) + " more from byte " +
                       std::to_string(offset) + " on.");
  }

  void
  FileContent::fail(const std::string &format, const std::string &reason) const
  {
    throw InputError("The surface file " + quoted_name(file) + " (" + format +
                     ") " + reason + ".");
  }

  HeightMap
  allocate_map(const FileContent &file,
               const std::string &format,
               const std::int64_t nx,
               const std::int64_t ny,
               const std::size_t  available,
               const std::size_t  bytes_per_point)
  {
    const std::string size =
      std::to_string(nx) + " x " + std::to_string(ny) + " points";
    if (nx < 2 || ny < 1)
      file.fail(format, "states " + size + "; at least 2 x 1 are expected");
    if (nx > max_points || ny > max_points || nx * ny > max_points)
      file.fail(format, "states " + size + "; that is more than 2^28");
    const std::size_t n = static_cast<std::size_t>(nx * ny);
    if (available < n * bytes_per_point)
      file.fail(format,
                "is cut off: " + size + " need " +
                  std::to_string(n * bytes_per_point) +
                  " bytes of heights, and it holds " +
                  std::to_string(available));

    HeightMap map;
    map.nx = static_cast<unsigned int>(nx);
    map.ny = static_cast<unsigned int>(ny);
    map.heights.assign(n, missing_height);
    map.provenance.file   = file.name();
    map.provenance.format = format;
    return map;
  }

  void
  check_surplus(const FileContent &file,
                const std::size_t  end,
                const std::size_t  limit,
                const std::size_t  bytes_per_point,
                HeightMap         &map)
  {
    if (limit <= end)
      return;
    const std::size_t surplus = limit - end;
    const std::string size =
      std::to_string(map.nx) + " x " + std::to_string(map.ny);
    if (surplus >= map.nx * bytes_per_point &&
        !looks_like_text(file.bytes().substr(end, surplus)))
      file.fail(map.provenance.format,
                "holds " + std::to_string(surplus) + " more bytes than its " +
                  size + " heights of " + std::to_string(bytes_per_point) +
                  " bytes need: its header states another size than its data "
                  "have");
    map.provenance.warnings.push_back(
      std::to_string(surplus) + " bytes behind the " + size +
      " heights that the header states are not read.");
  }

  void
  check_unpacked_size(const FileContent  &file,
                      const std::string  &format,
                      const std::uint64_t unpacked)
  {
    if (unpacked > (std::uint64_t(1) << 26) &&
        unpacked / 100 > file.bytes().size())
      file.fail(format,
                "has " + std::to_string(file.bytes().size()) +
                  " bytes and states that they unpack to " +
                  std::to_string(unpacked) +
                  "; at most a hundred times as many are expected");
  }

  bool
  parse_decimal(const std::string &text, double &value)
  {
    // strtod skips blanks and takes hexadecimal numbers, which nobody means.
    if (text.empty() || text.find_first_of(std::string(" \t\r\n\v\fxX\0", 9)) !=
                          std::string::npos)
      return false;
    char *end = nullptr;
    value     = std::strtod(text.c_str(), &end);
    return end == text.c_str() + text.size();
  }

  double
  parse_number(const FileContent &file,
               const std::string &format,
               const std::string &what,
               const std::string &text)
  {
    const std::string number = strip(text);
    double            value  = 0.;
    if (!parse_decimal(number, value) || !std::isfinite(value))
      file.fail(format,
                "has " + quoted_text(number) + " as " + what +
                  "; a number is expected");
    return value;
  }

  std::int64_t
  parse_integer(const FileContent &file,
                const std::string &format,
                const std::string &what,
                const std::string &text)
  {
    const double value = parse_number(file, format, what, text);
    if (value != std::floor(value) || std::abs(value) > 1e15)
      file.fail(format,
                "has " + quoted_text(strip(text)) + " as " + what +
                  "; a whole number is expected");
    return static_cast<std::int64_t>(value);
  }

  bool
  looks_like_text(const std::string &bytes)
  {
    const std::size_t n = std::min<std::size_t>(bytes.size(), 4096);
    return std::none_of(bytes.begin(),
                        bytes.begin() + n,
                        [](const unsigned char c) {
                          return c < 9 || (c > 13 && c < 32) || c == 127;
                        });
  }

  std::string
  strip(const std::string &text)
  {
    const std::string blank(" \t\r\n\v\f\0", 7);
    const auto        first = text.find_first_not_of(blank);
    if (first == std::string::npos)
      return "";
    return text.substr(first, text.find_last_not_of(blank) - first + 1);
  }
} // namespace asperity
