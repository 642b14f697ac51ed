#ifndef asperity_surrogate_law_document_h
#define asperity_surrogate_law_document_h

#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace asperity
{
  /** A part of the document, with its place for messages. */
  class LawNode
  {
  public:
    LawNode(const nlohmann::ordered_json &json,
            const std::string            &origin,
            const std::string            &place)
      : json(json)
      , origin(origin)
      , place(place)
    {}

    [[noreturn]] void
    fail(const std::string &expected) const
    {
      std::string found = json.dump();
      if (found.size() > 40)
        found = found.substr(0, 37) + "...";
      throw InputError(origin + ": The entry " + quoted_name(place) +
                       " of the friction "
                       "law is " +
                       found + "; " + expected + " is expected.");
    }

    LawNode
    child(const std::string &key) const
    {
      if (!json.is_object())
        fail("an object");
      const auto        position = json.find(key);
      const std::string path     = place.empty() ? key : place + "/" + key;
      if (position == json.end())
        throw InputError(origin + ": The friction law has no entry " +
                         quoted_name(path) +
                         "; every one that Asperity writes is expected.");
      return LawNode(*position, origin, path);
    }

    std::vector<LawNode>
    children() const
    {
      if (!json.is_array())
        fail("a list");
      std::vector<LawNode> result;
      for (std::size_t i = 0; i < json.size(); ++i)
        result.emplace_back(json[i], origin, place + "/" + std::to_string(i));
      return result;
    }

    double
    number() const
    {
      if (!json.is_number() || !std::isfinite(json.get<double>()))
        fail("a number");
      return json.get<double>();
    }

    double
    number_above(const double bound, const bool or_equal) const
    {
      const double value = number();
      if (!(value > bound || (or_equal && value == bound)))
        fail(or_equal ? "a number that is not negative" : "a positive number");
      return value;
    }

    unsigned int
    count() const
    {
      if (!json.is_number_unsigned() || json.get<unsigned int>() == 0)
        fail("a number of at least 1 without decimals");
      return json.get<unsigned int>();
    }

    std::vector<double>
    numbers() const
    {
      std::vector<double> result;
      for (const LawNode &node : children())
        result.push_back(node.number());
      return result;
    }

    std::string
    text() const
    {
      if (!json.is_string())
        fail("a text");
      return json.get<std::string>();
    }

    /** One that may stand in a line of any program. */
    std::string
    name() const
    {
      const std::string result = text();
      if (result.empty() || result.size() > 200 ||
          std::any_of(result.begin(), result.end(), [](const char c) {
            return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
          }))
        fail("a text of 1 to 200 characters in one line");
      return result;
    }

    std::string
    unit() const
    {
      const std::string result = name();
      try
        {
          dimension_of(result);
        }
      catch (const InputError &)
        {
          fail("a unit that Asperity knows");
        }
      return result;
    }

    bool
    flag() const
    {
      if (!json.is_boolean())
        fail("true or false");
      return json.get<bool>();
    }

    template <typename Choice>
    Choice
    choice(const std::vector<Choice> &choices) const
    {
      const std::string found = json.is_string() ? json.get<std::string>() : "";
      std::string       names;
      for (const Choice candidate : choices)
        {
          if (found == to_string(candidate))
            return candidate;
          names +=
            (names.empty() ? "" : " or ") + quoted_name(to_string(candidate));
        }
      fail(names);
    }

    const nlohmann::ordered_json &
    content() const
    {
      return json;
    }

  private:
    const nlohmann::ordered_json &json;
    const std::string             origin, place;
  };
} // namespace asperity

#endif
