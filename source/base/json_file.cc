#include <asperity/base/errors.h>
#include <asperity/base/json_file.h>
#include <asperity/base/text.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace asperity
{
  using Json = nlohmann::ordered_json;

  namespace
  {
    constexpr std::size_t largest_size  = 64 << 20; ///< bytes
    constexpr int         largest_depth = 32;
    constexpr std::size_t largest_keys  = 20000;

    std::string
    read_text(const std::string &path, const std::string &expected)
    {
      std::ifstream in(path, std::ios::binary);
      std::string   text;
      // a folder opens, but cannot be read
      if (in.peek(); in.bad() || !in.is_open())
        throw InputError("The file " + quoted_name(path) +
                         " could not be opened; " + expected + " is expected.");
      in.clear();
      text.resize(largest_size + 1);
      in.read(text.data(), static_cast<std::streamsize>(text.size()));
      text.resize(static_cast<std::size_t>(in.gcount()));
      if (text.size() > largest_size)
        throw InputError("The file " + quoted_name(path) +
                         " is larger than 64 MB; " + expected +
                         " is expected.");
      return text;
    }

    /** "line 3, column 7" of the byte that a parser counts from 1. */
    std::string
    place(const std::string &text, const std::size_t byte)
    {
      const std::size_t end = std::min(byte > 0 ? byte - 1 : 0, text.size());
      const auto        line =
        std::count(text.begin(), text.begin() + static_cast<long>(end), '\n');
      const std::size_t start =
        end == 0 ? std::string::npos : text.rfind('\n', end - 1);
      return "line " + std::to_string(line + 1) + ", column " +
             std::to_string(start == std::string::npos ? end + 1 : end - start);
    }
  } // namespace



  nlohmann::ordered_json
  read_json(const std::string &path, const std::string &expected)
  {
    const std::string text   = read_text(path, expected);
    std::size_t       n_keys = 0;
    const auto        bound =
      [&](const int depth, const Json::parse_event_t event, Json &) {
        if (depth > largest_depth ||
            (event == Json::parse_event_t::key && ++n_keys > largest_keys))
          throw InputError("The file " + quoted_name(path) +
                           " has more levels or keys than any that Asperity "
                           "writes; " +
                           expected + " is expected.");
        return true;
      };
    try
      {
        return Json::parse(text, bound);
      }
    catch (const Json::parse_error &error)
      {
        throw InputError("The file " + quoted_name(path) +
                         " is no JSON document at " + place(text, error.byte) +
                         "; " + expected + " is expected.");
      }
    catch (const Json::exception &)
      {
        throw InputError("The file " + quoted_name(path) +
                         " holds a number that is too large; " + expected +
                         " is expected.");
      }
  }
} // namespace asperity
