#include <asperity/contact_zone/scene_computation.h>
#include <asperity/contact_zone/scene_input.h>

#include <cmath>

namespace asperity
{
  std::vector<std::string>
  warnings_of_run(const std::vector<std::string> &warnings_of_audit,
                  const SlidingRun               &run,
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
    const LubricantModel model = parameters.lubrication.model;
    if ((model == LubricantModel::reynolds || fills_gap(model)) &&
        run.friction().contact_fraction > 0.)
      warnings.push_back(
        "Where tool and chip touch, the oil is taken to be " +
        format_quantity(parameters.lubrication.residual_film, "nm") +
        " thick (Lubrication/Residual film); no model tells this thickness, "
        "and mu depends on it by some per cent: vary it.");
    return warnings;
  }



  SceneResult
  compute_scene(SceneParameters &parameters)
  {
    const AuditedScene audited(parameters);
    SlidingRun         run(parameters, *audited.scene);
    run.run([](const SlidingRun &) {});

    SceneResult result;
    result.friction      = run.friction();
    result.status        = run.judgement().status;
    result.over_distance = means_over_distance(run.state().rows, 0.1e-6);
    result.last          = run.state().rows.back();
    result.lubricant     = name(parameters.lubrication.model);
    result.is_steady =
      parameters.protocol.window == FrictionWindow::time || run.is_steady();
    result.steps             = run.state().step;
    result.newton_iterations = run.newton_statistics().iterations;
    result.warnings = warnings_of_run(audited.audit.warnings, run, parameters);
    if (result.friction.T_y != 0.)
      result.oil_load_share = result.friction.oil_pressure *
                              audited.scene->length /
                              std::abs(result.friction.T_y);
    return result;
  }
} // namespace asperity
