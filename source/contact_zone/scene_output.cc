#include <asperity/base/version.h>
#include <asperity/contact_zone/mechanisms.h>
#include <asperity/contact_zone/scene_checkpoint.h>
#include <asperity/contact_zone/scene_heat.h>
#include <asperity/contact_zone/scene_output.h>
#include <asperity/postprocess/polyline.h>
#include <asperity/postprocess/summary.h>

#include <deal.II/base/timer.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace asperity
{
  using json = nlohmann::ordered_json;

  namespace
  {
    /** Up to which step pictures stay. */
    int
    kept(const RunState &state)
    {
      return state.step > 0 ? static_cast<int>(state.step) :
                              VtuSeries::keep_nothing;
    }
  } // namespace



  SceneOutput::SceneOutput(const SceneParameters &parameters,
                           const InputRecord     &inputs,
                           const Scene           &scene,
                           const RunState        &state)
    : parameters(parameters)
    , inputs(inputs)
    , scene(scene)
    , table(parameters.output.directory, state.rows)
    , chip_output(*scene.space,
                  scene.geometry,
                  parameters.output.subdivisions,
                  static_cast<unsigned int>(std::lround(
                    std::sqrt(scene.chip->table().points_per_element))))
    , chip(parameters.output.directory, "chip", kept(state))
    , tool(parameters.output.directory, "tool", kept(state))
    , contact_line(parameters.output.directory, "contact", kept(state))
    , checkpoints(parameters.output.directory + "/checkpoint")
    , last_picture(state.step)
  {
    if (scene.gap_flow != nullptr)
      oil = std::make_unique<VtuSeries>(parameters.output.directory,
                                        "oil",
                                        kept(state));
  }



  void
  SceneOutput::step(const SlidingRun &run)
  {
    dealii::Timer timer;
    table.append(run.state().rows.back());
    const unsigned int step = run.state().step;
    if (parameters.output.picture_interval > 0 &&
        step % parameters.output.picture_interval == 0)
      write_pictures(run);
    if (parameters.output.checkpoint_interval > 0 &&
        step % parameters.output.checkpoint_interval == 0)
      write_checkpoint(run);
    seconds_ += timer.wall_time();
  }



  void
  SceneOutput::write_pictures(const SlidingRun &run)
  {
    const unsigned int step = run.state().step;
    const double       time = run.state().time;
    last_picture            = step;
    write_chip(run);

    Polyline           curve;
    const unsigned int n = 4 * scene.tool_surface.curve.knot_vector().n_spans();
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double x = scene.length * i / n;
        curve.points.emplace_back(x, scene.tool_surface.height(x));
      }
    tool.write(step, time, [&](std::ostream &out) {
      write_polyline(out, curve, time, step);
    });
    write_contact_line(run.state().u, step, time);
    if (oil)
      oil->write(step, time, [&](std::ostream &out) {
        scene.gap_flow->write(out, time, step);
      });
  }



  void
  SceneOutput::write_chip(const SlidingRun &run)
  {
    const unsigned int step = run.state().step;
    const double       time = run.state().time;
    ChipFields         fields;
    fields.displacement.reinit(scene.n_dofs());
    std::copy_n(run.state().u.begin(),
                scene.n_dofs(),
                fields.displacement.begin());
    const auto         &history = scene.chip->history();
    std::vector<double> strain(history.size()), temperature(history.size());
    for (std::size_t q = 0; q < history.size(); ++q)
      {
        strain[q]      = history[q].plastic_strain;
        temperature[q] = history[q].temperature - 273.15;
      }
    fields.quadrature_scalars = {{"equivalent plastic strain [-]", strain},
                                 {"temperature [degC]", temperature},
                                 {"von Mises stress [Pa]",
                                  scene.chip->mises_stress()}};
    chip.write(step, time, [&](std::ostream &out) {
      chip_output.write(out, fields, time, step);
    });
  }



  void
  SceneOutput::write_contact_line(const dealii::Vector<double> &u,
                                  const unsigned int            step,
                                  const double                  time)
  {
    Polyline                          line;
    const auto                       &contact = *scene.contact;
    std::vector<double>               gap, oil_pressure;
    std::vector<dealii::Tensor<1, 2>> traction;
    const ShearTraction              *shear = contact.shear();
    // per present length
    std::vector<double>       pressure = contact.pressure(), shear_traction;
    const std::vector<double> stretch  = contact.stretch(u);
    if (shear != nullptr)
      shear_traction = shear->at_points();
    for (std::size_t q = 0; q < pressure.size(); ++q)
      {
        pressure[q] /= stretch[q];
        gap.push_back(contact.gaps()[q].gap);
        oil_pressure.push_back(
          scene.lubricant ?
            scene.lubricant->pressure(contact.table().parameter[q][0]) :
            0.);
        traction.push_back(pressure[q] * contact.gaps()[q].normal);
        if (shear == nullptr)
          continue;
        shear_traction[q] /= stretch[q];
        traction.back() -= shear_traction[q] * shear->slip()[q].tangent;
      }
    line.points  = contact.positions();
    line.scalars = {{"contact pressure [Pa]", pressure},
                    {"oil pressure [Pa]", oil_pressure},
                    {"gap [m]", gap}};
    line.vectors = {{"traction [Pa]", traction}};
    if (shear != nullptr)
      {
        line.scalars.emplace_back("shear traction [Pa]", shear_traction);
        line.scalars.emplace_back("sticking [-]", shear->sticking());
      }
    if (scene.heat)
      {
        const auto add = [&line](const std::string  &name,
                                 std::vector<double> temperature) {
          for (double &value : temperature)
            value -= 273.15;
          line.scalars.push_back({name, temperature});
        };
        add("temperature of the chip [degC]", scene.heat->chip_temperature());
        add("temperature of the tool [degC]", scene.heat->tool_temperature());
        line.scalars.push_back(
          {"heat flux into the tool [W/m^2]", scene.heat->flux_to_tool()});
      }
    contact_line.write(step, time, [&](std::ostream &out) {
      write_polyline(out, line, time, step);
    });
  }



  void
  SceneOutput::write_checkpoint(const SlidingRun &run) const
  {
    checkpoints.write({version_line(), inputs, save(run, scene)},
                      run.state().step);
  }



  double
  SceneOutput::seconds() const
  {
    return seconds_;
  }



  namespace
  {
    json
    summarise_friction(const SlidingRun &run, const SceneParameters &parameters)
    {
      const FrictionResult    friction  = run.friction();
      const FrictionJudgement judgement = run.judgement();
      const double            v         = parameters.load.velocity;
      json                    summary;
      summary["mu"]              = friction.mu;
      summary["ploughing"]       = friction.ploughing;
      summary["interface_shear"] = friction.interface_shear;
      summary["oil_shear"]       = friction.oil_shear;
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

    json
    summarise_oil(const SlidingRun      &run,
                  const Scene           &scene,
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

    json
    summarise_heat(const SlidingRun &run)
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
    add_end(const FrictionRow &last, const Scene &scene, json &summary)
    {
      const auto is_in = [](const FrictionColumn &column, const char *section) {
        return column.summary.rfind(section, 0) == 0;
      };
      for (const FrictionColumn &column : friction_columns())
        if (!column.summary.empty() &&
            (scene.lubricant || !is_in(column, "/oil/")) &&
            (scene.heat || !is_in(column, "/heat/")))
          std::visit(
            [&](const auto entry) {
              summary[json::json_pointer(column.summary)] = last.*entry;
            },
            column.member);
    }

    json
    summarise_cost(const SlidingRun &run,
                   const Scene      &scene,
                   const double      output_seconds,
                   const double      wall_time)
    {
      const EquilibriumCost &cost = scene.equilibrium->cost();
      json                   summary;
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



  void
  SceneOutput::finish(const SlidingRun               &run,
                      const SceneAudit               &audit,
                      const AccuracyReport           &accuracy,
                      const std::vector<std::string> &warnings,
                      const double                    wall_time)
  {
    dealii::Timer timer;
    if (last_picture != run.state().step)
      write_pictures(run);
    seconds_ += timer.wall_time();

    json summary;
    summary["program"]          = version_json();
    summary["friction"]         = summarise_friction(run, parameters);
    summary["contact_fraction"] = run.friction().contact_fraction;
    if (accuracy.error)
      summary["accuracy"] = to_json(accuracy);
    if (scene.lubricant)
      summary["oil"] = summarise_oil(run, scene, parameters);
    if (scene.heat)
      summary["heat"] = summarise_heat(run);
    add_end(run.state().rows.back(), scene, summary);
    summary["load"]   = {{"pressure", parameters.load.pressure},
                         {"velocity", parameters.load.velocity},
                         {"temperature", parameters.load.temperature},
                         {"plastic_strain", parameters.load.plastic_strain}};
    summary["models"] = {
      {"lubricant", name(parameters.lubrication.model)},
      {"inertia", run.solid_step().is_dynamic() ? "dynamic" : "quasi-static"},
      {"heat", name(parameters.heat_model())},
      {"material", scene.law->name()}};
    summary["mechanisms"] = mechanisms_of(parameters);
    summary["mesh"]       = {{"degree", scene.space->degree()},
                             {"cells", scene.space->n_cells()},
                             {"unknowns", scene.n_unknowns()},
                             {"contact_element", scene.contact_element_length()},
                             {"penalty", scene.penalty()}};
    summary["surfaces"]   = {{"period", scene.length},
                             {"tool", scene.tool_surface.description},
                             {"chip", scene.chip_surface.description}};
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
} // namespace asperity
