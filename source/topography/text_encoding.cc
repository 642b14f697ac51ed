#include <asperity/topography/text_table.h>

#include <boost/locale/encoding_utf.hpp>

#include <algorithm>

namespace asperity
{
  namespace
  {
    enum class Encoding
    {
      bytes,
      utf16_little_endian,
      utf16_big_endian
    };

    /** UTF-16 without a mark: digits and blanks have every other byte zero. */
    Encoding
    guess_encoding(const std::string &bytes)
    {
      const std::size_t n       = std::min<std::size_t>(bytes.size() / 2, 32);
      std::size_t       zeros[] = {0, 0};
      for (std::size_t i = 0; i < 2 * n; ++i)
        zeros[i % 2] += bytes[i] == '\0';
      if (n > 1 && zeros[1] == n && zeros[0] == 0)
        return Encoding::utf16_little_endian;
      if (n > 1 && zeros[0] == n && zeros[1] == 0)
        return Encoding::utf16_big_endian;
      return Encoding::bytes;
    }

    std::string
    from_utf16(const FileContent &file,
               const std::string &bytes,
               const bool         little_endian)
    {
      const auto unit = [&](const std::size_t i) {
        const auto first  = static_cast<unsigned char>(bytes[i]);
        const auto second = static_cast<unsigned char>(bytes[i + 1]);
        return static_cast<char16_t>(little_endian ? first | second << 8 :
                                                     second | first << 8);
      };
      std::u16string text;
      for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
        text += unit(i);
      try
        {
          if (bytes.size() % 2 == 0)
            return boost::locale::conv::utf_to_utf<char>(
              text, boost::locale::conv::stop);
        }
      catch (const boost::locale::conv::conversion_error &)
        {}
      file.fail("text", "is encoded in UTF-16 and damaged or cut off");
    }
  } // namespace

  std::string
  decode_text(const FileContent &file)
  {
    const std::string &bytes = file.bytes();
    if (file.starts_with(std::string("\xff\xfe\0\0", 4)) ||
        file.starts_with(std::string("\0\0\xfe\xff", 4)))
      file.fail("text", "is encoded in UTF-32; save it as UTF-8");
    std::string text = bytes;
    if (file.starts_with("\xef\xbb\xbf"))
      text = bytes.substr(3);
    else if (file.starts_with("\xff\xfe"))
      text = from_utf16(file, bytes.substr(2), true);
    else if (file.starts_with("\xfe\xff"))
      text = from_utf16(file, bytes.substr(2), false);
    else if (guess_encoding(bytes) != Encoding::bytes)
      text = from_utf16(file,
                        bytes,
                        guess_encoding(bytes) == Encoding::utf16_little_endian);
    return looks_like_text(text) ? text : std::string();
  }
} // namespace asperity
