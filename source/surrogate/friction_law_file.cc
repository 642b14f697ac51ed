#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/surrogate/friction_law.h>

#include <cmath>
#include <fstream>

namespace asperity
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    const char *const format_name    = "asperity friction law";
    constexpr int     format_version = 3;

    /** A part of the document, with its place for messages. */
    class Node
    {
    public:
      Node(const Json        &json,
           const std::string &origin,
           const std::string &place)
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
        throw InputError(origin + ": The entry '" + place +
                         "' of the friction "
                         "law is " +
                         found + "; " + expected + " is expected.");
      }

      Node
      child(const std::string &key) const
      {
        if (!json.is_object())
          fail("an object");
        const auto        position = json.find(key);
        const std::string path     = place.empty() ? key : place + "/" + key;
        if (position == json.end())
          throw InputError(origin + ": The friction law has no entry '" + path +
                           "'; every one that Asperity writes is expected.");
        return Node(*position, origin, path);
      }

      std::vector<Node>
      children() const
      {
        if (!json.is_array())
          fail("a list");
        std::vector<Node> result;
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
          fail(or_equal ? "a number that is not negative" :
                          "a positive number");
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
        for (const Node &node : children())
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

      template <typename Choice>
      Choice
      choice(const std::vector<Choice> &choices) const
      {
        const std::string found =
          json.is_string() ? json.get<std::string>() : "";
        std::string names;
        for (const Choice candidate : choices)
          {
            if (found == to_string(candidate))
              return candidate;
            names +=
              (names.empty() ? "'" : " or '") + to_string(candidate) + "'";
          }
        fail(names);
      }

      const Json &
      content() const
      {
        return json;
      }

    private:
      const Json       &json;
      const std::string origin, place;
    };

    Scale
    read_scale(const Node &node)
    {
      return node.choice<Scale>({Scale::linear, Scale::logarithmic});
    }

    LawInput
    read_input(const Node &node)
    {
      LawInput input;
      input.name   = node.child("name").text();
      input.symbol = node.child("symbol").text();
      input.unit   = node.child("unit").text();
      input.lower  = node.child("lower").number();
      input.upper  = node.child("upper").number();
      input.scale  = read_scale(node.child("scale"));
      return input;
    }

    ShearLimit
    read_shear_limit(const Node &node)
    {
      ShearLimit limit;
      limit.k_0      = node.child("k_0").number_above(0., true);
      limit.exponent = node.child("exponent").number_above(0., false);
      limit.transition_temperature =
        node.child("transition_temperature").number();
      limit.melting_temperature = node.child("melting_temperature").number();
      limit.strain              = node.child("strain").number();
      limit.rate                = node.child("rate").number();
      return limit;
    }

    Json
    shear_limit_to_json(const ShearLimit &limit)
    {
      return {{"k_0", limit.k_0},
              {"exponent", limit.exponent},
              {"transition_temperature", limit.transition_temperature},
              {"melting_temperature", limit.melting_temperature},
              {"strain", limit.strain},
              {"rate", limit.rate}};
    }

    FrictionLawDescription
    read_description(const Node &law)
    {
      FrictionLawDescription result;
      for (const Node &node : law.child("inputs").children())
        result.inputs.push_back(read_input(node));
      const Node output   = law.child("output");
      result.output       = output.child("name").text();
      result.output_scale = read_scale(output.child("scale"));
      result.kernel       = law.child("kernel").choice<KernelKind>(
        {KernelKind::rbf, KernelKind::matern_3_2, KernelKind::matern_5_2});
      result.largest_trusted_deviation =
        law.child("largest_trusted_deviation").number_above(0., true);
      const Node topography = law.child("topography");
      result.n_profiles     = topography.child("profiles").count();
      result.topography_scatter =
        topography.child("scatter").number_above(0., true);
      result.topography_error =
        topography.child("error").number_above(0., true);
      result.leave_one_out_error =
        law.child("leave_one_out_error").number_above(0., true);
      result.calibration = law.child("calibration").number_above(0., false);
      result.shear_limit = read_shear_limit(law.child("shear_limit"));
      for (const Node &node : law.child("warnings").children())
        result.warnings.push_back(node.text());
      result.provenance = law.child("provenance").content();
      return result;
    }

    LawData
    read_data(const Node &node, const std::size_t n_inputs)
    {
      LawData result;
      for (const Node &row : node.child("x").children())
        {
          const std::vector<double> point = row.numbers();
          if (point.size() != n_inputs)
            row.fail("a list of " + std::to_string(n_inputs) +
                     " numbers, one an input,");
          result.x.insert(result.x.end(), point.begin(), point.end());
        }
      result.y               = node.child("y").numbers();
      result.known_deviation = node.child("known_deviation").numbers();
      return result;
    }

    Hyperparameters
    read_hyperparameters(const Node &node, const std::size_t n_inputs)
    {
      Hyperparameters result;
      result.signal_variance =
        node.child("signal_variance").number_above(0., false);
      result.noise_variance =
        node.child("noise_variance").number_above(0., true);
      const Node scales = node.child("length_scales");
      for (const Node &scale : scales.children())
        result.length_scales.push_back(scale.number_above(0., false));
      if (result.length_scales.size() != n_inputs)
        scales.fail("a list of " + std::to_string(n_inputs) +
                    " numbers, one an input,");
      return result;
    }

    void
    check_format(const Node &law, const std::string &origin)
    {
      const Json &content = law.content();
      if (!content.is_object() || !content.contains("format") ||
          content["format"] != format_name)
        throw InputError(origin +
                         ": The document is no friction law: its entry "
                         "'format' must be '" +
                         format_name + "'.");
      const Node version = law.child("version");
      if (version.content() != format_version)
        version.fail(std::to_string(format_version) +
                     ", the version that this program reads,");
    }
  } // namespace



  nlohmann::ordered_json
  FrictionLaw::to_json() const
  {
    Json law;
    law["format"]  = format_name;
    law["version"] = format_version;
    law["output"]  = {{"name", description_.output},
                      {"scale", to_string(description_.output_scale)},
                      {"offset", offset_},
                      {"factor", factor_}};
    law["inputs"]  = Json::array();
    for (const LawInput &input : description_.inputs)
      law["inputs"].push_back({{"name", input.name},
                               {"symbol", input.symbol},
                               {"unit", input.unit},
                               {"lower", input.lower},
                               {"upper", input.upper},
                               {"scale", to_string(input.scale)}});
    const Hyperparameters &found = process_->hyperparameters();
    law["kernel"]                = to_string(process_->kernel());
    law["hyperparameters"]       = {{"signal_variance", found.signal_variance},
                                    {"length_scales", found.length_scales},
                                    {"noise_variance", found.noise_variance}};
    law["largest_trusted_deviation"] = description_.largest_trusted_deviation;
    law["topography"]                = {{"profiles", description_.n_profiles},
                                        {"scatter", description_.topography_scatter},
                                        {"error", description_.topography_error}};
    law["leave_one_out_error"]       = description_.leave_one_out_error;
    law["calibration"]               = description_.calibration;
    law["shear_limit"] = shear_limit_to_json(description_.shear_limit);
    law["warnings"]    = description_.warnings;
    law["provenance"]  = description_.provenance;

    const std::size_t d    = description_.inputs.size();
    Json              rows = Json::array();
    for (auto x = data_.x.begin(); x != data_.x.end(); x += d)
      rows.push_back(std::vector<double>(x, x + d));
    law["data"] = {{"x", rows},
                   {"y", data_.y},
                   {"known_deviation", data_.known_deviation}};
    return law;
  }



  FrictionLaw
  FrictionLaw::from_json(const nlohmann::ordered_json &document,
                         const std::string            &origin)
  {
    const Node root(document, origin, "");
    check_format(root, origin);
    const FrictionLawDescription description = read_description(root);
    const std::size_t            d           = description.inputs.size();
    FrictionLaw law(description, read_data(root.child("data"), d), origin);
    law.offset_ = root.child("output").child("offset").number();
    law.factor_ = root.child("output").child("factor").number_above(0., false);
    const Hyperparameters hyperparameters =
      read_hyperparameters(root.child("hyperparameters"), d);
    try
      {
        law.process_ =
          std::make_shared<const GaussianProcess>(description.kernel,
                                                  hyperparameters,
                                                  law.scaled_data());
      }
    catch (const std::runtime_error &error)
      {
        throw InputError(origin + ": " + error.what());
      }
    return law;
  }



  FrictionLaw
  FrictionLaw::load(const std::string &path)
  {
    std::ifstream in(path);
    if (!in)
      throw InputError("The file " + path +
                       " could not be opened; a friction law is expected.");
    Json document;
    try
      {
        document = Json::parse(in);
      }
    catch (const Json::exception &error)
      {
        throw InputError("The file " + path +
                         " is not a JSON document: " + error.what() + ".");
      }
    return from_json(document, path);
  }



  void
  FrictionLaw::save(const std::string &path) const
  {
    write_atomically(path, [&](std::ostream &out) {
      out << to_json().dump(1, ' ', false, Json::error_handler_t::replace)
          << '\n';
    });
  }
} // namespace asperity
