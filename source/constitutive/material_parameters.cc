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
    for_each_law(Laws &laws, const Action &action)
    {
      std::apply([&](auto &...constants) { (action(constants), ...); }, laws);
    }
  } // namespace



  void
  MaterialParameters::declare(ParameterDeclarator &parameters)
  {
    const auto section = parameters.subsection("Material");
    std::vector<std::pair<std::string, Place>> choices;
    for_each_law(laws, [&](const auto &constants) {
      choices.emplace_back(constants.name, Place(choices.size()));
    });
    parameters.choice(
      "Law",
      chosen,
      choices,
      "The material law: finite-strain J2 plasticity with the flow stress of "
      "Johnson and Cook or that of Voce (linear and saturating hardening); or "
      "elasticity after Hencky, neo-Hooke or St. Venant-Kirchhoff.");
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



  std::optional<double>
  MaterialParameters::softest_temperature(const double strength) const
  {
    return make_law()->softest_temperature(strength);
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
