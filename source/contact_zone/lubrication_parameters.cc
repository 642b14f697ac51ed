#include <asperity/base/errors.h>
#include <asperity/contact_zone/lubrication_parameters.h>

namespace asperity
{
  namespace
  {
    const std::vector<std::pair<std::string, LubricantModel>> models = {
      {"automatic", LubricantModel::automatic},
      {"none", LubricantModel::none},
      {"pocket", LubricantModel::pocket},
      {"Reynolds", LubricantModel::reynolds}};
  } // namespace



  std::string
  name(const LubricantModel model)
  {
    for (const auto &entry : models)
      if (entry.second == model)
        return entry.first;
    return "";
  }



  void
  LubricationParameters::declare(ParameterDeclarator &parameters)
  {
    {
      const auto in_section = parameters.subsection("Lubrication");
      parameters.choice("Model",
                        model,
                        models,
                        "What the oil between tool and chip is: `none`, dry "
                        "contact; `pocket`, liquid enclosed in the voids, one "
                        "pressure a pocket, no flow; `Reynolds`, a thin film "
                        "that flows, cavitates and shears; `automatic`, as the "
                        "scene audit says.");
      parameters.number("Wetting",
                        wetting,
                        Range::between(0., 1.),
                        "w, the part of the void between the surfaces that "
                        "holds oil at the start: 0 dry, 1 flooded.");
      parameters.quantity("Sealing gap",
                          sealing_gap,
                          "nm",
                          Range::non_negative(),
                          "Model `pocket`: where the gap is smaller, the "
                          "surfaces seal, and the void on each side is a "
                          "pocket with a pressure of its own; 0: all voids "
                          "are connected and share one pressure.");
      parameters.quantity("Residual film",
                          residual_film,
                          "nm",
                          Range::positive(),
                          "Model `Reynolds`: the thickness of the film where "
                          "the surfaces touch.");
    }
    oil.declare(parameters);
  }



  void
  LubricationParameters::check(const ParameterDeclarator &parameters) const
  {
    if (model == LubricantModel::none || model == LubricantModel::automatic)
      return;
    if (wetting == 0.)
      throw InputError(parameters.where("Lubrication/Wetting") +
                       ": found 0, so that there is no oil; expected a "
                       "positive number, or the model `none`.");
    oil.check();
  }
} // namespace asperity
