#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/lubricant/sealed_pocket.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  namespace
  {
    /** Two or three suffice where a solution exists. */
    constexpr unsigned int maximal_passes = 20;
  } // namespace

  SealedPocket::SealedPocket(const SplineSpace<2>      &space,
                             const PatchGeometry<2>    &geometry,
                             const SplineCurve         &tool,
                             const SealedPocketOptions &options)
    : options(options)
    , void_volume(space, geometry, tool)
    , length(tool.period()[0])
    , tracker(length)
    , accepted_tracker(length)
  {
    track();
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
        wetting = *options.oil_film * length / void_at_start;
      }
    std::vector<double> oil;
    for (const Enclosure &pocket : pockets)
      oil.push_back(wetting * pocket.volume);
    tracker.set_masses(oil);
    enclose();
    accept(dealii::Vector<double>());
  }



  void
  SealedPocket::track()
  {
    std::vector<PocketExtent> extents(1);
    extents[0].open = extents[0].domain = {0., length};
    if (options.sealing_gap > 0.)
      {
        std::vector<double> parameters, gaps;
        for (unsigned int e = 0; e < void_volume.n_elements(); ++e)
          {
            parameters.push_back(void_volume.parameter(e));
            gaps.push_back(void_volume.gap(e));
          }
        extents = find_pockets(parameters, gaps, length, options.sealing_gap);
      }
    std::vector<double> volumes;
    for (const PocketExtent &extent : extents)
      volumes.push_back(void_volume.volume(
        void_volume.stretch(extent.domain.begin, extent.domain.end)));
    tracker.update(extents, volumes, accepted_pressures);
    enclose();
  }



  void
  SealedPocket::enclose()
  {
    const unsigned int n_dofs = void_volume.n_dofs();
    pockets.clear();
    for (const Pocket &tracked : tracker.pockets())
      {
        Enclosure pocket;
        pocket.stretch = void_volume.stretch(tracked.extent.domain.begin,
                                             tracked.extent.domain.end);
        pocket.reference_volume = tracked.mass;
        pocket.volume           = void_volume.volume(pocket.stretch);
        pocket.gradient.reinit(n_dofs);
        pockets.push_back(pocket);
      }
  }



  void
  SealedPocket::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    void_volume.add_couplings(pattern);
  }



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



  bool
  SealedPocket::set_pressure(Enclosure &pocket) const
  {
    const auto           oil   = pocket_pressure(options,
                                     pocket.reference_volume,
                                     pocket.volume,
                                     pocket.multiplier);
    const PocketPressure found = oil.value_or(PocketPressure());
    pocket.pressure            = found.pressure;
    pocket.stiffness           = found.stiffness;
    return oil.has_value();
  }



  bool
  SealedPocket::add(const Vector                 &u,
                    Vector                       &residual,
                    dealii::SparseMatrix<double> *tangent)
  {
    void_volume.measure(u);
    for (Enclosure &pocket : pockets)
      {
        pocket.volume = void_volume.volume(pocket.stretch);
        if (!set_pressure(pocket))
          return false;
        if (pocket.pressure == 0.)
          continue;
        pocket.gradient = 0.;
        void_volume.add_gradient(pocket.stretch, 1., pocket.gradient);
        residual.add(-pocket.pressure, pocket.gradient);
        if (tangent != nullptr)
          void_volume.add_hessian(pocket.stretch, -pocket.pressure, *tangent);
      }
    return true;
  }



  std::vector<RankOneTerm>
  SealedPocket::rank_one_terms() const
  {
    std::vector<RankOneTerm> terms;
    for (const Enclosure &pocket : pockets)
      if (pocket.stiffness > 0.)
        terms.push_back({pocket.gradient, pocket.stiffness});
    return terms;
  }



  Lubricant::Exchange
  SealedPocket::exchange(const Vector &u)
  {
    if (options.density.law != DensityLaw::incompressible)
      return Exchange::converged;
    if (++n_passes_ > maximal_passes)
      return Exchange::failed;
    Exchange result = Exchange::converged;
    for (Enclosure &pocket : pockets)
      if (std::abs(pocket.pressure - pocket.multiplier) >
          options.volume_tolerance * options.penalty_modulus)
        {
          pocket.multiplier = pocket.pressure;
          result            = Exchange::repeat;
        }
    return result;
  }



  std::string
  SealedPocket::reason() const
  {
    return n_passes_ > maximal_passes ?
             "the volume of the incompressible oil was not met" :
             "";
  }



  void
  SealedPocket::set_oil(const LubricantParameters &oil)
  {
    options.density = oil.compressibility;
  }



  void
  SealedPocket::begin_step(const Vector      &u,
                           const unsigned int step,
                           const double,
                           const double)
  {
    step_     = step;
    n_passes_ = 0;
    tracker   = accepted_tracker;
    if (options.sealing_gap > 0.)
      {
        void_volume.measure(u);
        track();
      }
    const auto &former = accepted_tracker.pockets();
    for (unsigned int i = 0; i < pockets.size(); ++i)
      for (unsigned int j = 0; j < former.size(); ++j)
        if (former[j].name == tracker.pockets()[i].name)
          pockets[i].multiplier = accepted_pressures[j];
  }



  void
  SealedPocket::accept(const Vector &)
  {
    accepted_tracker = tracker;
    accepted_pressures.clear();
    for (const Enclosure &pocket : pockets)
      accepted_pressures.push_back(pocket.pressure);
    if (step_ == 0 || options.sealing_gap == 0.)
      return;
    for (PocketEvent event : tracker.events())
      {
        // The tracker also counts steps that were tried again.
        event.step = step_;
        events_.push_back(to_string(event));
      }
  }



  LubricantState
  SealedPocket::state() const
  {
    LubricantState state;
    for (const Enclosure &pocket : pockets)
      {
        if (pocket.pressure > 0.)
          for (unsigned int i = 0; i < pocket.gradient.size(); ++i)
            state.pressure_force[i % 2] += pocket.pressure * pocket.gradient(i);
        state.max_pressure = std::max(state.max_pressure, pocket.pressure);
        state.void_volume += pocket.volume;
        state.reference_volume += pocket.reference_volume;
        state.oil_volume +=
          pocket.reference_volume / options.density.ratio(pocket.pressure);
      }
    state.reference_volume += tracker.sealed_mass();
    state.mean_pressure = (0. - state.pressure_force[1]) / length;
    state.smallest_film = void_volume.gap(0);
    for (unsigned int e = 1; e < void_volume.n_elements(); ++e)
      state.smallest_film = std::min(state.smallest_film, void_volume.gap(e));
    state.n_pockets = pockets.size();
    return state;
  }



  const SealedPocket::Enclosure *
  SealedPocket::enclosure_at(const double parameter) const
  {
    if (pockets.empty())
      return nullptr;
    std::vector<PocketExtent> extents;
    for (const Pocket &pocket : tracker.pockets())
      extents.push_back(pocket.extent);
    return &pockets[pocket_at(extents, parameter, length)];
  }



  double
  SealedPocket::pressure(const dealii::Point<2> &parameter) const
  {
    const Enclosure *pocket = enclosure_at(parameter[0]);
    return pocket != nullptr ? pocket->pressure : 0.;
  }



  double
  SealedPocket::coverage(const dealii::Point<2> &parameter) const
  {
    const Enclosure *pocket = enclosure_at(parameter[0]);
    if (pocket == nullptr || pocket->reference_volume == 0.)
      return 0.;
    const double oil =
      pocket->reference_volume / options.density.ratio(pocket->pressure);
    return oil < pocket->volume ? oil / pocket->volume : 1.;
  }



  std::vector<std::string>
  SealedPocket::events() const
  {
    return events_;
  }



  void
  SealedPocket::save(OutputArchive &archive) const
  {
    archive << accepted_tracker << accepted_pressures << step_ << events_;
  }



  void
  SealedPocket::load(InputArchive &archive)
  {
    archive >> accepted_tracker >> accepted_pressures >> step_ >> events_;
    require_length("pressures of pockets",
                   accepted_pressures.size(),
                   accepted_tracker.pockets().size());
    tracker = accepted_tracker;
    enclose();
  }
} // namespace asperity
