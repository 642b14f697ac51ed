#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/base/json_file.h>
#include <asperity/base/mpi_session.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/base/version.h>
#include <asperity/campaign/scene_sensitivity.h>
#include <asperity/postprocess/summary.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <map>
#include <ostream>
#include <sstream>

namespace asperity
{
  namespace
  {
    const std::vector<ChoiceKind> all_kinds = {ChoiceKind::preparation,
                                               ChoiceKind::profile,
                                               ChoiceKind::scene,
                                               ChoiceKind::constants};

    /** A mu that is zero to the tolerances of the solvers. */
    constexpr double no_friction = 1e-4;

    std::string
    tenths_of_per_cent(const double share)
    {
      std::ostringstream text;
      text << std::fixed << std::setprecision(1) << 100. * share << " %";
      return text.str();
    }

    std::string
    interval(const double mu, const Spread &spread)
    {
      return format_quantity(mu * (1. - spread.below), "1", 3) + " to " +
             format_quantity(mu * (1. + spread.above), "1", 3);
    }

    nlohmann::ordered_json
    to_json(const Spread &spread)
    {
      return {{"below", spread.below}, {"above", spread.above}};
    }
  } // namespace



  std::vector<VariationResult>
  run_variations(
    const std::string                                               &file,
    const std::vector<Variation>                                    &variations,
    const std::function<void(const std::size_t, const std::size_t)> &progress)
  {
    MpiSession::start();
    const MPI_Comm     all     = MPI_COMM_WORLD;
    const unsigned int rank    = dealii::Utilities::MPI::this_mpi_process(all),
                       n_ranks = dealii::Utilities::MPI::n_mpi_processes(all);
    std::vector<double>                 mu(variations.size(), 0.);
    std::map<unsigned int, std::string> reasons;
    // Runs whose number leaves this rank as rest are its own.
    for (std::size_t i = rank; i < variations.size(); i += n_ranks)
      {
        RunOrder order;
        order.changes = variations[i].also;
        if (!variations[i].entry.empty())
          order.changes.emplace_back(variations[i].entry, variations[i].value);
        const RunRecord record = execute(file, order);
        mu[i]                  = record.mu;
        if (!record.done)
          reasons[i] = record.reason;
        else if (!record.no_result.empty())
          reasons[i] =
            "its mean is no friction coefficient (" + record.no_result + ")";
        if (progress)
          progress(std::min(variations.size(), i + n_ranks), variations.size());
      }
    dealii::Utilities::MPI::sum(mu, all, mu);
    std::vector<VariationResult> results;
    for (std::size_t i = 0; i < variations.size(); ++i)
      results.push_back({variations[i], mu[i], ""});
    for (const auto &of_rank : dealii::Utilities::MPI::all_gather(all, reasons))
      for (const auto &[i, reason] : of_rank)
        results[i].reason = reason;
    return results;
  }



  double
  SceneSensitivity::effect(const std::string &entry) const
  {
    double largest = 0.;
    for (const VariationResult &result : results)
      if (result.variation.entry == entry && result.reason.empty())
        largest = std::max(largest, std::abs(result.mu / mu - 1.));
    return largest;
  }



  Spread
  SceneSensitivity::spread(const ChoiceKind kind) const
  {
    std::map<std::string, Spread> of_entry;
    for (const VariationResult &result : results)
      if (result.variation.kind == kind && result.reason.empty())
        {
          const double change = result.mu / mu - 1.;
          Spread      &spread = of_entry[result.variation.entry];
          spread.below        = std::max(spread.below, -change);
          spread.above        = std::max(spread.above, change);
        }
    Spread sum;
    for (const auto &[entry, spread] : of_entry)
      sum = {std::hypot(sum.below, spread.below),
             std::hypot(sum.above, spread.above)};
    return sum;
  }



  Spread
  SceneSensitivity::spread() const
  {
    Spread sum;
    for (const ChoiceKind kind : all_kinds)
      {
        const Spread of_kind = spread(kind);
        sum                  = {std::hypot(sum.below, of_kind.below),
                                std::hypot(sum.above, of_kind.above)};
      }
    return sum;
  }



  SceneSensitivity
  compute_sensitivity(
    const std::string                                               &file,
    const std::vector<Variation>                                    &variations,
    const std::function<void(const std::size_t, const std::size_t)> &progress)
  {
    std::vector<Variation> all = {Variation()}; // the scene itself
    all.insert(all.end(), variations.begin(), variations.end());
    SceneSensitivity sensitivity;
    sensitivity.results         = run_variations(file, all, progress);
    const VariationResult scene = sensitivity.results.front();
    sensitivity.results.erase(sensitivity.results.begin());
    if (!scene.reason.empty() || std::abs(scene.mu) < no_friction)
      throw ComputationError(
        "The scene of " + file +
        " has no mu that variations could be compared with: " +
        (scene.reason.empty() ?
           "it is " + format_quantity(scene.mu, "1", 3) + ", which is none." :
           scene.reason));
    sensitivity.mu = scene.mu;
    std::map<std::string, double> effects;
    for (const Variation &variation : variations)
      effects[variation.entry] = sensitivity.effect(variation.entry);
    std::stable_sort(sensitivity.results.begin(),
                     sensitivity.results.end(),
                     [&](const VariationResult &a, const VariationResult &b) {
                       return effects[a.variation.entry] >
                              effects[b.variation.entry];
                     });
    return sensitivity;
  }



  void
  print_sensitivity(const SceneSensitivity &sensitivity, std::ostream &out)
  {
    const double mu = sensitivity.mu;
    out << "mu of the scene: " << format_quantity(mu, "1", 4) << "\n";
    std::size_t width = 0;
    for (const VariationResult &result : sensitivity.results)
      width = std::max(width,
                       result.variation.entry.size() +
                         result.variation.value.size() + 3);
    for (const VariationResult &result : sensitivity.results)
      {
        const Variation &v = result.variation;
        out << "  " << std::left << std::setw(static_cast<int>(width))
            << v.entry + " = " + v.value << std::right;
        if (!result.reason.empty())
          out << "  no mu: " << result.reason << "\n";
        else
          out << "  mu = " << std::left << std::setw(8)
              << format_quantity(result.mu, "1", 4) << std::right
              << std::showpos << std::fixed << std::setprecision(1)
              << std::setw(8) << 100. * (result.mu / mu - 1.) << std::noshowpos
              << std::defaultfloat << " %\n";
      }
    for (const ChoiceKind kind : all_kinds)
      {
        const Spread spread = sensitivity.spread(kind);
        if (spread.below > 0. || spread.above > 0.)
          out << name(kind) << ": -" << tenths_of_per_cent(spread.below) << " +"
              << tenths_of_per_cent(spread.above)
              << ", mu = " << interval(mu, spread) << "\n";
      }
    out << "all of them: mu = " << interval(mu, sensitivity.spread())
        << ", each choice by itself and added by their squares; constants "
           "within 10 %\n";
  }



  void
  write_sensitivity(const SceneSensitivity       &sensitivity,
                    const nlohmann::ordered_json &indices,
                    const std::string            &directory)
  {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    nlohmann::ordered_json summary, rows = nlohmann::ordered_json::array();
    summary["program"] = version_json();
    summary["mu"]      = sensitivity.mu;
    for (const ChoiceKind kind : all_kinds)
      summary["spread"][name(kind)] = to_json(sensitivity.spread(kind));
    summary["spread"]["all"] = to_json(sensitivity.spread());
    for (const VariationResult &result : sensitivity.results)
      {
        nlohmann::ordered_json row = {{"entry", result.variation.entry},
                                      {"value", result.variation.value},
                                      {"kind", name(result.variation.kind)}};
        if (result.reason.empty())
          row["mu"] = result.mu;
        else
          row["reason"] = result.reason;
        rows.push_back(row);
      }
    summary["variations"] = rows;
    if (!indices.is_null())
      summary["sobol"] = indices;
    write_summary(directory + "/sensitivity.json", summary);
    write_atomically(directory + "/sensitivity.csv", [&](std::ostream &out) {
      out << "entry,value,kind,mu,change\n" << std::setprecision(12);
      for (const VariationResult &result : sensitivity.results)
        {
          out << result.variation.entry << ',' << result.variation.value << ','
              << name(result.variation.kind) << ',';
          if (result.reason.empty())
            out << result.mu << ',' << result.mu / sensitivity.mu - 1.;
          else
            out << ',';
          out << '\n';
        }
    });
  }



  std::vector<ChoiceSpread>
  read_spreads(const std::string &path)
  {
    const auto document = read_json(path, "a table of `asperity sensitivity`");
    std::vector<ChoiceSpread> result;
    for (const ChoiceKind kind : all_kinds)
      {
        ChoiceSpread choice{name(kind)};
        for (const auto &[side, share] :
             {std::make_pair("below", &choice.below),
              std::make_pair("above", &choice.above)})
          {
            const nlohmann::ordered_json::json_pointer place(
              "/spread/" + choice.kind + "/" + side);
            if (!document.contains(place) || !document[place].is_number() ||
                !(document[place].get<double>() >= 0.))
              throw InputError(path +
                               ": no number that is not negative stands "
                               "at " +
                               quoted_text(place.to_string()) +
                               "; expected the sensitivity.json that 'asperity "
                               "sensitivity' writes.");
            *share = document[place];
          }
        if (choice.below + choice.above > 0.)
          result.push_back(choice);
      }
    return result;
  }
} // namespace asperity
