#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/lubricant/sheet_pockets.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  namespace
  {
    /** As those of SealedPocket. */
    constexpr unsigned int most_passes = 20;
  } // namespace



  SheetPockets::SheetPockets(const SplineSpace<3>       &space,
                             const PatchGeometry<3>     &geometry,
                             const SplineSheet          &tool,
                             const dealii::Tensor<1, 3> &motion,
                             const SealedPocketOptions  &options,
                             const bool                  counts)
    : options(options)
    , sheet_void(space, geometry, tool)
    , motion(motion)
    , length(tool.period(0))
    , width(tool.period(1))
    , counts(counts)
    , tracker(sheet_void.size())
    , accepted_tracker(sheet_void.size())
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
        wetting = *options.oil_film * length * width / void_at_start;
      }
    std::vector<double> oil;
    for (const Enclosure &pocket : pockets)
      oil.push_back(wetting * pocket.volume);
    tracker.set_masses(oil);
    enclose();
    accept(Vector());
  }



  void
  SheetPockets::track()
  {
    VoidRegions regions;
    if (options.sealing_gap > 0.)
      {
        std::vector<double> gaps;
        for (unsigned int e = 0; e < sheet_void.n_elements(); ++e)
          gaps.push_back(sheet_void.gap(e));
        regions = find_regions(sheet_void.size(), gaps, options.sealing_gap);
      }
    else
      {
        regions.n = 1;
        regions.region.assign(sheet_void.n_elements(), 0);
        regions.open.assign(sheet_void.n_elements(), 1);
        regions.through.push_back({{true, true}});
      }
    tracker.update(regions,
                   sheet_void.volumes(regions.region, regions.n),
                   accepted_pressures);
    enclose();
  }



  void
  SheetPockets::enclose()
  {
    const auto &regions = tracker.regions();
    const auto  volumes =
      sheet_void.volumes(tracker.places().region, regions.size());
    pockets.assign(regions.size(), Enclosure());
    for (std::size_t i = 0; i < pockets.size(); ++i)
      {
        pockets[i].reference_volume = regions[i].mass;
        pockets[i].volume           = volumes[i];
        pockets[i].gradient.reinit(sheet_void.n_dofs());
      }
  }



  void
  SheetPockets::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    sheet_void.add_couplings(pattern);
  }



  bool
  SheetPockets::add(const Vector                 &u,
                    Vector                       &residual,
                    dealii::SparseMatrix<double> *tangent)
  {
    if (pockets.empty())
      return true;
    sheet_void.measure(u);
    const auto         &region  = tracker.places().region;
    const auto          volumes = sheet_void.volumes(region, pockets.size());
    std::vector<double> factors;
    for (std::size_t i = 0; i < pockets.size(); ++i)
      {
        Enclosure &pocket = pockets[i];
        pocket.volume     = volumes[i];
        const auto oil    = pocket_pressure(options,
                                         pocket.reference_volume,
                                         pocket.volume,
                                         pocket.multiplier);
        pocket.oil        = oil.value_or(PocketPressure());
        if (!oil)
          return false;
        factors.push_back(-pocket.oil.pressure);
        if (pocket.oil.pressure == 0.)
          continue;
        pocket.gradient = 0.;
        sheet_void.add_gradient(region, i, 1., pocket.gradient);
        if (counts)
          residual.add(-pocket.oil.pressure, pocket.gradient);
      }
    if (tangent != nullptr && counts)
      sheet_void.add_hessian(region, factors, *tangent);
    return true;
  }



  std::vector<RankOneTerm>
  SheetPockets::rank_one_terms() const
  {
    std::vector<RankOneTerm> terms;
    for (const Enclosure &pocket : pockets)
      if (pocket.oil.stiffness > 0.)
        terms.push_back({pocket.gradient, pocket.oil.stiffness});
    return terms;
  }



  Lubricant::Exchange
  SheetPockets::exchange(const Vector &)
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
  SheetPockets::reason() const
  {
    return n_passes_ > most_passes ?
             "the volume of the incompressible oil was not met" :
             "";
  }



  void
  SheetPockets::set_oil(const LubricantParameters &oil)
  {
    options.density = oil.compressibility;
  }



  void
  SheetPockets::begin_step(const Vector      &u,
                           const unsigned int step,
                           const double,
                           const double)
  {
    step_     = step;
    n_passes_ = 0;
    tracker   = accepted_tracker;
    if (options.sealing_gap > 0.)
      {
        sheet_void.measure(u);
        track();
      }
    const auto &former = accepted_tracker.regions();
    for (std::size_t i = 0; i < pockets.size(); ++i)
      for (std::size_t j = 0; j < former.size(); ++j)
        if (former[j].name == tracker.regions()[i].name)
          pockets[i].multiplier = accepted_pressures[j];
  }



  void
  SheetPockets::accept(const Vector &)
  {
    if (step_ > 0 && options.sealing_gap > 0.)
      tell_events();
    accepted_tracker = tracker;
    accepted_pressures.clear();
    for (const Enclosure &pocket : pockets)
      accepted_pressures.push_back(pocket.oil.pressure);
  }



  void
  SheetPockets::tell_events()
  {
    for (PocketEvent event : tracker.events())
      {
        event.step = step_;
        events_.push_back(to_string(event));
      }
    const auto &former = accepted_tracker.regions();
    for (std::size_t i = 0; i < pockets.size(); ++i)
      {
        const std::string  &name   = tracker.regions()[i].name;
        std::array<bool, 2> before = {{false, false}};
        for (std::size_t j = 0; j < former.size(); ++j)
          if (former[j].name == name)
            before = accepted_tracker.places().through[j];
        for (unsigned int d = 0; d < 2; ++d)
          if (tracker.places().through[i][d] != before[d])
            events_.push_back("step " + std::to_string(step_) + ": pocket " +
                              name + (before[d] ? " no longer" : "") +
                              " goes through the period along " +
                              (d == 0 ? "x" : "y"));
      }
  }



  LubricantState
  SheetPockets::state() const
  {
    LubricantState       state;
    dealii::Tensor<1, 3> force;
    for (const Enclosure &pocket : pockets)
      {
        const double p = pocket.oil.pressure;
        if (p > 0.)
          for (unsigned int i = 0; i < pocket.gradient.size(); ++i)
            force[i % 3] += p * pocket.gradient(i);
        state.max_pressure = std::max(state.max_pressure, p);
        state.void_volume += pocket.volume / width;
        state.reference_volume += pocket.reference_volume / width;
        state.oil_volume +=
          pocket.reference_volume / options.density.ratio(p) / width;
      }
    state.pressure_force[0] =
      (force[0] * motion[0] + force[1] * motion[1]) / width;
    state.pressure_force[1] = force[2] / width;
    state.transverse = (force[1] * motion[0] - force[0] * motion[1]) / width;
    state.reference_volume += tracker.sealed_mass() / width;
    state.mean_pressure = (0. - state.pressure_force[1]) / length;
    state.smallest_film = sheet_void.gap(0);
    for (unsigned int e = 1; e < sheet_void.n_elements(); ++e)
      state.smallest_film = std::min(state.smallest_film, sheet_void.gap(e));
    state.n_pockets = pockets.size();
    return state;
  }



  const SheetPockets::Enclosure *
  SheetPockets::enclosure_at(const dealii::Point<2> &parameter) const
  {
    if (pockets.empty())
      return nullptr;
    return &pockets[tracker.places().region[sheet_void.element_at(parameter)]];
  }



  double
  SheetPockets::pressure(const dealii::Point<2> &parameter) const
  {
    const Enclosure *pocket = enclosure_at(parameter);
    return pocket != nullptr ? pocket->oil.pressure : 0.;
  }



  double
  SheetPockets::coverage(const dealii::Point<2> &parameter) const
  {
    const Enclosure *pocket = enclosure_at(parameter);
    if (pocket == nullptr || pocket->reference_volume == 0.)
      return 0.;
    const double oil =
      pocket->reference_volume / options.density.ratio(pocket->oil.pressure);
    return oil < pocket->volume ? oil / pocket->volume : 1.;
  }



  std::vector<std::string>
  SheetPockets::events() const
  {
    return events_;
  }



  void
  SheetPockets::save(OutputArchive &archive) const
  {
    archive << accepted_tracker << accepted_pressures << step_ << events_;
  }



  void
  SheetPockets::load(InputArchive &archive)
  {
    archive >> accepted_tracker >> accepted_pressures >> step_ >> events_;
    require_length("pressures of pockets",
                   accepted_pressures.size(),
                   accepted_tracker.regions().size());
    tracker = accepted_tracker;
    enclose();
  }
} // namespace asperity
