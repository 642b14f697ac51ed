#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/campaign/choice_indices.h>
#include <asperity/surrogate/design.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>

namespace asperity
{
  namespace
  {
    constexpr std::size_t n_predictions = 4096; ///< of the interval

    /** "um" of "20 um", "1" of "0.5". */
    std::string
    unit_of(const std::string &text)
    {
      const std::size_t blank = text.find(' ');
      return blank == std::string::npos ? "1" : text.substr(blank + 1);
    }

    double
    value_of(const std::string &text)
    {
      return parse_quantity(text, dimension_of(unit_of(text)));
    }

    /** The scene's own value among those of its variations; nothing if it is
     *  no number, such as `automatic`. */
    std::vector<Variation>
    values_of(const std::string      &entry,
              const SceneSensitivity &sensitivity,
              const SceneInput       &input)
    {
      std::vector<Variation> values;
      for (const VariationResult &result : sensitivity.results)
        if (result.variation.entry == entry && result.reason.empty())
          values.push_back(result.variation);
      if (values.empty())
        return values;
      Variation own = values.front();
      own.value     = input.declarator.get(entry);
      for (auto &[other, value] : own.also)
        value = input.declarator.get(other);
      try
        {
          value_of(own.value);
          values.push_back(own);
        }
      catch (const InputError &)
        {}
      return values;
    }

    /** Between the texts of two values of an entry. */
    std::string
    between(const std::string &lower, const std::string &upper, const double t)
    {
      const double a = value_of(lower), b = value_of(upper);
      double       x = (1. - t) * a + t * b;
      if (unit_of(lower) == "1" && a == std::round(a) && b == std::round(b) &&
          std::max(std::abs(a), std::abs(b)) > 2.)
        x = std::round(x);
      return format_quantity(x, unit_of(lower), 8);
    }

    FrictionLaw
    train(const std::vector<ChoiceRange> &ranges,
          const std::vector<double>      &x,
          const std::vector<double>      &y)
    {
      FrictionLawDescription description;
      for (const ChoiceRange &range : ranges)
        description.inputs.push_back(
          {range.entry, range.entry, "1", 0., 1., Scale::linear});
      return FrictionLaw::train(description, x, y);
    }

    /** Median and 95 % interval of the law over its box. */
    void
    find_interval(const FrictionLaw &law, ChoiceIndices &indices)
    {
      std::vector<double> mu(n_predictions);
      law.means(n_predictions,
                unit_sobol(n_predictions, indices.ranges.size()).data(),
                mu.data());
      std::sort(mu.begin(), mu.end());
      indices.lower  = mu[std::lround(0.025 * n_predictions)];
      indices.median = mu[n_predictions / 2];
      indices.upper  = mu[std::lround(0.975 * n_predictions)];
    }
  } // namespace



  std::vector<ChoiceRange>
  ranges_of_choices(const SceneSensitivity &sensitivity,
                    const SceneInput       &input,
                    const unsigned int      n_choices)
  {
    std::vector<ChoiceRange> ranges;
    for (const VariationResult &result : sensitivity.results)
      {
        const std::string &entry = result.variation.entry;
        const bool         known = std::any_of(ranges.begin(),
                                       ranges.end(),
                                       [&](const ChoiceRange &range) {
                                         return range.entry == entry;
                                       });
        if (known || ranges.size() == n_choices)
          continue;
        const auto values = values_of(entry, sensitivity, input);
        const auto [least, most] =
          std::minmax_element(values.begin(),
                              values.end(),
                              [](const Variation &a, const Variation &b) {
                                return value_of(a.value) < value_of(b.value);
                              });
        if (values.empty() || value_of(least->value) == value_of(most->value))
          continue;
        ranges.push_back({entry,
                          unit_of(most->value),
                          value_of(least->value),
                          value_of(most->value),
                          *least,
                          *most});
      }
    return ranges;
  }



  EntryValues
  choice_at(const std::vector<ChoiceRange> &ranges, const double *unit)
  {
    EntryValues changes;
    for (std::size_t i = 0; i < ranges.size(); ++i)
      {
        const ChoiceRange &range = ranges[i];
        changes.emplace_back(range.entry,
                             between(range.at_lower.value,
                                     range.at_upper.value,
                                     unit[i]));
        for (std::size_t k = 0; k < range.at_lower.also.size(); ++k)
          changes.emplace_back(range.at_lower.also[k].first,
                               between(range.at_lower.also[k].second,
                                       range.at_upper.also[k].second,
                                       unit[i]));
      }
    return changes;
  }



  ChoiceIndices
  compute_indices(
    const std::string                                               &file,
    const std::vector<ChoiceRange>                                  &ranges,
    const std::size_t                                                n_runs,
    const std::function<void(const std::size_t, const std::size_t)> &progress)
  {
    const std::size_t         d    = ranges.size();
    const std::vector<double> unit = unit_sobol(n_runs, d);
    std::vector<Variation>    runs(n_runs);
    for (std::size_t i = 0; i < n_runs; ++i)
      runs[i].also = choice_at(ranges, &unit[i * d]);
    const std::vector<VariationResult> results =
      run_variations(file, runs, progress);
    std::vector<double> x, y;
    std::string         reason;
    for (std::size_t i = 0; i < n_runs; ++i)
      if (!results[i].reason.empty() || results[i].mu <= 0.)
        reason =
          results[i].reason.empty() ? "mu is not positive" : results[i].reason;
      else
        {
          x.insert(x.end(), &unit[i * d], &unit[i * d] + d);
          y.push_back(results[i].mu);
        }
    if (y.size() < 2 * d + 2)
      throw ComputationError(
        "Only " + std::to_string(y.size()) + " of " + std::to_string(n_runs) +
        " runs have a mu; Sobol's indices of " + std::to_string(d) +
        " choices need " + std::to_string(2 * d + 2) +
        (reason.empty() ? "." : ". One: " + reason));
    const FrictionLaw law = train(ranges, x, y);
    ChoiceIndices     indices;
    indices.ranges   = ranges;
    indices.indices  = sensitivity_indices(law);
    indices.n_runs   = y.size();
    indices.n_failed = n_runs - y.size();
    indices.error    = law.description().leave_one_out_error;
    find_interval(law, indices);
    return indices;
  }



  void
  print_indices(const ChoiceIndices &indices, std::ostream &out)
  {
    out << "All of them at a time, from " << indices.n_runs << " runs";
    if (indices.n_failed > 0)
      out << " (" << indices.n_failed << " had no mu)";
    out << ", shares of the variance of mu:\n"
        << "  alone  with others  entry\n";
    for (std::size_t i = 0; i < indices.ranges.size(); ++i)
      {
        const ChoiceRange &range = indices.ranges[i];
        out << std::fixed << std::setprecision(2) << std::setw(7)
            << indices.indices[i].S1 << std::setw(13) << indices.indices[i].ST
            << std::defaultfloat << "  " << range.entry << " from "
            << range.at_lower.value << " to " << range.at_upper.value << "\n";
      }
    out << "95 % of these choices: mu = "
        << format_quantity(indices.lower, "1", 3) << " to "
        << format_quantity(indices.upper, "1", 3) << ", half of them below "
        << format_quantity(indices.median, "1", 3)
        << "; a run left out is missed by "
        << format_quantity(100. * indices.error, "1", 2)
        << " % in the mean, which is in no share\n";
  }



  nlohmann::ordered_json
  to_json(const ChoiceIndices &indices)
  {
    nlohmann::ordered_json json, rows = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < indices.ranges.size(); ++i)
      rows.push_back({{"entry", indices.ranges[i].entry},
                      {"from", indices.ranges[i].at_lower.value},
                      {"to", indices.ranges[i].at_upper.value},
                      {"S1", indices.indices[i].S1},
                      {"S1_conf", indices.indices[i].S1_conf},
                      {"ST", indices.indices[i].ST},
                      {"ST_conf", indices.indices[i].ST_conf}});
    json["runs"]                = indices.n_runs;
    json["failed"]              = indices.n_failed;
    json["leave_one_out_error"] = indices.error;
    json["median"]              = indices.median;
    json["lower"]               = indices.lower;
    json["upper"]               = indices.upper;
    json["choices"]             = rows;
    return json;
  }
} // namespace asperity
