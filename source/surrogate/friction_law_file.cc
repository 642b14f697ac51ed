#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/base/json_file.h>
#include <asperity/base/text.h>
#include <asperity/surrogate/friction_law.h>

#include <cmath>

#include "law_checksum.h"
#include "law_document.h"

namespace asperity
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    const char *const format_name    = "asperity friction law";
    constexpr int     format_version = 4;

    /** Without checksum, mechanisms, references of inputs and `softens`. */
    constexpr int oldest_version = 3;

    Scale
    read_scale(const LawNode &node)
    {
      return node.choice<Scale>({Scale::linear, Scale::logarithmic});
    }

    LawInput
    read_input(const LawNode &node, const int version)
    {
      LawInput input;
      input.name   = node.child("name").name();
      input.symbol = node.child("symbol").name();
      input.unit   = node.child("unit").unit();
      input.lower  = node.child("lower").number();
      input.upper  = node.child("upper").number();
      input.scale  = read_scale(node.child("scale"));
      if (version > 3)
        if (const LawNode reference = node.child("reference");
            !reference.content().is_null())
          input.reference = reference.number();
      return input;
    }

    ShearLimit
    read_shear_limit(const LawNode &node, const int version)
    {
      ShearLimit limit;
      limit.k_0      = node.child("k_0").number_above(0., true);
      limit.exponent = node.child("exponent").number_above(0., false);
      limit.transition_temperature =
        node.child("transition_temperature").number();
      limit.melting_temperature = node.child("melting_temperature").number();
      limit.strain              = node.child("strain").number();
      limit.rate                = node.child("rate").number();
      if (version > 3)
        limit.softens = node.child("softens").flag();
      if (limit.k_0 > 0. && limit.softens &&
          !(limit.transition_temperature < limit.melting_temperature))
        node.child("melting_temperature").fail("more than the transition's");
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
              {"rate", limit.rate},
              {"softens", limit.softens}};
    }

    FrictionLawDescription
    read_description(const LawNode &law, const int version)
    {
      FrictionLawDescription result;
      for (const LawNode &node : law.child("inputs").children())
        result.inputs.push_back(read_input(node, version));
      const LawNode output = law.child("output");
      result.output        = output.child("name").name();
      result.output_scale  = read_scale(output.child("scale"));
      result.kernel        = law.child("kernel").choice<KernelKind>(
        {KernelKind::rbf, KernelKind::matern_3_2, KernelKind::matern_5_2});
      result.largest_trusted_deviation =
        law.child("largest_trusted_deviation").number_above(0., true);
      const LawNode topography = law.child("topography");
      result.n_profiles        = topography.child("profiles").count();
      result.topography_scatter =
        topography.child("scatter").number_above(0., true);
      result.topography_error =
        topography.child("error").number_above(0., true);
      result.leave_one_out_error =
        law.child("leave_one_out_error").number_above(0., true);
      result.calibration = law.child("calibration").number_above(0., false);
      result.shear_limit = read_shear_limit(law.child("shear_limit"), version);
      if (version > 3)
        for (const LawNode &node : law.child("mechanisms").children())
          result.mechanisms.push_back(node.name());
      for (const LawNode &node : law.child("warnings").children())
        result.warnings.push_back(node.text());
      result.provenance = law.child("provenance").content();
      return result;
    }

    LawData
    read_data(const LawNode &node, const std::size_t n_inputs)
    {
      LawData result;
      for (const LawNode &row : node.child("x").children())
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
    read_hyperparameters(const LawNode &node, const std::size_t n_inputs)
    {
      Hyperparameters result;
      result.signal_variance =
        node.child("signal_variance").number_above(0., false);
      result.noise_variance =
        node.child("noise_variance").number_above(0., true);
      const LawNode scales = node.child("length_scales");
      for (const LawNode &scale : scales.children())
        result.length_scales.push_back(scale.number_above(0., false));
      if (result.length_scales.size() != n_inputs)
        scales.fail("a list of " + std::to_string(n_inputs) +
                    " numbers, one an input,");
      return result;
    }

    /** The version of a law's document. */
    int
    check_format(const LawNode &law, const std::string &origin)
    {
      const Json &content = law.content();
      if (!content.is_object() || !content.contains("format") ||
          content["format"] != format_name)
        throw InputError(origin +
                         ": The document is no friction law: its entry "
                         "'format' must be " +
                         quoted_name(format_name) + ".");
      const LawNode version = law.child("version");
      for (int known = oldest_version; known <= format_version; ++known)
        if (version.content() == known)
          return known;
      version.fail(std::to_string(oldest_version) + " or " +
                   std::to_string(format_version) +
                   ", which this program reads,");
    }

    void
    check_sum(const LawNode &law, const std::string &origin)
    {
      if (law.child("checksum").text() != law_checksum(law.content()))
        throw InputError(
          origin + ": The friction law was changed after it was written: "
                   "its checksum is not that of its contents; expected the "
                   "file as Asperity wrote it.");
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
      law["inputs"].push_back(
        {{"name", input.name},
         {"symbol", input.symbol},
         {"unit", input.unit},
         {"lower", input.lower},
         {"upper", input.upper},
         {"scale", to_string(input.scale)},
         {"reference",
          input.reference ? Json(*input.reference) : Json(nullptr)}});
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
    law["mechanisms"]  = description_.mechanisms;
    law["warnings"]    = description_.warnings;
    law["provenance"]  = description_.provenance;

    const std::size_t d    = description_.inputs.size();
    Json              rows = Json::array();
    for (auto x = data_.x.begin(); x != data_.x.end(); x += d)
      rows.push_back(std::vector<double>(x, x + d));
    law["data"]     = {{"x", rows},
                       {"y", data_.y},
                       {"known_deviation", data_.known_deviation}};
    law["checksum"] = law_checksum(law);
    return law;
  }



  void
  FrictionLaw::require_agreement(const TrainingData &data,
                                 const std::string  &origin) const
  {
    // The process sees values of mean 0 and variance 1, or constant ones.
    double       square = 0.;
    const double n      = static_cast<double>(data.y.size());
    for (const double value : data.y)
      square += value * value / n;
    bool agrees =
      std::isfinite(square) && square < 1. + 1e-6 &&
      (square > 1. - 1e-6 || factor_ < 1e-9 * (1. + std::abs(offset_)));
    if (agrees)
      {
        const double stated = description_.leave_one_out_error;
        agrees = std::abs(left_out_error() - stated) <= 0.05 * stated + 1e-6;
      }
    if (!agrees)
      throw InputError(
        origin + ": The numbers of the friction law contradict each "
                 "other: its error of cross-validation is not that of its "
                 "data; expected the file as Asperity wrote it.");
  }



  FrictionLaw
  FrictionLaw::from_json(const nlohmann::ordered_json &document,
                         const std::string            &origin)
  {
    const LawNode                root(document, origin, "");
    const int                    version     = check_format(root, origin);
    const FrictionLawDescription description = read_description(root, version);
    const std::size_t            d           = description.inputs.size();
    FrictionLaw law(description, read_data(root.child("data"), d), origin);
    law.offset_ = root.child("output").child("offset").number();
    law.factor_ = root.child("output").child("factor").number_above(0., false);
    const Hyperparameters hyperparameters =
      read_hyperparameters(root.child("hyperparameters"), d);
    if (version > 3)
      check_sum(root, origin);
    const TrainingData data = law.scaled_data();
    try
      {
        law.process_ =
          std::make_shared<const GaussianProcess>(description.kernel,
                                                  hyperparameters,
                                                  data);
      }
    catch (const std::runtime_error &error)
      {
        throw InputError(origin + ": " + error.what());
      }
    if (version == 3)
      law.require_agreement(data, origin); // for want of a checksum
    return law;
  }



  FrictionLaw
  FrictionLaw::load(const std::string &path)
  {
    return from_json(read_json(path, "a friction law"), path);
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
