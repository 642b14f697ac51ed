#include "vtu_reader.h"

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace
{
  std::string
  decode_base64(const std::string &text)
  {
    const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                 "abcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string       bytes;
    std::uint32_t     bits   = 0;
    unsigned int      n_bits = 0;
    for (const char letter : text)
      {
        const auto value = alphabet.find(letter);
        if (value == std::string::npos)
          continue;
        bits = (bits << 6) | static_cast<std::uint32_t>(value);
        n_bits += 6;
        if (n_bits >= 8)
          {
            n_bits -= 8;
            bytes += static_cast<char>((bits >> n_bits) & 0xff);
          }
      }
    return bytes;
  }

  /** Four 32-bit numbers (1, size, size, compressed size), then zlib data. */
  template <typename Number>
  std::vector<Number>
  decode(const std::string &text)
  {
    const std::size_t first = text.find_first_not_of(" \n");
    // The head is encoded by itself: 16 bytes, 24 letters.
    const std::string head = decode_base64(text.substr(first, 24));
    const std::string body = decode_base64(text.substr(first + 24));
    std::uint32_t     sizes[4];
    std::memcpy(sizes, head.data(), sizeof(sizes));
    if (sizes[0] != 1 || sizes[3] != body.size())
      throw std::runtime_error("unexpected head of a VTU array");
    std::vector<Number> values(sizes[1] / sizeof(Number));
    uLongf              size = sizes[1];
    if (uncompress(reinterpret_cast<Bytef *>(values.data()),
                   &size,
                   reinterpret_cast<const Bytef *>(body.data()),
                   body.size()) != Z_OK)
      throw std::runtime_error("a VTU array cannot be uncompressed");
    return values;
  }
} // namespace

VtuReader::VtuReader(const std::string &content)
  : content(content)
{
  n_points = std::stoi(content.substr(content.find("NumberOfPoints=\"") + 16));
  n_cells  = std::stoi(content.substr(content.find("NumberOfCells=\"") + 15));
}

std::string
VtuReader::array_text(const std::string &start) const
{
  const auto position = content.find(start);
  if (position == std::string::npos)
    throw std::runtime_error("there is no " + start);
  auto array = content.find("<DataArray", position);
  // The name may be an attribute of the array itself.
  if (start[0] == 'N')
    array = content.rfind("<DataArray", position);
  const auto begin = content.find('>', array) + 1;
  return content.substr(begin, content.find('<', begin) - begin);
}

std::vector<float>
VtuReader::points() const
{
  return decode<float>(array_text("<Points>"));
}

std::vector<float>
VtuReader::field(const std::string &name) const
{
  return decode<float>(array_text("Name=\"" + name + "\""));
}

std::vector<int>
VtuReader::connectivity() const
{
  return decode<int>(array_text("Name=\"connectivity\""));
}

double
VtuReader::time() const
{
  return std::stod(array_text("Name=\"TIME\""));
}
