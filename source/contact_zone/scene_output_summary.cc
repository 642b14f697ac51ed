#include <asperity/base/version.h>
#include <asperity/contact_zone/mechanisms.h>
#include <asperity/contact_zone/scene_output.h>
#include <asperity/contact_zone/scene_report.h>
#include <asperity/postprocess/summary.h>

#include <deal.II/base/timer.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using json = nlohmann::ordered_json;

  namespace
  {
    template <int dim>
    json
    summarise_friction(const SlidingRun<dim> &run,
                       const SceneParameters &parameters)
    {
      const FrictionResult    friction  = run.friction();
      const FrictionJudgement judgement = run.judgement();
      const double            v         = parameters.load.velocity;
      json                    summary;
      summary["mu"]              = friction.mu;
      summary["ploughing"]       = friction.ploughing;
      summary["interface_shear"] = friction.interface_shear;
      summary["oil_shear"]       = friction.oil_shear;
      summary["transverse"]      = friction.transverse;
      summary["mu_end"]          = friction.mu_end;
      summary["spread"]          = friction.spread;
      summary["valid"]           = judgement.status == FrictionStatus::valid;
      summary["status"]          = name(judgement.status);
      summary["window"]          = {friction.window_begin, friction.window_end};
      summary["window_sliding_distance"] = {friction.window_begin * v,
                                            friction.window_end * v};
      summary["T_x"]                     = friction.T_x;
      summary["T_y"]                     = friction.T_y;
      summary["carried_load"]            = judgement.carried_load;
      json distances                     = json::array();
      for (const DistanceMean &mean :
           means_over_distance(run.state().rows, 0.1e-6))
        distances.push_back(
          {{"from", mean.from}, {"to", mean.to}, {"mu", mean.mu}});
      summary["over_distance"] = distances;
      if (parameters.protocol.window == FrictionWindow::steady)
        summary["steady"] = run.is_steady();
      return summary;
    }

    /** JSON has no number for 0/0. */
    json
    number_or_null(const double value)
    {
      return std::isfinite(value) ? json(value) : json(nullptr);
    }

    /** Lengths in m, before scaling; pairs are along x and y. */
    json
    to_json(const WindowReport &w)
    {
      return {{"column", w.window.column},
              {"row", w.window.row},
              {"samples", {w.window.nx, w.window.ny}},
              {"extent", w.extent},
              {"filled_samples", w.n_filled},
              {"removed_tilt", w.removed_tilt},
              {"largest_jump", w.largest_jump},
              {"rms_jump", w.rms_jump},
              {"bridged", w.bridged},
              {"Sq_before", w.Sq_before},
              {"Sq_after", w.Sq_after},
              {"Sdq_before", w.Sdq_before},
              {"Sdq_after", w.Sdq_after},
              {"fit_rms", w.fit_rms},
              {"fit_max", w.fit_max},
              {"spans", w.n_knots}};
    }

    template <int dim>
    json
    summarise_surfaces(const Scene<dim> &scene)
    {
      json        summary    = {{"period", scene.length},
                                {"tool", scene.tool_surface.description},
                                {"chip", scene.chip_surface.description}};
      const auto &topography = scene.tool_surface.topography;
      if (topography)
        {
          summary["Sal"] = number_or_null(topography->texture.Sal);
          summary["Str"] = number_or_null(topography->texture.Str);
        }
      if constexpr (dim == 3)
        {
          summary["width"] = scene.width;
          if (scene.tool_surface.window)
            summary["window"] = to_json(*scene.tool_surface.window);
        }
      return summary;
    }

    template <int dim>
    json
    summarise_oil(const SlidingRun<dim> &run,
                  const Scene<dim>      &scene,
                  const SceneParameters &parameters)
    {
      const FrictionResult friction = run.friction();
      const FrictionRow   &last     = run.state().rows.back();
      json                 summary;
      summary["wetting"]               = parameters.lubrication.wetting;
      summary["thickness"]             = scene.oil.thickness;
      summary["part_of_void_at_start"] = scene.oil.part_at_start;
      summary["part_of_void_at_touch"] =
        number_or_null(scene.oil.part_at_touch);
      summary["temperature"] = run.oil_temperature();
      summary["initial_gap"] = scene.oil.initial_gap;
      summary["pressure"]    = friction.oil_pressure;
      summary["load_share"]  = number_or_null(
        friction.oil_pressure * scene.length / std::abs(friction.T_y));
      summary["T_x_pressure"]     = friction.oil_T_x;
      summary["T_x_shear"]        = friction.shear_T_x;
      summary["reference_volume"] = last.oil_reference_volume;
      summary["events"]           = scene.lubricant->events();
      return summary;
    }

    template <int dim>
    json
    summarise_heat(const SlidingRun<dim> &run)
    {
      const std::vector<FrictionRow> &rows     = run.state().rows;
      const FrictionResult            friction = run.friction();
      const std::optional<double>     to_tool =
        share_of_tool(rows, friction.window_begin, friction.window_end);
      double flash = 0., error = 0.;
      for (const FrictionRow &row : rows)
        {
          flash = std::max(flash, row.flash_temperature);
          error = std::max(error, row.heat_balance_error);
        }
      json summary;
      summary["to_tool"]           = to_tool ? json(*to_tool) : json(nullptr);
      summary["balance_error"]     = error;
      summary["flash_temperature"] = flash;
      return summary;
    }

    /** The columns of the last row that summary.json shows. */
    void
    add_end(const FrictionRow &last,
            const bool         has_oil,
            const bool         has_heat,
            json              &summary)
    {
      const auto is_in = [](const FrictionColumn &column, const char *section) {
        return column.summary.rfind(section, 0) == 0;
      };
      for (const FrictionColumn &column : friction_columns())
        if (!column.summary.empty() && (has_oil || !is_in(column, "/oil/")) &&
            (has_heat || !is_in(column, "/heat/")))
          std::visit(
            [&](const auto entry) {
              summary[json::json_pointer(column.summary)] = last.*entry;
            },
            column.member);
    }

    template <int dim>
    json
    summarise_mesh(const SlidingRun<dim> &run,
                   const Scene<dim>      &scene,
                   const SceneParameters &parameters)
    {
      json summary = {{"degree", scene.space->degree()},
                      {"cells", scene.space->n_cells()},
                      {"unknowns", scene.n_unknowns()},
                      {"contact_element", scene.contact_element_length()},
                      {"penalty", scene.penalty()}};
      if (parameters.mesh.adaptive_levels == 0)
        return summary;
      const RemeshReport &report = run.state().remeshing;
      summary["remeshing"]       = {
              {"remeshes", report.remeshes},
              {"largest_change_of_mu", report.change},
              {"largest_change_of_mu_in_ramp", report.change_in_ramp},
              {"drift_of_plastic_work", report.work_drift()},
              {"excess_of_plastic_strain", report.strain_excess},
              {"excess_of_temperature", report.temperature_excess},
              {"most_unknowns", report.most_unknowns},
              {"bounded", report.bounded},
              {"missing_levels", report.missing_levels},
              {"mean_unknowns", run.mean_unknowns()}};
      return summary;
    }

    template <int dim>
    json
    summarise_cost(const SlidingRun<dim> &run,
                   const Scene<dim>      &scene,
                   const double           output_seconds,
                   const double           wall_time)
    {
      const EquilibriumCost &cost = scene.equilibrium->cost();
      json                   summary;
      if constexpr (dim == 3)
        {
          summary["ranks"]         = scene.share().ranks.size();
          summary["imbalance"]     = scene.imbalance();
          summary["linear_solver"] = name_of_solver(scene.linear_solver());
        }
      summary["wall_time"]     = wall_time;
      summary["assembly"]      = cost.assembly;
      summary["factorisation"] = cost.factorisation;
      summary["solution"]      = cost.solution;
      if (scene.gap_flow != nullptr)
        summary["flow"] = scene.gap_flow->seconds();
      summary["output"]            = output_seconds;
      summary["steps"]             = run.state().step;
      summary["cuts"]              = run.n_cuts();
      summary["newton_iterations"] = run.newton_statistics().iterations;
      summary["factorisations"]    = cost.factorisations;
      summary["linearizations"]    = run.newton_statistics().linearizations;
      summary["residuals"]         = run.newton_statistics().residuals;
      return summary;
    }
  } // namespace



  template <int dim>
  void
  SceneOutput<dim>::finish(const SlidingRun<dim>          &run,
                           const SceneAudit               &audit,
                           const AccuracyReport           &accuracy,
                           const std::vector<std::string> &warnings,
                           const double                    wall_time)
  {
    dealii::Timer timer;
    if (last_picture != run.state().step)
      write_pictures(run);
    seconds_ += timer.wall_time();
    if (!files)
      return;

    json summary;
    summary["program"]          = version_json();
    summary["friction"]         = summarise_friction(run, parameters);
    summary["contact_fraction"] = run.friction().contact_fraction;
    if (accuracy.error)
      summary["accuracy"] = to_json(accuracy, run.friction().mu);
    if (scene.lubricant)
      summary["oil"] = summarise_oil(run, scene, parameters);
    if (scene.heat)
      summary["heat"] = summarise_heat(run);
    add_end(run.state().rows.back(),
            scene.lubricant != nullptr,
            scene.heat != nullptr,
            summary);
    summary["load"]   = {{"pressure", parameters.load.pressure},
                         {"velocity", parameters.load.velocity},
                         {"sliding_direction", parameters.load.direction},
                         {"temperature", parameters.load.temperature},
                         {"plastic_strain", parameters.load.plastic_strain}};
    summary["models"] = {
      {"lubricant", name(parameters.lubrication.model)},
      {"inertia", run.solid_step().is_dynamic() ? "dynamic" : "quasi-static"},
      {"heat", name(parameters.heat_model())},
      {"material", scene.law->name()}};
    summary["mechanisms"] = mechanisms_of(parameters);
    summary["mesh"]       = summarise_mesh(run, scene, parameters);
    summary["surfaces"]   = summarise_surfaces(scene);
    json numbers;
    for (const AuditEntry &entry : audit.entries)
      numbers[entry.name] = {{"value", number_or_null(entry.value)},
                             {"meaning", entry.meaning}};
    summary["audit"]    = numbers;
    summary["cost"]     = summarise_cost(run, scene, seconds_, wall_time);
    summary["warnings"] = warnings;
    json unused         = json::array();
    for (const UnusedEntry &entry : audit.unused)
      unused.push_back(
        {{"entry", entry.path}, {"counts_with", entry.counts_with}});
    summary["unused_entries"] = unused;
    write_summary(parameters.output.directory + "/summary.json", summary);
  }



  template void
  SceneOutput<2>::finish(const SlidingRun<2> &,
                         const SceneAudit &,
                         const AccuracyReport &,
                         const std::vector<std::string> &,
                         const double);
  template void
  SceneOutput<3>::finish(const SlidingRun<3> &,
                         const SceneAudit &,
                         const AccuracyReport &,
                         const std::vector<std::string> &,
                         const double);
} // namespace asperity
