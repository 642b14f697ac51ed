#ifndef asperity_tool_design_design_parameters_h
#define asperity_tool_design_design_parameters_h

#include <asperity/optimization/direct.h>
#include <asperity/optimization/genetic.h>
#include <asperity/tool_design/texture_family.h>
#include <asperity/tool_design/train_textures.h>

#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  class ParameterDeclarator;
  struct RunRecord;

  /** Which profiles a search sees. */
  enum class DesignSpace
  {
    latent,   ///< LatentTextures
    modes,    ///< ModalTextures
    free_form ///< FreeFormTextures
  };

  /** A result of a run that counts, and how much. */
  struct DesignGoal
  {
    std::string name;
    double RunRecord::*value;
    double             weight;
  };

  /** A parameter file of `asperity optimize`: what is searched, by which runs,
   *  and how. */
  struct ToolDesignParameters
  {
    std::string base_scene;
    std::string check_scene; ///< or empty

    /** A law that is searched instead of a tool, or empty; and its inputs that
     *  are not varied, "T = 25 degC, Wetting = 0.5". */
    std::string friction_law, fixed_inputs;

    std::string         results = "mu";
    std::vector<double> weights = {1.};

    DesignSpace  space        = DesignSpace::latent;
    unsigned int n_columns    = 4;
    double       largest_move = 2.;

    bool           by_direct = true, genetically = true;
    DirectOptions  direct;
    GeneticOptions genetic;

    /** Nesting index of the filter of textures [m]; automatic: see
     *  filter_of(). */
    std::optional<double> shortest_wave;

    TextureFamily   family;
    TextureTraining training;

    std::string directory = "output/tool_design";

    /** Declares all entries. */
    void
    declare(ParameterDeclarator &parameters);

    /** @throws InputError if entries contradict each other */
    void
    check(const ParameterDeclarator &parameters);

    /** As check() has found them. */
    const std::vector<DesignGoal> &
    goals() const
    {
      return goals_;
    }

  private:
    enum class Methods
    {
      direct,
      genetic,
      both
    };

    void
    declare_scene(ParameterDeclarator &parameters);

    void
    declare_search(ParameterDeclarator &parameters);

    void
    declare_textures(ParameterDeclarator &parameters);

    void
    declare_network(ParameterDeclarator &parameters);

    void
    check_goals(const ParameterDeclarator &parameters);

    Methods                 methods       = Methods::both;
    unsigned int            seed          = 1;
    unsigned int            n_evaluations = 150, n_genetic = 500;
    std::vector<DesignGoal> goals_;
  };
} // namespace asperity

#endif
