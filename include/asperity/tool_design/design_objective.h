#ifndef asperity_tool_design_design_objective_h
#define asperity_tool_design_design_objective_h

#include <asperity/campaign/run_record.h>
#include <asperity/optimization/evaluation_record.h>
#include <asperity/tool_design/design_parameters.h>
#include <asperity/tool_design/texture_space.h>

#include <string>
#include <vector>

namespace asperity
{
  /** The tool of a scene, and what takes its place: textures of its period and
   *  root mean square height. */
  class ToolExchange
  {
  public:
    /** @param n_places heights of a period @param n_waves that textures have
     *  @throws InputError if the scene's tool is flat or a patch */
    ToolExchange(const SceneParameters &scene,
                 const std::size_t      n_places,
                 const unsigned int     n_waves);

    /** The scene's own tool, as of a ToolTexture. */
    const std::vector<double> &
    base() const
    {
      return base_;
    }

    double
    period() const
    {
      return period_;
    }

    /** Rq [m] */
    double
    rms() const
    {
      return rms_;
    }

    /** Entries that give the scene a tool of harmonics with this texture.
     *  @param heights as of a ToolTexture, out of the tool */
    EntryValues
    entries(const std::vector<double> &heights) const;

  private:
    unsigned int        n_waves;
    double              period_ = 0., rms_ = 0.;
    std::vector<double> base_;
  };

  /** What a run is worth: the weighted sum of its results over those of the
   *  base scene. */
  class DesignObjective
  {
  public:
    /** @param base run of the base scene
     *  @throws ComputationError if it failed, or a result of it that counts is
     *    zero */
    DesignObjective(const std::vector<DesignGoal> &goals,
                    const RunRecord               &base);

    /** A failure if the run has no friction coefficient. */
    Evaluation
    evaluate(const RunRecord &run) const;

  private:
    std::vector<DesignGoal> goals;
    RunRecord               base;
  };

  /** All runs of a search in a space of textures, which are kept in a folder.
   */
  class DesignRuns
  {
  public:
    /** @param folder of evaluations.csv and the runs
     *  @throws InputError if it holds another search */
    DesignRuns(const std::string     &base_scene,
               const ToolExchange    &tool,
               const TextureSpace    &space,
               const DesignObjective &objective,
               const std::string     &folder,
               const std::string     &description);

    /** For a search: a run at a point that is not in the record. */
    Evaluation
    evaluate(const std::vector<double> &variables);

    EvaluationRecord &
    record()
    {
      return record_;
    }

    /** The run of a point that has been evaluated.
     *  @throws ComputationError if its file is gone */
    RunRecord
    run_of(const std::vector<double> &variables) const;

  private:
    RunOrder
    order(const std::size_t number, const std::vector<double> &variables) const;

    std::string
    path_of(const RunOrder &order) const;

    std::string            base_scene;
    const ToolExchange    &tool;
    const TextureSpace    &space;
    const DesignObjective &objective;
    std::string            folder;
    EvaluationRecord       record_;
  };
} // namespace asperity

#endif
