#include <asperity/base/parameters.h>
#include <asperity/constitutive/material_parameters.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace asperity
{
  namespace
  {
    /** Calls the action with the constants of each law, in order. */
    template <class Laws, class Action>
    void
    for_each_law(Laws &&laws, const Action &action)
    {
      std::apply([&](auto &...constants) { (action(constants), ...); }, laws);
    }
  } // namespace



  void
  MaterialParameters::declare(ParameterDeclarator &parameters)
  {
    const auto section = parameters.subsection("Material");
    std::vector<std::pair<std::string, Place>> choices;
    std::string                                descriptions;
    for_each_law(laws, [&](const auto &constants) {
      descriptions += (choices.empty() ? "" : "; ") +
                      std::string(constants.name) + ": " +
                      constants.description;
      choices.emplace_back(constants.name, Place(choices.size()));
    });
    parameters.choice("Law",
                      chosen,
                      choices,
                      "The material law. " + descriptions + ".");
    elasticity.declare(parameters);
    heating.declare(parameters);
    for_each_law(laws, [&](auto &constants) { constants.declare(parameters); });
  }



  void
  MaterialParameters::check(const ParameterDeclarator &parameters) const
  {
    for_each_law(laws, [&](const auto &constants) {
      if (place<std::decay_t<decltype(constants)>>() == chosen)
        constants.check(parameters);
    });
  }



  std::optional<Softening>
  MaterialParameters::softening() const
  {
    return make_law()->softening();
  }



  std::string
  MaterialParameters::melting_entry() const
  {
    return "Material/" + make_law()->name() + "/Melting temperature";
  }



  std::vector<std::string>
  MaterialParameters::law_names()
  {
    std::vector<std::string> names;
    for_each_law(MaterialLaws(), [&](const auto &constants) {
      names.emplace_back(constants.name);
    });
    return names;
  }



  bool
  MaterialParameters::heats_itself() const
  {
    const bool yields = std::isfinite(make_law()->shear_limit(0., 0., 0.));
    return yields && heating.adiabatic && heating.heat_fraction > 0.;
  }



  std::unique_ptr<MaterialLaw>
  MaterialParameters::make_law() const
  {
    std::unique_ptr<MaterialLaw> law;
    for_each_law(laws, [&](const auto &constants) {
      if (place<std::decay_t<decltype(constants)>>() == chosen)
        law = constants.make_law(elasticity, heating);
    });
    return law;
  }
} // namespace asperity
