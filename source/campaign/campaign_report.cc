#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/base/mechanisms.h>
#include <asperity/base/version.h>
#include <asperity/campaign/campaign_report.h>
#include <asperity/law_export/commands.h>
#include <asperity/law_export/export_law.h>
#include <asperity/postprocess/summary.h>
#include <asperity/surrogate/power_law.h>
#include <asperity/surrogate/sensitivity.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <ostream>

namespace asperity
{
  using json = nlohmann::ordered_json;

  namespace
  {
    /** As a shell takes it for one word. */
    std::string
    shell_word(const std::string &path)
    {
      const bool is_plain =
        path.find_first_not_of("abcdefghijklmnopqrstuvwxyz"
                               "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/._-+") ==
        std::string::npos;
      std::string text;
      for (const char c : path)
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
      return is_plain ? path : "'" + text + "'";
    }

    std::string
    percent(const double fraction)
    {
      return format_quantity(100. * fraction, "1", 3) + " %";
    }

    json
    to_json(const TestReport &test)
    {
      return {{"runs", test.n_runs},
              {"mean_relative_error", test.mean_relative_error},
              {"largest_relative_error", test.largest_error},
              {"coverage_95", test.coverage}};
    }

    void
    write_history(const std::string             &path,
                  const std::vector<HistoryRow> &history)
    {
      write_atomically(path, [&](std::ostream &out) {
        out << "runs,leave one out error [-],test error [-],"
               "largest test error [-],coverage of the 95 % interval [-]\n";
        for (const HistoryRow &row : history)
          {
            out << row.n_runs << ','
                << shortest_decimal(row.leave_one_out_error);
            if (row.test.n_runs > 0)
              out << ',' << shortest_decimal(row.test.mean_relative_error)
                  << ',' << shortest_decimal(row.test.largest_error) << ','
                  << shortest_decimal(row.test.coverage) << '\n';
            else
              out << ",,,\n";
          }
      });
    }

    /** The laws of practice, fitted to the same runs, as far as these determine
     *  them. */
    json
    compare_power_laws(const FrictionLaw &law, std::ostream &out)
    {
      json       result = json::object();
      const auto tell   = [&](const std::string &name,
                            PowerLaw (*fit)(const FrictionLaw &)) {
        try
          {
            const PowerLaw    power = fit(law);
            const std::string text = to_string(power, law.description().inputs);
            result[name]           = {{"law", text},
                                      {"mean_relative_error", power.mean_relative_error},
                                      {"leave_one_out_error", power.leave_one_out_error}};
            out << "  " << text << ": " << percent(power.leave_one_out_error)
                << "\n";
          }
        catch (const InputError &error)
          {
            result[name] = {{"missing", error.what()}};
            out << "  no " << name << ": " << error.what() << "\n";
          }
      };
      out << "Laws of practice, fitted to the same runs, and their error:\n";
      tell("power law", fit_power_law);
      for (const LawInput &input : law.description().inputs)
        if (input.symbol == "v")
          tell("velocity law", fit_velocity_law);
      return result;
    }

    json
    report_sensitivity(const std::string &directory,
                       const FrictionLaw &law,
                       std::ostream      &out)
    {
      const auto &description = law.description();
      const auto  indices     = sensitivity_indices(law);
      asperity::write_sensitivity(directory + "/sensitivity.csv",
                                  description,
                                  indices);
      json result = json::object();
      out << "Share of each input in the variance of " << description.output
          << " (by itself, with its interactions):\n";
      for (std::size_t i = 0; i < indices.size(); ++i)
        {
          const std::string &symbol = description.inputs[i].symbol;
          result[symbol] = {{"S1", indices[i].S1}, {"ST", indices[i].ST}};
          out << "  " << symbol << ": " << percent(indices[i].S1) << ", "
              << percent(indices[i].ST) << "\n";
        }
      return result;
    }

    json
    write_exports(const CampaignParameters &parameters,
                  const FrictionLaw        &law,
                  std::ostream             &out)
    {
      const std::string directory = parameters.directory + "/export";
      ExportOptions     options;
      options.grid.tolerance    = parameters.exports.table_tolerance;
      const ExportReport report = export_law(law, directory, options);
      json               files  = json::array();
      for (const ExportedFile &file : report.files)
        files.push_back(file.name);
      out << "For other programs: " << report.files.size() << " files in "
          << directory << ", tables within " << percent(report.table_error)
          << " of the law\n";
      for (const std::string &warning : report.warnings)
        out << "Warning: " << warning << "\n";
      return {{"files", files}, {"table_error", report.table_error}};
    }

    json
    describe_law(const FrictionLaw &law, const ProfileScatter &scatter)
    {
      const FrictionLawDescription &description = law.description();
      const Hyperparameters        &values = law.process().hyperparameters();
      json                          result;
      result["file"]                = "friction_law.json";
      result["output"]              = description.output;
      result["leave_one_out_error"] = description.leave_one_out_error;
      result["calibration"]         = description.calibration;
      result["topography"]          = {{"profiles", description.n_profiles},
                                       {"scatter", description.topography_scatter},
                                       {"scatter_beyond_factors",
                                        scatter.beyond_factor()},
                                       {"error", description.topography_error}};
      for (unsigned int k = 0; k < description.n_profiles; ++k)
        result["topography"]["factors"].push_back(scatter.factor(k));
      result["log_likelihood"]  = law.process().log_likelihood();
      result["signal_variance"] = values.signal_variance;
      result["noise_variance"]  = values.noise_variance;
      for (std::size_t i = 0; i < description.inputs.size(); ++i)
        result["length_scales"][description.inputs[i].symbol] =
          values.length_scales[i];
      return result;
    }

    void
    print_law(const CampaignParameters &parameters,
              const FrictionLaw        &law,
              const ProfileScatter     &scatter,
              const TestReport         &test,
              std::ostream             &out)
    {
      const FrictionLawDescription &description = law.description();
      out << "Friction law of " << law.process().data().y.size()
          << " runs: " << parameters.directory << "/friction_law.json\n"
          << "  " << mechanisms_sentence(description.mechanisms) << "\n"
          << "  mean error of cross-validation (leave one out) "
          << percent(description.leave_one_out_error) << "\n";
      if (test.n_runs > 0)
        out << "  mean error on " << test.n_runs << " test runs "
            << percent(test.mean_relative_error) << ", largest "
            << percent(test.largest_error) << "; " << percent(test.coverage)
            << " of them in the 95 % interval\n";
      if (description.n_profiles > 1)
        out << "  " << description.n_profiles << " profiles differ by "
            << percent(description.topography_scatter)
            << " (standard deviation), " << percent(scatter.beyond_factor())
            << " beyond a factor of each; the mean over the whole surface lies "
               "within "
            << percent(description.topography_error) << " (95 %)\n";
    }
  } // namespace



  void
  report_campaign(const CampaignParameters &parameters,
                  const Campaign           &campaign,
                  const double              wall_time,
                  std::ostream             &out)
  {
    const CampaignResults &results   = campaign.results();
    const SampleTable     &table     = results.table();
    const std::string     &directory = parameters.directory;

    const FrictionLaw law =
      results.train(results.training_data(campaign.plan().n_points(false)));
    const TestReport test = test_law(law, results.test_data());
    law.save(directory + "/friction_law.json");
    write_history(directory + "/history.csv", results.history());

    const unsigned int n_failed =
      table.count(SampleRole::training, SampleStatus::failed) +
      table.count(SampleRole::test, SampleStatus::failed);
    out << "\n"
        << table.samples().size() - n_failed << " runs, " << n_failed
        << " failed or without a result, " << format_duration(results.seconds())
        << " of one core in all; this session " << format_duration(wall_time)
        << "\n";
    print_law(parameters, law, results.scatter(), test, out);

    json summary;
    summary["program"]    = version_json();
    summary["base_scene"] = parameters.base_scene;
    summary["runs"]       = {
            {"training", table.count(SampleRole::training, SampleStatus::done)},
            {"test", table.count(SampleRole::test, SampleStatus::done)},
            {"failed", n_failed},
            {"without_result", results.n_without_result()}};
    summary["mechanisms"]  = law.description().mechanisms;
    summary["law"]         = describe_law(law, results.scatter());
    summary["test"]        = to_json(test);
    summary["power_laws"]  = compare_power_laws(law, out);
    summary["sensitivity"] = report_sensitivity(directory, law, out);
    if (parameters.exports.write)
      summary["export"] = write_exports(parameters, law, out);
    summary["cost"] = {{"core_seconds", results.seconds()},
                       {"session_seconds", wall_time}};

    std::vector<std::string> warnings = results.warnings();
    warnings.insert(warnings.end(),
                    law.description().warnings.begin(),
                    law.description().warnings.end());
    summary["warnings"] = warnings;
    write_summary(directory + "/summary.json", summary);
    for (const std::string &warning : warnings)
      out << "Warning: " << warning << "\n";
    out << "Ask it: asperity predict "
        << shell_word(directory + "/friction_law.json")
        << example_arguments(law.description()) << "\n"
        << "Pictures: tools/plot_law.py " << directory << "\n";
  }
} // namespace asperity
