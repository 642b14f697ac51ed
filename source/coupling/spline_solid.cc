#include <asperity/base/archive.h>
#include <asperity/coupling/spline_solid.h>

#include <algorithm>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  namespace
  {
    std::vector<ForceTerm *>
    all_terms(SolidAssembler                 &solid,
              InterfaceLoad                  &load,
              const std::vector<ForceTerm *> &further)
    {
      std::vector<ForceTerm *> terms{&solid, &load};
      terms.insert(terms.end(), further.begin(), further.end());
      return terms;
    }
  } // namespace



  SplineSolid::SplineSolid(SolidAssembler                 &solid,
                           const std::vector<ForceTerm *> &further_terms,
                           const dealii::AffineConstraints<double> &constraints,
                           const Interface                         &interface,
                           const SplineSolidOptions                &options)
    : solid(solid)
    , interface(interface)
    , options(options)
    , load(interface)
    , equilibrium(2 * solid.space().n_functions(),
                  all_terms(solid, load, further_terms),
                  constraints,
                  options.solver)
    , motion(options.spectral_radius)
    , u(2 * solid.space().n_functions())
    , old_forces(u)
    , largest_load(options.load_floor)
  {
    motion.u = motion.v = motion.a = u;
    if (options.dynamic)
      {
        mass = equilibrium.make_matrix();
        solid.assemble_mass(*mass);
      }
  }



  void
  SplineSolid::begin_step(const double new_dt)
  {
    dt = new_dt;
    solid.set_time_step(dt);
    u = motion.u;
    if (!options.dynamic)
      return;
    Vector constant(u.size());
    mass->vmult(constant, motion.constant(dt));
    constant.add(motion.alpha_f(), old_forces);
    equilibrium.set_inertia(mass.get(),
                            motion.mass_factor(dt),
                            constant,
                            1. - motion.alpha_f());
  }



  ConvergenceReport
  SplineSolid::solve(const Vector &force, Vector &displacement)
  {
    load.set_force(force);
    Vector loads(u.size());
    interface.add_loads(force, loads);
    largest_load = std::max(largest_load, loads.l2_norm());

    NewtonOptions newton_options;
    newton_options.tolerance          = options.tolerance * largest_load;
    newton_options.maximum_iterations = options.maximum_iterations;
    const unsigned int      n_before  = statistics_.iterations;
    const ConvergenceReport report =
      newton(equilibrium, u, newton_options, statistics_);
    if (statistics_.iterations > n_before)
      factorised_dt = dt;
    displacement = interface.interpolate(u);
    return report;
  }



  bool
  SplineSolid::compliance(const Vector &force, Vector &displacement)
  {
    Vector change(u.size());
    if (factorised_dt != dt)
      {
        Vector R(u.size());
        if (!equilibrium.linearize(u, R) || !equilibrium.direction(R, change))
          return false;
        factorised_dt = dt;
      }
    change = 0.;
    interface.add_loads(force, change);
    equilibrium.back_substitute(change);
    // The balance has the new forces by this weight.
    if (options.dynamic)
      change *= 1. - motion.alpha_f();
    displacement = interface.interpolate(change);
    return true;
  }



  void
  SplineSolid::accept()
  {
    if (options.dynamic)
      {
        equilibrium.forces(u, old_forces);
        motion.advance(u, dt);
      }
    else
      motion.u = u;
    solid.accept();
  }



  const Vector &
  SplineSolid::displacement() const
  {
    return u;
  }



  SplineSolid::State
  SplineSolid::state() const
  {
    return {motion.u, motion.v, motion.a, old_forces};
  }



  void
  SplineSolid::set_state(const State &state)
  {
    u = motion.u  = state.u;
    motion.v      = state.v;
    motion.a      = state.a;
    old_forces    = state.forces;
    factorised_dt = 0.;
  }



  const NewtonStatistics &
  SplineSolid::statistics() const
  {
    return statistics_;
  }



  void
  SplineSolid::State::save(OutputArchive &archive) const
  {
    archive << u << v << a << forces;
  }



  void
  SplineSolid::State::load(InputArchive &archive)
  {
    for (Vector *x : {&u, &v, &a, &forces})
      archive >> fixed_length(*x, "unknowns of a body");
  }
} // namespace asperity
