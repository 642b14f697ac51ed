#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/base/text.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

// The kinds of parameters: how each reads its text, and what it says of itself.

namespace asperity
{
  namespace
  {
    const std::string automatic = "automatic";

    ParameterEntry
    new_entry(const std::string &key,
              const std::string &kind,
              const std::string &range,
              const std::string &sentence,
              const Need         need)
    {
      ParameterEntry entry;
      entry.key      = key;
      entry.kind     = kind;
      entry.range    = range;
      entry.sentence = sentence;
      entry.need     = need;
      return entry;
    }

    double
    in_range(const double       value,
             const std::string &text,
             const Range       &range,
             const std::string &unit)
    {
      if (!range.contains(value))
        throw InputError(quoted_text(text) + " is out of range; " +
                         range.description(unit) + " is expected");
      return value;
    }

    double
    parse_in_range(const std::string &text,
                   const Range       &range,
                   const std::string &unit)
    {
      return in_range(parse_quantity(text, dimension_of(unit)),
                      text,
                      range,
                      unit);
    }

    unsigned int
    parse_integer(const std::string &text, const Range &range)
    {
      const std::string expected =
        range.description() == "any" ? "" : ", " + range.description();
      double value = 0;
      try
        {
          value = parse_number(text);
        }
      catch (const InputError &)
        {
          value = 0.5; // falls through to the one message of this function
        }
      if (value != std::floor(value) || std::abs(value) > 4294967295.)
        throw InputError(quoted_text(text) +
                         " is not a whole number; a whole number" + expected +
                         " is expected");
      if (value < 0 || !range.contains(value))
        throw InputError(
          quoted_text(text) + " is out of range; a whole number" +
          (expected.empty() ? ", 0 or more," : expected) + " is expected");
      return static_cast<unsigned int>(value);
    }

    std::string
    kind_of(const std::string &unit)
    {
      const Dimension dimension = dimension_of(unit);
      return dimension == Dimension::none ? "number" : to_string(dimension);
    }

    bool
    has_unit(const std::string &item)
    {
      return item.find_first_not_of("+-.0123456789eE") != std::string::npos;
    }

    /**
     * "0,16 um" is not 0 and 16 um: where an item has no unit of its own, a
     * comma between two digits may be a decimal comma.
     */
    void
    refuse_decimal_commas(const std::string              &text,
                          const std::vector<std::string> &items,
                          const std::string              &unit)
    {
      if (dimension_of(unit) == Dimension::none ||
          std::all_of(items.begin(), items.end(), has_unit))
        return;
      const auto is_digit = [&text](const std::size_t at) {
        return at < text.size() && text[at] >= '0' && text[at] <= '9';
      };
      for (std::size_t at = text.find(',', 1); at != std::string::npos;
           at             = text.find(',', at + 1))
        if (is_digit(at - 1) && is_digit(at + 1))
          throw InputError(quoted_text(text) +
                           " has a comma between two digits; decimals take a "
                                       "point, and a comma between two numbers is followed "
                                       "by a blank");
    }

    /** Items without a unit take that of the last item. */
    std::vector<double>
    parse_list(const std::string &text,
               const Range       &range,
               const std::string &unit)
    {
      std::vector<double>            values;
      const std::vector<std::string> items = split(text, ',');
      if (items.empty())
        return values;
      refuse_decimal_commas(text, items, unit);
      const std::size_t begin_of_unit =
        items.back().find_first_not_of("+-.0123456789eE");
      const std::string shared_unit = begin_of_unit == std::string::npos ?
                                        "" :
                                        items.back().substr(begin_of_unit);
      for (const std::string &item : items)
        values.push_back(parse_in_range(
          has_unit(item) ? item : item + " " + shared_unit, range, unit));
      return values;
    }

    /** Fifteen digits: 160 nm and 0.16 um, which may differ by a rounding
     *  error, are one value. */
    std::string
    value_in(const std::string &unit, const double value)
    {
      return format_quantity(value, unit, 15);
    }

    /** The text with `automatic` for no value. */
    template <typename Number, typename Parse, typename Format>
    std::function<std::string(const std::string &)>
    or_automatic(std::optional<Number> &variable,
                 const Parse           &parse,
                 const Format          &format)
    {
      return [&variable, parse, format](const std::string &text) {
        if (trim(text) == automatic)
          {
            variable.reset();
            return automatic;
          }
        try
          {
            variable = parse(text);
          }
        catch (const InputError &error)
          {
            throw InputError(error.what() + std::string(", or the word '") +
                             automatic + "'");
          }
        return format(*variable);
      };
    }
  } // namespace

  void
  ParameterDeclarator::quantity(const std::string &key,
                                double            &variable,
                                const std::string &unit,
                                const Range       &range,
                                const std::string &sentence,
                                const Need         need)
  {
    ParameterEntry entry =
      new_entry(key, kind_of(unit), range.description(unit), sentence, need);
    entry.assign = [&variable, range, unit](const std::string &text) {
      variable = parse_in_range(text, range, unit);
      return value_in(unit, variable);
    };
    declare(std::move(entry),
            need == Need::mandatory ? "" : format_quantity(variable, unit));
  }

  void
  ParameterDeclarator::quantity(const std::string     &key,
                                std::optional<double> &variable,
                                const std::string     &unit,
                                const Range           &range,
                                const std::string     &sentence)
  {
    ParameterEntry entry = new_entry(key,
                                     kind_of(unit) + " or " + automatic,
                                     range.description(unit),
                                     sentence,
                                     Need::optional);
    entry.assign         = or_automatic(
      variable,
      [range, unit](const auto &text) {
        return parse_in_range(text, range, unit);
      },
      [unit](const double value) { return value_in(unit, value); });
    declare(std::move(entry),
            variable ? format_quantity(*variable, unit) : automatic);
  }

  void
  ParameterDeclarator::number(const std::string &key,
                              double            &variable,
                              const Range       &range,
                              const std::string &sentence,
                              const Need         need)
  {
    quantity(key, variable, "1", range, sentence, need);
  }

  void
  ParameterDeclarator::number(const std::string     &key,
                              std::optional<double> &variable,
                              const Range           &range,
                              const std::string     &sentence)
  {
    quantity(key, variable, "1", range, sentence);
  }

  void
  ParameterDeclarator::integer(const std::string &key,
                               unsigned int      &variable,
                               const Range       &range,
                               const std::string &sentence,
                               const Need         need)
  {
    ParameterEntry entry =
      new_entry(key, "whole number", range.description(), sentence, need);
    entry.assign = [&variable, range](const std::string &text) {
      variable = parse_integer(text, range);
      return std::to_string(variable);
    };
    declare(std::move(entry), std::to_string(variable));
  }

  void
  ParameterDeclarator::integer(const std::string           &key,
                               std::optional<unsigned int> &variable,
                               const Range                 &range,
                               const std::string           &sentence)
  {
    ParameterEntry entry = new_entry(key,
                                     "whole number or " + automatic,
                                     range.description(),
                                     sentence,
                                     Need::optional);
    entry.assign         = or_automatic(
      variable,
      [range](const auto &text) { return parse_integer(text, range); },
      [](const unsigned int value) { return std::to_string(value); });
    declare(std::move(entry), variable ? std::to_string(*variable) : automatic);
  }

  void
  ParameterDeclarator::flag(const std::string &key,
                            bool              &variable,
                            const std::string &sentence)
  {
    ParameterEntry entry =
      new_entry(key, "flag", "true, false", sentence, Need::optional);
    entry.assign = [&variable](const std::string &text) {
      if (text != "true" && text != "false")
        throw InputError(quoted_text(text) + " is neither 'true' nor 'false'");
      variable = (text == "true");
      return text;
    };
    declare(std::move(entry), variable ? "true" : "false");
  }

  void
  ParameterDeclarator::declare_choice(
    const std::string                      &key,
    const std::vector<std::string>         &names,
    const std::function<void(std::size_t)> &assign,
    const std::string                      &default_name,
    const std::string                      &sentence,
    const Need                              need)
  {
    ParameterEntry entry =
      new_entry(key, "choice", join(names, ", "), sentence, need);
    entry.assign = [names, assign](const std::string &text) {
      for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == text)
          {
            assign(i);
            return text;
          }
      throw InputError(quoted_text(text) + " is not a choice; one of " +
                       join(names, ", ") + " is expected");
    };
    declare(std::move(entry), default_name);
  }

  void
  ParameterDeclarator::text(const std::string &key,
                            std::string       &variable,
                            const std::string &sentence,
                            const Need         need)
  {
    ParameterEntry entry = new_entry(key, "text", "any", sentence, need);
    entry.assign         = [&variable, need](const std::string &text) {
      if (text.empty() && need == Need::mandatory)
        throw InputError("the text is empty");
      variable = text;
      return text;
    };
    declare(std::move(entry), variable);
  }

  void
  ParameterDeclarator::file(const std::string &key,
                            std::string       &variable,
                            const std::string &sentence,
                            const Need         need)
  {
    ParameterEntry entry =
      new_entry(key, "file", "an existing file", sentence, need);
    entry.is_file = true;
    entry.assign  = [&variable, need](const std::string &text) {
      if (text.empty() && need == Need::mandatory)
        throw InputError("no file is named");
      if (!text.empty() &&
          (std::filesystem::is_directory(text) || !std::ifstream(text).good()))
        throw InputError("the file " + quoted_name(text) +
                         " does not exist or cannot be read");
      variable = text;
      return text;
    };
    declare(std::move(entry), variable);
  }

  void
  ParameterDeclarator::list(const std::string   &key,
                            std::vector<double> &variable,
                            const std::string   &unit,
                            const Range         &range,
                            const std::string   &sentence)
  {
    ParameterEntry entry = new_entry(key,
                                     "list of " + kind_of(unit),
                                     range.description(unit),
                                     sentence,
                                     Need::optional);
    entry.assign         = [&variable, range, unit](const std::string &text) {
      variable = parse_list(text, range, unit);
      std::vector<std::string> values;
      for (const double value : variable)
        values.push_back(value_in(unit, value));
      return join(values, ", ");
    };
    std::vector<std::string> items;
    for (const double value : variable)
      items.push_back(format_quantity(value, unit));
    declare(std::move(entry), join(items, ", "));
  }
} // namespace asperity
