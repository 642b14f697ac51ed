#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/base/json_file.h>
#include <asperity/base/text.h>
#include <asperity/surrogate/friction_law.h>

#include <cmath>

#include "law_checksum.h"
#include "law_document.h"
#include "law_parts.h"

namespace asperity
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    const char *const format_name    = "asperity friction law";
    constexpr int     format_version = 7;

    /** Without checksum, mechanisms, references of inputs and `softens`;
     *  version 4 has no `model`, since all are Gaussian processes; version 5
     *  no hardening of the shear limit and no pressure over it, version 6 no
     *  choices. */
    constexpr int oldest_version = 3;

    const char *const of_process = "Gaussian process";
    const char *const of_formula = "piecewise power law";

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

    FrictionLawDescription
    read_description(const LawNode &law,
                     const int      version,
                     const bool     is_formula)
    {
      FrictionLawDescription result;
      for (const LawNode &node : law.child("inputs").children())
        result.inputs.push_back(read_input(node, version));
      const LawNode output = law.child("output");
      result.output        = output.child("name").name();
      result.output_scale  = read_scale(output.child("scale"));
      if (!is_formula)
        result.kernel = law.child("kernel").choice<KernelKind>(
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
      if (version > 5)
        result.pressure_over_strength =
          law.child("pressure_over_strength").flag();
      if (version > 3)
        for (const LawNode &node : law.child("mechanisms").children())
          result.mechanisms.push_back(node.name());
      if (version > 6)
        result.choices = read_choices(law.child("choices"));
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

    std::shared_ptr<const GaussianProcess>
    make_process(const KernelKind       kernel,
                 const Hyperparameters &hyperparameters,
                 const TrainingData    &data,
                 const std::string     &origin)
    {
      try
        {
          return std::make_shared<const GaussianProcess>(kernel,
                                                         hyperparameters,
                                                         data);
        }
      catch (const std::runtime_error &error)
        {
          throw InputError(origin + ": " + error.what());
        }
    }

    PiecewisePowerLaw
    read_constants(const LawNode &node)
    {
      PiecewisePowerLaw law;
      law.mu_0              = node.child("mu_0").number_above(0., false);
      law.v_0               = node.child("v_0").number_above(0., false);
      law.exponent          = node.child("exponent").number();
      law.has_constant_part = node.child("has_constant_part").flag();
      law.scatter           = node.child("scatter").number_above(0., true);
      const std::vector<double> covariance = node.child("covariance").numbers();
      if (covariance.size() != law.covariance.size())
        node.child("covariance").fail("a list of 9 numbers");
      std::copy(covariance.begin(), covariance.end(), law.covariance.begin());
      for (unsigned int i = 0; i < 3; ++i)
        if (!(law.covariance[4 * i] >= 0.))
          node.child("covariance").fail("a variance that is not negative");
      return law;
    }

    Json
    constants_to_json(const PiecewisePowerLaw &law)
    {
      return {{"mu_0", law.mu_0},
              {"v_0", law.v_0},
              {"exponent", law.exponent},
              {"has_constant_part", law.has_constant_part},
              {"covariance", law.covariance},
              {"scatter", law.scatter}};
    }

    /** Whether the law is a formula that was fitted to measurements. */
    bool
    read_model(const LawNode &law, const int version)
    {
      if (version < 5)
        return false;
      const LawNode     node  = law.child("model");
      const std::string model = node.text();
      if (model != of_process && model != of_formula)
        node.fail(quoted_name(of_process) + " or " + quoted_name(of_formula));
      return model == of_formula;
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
      version.fail(std::to_string(oldest_version) + " to " +
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
    law["model"]   = fitted() == nullptr ? of_process : of_formula;
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
    if (fitted() != nullptr)
      law["constants"] = constants_to_json(fitted()->law());
    else
      {
        const Hyperparameters &found = process().hyperparameters();
        law["kernel"]                = to_string(process().kernel());
        law["hyperparameters"] = {{"signal_variance", found.signal_variance},
                                  {"length_scales", found.length_scales},
                                  {"noise_variance", found.noise_variance}};
      }
    law["largest_trusted_deviation"] = description_.largest_trusted_deviation;
    law["topography"]                = {{"profiles", description_.n_profiles},
                                        {"scatter", description_.topography_scatter},
                                        {"error", description_.topography_error}};
    law["leave_one_out_error"]       = description_.leave_one_out_error;
    law["calibration"]               = description_.calibration;
    law["shear_limit"] = shear_limit_to_json(description_.shear_limit);
    law["pressure_over_strength"] = description_.pressure_over_strength;
    law["mechanisms"]             = description_.mechanisms;
    law["choices"]                = choices_to_json(description_.choices);
    law["warnings"]               = description_.warnings;
    law["provenance"]             = description_.provenance;

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
    const int                    version    = check_format(root, origin);
    const bool                   is_formula = read_model(root, version);
    const FrictionLawDescription description =
      read_description(root, version, is_formula);
    const std::size_t d = description.inputs.size();
    FrictionLaw law(description, read_data(root.child("data"), d), origin);
    law.offset_ = root.child("output").child("offset").number();
    law.factor_ = root.child("output").child("factor").number_above(0., false);
    if (is_formula)
      {
        if (d != 1 || description.inputs[0].scale != Scale::logarithmic)
          root.child("inputs").fail("one input on a logarithmic scale");
        const PiecewisePowerLaw constants =
          read_constants(root.child("constants"));
        check_sum(root, origin);
        law.set_fitted(constants);
        return law;
      }
    const Hyperparameters hyperparameters =
      read_hyperparameters(root.child("hyperparameters"), d);
    if (version > 3)
      check_sum(root, origin);
    const TrainingData data = law.scaled_data();
    law.regression =
      make_process(description.kernel, hyperparameters, data, origin);
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
