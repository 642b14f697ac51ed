#include <asperity/base/atomic_file.h>
#include <asperity/base/mechanisms.h>
#include <asperity/base/quantity.h>
#include <asperity/base/version.h>
#include <asperity/postprocess/summary.h>
#include <asperity/tool_design/tool_search.h>
#include <asperity/topography/roughness.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <iomanip>
#include <ostream>
#include <set>

namespace asperity
{
  namespace
  {
    using json = nlohmann::ordered_json;

    void
    write_profile(const std::string         &path,
                  const ToolExchange        &tool,
                  const std::vector<double> &heights)
    {
      write_atomically(path, [&](std::ostream &out) {
        out << "x [um],height [um]\n";
        for (std::size_t i = 0; i < heights.size(); ++i)
          out << shortest_decimal(1e6 * tool.period() * i / heights.size())
              << "," << shortest_decimal(1e6 * tool.rms() * heights[i]) << "\n";
      });
    }



    /** The base scene with another tool, ready to be run. */
    void
    write_scene(const std::string &path,
                const std::string &base_scene,
                const std::string &folder,
                const EntryValues &entries)
    {
      write_atomically(path, [&](std::ostream &out) {
        out
          << "# A tool that 'asperity optimize' has found: the profile of the "
             "table beside\n# this file as harmonics.\ninclude "
          << std::filesystem::absolute(base_scene).string() << "\n\n";
        for (const auto &[entry, value] : entries)
          {
            std::string rest = entry, indent;
            for (std::size_t slash;
                 (slash = rest.find('/')) != std::string::npos;
                 rest = rest.substr(slash + 1), indent += "  ")
              out << indent << "subsection " << rest.substr(0, slash) << "\n";
            out << indent << "set " << rest << " = " << value << "\n";
            for (; !indent.empty(); indent.erase(0, 2))
              out << indent.substr(2) << "end\n";
          }
        out << "subsection Output\n  set Output directory = " << folder
            << "/best\nend\n";
      });
    }



    json
    results_of(const RunRecord &run)
    {
      if (!run.done)
        return {{"failed", run.reason}};
      json result = {{"mu", run.mu},
                     {"mu_end", run.mu_end},
                     {"contact_fraction", run.contact_fraction},
                     {"max_contact_pressure", run.max_contact_pressure},
                     {"oil_pressure", run.oil_pressure},
                     {"oil_load_share", run.oil_load_share},
                     {"max_plastic_strain", run.max_plastic_strain},
                     {"mechanisms", run.mechanisms},
                     {"warnings", run.warnings}};
      if (!run.no_result.empty())
        result["no_result"] = run.no_result;
      return result;
    }

    json
    shape_json(const ToolExchange &tool, std::vector<double> heights)
    {
      for (double &h : heights)
        h *= tool.rms();
      const ProfileRoughness roughness =
        profile_roughness(heights, tool.period() / heights.size());
      return {{"Rq", roughness.Rq},
              {"Rsk", roughness.Rsk},
              {"Rku", roughness.Rku},
              {"Rdq", roughness.Rdq}};
    }



    json
    summary_of(const ToolSearch &search)
    {
      const DesignResults &results = search.results();
      json                 summary;
      summary["program"] = version_json();
      summary["space"]   = results.space;
      for (const TextureErrors &errors : results.errors)
        summary["textures"][errors.kind] = {{"n", errors.n},
                                            {"network", errors.network},
                                            {"modes", errors.modes}};
      summary["base"]["results"] = results_of(results.base);
      summary["base"]["shape"] =
        shape_json(search.tool(), search.tool().base());
      if (results.base_check)
        summary["base"]["check"] = results_of(*results.base_check);
      for (const FoundTool &found : results.found)
        {
          json &tool          = summary["found"][found.method];
          tool["objective"]   = found.search.value;
          tool["evaluations"] = found.search.n_evaluations;
          tool["failed"]      = found.search.n_failed;
          tool["to_best"]     = found.search.n_to_best;
          tool["end"]         = found.search.end;
          tool["variables"]   = found.search.best;
          tool["results"]     = results_of(found.run);
          tool["shape"]       = shape_json(search.tool(), found.heights);
          if (found.check)
            tool["check"] = results_of(*found.check);
          tool["history"] = found.search.history;
        }
      return summary;
    }
  } // namespace



  void
  write_tools(const ToolSearch &search, const ToolDesignParameters &parameters)
  {
    const std::string &folder = parameters.directory;
    write_profile(folder + "/base_profile.csv",
                  search.tool(),
                  search.tool().base());
    for (const FoundTool &found : search.results().found)
      {
        const std::string to = folder + "/" + found.method;
        write_profile(to + "/best_profile.csv", search.tool(), found.heights);
        write_scene(to + "/best.prm",
                    parameters.base_scene,
                    to,
                    search.tool().entries(found.heights));
      }
    write_summary(folder + "/summary.json", summary_of(search));
  }



  namespace
  {
    void
    print_errors(const std::vector<TextureErrors> &all, std::ostream &out)
    {
      if (all.empty())
        return;
      out << "\nTextures that were not trained with: error over Rq of the "
             "network, and of as many modes\n";
      for (const TextureErrors &errors : all)
        if (errors.n > 0)
          out << "  " << std::setw(10) << std::left << errors.kind << std::right
              << std::setw(5) << errors.n << std::setw(10)
              << per_cent(errors.network) << std::setw(10)
              << per_cent(errors.modes) << "\n";
    }

    void
    print_row(const std::string              &name,
              const RunRecord                &run,
              const std::optional<RunRecord> &check,
              const json                     &shape,
              std::ostream                   &out)
    {
      const auto number = [&](const double value) {
        out << std::setw(10) << format_quantity(value, "1", 3);
      };
      out << "  " << std::setw(10) << std::left << name << std::right;
      number(run.mu);
      number(run.contact_fraction);
      number(run.oil_load_share);
      number(1e6 * shape.at("Rq").get<double>());
      number(shape.at("Rdq"));
      number(shape.at("Rsk"));
      if (check && check->done)
        number(check->mu);
      else if (check)
        out << "    failed: " << check->reason;
      out << "\n";
    }
  } // namespace



  void
  print_tools(const ToolSearch           &search,
              const ToolDesignParameters &parameters,
              std::ostream               &out)
  {
    const DesignResults &results = search.results();
    const ToolExchange  &tool    = search.tool();
    print_errors(results.errors, out);
    out << "\n                    mu   contact  oil load   Rq [um]       Rdq "
           "      Rsk"
        << (results.base_check ? "  mu check\n" : "\n");
    print_row("base",
              results.base,
              results.base_check,
              shape_json(tool, tool.base()),
              out);
    for (const FoundTool &found : results.found)
      print_row(found.method,
                found.run,
                found.check,
                shape_json(tool, found.heights),
                out);
    out << "\n";
    for (const FoundTool &found : results.found)
      out << found.method << ": objective "
          << format_quantity(found.search.value, "1", 4)
          << " of the base scene's, after " << found.search.n_to_best << " of "
          << found.search.n_evaluations << " runs (" << found.search.n_failed
          << " failed); " << found.search.end << "\n";
    out << mechanisms_sentence(results.base.mechanisms) << "\n";
    std::set<std::string> warnings(results.base.warnings.begin(),
                                   results.base.warnings.end());
    for (const FoundTool &found : results.found)
      warnings.insert(found.run.warnings.begin(), found.run.warnings.end());
    for (const std::string &warning : warnings)
      out << "Warning: " << warning << "\n";
    out << "Profiles, their scenes and all runs are in " << parameters.directory
        << "\n";
  }
} // namespace asperity
