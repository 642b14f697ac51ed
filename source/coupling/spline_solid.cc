#include <asperity/coupling/spline_solid.h>

#include <algorithm>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  SplineSolid::SplineSolid(SolidAssembler<2>                       &solid,
                           const dealii::AffineConstraints<double> &constraints,
                           const Interface                         &interface,
                           const SplineSolidOptions                &options)
    : interface(interface)
    , options(options)
    , load(interface)
    , equilibrium(2 * solid.space().n_functions(),
                  {&solid, &load},
                  constraints,
                  options.solver)
    , u(2 * solid.space().n_functions())
    , step(solid,
           equilibrium,
           u,
           options.dynamic ? std::optional(options.spectral_radius) :
                             std::nullopt)
    , largest_load(options.load_floor)
  {}



  void
  SplineSolid::begin_step(const double dt)
  {
    step.begin(dt);
    // A tangent of an earlier step would make the run depend on where it was
    // interrupted.
    step.forget_tangent();
    u = step.state().u;
  }



  ConvergenceReport
  SplineSolid::solve(const Vector &force, Vector &displacement)
  {
    load.set_force(force);
    Vector loads(u.size());
    interface.add_loads(force, loads);
    present_load = loads.l2_norm();

    // Not those of iterations that have diverged: beside them any residual
    // would be small.
    NewtonOptions newton_options;
    newton_options.tolerance =
      options.tolerance * std::max(largest_load, present_load);
    newton_options.maximum_iterations = options.maximum_iterations;
    const ConvergenceReport report = step.solve(u, newton_options, statistics_);
    displacement                   = interface.interpolate(u);
    return report;
  }



  bool
  SplineSolid::compliance(const Vector &force, Vector &displacement)
  {
    Vector change(u.size());
    interface.add_loads(force, change);
    if (!step.compliance(u, change))
      return false;
    displacement = interface.interpolate(change);
    return true;
  }



  void
  SplineSolid::accept()
  {
    step.accept(u);
    largest_load = std::max(largest_load, present_load);
  }



  const Vector &
  SplineSolid::displacement() const
  {
    return u;
  }



  SolidStep::State
  SplineSolid::state() const
  {
    return step.state();
  }



  void
  SplineSolid::set_state(const SolidStep::State &state)
  {
    u = state.u;
    step.set_state(state);
  }



  const NewtonStatistics &
  SplineSolid::statistics() const
  {
    return statistics_;
  }
} // namespace asperity
