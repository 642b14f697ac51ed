#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/contact_zone/surface.h>
#include <asperity/tool_design/design_objective.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asperity
{
  ToolExchange::ToolExchange(const SceneParameters &scene,
                             const std::size_t      n_places,
                             const unsigned int     n_waves)
    : n_waves(n_waves)
  {
    const std::vector<double> heights = tool_heights(scene, n_places);
    base_                             = normalized(heights);
    rms_ =
      std::inner_product(heights.begin(), heights.end(), base_.begin(), 0.) /
      n_places;
    period_ = make_surface(scene.tool, scene.geometry.length).period;
  }



  EntryValues
  ToolExchange::entries(const std::vector<double> &heights) const
  {
    Harmonics                waves  = harmonics_of(heights, n_waves);
    const double             factor = rms_ / waves.rms();
    std::vector<std::string> numbers, amplitudes, phases;
    for (unsigned int k = 0; k < n_waves; ++k)
      {
        numbers.push_back(std::to_string(k + 1));
        amplitudes.push_back(
          format_quantity(factor * waves.amplitudes[k], "um"));
        // The tool is above the chip: its heights point downwards.
        phases.push_back(format_quantity(waves.phases[k] + M_PI, "rad"));
      }
    return {{"Geometry/Period", format_quantity(period_, "um")},
            {"Tool/Kind", "harmonics"},
            {"Tool/Wave numbers", join(numbers, ", ")},
            {"Tool/Amplitudes", join(amplitudes, ", ")},
            {"Tool/Phases", join(phases, ", ")},
            {"Tool/Spline spans", "automatic"},
            {"Tool/Topography/Scale z", "1"}};
  }



  DesignObjective::DesignObjective(const std::vector<DesignGoal> &goals,
                                   const RunRecord               &base)
    : goals(goals)
    , base(base)
  {
    if (!base.done || !base.no_result.empty())
      throw ComputationError("The base scene has no friction coefficient: " +
                             (base.done ? base.no_result + "." : base.reason));
    for (const DesignGoal &goal : goals)
      if (base.*goal.value == 0.)
        throw ComputationError("The result " + quoted_name(goal.name) +
                               " of the base scene is zero, so that others "
                               "cannot be measured by it.");
  }



  Evaluation
  DesignObjective::evaluate(const RunRecord &run) const
  {
    Evaluation result;
    if (!run.done)
      result.failure = run.reason;
    else if (!run.no_result.empty())
      result.failure = "The run has no friction coefficient: " + run.no_result;
    else
      {
        result.value = 0.;
        for (const DesignGoal &goal : goals)
          result.value += goal.weight * (run.*goal.value) / (base.*goal.value);
      }
    return result;
  }



  DesignRuns::DesignRuns(const std::string     &base_scene,
                         const ToolExchange    &tool,
                         const TextureSpace    &space,
                         const DesignObjective &objective,
                         const std::string     &folder,
                         const std::string     &description)
    : base_scene(base_scene)
    , tool(tool)
    , space(space)
    , objective(objective)
    , folder(folder)
    , record_(space.box(), folder + "/evaluations.csv", description)
  {}



  RunOrder
  DesignRuns::order(const std::size_t          number,
                    const std::vector<double> &variables) const
  {
    RunOrder result;
    result.id      = number;
    result.changes = tool.entries(space.heights(variables));
    return result;
  }



  std::string
  DesignRuns::path_of(const RunOrder &order) const
  {
    return folder + "/runs/" + order.name(1) + ".json";
  }



  Evaluation
  DesignRuns::evaluate(const std::vector<double> &variables)
  {
    const RunOrder order = this->order(record_.entries().size() + 1, variables);
    const RunRecord run  = execute(base_scene, order);
    write_record(path_of(order), order, run);
    return objective.evaluate(run);
  }



  RunRecord
  DesignRuns::run_of(const std::vector<double> &variables) const
  {
    const auto    &entries = record_.entries();
    const auto     entry   = std::find_if(entries.begin(),
                                    entries.end(),
                                    [&](const EvaluationRecord::Entry &e) {
                                      return e.point == variables;
                                    });
    const RunOrder order = this->order(entry - entries.begin() + 1, variables);
    const auto     run   = read_record(path_of(order), order);
    if (!run)
      throw ComputationError("The run " + quoted_name(path_of(order)) +
                             " is missing.");
    return *run;
  }
} // namespace asperity
