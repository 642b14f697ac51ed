#include <asperity/base/archive.h>
#include <asperity/lubricant/sheet_pockets.h>

#include <algorithm>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  SheetPockets::SheetPockets(const SplineSpace<3>              &space,
                             const PatchGeometry<3>            &geometry,
                             const SplineSheet                 &tool,
                             const dealii::Tensor<1, 3>        &motion,
                             const SealedPocketOptions         &options,
                             const bool                         counts,
                             const std::array<unsigned int, 2> &size)
    : EnclosedOil(options)
    , sheet_void(space, geometry, tool, size)
    , motion(motion)
    , length(tool.period(0))
    , width(tool.period(1))
    , counts(counts)
    , tracker(sheet_void.size())
    , accepted_tracker(sheet_void.size())
  {
    track();
    tracker.set_masses(oil_at_start(length * width));
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
        if (!set_pressure(pocket))
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



  void
  SheetPockets::begin_step(const Vector      &u,
                           const unsigned int step,
                           const double,
                           const double)
  {
    begin_passes(step);
    tracker = accepted_tracker;
    if (options.sealing_gap > 0.)
      {
        sheet_void.measure(u);
        track();
      }
    hand_down_multipliers(tracker.regions(), accepted_tracker.regions());
  }



  void
  SheetPockets::accept(const Vector &)
  {
    if (step_ > 0 && options.sealing_gap > 0.)
      tell_events();
    accepted_tracker = tracker;
    accept_pressures();
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
    LubricantState state = sum_of_pockets();
    for (double *volume :
         {&state.void_volume, &state.reference_volume, &state.oil_volume})
      *volume /= width;
    const dealii::Tensor<1, 3> force = pressure_force<3>();
    state.pressure_force[0] =
      (force[0] * motion[0] + force[1] * motion[1]) / width;
    state.pressure_force[1] = force[2] / width;
    state.transverse = (force[1] * motion[0] - force[0] * motion[1]) / width;
    state.reference_volume += tracker.sealed_mass() / width;
    state.mean_pressure = (0. - state.pressure_force[1]) / length;
    state.smallest_film = sheet_void.gap(0);
    for (unsigned int e = 1; e < sheet_void.n_elements(); ++e)
      state.smallest_film = std::min(state.smallest_film, sheet_void.gap(e));
    return state;
  }



  const EnclosedOil::Enclosure *
  SheetPockets::enclosure_at(const dealii::Point<2> &parameter) const
  {
    if (pockets.empty())
      return nullptr;
    return &pockets[tracker.places().region[sheet_void.element_at(parameter)]];
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
