#include "lubricant_audit.h"

#include <asperity/contact_zone/load_protocol.h>

namespace asperity
{
  namespace
  {
    /** The rung that the numbers ask for. In a void that is not full, oil has
     *  to leave the gaps that close, and one pressure of a whole pocket knows
     *  nothing of the films that hold them open until it has
     *  (tools/benchmarks/README.md, "Thin oil"). */
    LubricantModel
    choose_lubricant(const double wetting,
                     const double flow_pressure,
                     const double squeeze_pressure)
    {
      if (wetting == 0.)
        return LubricantModel::none;
      const bool yields = wetting == 1. || squeeze_pressure < 0.001;
      return yields && flow_pressure < 0.01 ? LubricantModel::pocket :
                                              LubricantModel::reynolds;
    }

    /** Temperature from which mineral oil decomposes thermally within minutes
     *  (J. G. Speight, The Chemistry and Technology of Petroleum, 2014) [K]. */
    constexpr double cracking = 623.15;

    /** @param amount what is to be said of how much oil there is, or empty
     *  @param T of the oil [K] */
    void
    warn_of_oil(const std::string         &amount,
                const LubricantParameters &oil,
                const double               T,
                SceneAudit                &audit)
    {
      if (!amount.empty())
        audit.warnings.push_back(amount);
      if (oil.temperature.law != TemperatureLaw::none && T > cracking)
        audit.warnings.push_back(
          "The oil is as hot as " + format_quantity(T, "degC", 4) +
          ", where mineral oil cracks (from about " +
          format_quantity(cracking, "degC") +
          " on): its viscosity and density are extrapolations.");
    }

    /** A patch has no film: it is taken as a pocket, and told. */
    void
    enclose_film(const double flow_pressure,
                 const double squeeze_pressure,
                 SceneAudit  &audit)
    {
      if (audit.lubricant != LubricantModel::reynolds)
        return;
      audit.lubricant = LubricantModel::pocket;
      audit.warnings.push_back(
        "The oil would flow as a film in two dimensions (" +
        format_quantity(flow_pressure, "1", 2) + " of the load by sliding, " +
        format_quantity(squeeze_pressure, "1", 2) +
        " by squeezing); in three it is enclosed, with one pressure a pocket.");
    }
  } // namespace



  void
  audit_lubricant(const SceneParameters &parameters,
                  const OilInGap        &in_gap,
                  const double           mean_gap,
                  const double           asperity,
                  SceneAudit            &audit)
  {
    const LubricationParameters &lubrication = parameters.lubrication;
    audit.lubricant                          = lubrication.model;
    if (lubrication.model == LubricantModel::none)
      return;
    const double              T   = parameters.load.temperature;
    const LubricantParameters oil = lubrication.oil.at(T, T);
    const double p = parameters.load.pressure, v = parameters.load.velocity,
                 eta = oil.viscosity.viscosity, h = mean_gap;

    audit.entries.push_back(
      {"oil over the void at first touch",
       in_gap.part_at_touch,
       "above 1 the gap is flooded: the oil is compressed before the "
       "surfaces touch"});
    warn_of_oil(in_gap.warning, oil, T, audit);
    audit.entries.push_back(
      {"compression of the oil at the load",
       1. - 1. / oil.compressibility.ratio(p),
       "how far the void must shrink until full pockets carry the load; "
       "above 0.01 an incompressible oil is too stiff a model"});
    const double flow_pressure = 12. * eta * v * asperity / (h * h * p);
    audit.entries.push_back(
      {"pressure differences by flow over the load",
       flow_pressure,
       "below 0.01 sliding leaves one pressure to the oil; else the film's "
       "own pressure counts"});
    const double ramp_time =
      LoadProtocol(parameters.load, parameters.protocol).ramp_time();
    const double squeeze_pressure =
      12. * eta * asperity * asperity / (h * h * ramp_time * p);
    audit.entries.push_back(
      {"squeeze pressure in closing gaps over the load",
       squeeze_pressure,
       "in a void that is not full; below 0.001 the oil gives way before "
       "the asperities touch; else it holds them apart"});
    audit.entries.push_back({"viscous shear over the load",
                             eta * v / (h * p),
                             "what the oil itself adds to mu"});
    audit.entries.push_back(
      {"reduced Reynolds number of the film",
       oil.density * v * h / eta * h / asperity,
       "far below 1 the oil has no inertia: Reynolds or Stokes"});
    if (lubrication.model == LubricantModel::automatic)
      audit.lubricant =
        choose_lubricant(in_gap.part_at_start, flow_pressure, squeeze_pressure);
    if (parameters.geometry.dimension == 3 &&
        lubrication.model == LubricantModel::automatic)
      enclose_film(flow_pressure, squeeze_pressure, audit);
    // Only its mass holds a chip whose balance and flow are solved in turn.
    if (fills_gap(audit.lubricant))
      audit.inertia = Inertia::dynamic;
  }
} // namespace asperity
