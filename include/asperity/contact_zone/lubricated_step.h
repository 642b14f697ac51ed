#ifndef asperity_contact_zone_lubricated_step_h
#define asperity_contact_zone_lubricated_step_h

#include <asperity/coupling/gap_flow.h>
#include <asperity/coupling/partitioned_step.h>
#include <asperity/solid/solid_step.h>

#include <functional>

namespace asperity
{
  /** The chip, with its contact, loads and inertia, as one side of a coupled
   *  step with the oil in the gap. */
  class ChipSide : public SolidSide
  {
  public:
    /** Solves the balance of the chip; starts from u. */
    using Solve = std::function<ConvergenceReport(Vector &u)>;

    /**
     * @param step of the chip, begun; the oil is among the terms of its balance
     * @param solve of the step
     */
    ChipSide(SolidStep &step, GapFlow &oil, const Solve &solve);

    /** First guess of the next step, with the prescribed values. */
    void
    start_from(const Vector &u);

    /** The last result. */
    const Vector &
    displacement() const;

    void
    begin_step(const double dt) override;

    ConvergenceReport
    solve(const Vector &force, Vector &displacement) override;

    bool
    compliance(const Vector &force, Vector &displacement) override;

    void
    accept() override;

  private:
    SolidStep &step;
    GapFlow   &oil;
    Solve      solve_balance;
    Vector     start, u;
  };



  /** A step of chip and oil together: PartitionedStep between ChipSide and
   *  GapFlow. */
  class LubricatedStep
  {
  public:
    using Vector = dealii::Vector<double>;

    /** See ChipSide. */
    LubricatedStep(SolidStep                &chip_step,
                   GapFlow                  &oil,
                   const ChipSide::Solve    &solve,
                   const CouplingParameters &parameters);

    /** Solves for the chip's displacement u, from a first guess; the oil
     *  accepts the step with it. */
    ConvergenceReport
    advance(Vector &u, const double dt);

    /** All that a restart needs. */
    void
    save(OutputArchive &archive) const;

    /** Takes what save() wrote.
     *  @throws InputError if that is of another interface */
    void
    load(InputArchive &archive);

  private:
    ChipSide        chip;
    PartitionedStep step;
  };
} // namespace asperity

#endif
