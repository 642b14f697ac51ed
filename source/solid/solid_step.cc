#include <asperity/base/archive.h>
#include <asperity/solid/solid_step.h>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  SolidStep::SolidStep(DeformableBody             &solid,
                       Equilibrium                &equilibrium,
                       const Vector               &u,
                       const std::optional<double> spectral_radius)
    : solid(solid)
    , equilibrium(equilibrium)
    , motion(spectral_radius.value_or(1.))
    , old_forces(u.size())
    , frame(u.size())
  {
    motion.u = u;
    motion.v = motion.a = old_forces;
    if (!spectral_radius)
      return;
    mass = equilibrium.make_matrix();
    solid.assemble_mass(*mass);
  }



  bool
  SolidStep::is_dynamic() const
  {
    return mass != nullptr;
  }



  void
  SolidStep::set_frame(const Vector &velocity)
  {
    frame = velocity;
  }



  const MotionEnergy &
  SolidStep::energy() const
  {
    return energy_;
  }



  MotionEnergy::End
  SolidStep::end_in_frame(const double time) const
  {
    MotionEnergy::End end{motion.u, motion.v, old_forces};
    end.u.add(-time, frame);
    end.v -= frame;
    end.forces *= -1.;
    return end;
  }



  void
  SolidStep::begin(const double new_dt, const Vector &new_load)
  {
    dt   = new_dt;
    load = new_load;
    solid.set_time_step(dt);
    if (load.size() > 0)
      equilibrium.set_load(load);
    if (!is_dynamic())
      return;
    // M (m u + b) + (1 - alpha_f) f(u) + alpha_f f_n
    Vector constant(motion.u.size());
    mass->vmult(constant, motion.constant(dt));
    constant.add(motion.alpha_f(), old_forces);
    equilibrium.set_inertia(mass.get(),
                            motion.mass_factor(dt),
                            constant,
                            1. - motion.alpha_f());
  }



  Vector
  SolidStep::predict() const
  {
    return motion.predict(dt);
  }



  ConvergenceReport
  SolidStep::solve(Vector              &u,
                   const NewtonOptions &options,
                   NewtonStatistics    &statistics)
  {
    const unsigned int      n_before = equilibrium.cost().factorisations;
    const ConvergenceReport report =
      newton(equilibrium, u, options, statistics);
    if (equilibrium.cost().factorisations > n_before)
      has_tangent = true;
    return report;
  }



  bool
  SolidStep::compliance(const Vector &u, Vector &forces)
  {
    if (!has_tangent)
      {
        Vector R(u.size()), change(u.size());
        if (!equilibrium.linearize(u, R) || !equilibrium.direction(R, change))
          return false;
        has_tangent = true;
      }
    equilibrium.back_substitute(forces);
    // The balance has the new forces by this weight.
    if (is_dynamic())
      forces *= 1. - motion.alpha_f();
    return true;
  }



  void
  SolidStep::forget_tangent()
  {
    has_tangent = false;
  }



  void
  SolidStep::accept(const Vector &u)
  {
    if (is_dynamic())
      {
        const MotionEnergy::End before = end_in_frame(0.);
        // Before the history moves on: the forces belong to this step.
        equilibrium.forces(u, old_forces);
        if (load.size() > 0)
          old_forces -= load;
        motion.advance(u, dt);
        energy_.add(*mass, before, end_in_frame(dt));
      }
    else
      motion.u = u;
    solid.accept();
  }



  SolidStep::State
  SolidStep::state() const
  {
    return {motion.u, motion.v, motion.a, old_forces, energy_};
  }



  void
  SolidStep::set_state(const State &state)
  {
    motion.u   = state.u;
    motion.v   = state.v;
    motion.a   = state.a;
    old_forces = state.forces;
    energy_    = state.energy;
    forget_tangent();
  }



  void
  SolidStep::State::save(OutputArchive &archive) const
  {
    archive << u << v << a << forces << energy;
  }



  void
  SolidStep::State::load(InputArchive &archive)
  {
    for (Vector *x : {&u, &v, &a, &forces})
      archive >> fixed_length(*x, "unknowns of a body");
    archive >> energy;
  }
} // namespace asperity
