#include <asperity/base/archive.h>
#include <asperity/contact_zone/lubricated_step.h>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  ChipSide::ChipSide(SolidStep &step, GapFlow &oil, const Solve &solve)
    : step(step)
    , oil(oil)
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
    step.forget_tangent();
  }



  ConvergenceReport
  ChipSide::solve(const Vector &force, Vector &displacement)
  {
    oil.set_force(force);
    const ConvergenceReport report = solve_balance(u);
    oil.set_chip(u);
    displacement = oil.interface().interpolate(u);
    return report;
  }



  bool
  ChipSide::compliance(const Vector &force, Vector &displacement)
  {
    Vector change(u.size());
    oil.interface().add_loads(force, change);
    if (!step.compliance(u, change))
      return false;
    displacement = oil.interface().interpolate(change);
    return true;
  }



  void
  ChipSide::accept()
  {
    // The run accepts the chip.
  }



  LubricatedStep::LubricatedStep(SolidStep                &chip_step,
                                 GapFlow                  &oil,
                                 const ChipSide::Solve    &solve,
                                 const CouplingParameters &parameters)
    : chip(chip_step, oil, solve)
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
