#include <asperity/base/archive.h>
#include <asperity/contact_zone/lubricated_step.h>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  ChipSide::ChipSide(Equilibrium &equilibrium,
                     GapFlow     &oil,
                     const double force_weight,
                     const Solve &solve)
    : equilibrium(equilibrium)
    , oil(oil)
    , force_weight(force_weight)
    , solve_balance(solve)
  {}



  void
  ChipSide::start_from(const Vector &new_start)
  {
    start = new_start;
  }



  const Vector &
  ChipSide::displacement() const
  {
    return u;
  }



  void
  ChipSide::begin_step(const double)
  {
    u = start;
    // A tangent of an earlier step would make the run depend on where it was
    // interrupted.
    is_factorised = false;
  }



  ConvergenceReport
  ChipSide::solve(const Vector &force, Vector &displacement)
  {
    oil.set_force(force);
    const unsigned int      n_before = equilibrium.cost().factorisations;
    const ConvergenceReport report   = solve_balance(u);
    if (equilibrium.cost().factorisations > n_before)
      is_factorised = true;
    oil.set_chip(u);
    displacement = oil.interface().interpolate(u);
    return report;
  }



  bool
  ChipSide::compliance(const Vector &force, Vector &displacement)
  {
    Vector change(u.size());
    if (!is_factorised)
      {
        Vector R(u.size());
        if (!equilibrium.linearize(u, R) || !equilibrium.direction(R, change))
          return false;
        is_factorised = true;
      }
    change = 0.;
    oil.interface().add_loads(force, change);
    equilibrium.back_substitute(change);
    change *= force_weight;
    displacement = oil.interface().interpolate(change);
    return true;
  }



  void
  ChipSide::accept()
  {
    // The run accepts the chip.
  }



  LubricatedStep::LubricatedStep(Equilibrium              &equilibrium,
                                 GapFlow                  &oil,
                                 const double              force_weight,
                                 const ChipSide::Solve    &solve,
                                 const CouplingParameters &parameters)
    : chip(equilibrium, oil, force_weight, solve)
    , step(chip, oil.side(), parameters)
  {}



  ConvergenceReport
  LubricatedStep::advance(Vector &u, const double dt)
  {
    chip.start_from(u);
    const ConvergenceReport report = step.advance(dt);
    u                              = chip.displacement();
    return report;
  }



  void
  LubricatedStep::save(OutputArchive &archive) const
  {
    step.save(archive);
  }



  void
  LubricatedStep::load(InputArchive &archive)
  {
    step.load(archive);
  }
} // namespace asperity
