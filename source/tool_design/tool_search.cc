#include <asperity/base/errors.h>
#include <asperity/base/md5.h>
#include <asperity/base/progress.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/contact_zone/scene_input.h>
#include <asperity/contact_zone/surface.h>
#include <asperity/postprocess/summary.h>
#include <asperity/tool_design/tool_search.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <limits>

namespace asperity
{
  namespace
  {
    /** Of all that a scene is computed from. */
    std::string
    check_sum(const SceneInput &input)
    {
      std::string text;
      for (const RecordedEntry &entry : input.record.entries)
        if (entry.path.rfind("Output/", 0) != 0)
          text += entry.path + "=" +
                  (entry.is_file ? entry.content : entry.value) + "\n";
      return md5(text);
    }
  } // namespace



  ToolSearch::ToolSearch(const ToolDesignParameters &given)
    : parameters(given)
  {
    const SceneInput base(given.base_scene);
    scene  = base.parameters;
    scenes = check_sum(base);
    if (!parameters.check_scene.empty())
      scenes += " " + check_sum(SceneInput(parameters.check_scene));
    const double period =
      make_surface(scene.tool, scene.geometry.length).period;
    parameters.family.shortest_wave =
      (parameters.shortest_wave ? *parameters.shortest_wave :
                                  filter_of(scene.tool, period)) /
      period;
    const unsigned int n_waves = parameters.family.n_waves();
    if (4 * n_waves > parameters.family.n_places)
      throw InputError("The profile of the base scene is " +
                       format_quantity(period, "um", 4) + " long and has " +
                       std::to_string(n_waves) +
                       " waves; expected at least four Textures/Places for "
                       "each, " +
                       std::to_string(4 * n_waves) + ".");
    tool_ = std::make_unique<ToolExchange>(scene,
                                           parameters.family.n_places,
                                           n_waves);
  }



  void
  ToolSearch::claim_folder(const std::string &where) const
  {
    const std::string path = parameters.directory + "/scenes.json";
    if (!std::filesystem::exists(path))
      write_summary(path, {{"check_sums", scenes}});
    else if (read_summary(path).value("check_sums", "") != scenes)
      throw InputError(where + ": " + quoted_name(parameters.directory) +
                       " holds a search with another base or check scene; "
                       "expected another folder.");
  }



  void
  ToolSearch::make_space()
  {
    const TextureFamily &family = parameters.family;
    if (parameters.space == DesignSpace::free_form)
      {
        space = std::make_unique<FreeFormTextures>(tool_->base(),
                                                   parameters.n_columns,
                                                   parameters.largest_move);
        return;
      }
    const auto [trained, held_out] = make_textures(family, scene);
    if (parameters.space == DesignSpace::modes)
      {
        space =
          std::make_unique<ModalTextures>(trained,
                                          parameters.training.network.n_code);
        return;
      }
    ProgressLine      progress(std::cout);
    const AutoDecoder network =
      train_textures(trained,
                     family,
                     parameters.training,
                     parameters.directory + "/textures.checkpoint",
                     progress);
    results_.errors = judge_textures(network, trained, held_out, family);
    space           = std::make_unique<LatentTextures>(network,
                                             family.n_places,
                                             family.n_waves());
  }



  RunRecord
  ToolSearch::run_once(const std::string         &scene_file,
                       const std::vector<double> *heights,
                       const std::string         &name) const
  {
    RunOrder order;
    if (heights != nullptr)
      order.changes = tool_->entries(*heights);
    const std::string path = parameters.directory + "/" + name + ".json";
    if (const auto known = read_record(path, order))
      return *known;
    const RunRecord run = execute(scene_file, order);
    write_record(path, order, run);
    return run;
  }



  std::string
  ToolSearch::description(const std::string &method) const
  {
    std::string goals;
    for (const DesignGoal &goal : parameters.goals())
      goals += ", " + format_number(goal.weight) + " " + goal.name;
    return method + ", " + space->description() + ", " +
           std::to_string(parameters.family.n_waves()) + " waves" + goals +
           ", " + parameters.base_scene;
  }



  FoundTool
  ToolSearch::search(const std::string     &method,
                     const DesignObjective &objective) const
  {
    DesignRuns         runs(parameters.base_scene,
                    *tool_,
                    *space,
                    objective,
                    parameters.directory + "/" + method,
                    description(method));
    const bool         is_direct = method == "DIRECT";
    const unsigned int most = is_direct ? parameters.direct.max_evaluations :
                                          parameters.genetic.max_evaluations;
    ProgressLine       progress(std::cout);
    unsigned int       n        = 0;
    double             best     = std::numeric_limits<double>::infinity();
    const Objective    evaluate = [&](const std::vector<double> &variables) {
      const Evaluation evaluation = runs.evaluate(variables);
      ++n;
      if (!evaluation.has_failed())
        best = std::min(best, evaluation.value);
      progress.update(std::min(1., static_cast<double>(n) / most),
                      method + ": run " + std::to_string(n) + " of " +
                        std::to_string(most) + ", best " +
                        format_quantity(best, "1", 4));
      return evaluation;
    };
    FoundTool found;
    found.method = method;
    found.search =
      is_direct ?
        search_by_direct(evaluate, runs.record(), parameters.direct) :
        search_genetically(evaluate, runs.record(), parameters.genetic);
    if (found.search.best.empty())
      throw ComputationError(
        "All " + std::to_string(found.search.n_evaluations) +
        " runs of the search failed, the first because: " +
        runs.record().entries().front().evaluation.failure);
    found.heights = space->heights(found.search.best);
    found.run     = runs.run_of(found.search.best);
    return found;
  }



  void
  ToolSearch::run()
  {
    make_space();
    results_.space = space->description();
    results_.base  = run_once(parameters.base_scene, nullptr, "base");
    const DesignObjective objective(parameters.goals(), results_.base);
    if (parameters.by_direct)
      results_.found.push_back(search("DIRECT", objective));
    if (parameters.genetically)
      results_.found.push_back(search("genetic", objective));
    if (parameters.check_scene.empty())
      return;
    results_.base_check =
      run_once(parameters.check_scene, nullptr, "base_check");
    for (FoundTool &found : results_.found)
      found.check = run_once(parameters.check_scene,
                             &found.heights,
                             found.method + "/best_check");
  }
} // namespace asperity
