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

  /** Content of the first data array after `start`. */
  std::string
  array_text(const std::string &content, const std::string &start)
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

  unsigned int
  number_of(const std::string &piece, const std::string &what)
  {
    const std::string name = "NumberOf" + what + "=\"";
    return std::stoi(piece.substr(piece.find(name) + name.size()));
  }

  template <typename Number>
  std::vector<Number>
  of_all(const std::vector<std::string> &pieces, const std::string &start)
  {
    std::vector<Number> all;
    for (const std::string &piece : pieces)
      {
        const auto values = decode<Number>(array_text(piece, start));
        all.insert(all.end(), values.begin(), values.end());
      }
    return all;
  }
} // namespace

VtuReader::VtuReader(const std::string &content)
{
  auto position = content.find("<Piece");
  head          = content.substr(0, position);
  while (position != std::string::npos)
    {
      const auto next = content.find("<Piece", position + 1);
      pieces.push_back(content.substr(position, next - position));
      n_points += number_of(pieces.back(), "Points");
      n_cells += number_of(pieces.back(), "Cells");
      position = next;
    }
  n_pieces = pieces.size();
}

std::vector<float>
VtuReader::points() const
{
  return of_all<float>(pieces, "<Points>");
}

std::vector<float>
VtuReader::field(const std::string &name) const
{
  return of_all<float>(pieces, "Name=\"" + name + "\"");
}

std::vector<int>
VtuReader::connectivity() const
{
  std::vector<int> all;
  int              first = 0;
  for (const std::string &piece : pieces)
    {
      for (const int point :
           decode<int>(array_text(piece, "Name=\"connectivity\"")))
        all.push_back(first + point);
      first += number_of(piece, "Points");
    }
  return all;
}

double
VtuReader::time() const
{
  return std::stod(array_text(head, "Name=\"TIME\""));
}
