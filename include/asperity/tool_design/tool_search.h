#ifndef asperity_tool_design_tool_search_h
#define asperity_tool_design_tool_search_h

#include <asperity/tool_design/design_objective.h>

#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  /** What one method has found. */
  struct FoundTool
  {
    std::string         method; ///< "DIRECT", "genetic"
    SearchResult        search;
    std::vector<double> heights; ///< as of a ToolTexture
    RunRecord           run;

    /** In the check scene, if there is one. */
    std::optional<RunRecord> check;
  };

  /** All that a search ends with. */
  struct DesignResults
  {
    std::string                space; ///< for people
    std::vector<TextureErrors> errors;
    RunRecord                  base;
    std::optional<RunRecord>   base_check;
    std::vector<FoundTool>     found;
  };

  /** The search of a parameter file, step by step. */
  class ToolSearch
  {
  public:
    /** Reads the scenes; writes nothing. @throws InputError if one is wrong */
    explicit ToolSearch(const ToolDesignParameters &parameters);

    /**
     * Makes sure that what the folder holds is of these scenes.
     * @param where the entry that names it
     * @throws InputError if it is not
     */
    void
    claim_folder(const std::string &where) const;

    /** Textures, network, base run, searches, check. */
    void
    run();

    const DesignResults &
    results() const
    {
      return results_;
    }

    const ToolExchange &
    tool() const
    {
      return *tool_;
    }

  private:
    void
    make_space();

    /** The run with a texture, or of the scene as it is, which is kept in a
     *  file. */
    RunRecord
    run_once(const std::string         &scene,
             const std::vector<double> *heights,
             const std::string         &name) const;

    /** All that the values of evaluations depend on besides the scenes. */
    std::string
    description(const std::string &method) const;

    FoundTool
    search(const std::string &method, const DesignObjective &objective) const;

    ToolDesignParameters          parameters;
    SceneParameters               scene;
    std::string                   scenes; ///< check sums
    std::unique_ptr<ToolExchange> tool_;
    std::unique_ptr<TextureSpace> space;
    DesignResults                 results_;
  };

  /** A parameter file of each tool that was found, profiles as tables,
   *  textures.csv and summary.json. */
  void
  write_tools(const ToolSearch &search, const ToolDesignParameters &parameters);

  /** A page for people. */
  void
  print_tools(const ToolSearch           &search,
              const ToolDesignParameters &parameters,
              std::ostream               &out);
} // namespace asperity

#endif
