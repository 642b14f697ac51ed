#include <asperity/base/archive.h>
#include <asperity/lubricant/sealed_pocket.h>

#include <algorithm>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  SealedPocket::SealedPocket(const SplineSpace<2>      &space,
                             const PatchGeometry<2>    &geometry,
                             const SplineCurve         &tool,
                             const SealedPocketOptions &options)
    : EnclosedOil(options)
    , void_volume(space, geometry, tool)
    , length(tool.period()[0])
    , tracker(length)
    , accepted_tracker(length)
  {
    track();
    tracker.set_masses(oil_at_start(length));
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
    pockets.clear();
    stretches.clear();
    for (const Pocket &tracked : tracker.pockets())
      {
        stretches.push_back(void_volume.stretch(tracked.extent.domain.begin,
                                                tracked.extent.domain.end));
        Enclosure pocket;
        pocket.reference_volume = tracked.mass;
        pocket.volume           = void_volume.volume(stretches.back());
        pocket.gradient.reinit(void_volume.n_dofs());
        pockets.push_back(pocket);
      }
  }



  void
  SealedPocket::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    void_volume.add_couplings(pattern);
  }



  bool
  SealedPocket::add(const Vector                 &u,
                    Vector                       &residual,
                    dealii::SparseMatrix<double> *tangent)
  {
    void_volume.measure(u);
    for (std::size_t i = 0; i < pockets.size(); ++i)
      {
        Enclosure &pocket = pockets[i];
        pocket.volume     = void_volume.volume(stretches[i]);
        if (!set_pressure(pocket))
          return false;
        const double p = pocket.oil.pressure;
        if (p == 0.)
          continue;
        pocket.gradient = 0.;
        void_volume.add_gradient(stretches[i], 1., pocket.gradient);
        residual.add(-p, pocket.gradient);
        if (tangent != nullptr)
          void_volume.add_hessian(stretches[i], -p, *tangent);
      }
    return true;
  }



  void
  SealedPocket::begin_step(const Vector      &u,
                           const unsigned int step,
                           const double,
                           const double)
  {
    begin_passes(step);
    tracker = accepted_tracker;
    if (options.sealing_gap > 0.)
      {
        void_volume.measure(u);
        track();
      }
    hand_down_multipliers(tracker.pockets(), accepted_tracker.pockets());
  }



  void
  SealedPocket::accept(const Vector &)
  {
    accepted_tracker = tracker;
    accept_pressures();
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
    LubricantState state = sum_of_pockets();
    state.pressure_force = pressure_force<2>();
    state.reference_volume += tracker.sealed_mass();
    state.mean_pressure = (0. - state.pressure_force[1]) / length;
    state.smallest_film = void_volume.gap(0);
    for (unsigned int e = 1; e < void_volume.n_elements(); ++e)
      state.smallest_film = std::min(state.smallest_film, void_volume.gap(e));
    return state;
  }



  const EnclosedOil::Enclosure *
  SealedPocket::enclosure_at(const dealii::Point<2> &parameter) const
  {
    if (pockets.empty())
      return nullptr;
    std::vector<PocketExtent> extents;
    for (const Pocket &pocket : tracker.pockets())
      extents.push_back(pocket.extent);
    return &pockets[pocket_at(extents, parameter[0], length)];
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
