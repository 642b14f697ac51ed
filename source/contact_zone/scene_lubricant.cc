#include <asperity/contact_zone/scene.h>
#include <asperity/lubricant/film_term.h>
#include <asperity/lubricant/sealed_pocket.h>
#include <asperity/lubricant/sheet_pockets.h>

#include <algorithm>
#include <array>

namespace asperity
{
  namespace
  {
    /** Tool and chip are as warm at the start. */
    LubricantParameters
    oil_at_start(const SceneParameters &parameters)
    {
      const double T = parameters.load.temperature;
      return parameters.lubrication.oil.at(T, T);
    }

    SealedPocketOptions
    pocket_options(const SceneParameters &parameters, const OilInGap &oil)
    {
      SealedPocketOptions options;
      options.density         = oil_at_start(parameters).compressibility;
      options.wetting         = oil.part_at_start;
      options.oil_film        = oil.film;
      options.sealing_gap     = parameters.lubrication.sealing_gap;
      options.penalty_modulus = 1e6 * parameters.load.pressure;
      return options;
    }
  } // namespace



  template <>
  void
  Scene<2>::build_lubricant(const SceneParameters &parameters)
  {
    const LubricationParameters &lubrication = parameters.lubrication;
    initial_unknowns_.reinit(n_dofs());
    if (lubrication.model == LubricantModel::reynolds)
      build_film(parameters);
    if (fills_gap(lubrication.model))
      build_flow(parameters);
    if (lubrication.model != LubricantModel::pocket)
      return;
    lubricant = std::make_unique<SealedPocket>(*space,
                                               geometry,
                                               tool_surface.curve,
                                               pocket_options(parameters, oil));
  }



  template <>
  double
  Scene<2>::gap_scale(const SceneParameters &parameters) const
  {
    // Gaps are scaled by the tool, the chip, the start: by what is not flat.
    for (const double scale : {tool_surface.maximum() - tool_surface.minimum(),
                               chip_surface.maximum() - chip_surface.minimum(),
                               parameters.geometry.initial_gap})
      if (scale > 1e-9 * length)
        return scale;
    return parameters.lubrication.residual_film;
  }



  template <>
  void
  Scene<2>::build_film(const SceneParameters &parameters)
  {
    const LubricationParameters &lubrication = parameters.lubrication;
    FilmTermOptions              options;
    options.oil            = oil_at_start(parameters);
    options.wetting        = oil.part_at_start;
    options.oil_film       = oil.film;
    options.gap.residual   = lubrication.residual_film;
    options.pressure_scale = parameters.load.pressure;
    options.gap_scale      = gap_scale(parameters);
    auto film              = std::make_unique<FilmTerm>(
      *space, geometry, tool_surface.curve, options, n_dofs());
    n_lubricant_unknowns = film->n_unknowns();
    // The chip starts in touch if the oil leaves that room: a film that had to
    // be squeezed out in the first step would resist as none does.
    const double mean_gap = film->state().void_volume / length;
    initial_unknowns_     = translation(
      0., std::min(oil.initial_gap, (1. - oil.part_at_start) * mean_gap));
    film->initialize(initial_unknowns_);
    lubricant = std::move(film);
  }



  template <>
  void
  Scene<2>::build_flow(const SceneParameters &parameters)
  {
    GapFlowOptions options = parameters.lubrication.gap_flow();
    options.oil            = oil_at_start(parameters);
    auto flow =
      std::make_unique<GapFlow>(*space, geometry, tool_surface.curve, options);
    gap_flow  = flow.get();
    lubricant = std::move(flow);
  }



  template <>
  void
  Scene<3>::build_lubricant(const SceneParameters &parameters)
  {
    initial_unknowns_.reinit(n_dofs());
    if (parameters.lubrication.model != LubricantModel::pocket)
      return;
    // Pockets of a mesh that changes consist of its finest elements.
    std::array<unsigned int, 2> size = {{0, 0}};
    if (parameters.mesh.adaptive_levels > 0)
      size = {
        {parameters.mesh.spans, parameters.mesh.n_spans_across(length, width)}};
    lubricant = std::make_unique<SheetPockets>(*space,
                                               geometry,
                                               tool_surface.sheet,
                                               motion,
                                               pocket_options(parameters, oil),
                                               share_.ranks.is_first(),
                                               size);
  }
} // namespace asperity
