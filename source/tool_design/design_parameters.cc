#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/base/text.h>
#include <asperity/campaign/run_record.h>
#include <asperity/learning/decoder_parameters.h>
#include <asperity/tool_design/design_parameters.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    const std::vector<std::pair<std::string, double RunRecord::*>> all_results =
      {{"mu", &RunRecord::mu},
       {"mu_end", &RunRecord::mu_end},
       {"spread", &RunRecord::spread},
       {"contact_fraction", &RunRecord::contact_fraction},
       {"max_contact_pressure", &RunRecord::max_contact_pressure},
       {"oil_pressure", &RunRecord::oil_pressure},
       {"oil_load_share", &RunRecord::oil_load_share},
       {"max_plastic_strain", &RunRecord::max_plastic_strain},
       {"max_temperature", &RunRecord::max_temperature}};
  }



  void
  ToolDesignParameters::declare_scene(ParameterDeclarator &parameters)
  {
    {
      const auto section = parameters.subsection("Scene");
      parameters.file("Base scene",
                      base_scene,
                      "The scene whose tool is to be improved: each evaluation "
                      "is a run of it with another profile of the same period "
                      "and root mean square height.");
      parameters.file("Check scene",
                      check_scene,
                      "A scene with a finer mesh and smaller steps, in which "
                      "the tools of both are computed again at the end; empty: "
                      "none.");
    }
    const auto section = parameters.subsection("Objective");
    parameters.text("Results",
                    results,
                    "Results of a run that are to become small, separated by "
                    "commas: mu, mu_end, spread, contact_fraction, "
                    "max_contact_pressure (at the end), oil_pressure, "
                    "oil_load_share, max_plastic_strain, max_temperature.");
    parameters.list("Weights",
                    weights,
                    "1",
                    Range::any(),
                    "Of each result as a multiple of what the base scene has; "
                    "negative for what is to become large. The objective is "
                    "their sum over that of the absolute weights.");
    parameters.file("Friction law",
                    friction_law,
                    "A trained law whose least value is searched over its "
                    "inputs, in place of a tool by runs; then there is no base "
                    "scene, and textures and networks are not used.");
    parameters.text("Fixed inputs",
                    fixed_inputs,
                    "Inputs of that law that are not varied, separated by "
                    "commas: T = 25 degC, Lubrication/Wetting = 0.5.");
  }



  void
  ToolDesignParameters::declare_search(ParameterDeclarator &parameters)
  {
    const auto section = parameters.subsection("Search");
    parameters.choice("Space",
                      space,
                      {{"latent", DesignSpace::latent},
                       {"modes", DesignSpace::modes},
                       {"free form", DesignSpace::free_form}},
                      "What the variables are: latent codes of a network that "
                      "has learnt textures, coefficients of their first modes, "
                      "or moves of control points around the base profile.");
    parameters.choice("Methods",
                      methods,
                      {{"DIRECT", Methods::direct},
                       {"genetic", Methods::genetic},
                       {"both", Methods::both}},
                      "By division of rectangles, by a genetic algorithm, or "
                      "both one after the other.");
    parameters.integer("Evaluations of DIRECT",
                       n_evaluations,
                       Range::between(3, 100000),
                       "Runs at most.");
    parameters.integer("Genetic evaluations",
                       n_genetic,
                       Range::between(4, 100000),
                       "Runs at most.");
    parameters.integer("Population per variable",
                       genetic.population_per_variable,
                       Range::between(2, 1000),
                       "Size of the genetic algorithm's population over the "
                       "number of variables.");
    parameters.integer("Columns",
                       n_columns,
                       Range::between(4, 100),
                       "Control points of a row of the free-form deformation, "
                       "which has two rows.");
    parameters.number("Largest move",
                      largest_move,
                      Range::positive(),
                      "How far these control points move, in multiples of the "
                      "base profile's root mean square height.");
    parameters.integer("Seed",
                       seed,
                       Range::between(0, 1000000000),
                       "Of all random numbers.");
  }



  void
  ToolDesignParameters::declare_textures(ParameterDeclarator &parameters)
  {
    const auto section = parameters.subsection("Textures");
    parameters.integer("Textures of each kind",
                       family.n_per_kind,
                       Range::between(1, 10000),
                       "Grooves, dimples, ridges and waves each that the "
                       "network learns.");
    parameters.integer("Measured profiles",
                       family.n_measured,
                       Range::between(0, 10000),
                       "Pieces of the base tool's map that it learns, if that "
                       "is measured.");
    parameters.integer("Held out of each kind",
                       family.n_held_out,
                       Range::between(0, 1000),
                       "Further ones that are not trained with, by which it is "
                       "judged.");
    parameters.integer(
      "Most repeats",
      family.most_repeats,
      Range::between(1, 100),
      "Grooves, dimples, ridges or waves of a period at most.");
    parameters.quantity("S-filter nesting index",
                        shortest_wave,
                        "um",
                        Range::positive(),
                        "Cutoff of the Gaussian filter of grooves and the "
                        "like, which leaves no waves below a third of it; "
                        "automatic: that of the measured base tool, or the "
                        "shortest wave of harmonics.");
    parameters.integer("Places",
                       family.n_places,
                       Range::between(32, 4096),
                       "Heights of a period.");
  }



  void
  ToolDesignParameters::declare_network(ParameterDeclarator &parameters)
  {
    const auto section = parameters.subsection("Network");
    declare_size(parameters, training.network, "a texture, also by modes");
    parameters.integer("Epochs",
                       training.options.n_epochs,
                       Range::between(1, 1000000),
                       "Passes over all textures.");
    parameters.number("Code regularisation",
                      training.options.code_regularization,
                      Range::non_negative(),
                      "Factor of the mean length of codes in the loss.");
  }



  void
  ToolDesignParameters::declare(ParameterDeclarator &parameters)
  {
    declare_scene(parameters);
    declare_search(parameters);
    declare_textures(parameters);
    declare_network(parameters);
    const auto section = parameters.subsection("Output");
    parameters.text("Output directory",
                    directory,
                    "Folder of evaluations, runs, the best profile and its "
                    "scene.");
  }



  void
  ToolDesignParameters::check_goals(const ParameterDeclarator &parameters)
  {
    goals_.clear();
    const std::vector<std::string> names = split(results, ',');
    if (names.empty() || names.size() != weights.size())
      throw InputError(parameters.where("Objective/Weights") + ": found " +
                       std::to_string(weights.size()) + " weights for " +
                       std::to_string(names.size()) +
                       " results; expected one for each.");
    double sum = 0.;
    for (const double weight : weights)
      sum += std::abs(weight);
    if (sum == 0.)
      throw InputError(parameters.where("Objective/Weights") +
                       ": all are zero; expected one that is not.");
    for (std::size_t i = 0; i < names.size(); ++i)
      {
        const auto result =
          std::find_if(all_results.begin(),
                       all_results.end(),
                       [&](const auto &r) { return r.first == names[i]; });
        if (result == all_results.end())
          {
            std::vector<std::string> known;
            for (const auto &[name, value] : all_results)
              known.push_back(name);
            throw InputError(parameters.where("Objective/Results") +
                             ": found " + quoted_text(names[i]) +
                             "; expected some of " + join(known, ", ") + ".");
          }
        goals_.push_back({names[i], result->second, weights[i] / sum});
      }
  }



  void
  ToolDesignParameters::check(const ParameterDeclarator &parameters)
  {
    if (base_scene.empty() == friction_law.empty())
      throw InputError(parameters.where("Scene/Base scene") + ": expected " +
                       (base_scene.empty() ?
                          "a scene, or a law at Objective/Friction law." :
                          "either a scene or a law at Objective/Friction law, "
                          "not both."));
    if (!friction_law.empty() && results != "mu")
      throw InputError(parameters.where("Objective/Results") + ": found " +
                       quoted_text(results) +
                       "; expected mu, which is what a friction law says.");
    check_goals(parameters);
    by_direct                         = methods != Methods::genetic;
    genetically                       = methods != Methods::direct;
    direct.max_evaluations            = n_evaluations;
    genetic.max_evaluations           = n_genetic;
    genetic.seed                      = seed;
    family.seed                       = seed;
    training.options.seed             = seed;
    const unsigned int epochs         = training.options.n_epochs;
    training.options.weights.interval = std::max(1u, epochs / 5);
    training.options.codes.interval   = std::max(1u, epochs / 5);
  }
} // namespace asperity
