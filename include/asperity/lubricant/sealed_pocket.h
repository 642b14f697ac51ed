#ifndef asperity_lubricant_sealed_pocket_h
#define asperity_lubricant_sealed_pocket_h

#include <asperity/lubricant/enclosed_oil.h>
#include <asperity/lubricant/pocket_tracker.h>
#include <asperity/lubricant/void_volume.h>

namespace asperity
{
  /**
   * Oil that is enclosed between the chip and the curve of the tool.
   *
   * With a sealing gap, each void between two seals is a pocket of its own.
   * Where they begin and end is decided at the end of each step, at the starts
   * of elements of the edge, and the oil of a pocket goes with its name (see
   * PocketTracker). Forces on both sides of a seal then differ by the pressure
   * difference times the gap of the seal, which acts on the oil in it.
   */
  class SealedPocket : public EnclosedOil
  {
  public:
    /** The chip is undeformed where V is taken first.
     *  @throws InputError if an oil film finds no pocket */
    SealedPocket(const SplineSpace<2>      &space,
                 const PatchGeometry<2>    &geometry,
                 const SplineCurve         &tool,
                 const SealedPocketOptions &options);

    void
    add_couplings(dealii::DynamicSparsityPattern &pattern) const override;

    bool
    add(const dealii::Vector<double> &u,
        dealii::Vector<double>       &residual,
        dealii::SparseMatrix<double> *tangent) override;

    /** Finds the pockets at the start of the step. */
    void
    begin_step(const dealii::Vector<double> &u,
               const unsigned int            step,
               const double                  time,
               const double                  dt) override;

    void
    accept(const dealii::Vector<double> &u) override;

    LubricantState
    state() const override;

    void
    save(OutputArchive &archive) const override;

    void
    load(InputArchive &archive) override;

  private:
    const Enclosure *
    enclosure_at(const dealii::Point<2> &parameter) const override;

    /** Finds the pockets at the measured displacement; the oil follows. */
    void
    track();

    /** The tracker's pockets as enclosures. */
    void
    enclose();

    VoidVolume                       void_volume;
    double                           length;    ///< period [m]
    PocketTracker                    tracker;   ///< masses over rho_0 [m^2]
    std::vector<VoidVolume::Stretch> stretches; ///< of the edge, of pockets

    /** As the last accepted step left it. */
    PocketTracker accepted_tracker;
  };
} // namespace asperity

#endif
