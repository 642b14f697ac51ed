#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/lubricant/enclosed_oil.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** Two or three suffice where a solution exists. */
    constexpr unsigned int most_passes = 20;

    /** The law of a pocket; nothing if there is no pressure at this volume.
     *  @param reference_volume V_r, in the unit of V
     *  @param multiplier of the incompressible law [Pa] */
    std::optional<PocketPressure>
    pocket_pressure(const SealedPocketOptions &options,
                    const double               reference_volume,
                    const double               volume,
                    const double               multiplier)
    {
      // of the oil at p = 0
      const double V_0 = reference_volume / options.density.ambient_ratio;
      if (V_0 == 0.)
        return PocketPressure();
      if (volume <= 0.)
        return std::nullopt;
      if (options.density.law == DensityLaw::incompressible)
        {
          const double p =
            multiplier + options.penalty_modulus * (1. - volume / V_0);
          if (p <= 0.)
            return PocketPressure();
          return PocketPressure{p, options.penalty_modulus / V_0};
        }
      if (volume >= V_0)
        return PocketPressure();
      const double ratio = reference_volume / volume;
      const double p     = options.density.pressure(ratio);
      if (!std::isfinite(p))
        return std::nullopt;
      const double stiffness = ratio / volume / options.density.derivative(p);
      if (!std::isfinite(stiffness))
        return std::nullopt;
      return PocketPressure{p, stiffness};
    }
  } // namespace



  EnclosedOil::EnclosedOil(const SealedPocketOptions &options)
    : options(options)
  {}



  std::vector<double>
  EnclosedOil::oil_at_start(const double extent) const
  {
    double void_at_start = 0.;
    for (const Enclosure &pocket : pockets)
      void_at_start += pocket.volume;
    double wetting = options.wetting;
    if (options.oil_film)
      {
        if (!(void_at_start > 0.))
          throw InputError(
            "Lubrication/Sealing gap: found " +
            format_quantity(options.sealing_gap, "nm") +
            ", and the surfaces are nowhere further apart at the start, so "
            "that no pocket takes the oil; expected less.");
        wetting = *options.oil_film * extent / void_at_start;
      }
    std::vector<double> oil;
    for (const Enclosure &pocket : pockets)
      oil.push_back(wetting * pocket.volume);
    return oil;
  }



  bool
  EnclosedOil::set_pressure(Enclosure &pocket) const
  {
    const auto oil = pocket_pressure(options,
                                     pocket.reference_volume,
                                     pocket.volume,
                                     pocket.multiplier);
    pocket.oil     = oil.value_or(PocketPressure());
    return oil.has_value();
  }



  std::vector<RankOneTerm>
  EnclosedOil::rank_one_terms() const
  {
    std::vector<RankOneTerm> terms;
    for (const Enclosure &pocket : pockets)
      if (pocket.oil.stiffness > 0.)
        terms.push_back({pocket.gradient, pocket.oil.stiffness});
    return terms;
  }



  Lubricant::Exchange
  EnclosedOil::exchange(const dealii::Vector<double> &)
  {
    if (options.density.law != DensityLaw::incompressible)
      return Exchange::converged;
    if (++n_passes_ > most_passes)
      return Exchange::failed;
    Exchange result = Exchange::converged;
    for (Enclosure &pocket : pockets)
      if (std::abs(pocket.oil.pressure - pocket.multiplier) >
          options.volume_tolerance * options.penalty_modulus)
        {
          pocket.multiplier = pocket.oil.pressure;
          result            = Exchange::repeat;
        }
    return result;
  }



  std::string
  EnclosedOil::reason() const
  {
    return n_passes_ > most_passes ?
             "the volume of the incompressible oil was not met" :
             "";
  }



  void
  EnclosedOil::set_oil(const LubricantParameters &oil)
  {
    options.density = oil.compressibility;
  }



  void
  EnclosedOil::begin_passes(const unsigned int step)
  {
    step_     = step;
    n_passes_ = 0;
  }



  void
  EnclosedOil::accept_pressures()
  {
    accepted_pressures.clear();
    for (const Enclosure &pocket : pockets)
      accepted_pressures.push_back(pocket.oil.pressure);
  }



  LubricantState
  EnclosedOil::sum_of_pockets() const
  {
    LubricantState state;
    for (const Enclosure &pocket : pockets)
      {
        const double p     = pocket.oil.pressure;
        state.max_pressure = std::max(state.max_pressure, p);
        state.void_volume += pocket.volume;
        state.reference_volume += pocket.reference_volume;
        state.oil_volume += pocket.reference_volume / options.density.ratio(p);
      }
    state.n_pockets = pockets.size();
    return state;
  }



  double
  EnclosedOil::pressure(const dealii::Point<2> &parameter) const
  {
    const Enclosure *pocket = enclosure_at(parameter);
    return pocket != nullptr ? pocket->oil.pressure : 0.;
  }



  double
  EnclosedOil::coverage(const dealii::Point<2> &parameter) const
  {
    const Enclosure *pocket = enclosure_at(parameter);
    if (pocket == nullptr || pocket->reference_volume == 0.)
      return 0.;
    const double oil =
      pocket->reference_volume / options.density.ratio(pocket->oil.pressure);
    return oil < pocket->volume ? oil / pocket->volume : 1.;
  }



  std::vector<std::string>
  EnclosedOil::events() const
  {
    return events_;
  }
} // namespace asperity
