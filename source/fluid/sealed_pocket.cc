#include <asperity/base/errors.h>
#include <asperity/fluid/sealed_pocket.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  SealedPocket::SealedPocket(const SplineSpace         &space,
                             const PatchGeometry       &geometry,
                             const SplineCurve         &tool,
                             const SealedPocketOptions &options)
    : options(options)
    , void_volume(space, geometry, tool)
    , length(tool.period()[0])
  {
    Pocket all;
    all.stretch          = void_volume.period();
    all.volume           = void_volume.volume(all.stretch);
    all.reference_volume = options.wetting * all.volume;
    all.gradient.reinit(2 * space.n_functions());
    pockets.push_back(all);
    accepted_multipliers.push_back(0.);
  }



  void
  SealedPocket::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    void_volume.add_couplings(pattern);
  }



  bool
  SealedPocket::set_pressure(Pocket &pocket) const
  {
    const double V   = pocket.volume;
    const double V_r = pocket.reference_volume;
    pocket.pressure = pocket.stiffness = 0.;
    if (V_r == 0.)
      return true;
    if (V <= 0.)
      return false;
    if (options.density.law == DensityLaw::incompressible)
      {
        const double p =
          pocket.multiplier + options.penalty_modulus * (1. - V / V_r);
        if (p <= 0.)
          return true;
        pocket.pressure  = p;
        pocket.stiffness = options.penalty_modulus / V_r;
        return true;
      }
    if (V >= V_r)
      return true;
    const double ratio = V_r / V;
    const double p     = options.density.pressure(ratio);
    if (!std::isfinite(p))
      return false;
    pocket.pressure  = p;
    pocket.stiffness = ratio / V / options.density.derivative(p);
    return std::isfinite(pocket.stiffness);
  }



  bool
  SealedPocket::add(const Vector                 &u,
                    Vector                       &residual,
                    dealii::SparseMatrix<double> *tangent)
  {
    void_volume.measure(u);
    for (Pocket &pocket : pockets)
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
    for (const Pocket &pocket : pockets)
      if (pocket.stiffness > 0.)
        terms.push_back({pocket.gradient, pocket.stiffness});
    return terms;
  }



  Lubricant::Exchange
  SealedPocket::exchange(const Vector &u)
  {
    if (options.density.law != DensityLaw::incompressible)
      return Exchange::converged;
    Exchange result = Exchange::converged;
    for (Pocket &pocket : pockets)
      if (std::abs(pocket.pressure - pocket.multiplier) >
          options.volume_tolerance * options.penalty_modulus)
        {
          pocket.multiplier = pocket.pressure;
          result            = Exchange::repeat;
        }
    return result;
  }



  void
  SealedPocket::accept(const Vector &u, const unsigned int step)
  {
    accepted_multipliers.clear();
    for (const Pocket &pocket : pockets)
      accepted_multipliers.push_back(pocket.multiplier);
  }



  void
  SealedPocket::reject()
  {
    for (unsigned int i = 0; i < pockets.size(); ++i)
      pockets[i].multiplier = accepted_multipliers[i];
  }



  LubricantState
  SealedPocket::state() const
  {
    LubricantState state;
    for (const Pocket &pocket : pockets)
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
    state.mean_pressure = -state.pressure_force[1] / length;
    state.n_pockets     = pockets.size();
    return state;
  }



  std::vector<double>
  SealedPocket::save() const
  {
    return accepted_multipliers;
  }



  void
  SealedPocket::load(const std::vector<double> &data)
  {
    if (data.size() != pockets.size())
      throw InputError("The checkpoint holds " + std::to_string(data.size()) +
                       " oil pockets; expected " +
                       std::to_string(pockets.size()) + ".");
    accepted_multipliers = data;
    reject();
  }
} // namespace asperity
