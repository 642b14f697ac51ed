#include <asperity/contact_zone/field_recorder.h>
#include <asperity/contact_zone/mechanisms.h>
#include <asperity/contact_zone/scene_computation.h>
#include <asperity/contact_zone/scene_input.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** Part of the strength that a chip near its melting temperature has left.
     *  Plastic work, which falls with it, hardly heats beyond that. */
    constexpr double melted = 0.02;

    /** Whether plastic work has all but melted a point of the chip. */
    template <int dim>
    void
    warn_of_melting(const SlidingRun<dim>    &run,
                    const SceneParameters    &parameters,
                    std::vector<std::string> &warnings)
    {
      const auto softening = parameters.material.softening();
      double     hottest   = 0.;
      for (const FrictionRow &row : run.state().rows)
        hottest = std::max(hottest, row.max_temperature);
      if (softening && hottest >= softening->temperature_at(melted))
        warnings.push_back(
          "The chip gets as hot as " + format_quantity(hottest, "degC", 5) +
          " and all but melts there (melting temperature " +
          format_quantity(softening->melting_temperature, "degC", 5) + ")" +
          (parameters.heat_model() == HeatModel::conducting ?
             "." :
             std::string("; nothing conducts the heat away, so that this is an "
                         "upper bound") +
               (dim == 3 ? "." :
                           ": Heat/Model = conducting would tell more.")));
    }

    /** That tool, oil and load have done on the chip since the start, per metre
     *  of its width [J/m]. */
    template <int dim>
    double
    work_on_chip(const SlidingRun<dim> &run)
    {
      const std::vector<FrictionRow> &rows = run.state().rows;
      double                          work = 0.;
      for (std::size_t i = 1; i < rows.size(); ++i)
        work +=
          std::abs(rows[i].T_x *
                   (rows[i].sliding_distance - rows[i - 1].sliding_distance)) +
          std::abs(rows[i].T_y * (rows[i].mean_gap - rows[i - 1].mean_gap));
      return work;
    }

    /** Whether the oil shears as no oil does: the limiting stress grows
     *  linearly with the pressure, so that its mean over the period belongs
     *  to the mean pressure. */
    template <int dim>
    void
    warn_of_oil_shear(const SlidingRun<dim>    &run,
                      const double              length,
                      const SceneParameters    &parameters,
                      std::vector<std::string> &warnings)
    {
      const ViscosityParameters &oil = parameters.lubrication.oil.viscosity;
      if (oil.stress_limit != StressLimit::none)
        return;
      double stress = 0., limit = 0.;
      for (const FrictionRow &row : run.state().rows)
        if (std::abs(row.shear_T_x) / length > stress)
          {
            stress = std::abs(row.shear_T_x) / length;
            limit  = oil.limiting_stress +
                    oil.limiting_stress_slope * std::max(0., row.oil_pressure);
          }
      if (stress > limit)
        warnings.push_back(
          "The shear stress of the oil reaches a mean of " +
          format_quantity(stress, "MPa", 3) +
          " over the period, where oil slips like a plastic solid above " +
          format_quantity(limit, "MPa", 3) +
          ", so that mu is too large; set Lubricant/Stress limit = circular.");
    }
  } // namespace



  template <int dim>
  std::vector<std::string>
  warnings_of_run(const std::vector<std::string> &warnings_of_audit,
                  const SlidingRun<dim>          &run,
                  const SceneParameters          &parameters)
  {
    std::vector<std::string> warnings = warnings_of_audit;
    for (const std::string &warning : run.judgement().warnings)
      warnings.push_back(warning);
    if (parameters.protocol.window == FrictionWindow::steady &&
        !run.is_steady())
      warnings.push_back(
        "mu is not steady after the maximal sliding distance of " +
        format_quantity(parameters.protocol.maximum_distance, "um") + ".");
    warn_of_melting(run, parameters, warnings);
    if (const std::string excess = run.excess_shear(); !excess.empty())
      warnings.push_back(excess);
    warn_of_oil_shear(run, run.period(), parameters, warnings);
    for (const std::string &warning :
         {run.coarse_film(),
          run.coarser_meshes(),
          run.solid_step().energy().warning(work_on_chip(run) * run.area() /
                                            run.period())})
      if (!warning.empty())
        warnings.push_back(warning);
    const LubricantModel model = parameters.lubrication.model;
    const bool           has_residual_film =
      model == LubricantModel::reynolds ||
      (fills_gap(model) && parameters.lubrication.sealing_gap == 0.);
    if (has_residual_film && run.friction().contact_fraction > 0.)
      warnings.push_back(
        "Where tool and chip touch, the oil is taken to be " +
        format_quantity(parameters.lubrication.residual_film, "nm") +
        " thick (Lubrication/Residual film); no model tells this thickness, "
        "and mu depends on it by some per cent: vary it.");
    if (fills_gap(model) && parameters.lubrication.sealing_gap > 0.)
      warnings.push_back(
        "Where the gap is below " +
        format_quantity(parameters.lubrication.sealing_gap, "nm") +
        " (Lubrication/Sealing gap) the oil does not flow, and has the pressure "
        "of the pocket beside it; mu depends on this gap: vary it.");
    if (fills_gap(model) && parameters.lubrication.sealing_gap > 0. &&
        !parameters.lubrication.flow.compressible)
      warnings.push_back(
        "The oil in the pockets is incompressible, where oil loses 10 to 20 % "
        "of its volume at such loads; Flow/Compressible = true would tell what "
        "this changes.");
    return warnings;
  }



  template std::vector<std::string>
  warnings_of_run(const std::vector<std::string> &,
                  const SlidingRun<2> &,
                  const SceneParameters &);
  template std::vector<std::string>
  warnings_of_run(const std::vector<std::string> &,
                  const SlidingRun<3> &,
                  const SceneParameters &);



  namespace
  {
    /** A patch has none. */
    template <int dim>
    void
    run_with_fields(SlidingRun<dim>       &run,
                    const Scene<dim>      &scene,
                    const SceneParameters &parameters,
                    const std::string     &field_file)
    {
      if constexpr (dim == 2)
        if (!field_file.empty() && !parameters.output.field_times.empty())
          {
            FieldRecorder recorder(parameters, scene);
            run.run([&](const SlidingRun<2> &now) { recorder.step(now); });
            recorder.fields().write(field_file);
            return;
          }
      run.run([](const SlidingRun<dim> &) {});
    }



    template <int dim>
    SceneResult
    compute(SceneParameters   &parameters,
            const Ranks       &ranks,
            const std::string &field_file)
    {
      const AuditedScene<dim> audited(parameters, ranks);
      SlidingRun<dim>         run(parameters, *audited.scene);
      run_with_fields(run, *audited.scene, parameters, field_file);

      SceneResult result;
      result.friction      = run.friction();
      result.status        = run.judgement().status;
      result.over_distance = means_over_distance(run.state().rows, 0.1e-6);
      result.last          = run.state().rows.back();
      result.lubricant     = name(parameters.lubrication.model);
      result.mechanisms    = mechanisms_of(parameters);
      result.is_steady =
        parameters.protocol.window == FrictionWindow::time || run.is_steady();
      result.steps             = run.state().step;
      result.newton_iterations = run.newton_statistics().iterations;
      result.unknowns          = run.mean_unknowns();
      result.warnings =
        warnings_of_run(audited.audit.warnings, run, parameters);
      if (result.friction.T_y != 0.)
        result.oil_load_share = result.friction.oil_pressure *
                                audited.scene->length /
                                std::abs(result.friction.T_y);
      return result;
    }
  } // namespace



  SceneResult
  compute_scene(SceneParameters   &parameters,
                const Ranks       &ranks,
                const std::string &field_file)
  {
    return parameters.geometry.dimension == 3 ?
             compute<3>(parameters, ranks, field_file) :
             compute<2>(parameters, ranks, field_file);
  }
} // namespace asperity
