#include <asperity/base/text.h>

#include <boost/locale/utf.hpp>

#include <algorithm>
#include <cctype>

namespace asperity
{
  std::string
  trim(const std::string &text)
  {
    const char *const blanks = " \t\r\n";
    const auto        first  = text.find_first_not_of(blanks);
    if (first == std::string::npos)
      return "";
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
  }

  std::vector<std::string>
  split(const std::string &text, const char separator)
  {
    std::vector<std::string> parts;
    if (trim(text).empty())
      return parts;
    std::size_t begin = 0;
    while (true)
      {
        const std::size_t end = text.find(separator, begin);
        parts.push_back(trim(text.substr(begin, end - begin)));
        if (end == std::string::npos)
          return parts;
        begin = end + 1;
      }
  }

  std::string
  join(const std::vector<std::string> &parts, const std::string &separator)
  {
    std::string result;
    for (const std::string &part : parts)
      result += (result.empty() ? "" : separator) + part;
    return result;
  }

  std::string
  printable(const std::string &text)
  {
    using Utf8 = boost::locale::utf::utf_traits<char>;
    std::string result;
    for (auto at = text.begin(); at != text.end();)
      {
        const auto begin = at;
        const auto code  = Utf8::decode(at, text.end());
        if (!boost::locale::utf::is_valid_codepoint(code))
          {
            result += '?';
            at = begin + 1;
          }
        else if (code < 32 || (code >= 127 && code < 160))
          result += '?';
        else
          result.append(begin, at);
      }
    return result;
  }

  std::string
  quoted_text(const std::string &text)
  {
    constexpr std::size_t most = 60;

    if (text.size() <= most)
      return "'" + printable(text) + "'";
    std::size_t end = most - 3;
    // not in the midst of a character of several bytes
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
      --end;
    return "'" + printable(text.substr(0, end)) + "...'";
  }

  std::string
  quoted_name(const std::string &name)
  {
    constexpr std::size_t longest_path = 4096;

    return name.size() > longest_path ? quoted_text(name) :
                                        "'" + printable(name) + "'";
  }

  unsigned int
  edit_distance(const std::string &first, const std::string &second)
  {
    const auto lower = [](std::string text) {
      for (char &c : text)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      return text;
    };
    const std::string a = lower(first), b = lower(second);
    // distance[i][j] belongs to the first i and j characters
    std::vector<std::vector<unsigned int>> distance(
      a.size() + 1, std::vector<unsigned int>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
      for (std::size_t j = 0; j <= b.size(); ++j)
        {
          if (i == 0 || j == 0)
            {
              distance[i][j] = static_cast<unsigned int>(i + j);
              continue;
            }
          distance[i][j] =
            std::min({distance[i - 1][j] + 1,
                      distance[i][j - 1] + 1,
                      distance[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
          if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
            distance[i][j] =
              std::min(distance[i][j], distance[i - 2][j - 2] + 1);
        }
    return distance[a.size()][b.size()];
  }
} // namespace asperity
