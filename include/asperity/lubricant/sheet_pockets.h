#ifndef asperity_lubricant_sheet_pockets_h
#define asperity_lubricant_sheet_pockets_h

#include <asperity/lubricant/enclosed_oil.h>
#include <asperity/lubricant/region_tracker.h>
#include <asperity/lubricant/sheet_void.h>

#include <deal.II/base/tensor.h>

#include <array>

namespace asperity
{
  /**
   * Oil that is enclosed between a patch of the chip and the sheet of the tool:
   * what SealedPocket is in two dimensions.
   *
   * With a sealing gap, pockets are the connected regions of the void
   * (find_regions()), found at the start of each step, and their oil goes with
   * their names (RegionTracker). A region that goes through the whole period is
   * a pocket like the others: the surfaces repeat, and the oil has nowhere to
   * leave to; events() tells of it. Without a sealing gap there is one pocket.
   */
  class SheetPockets : public EnclosedOil
  {
  public:
    /**
     * The chip is undeformed where V is taken first.
     * @param motion unit vector in which the chip slides
     * @param counts whether forces and tangent are added here: on one of
     *   several ranks that share the chip
     * @param size of the grid that the pockets consist of, see SheetVoid; they
     *   go over to another mesh of the chip by save() and load() if it is given
     * @throws InputError if an oil film finds no pocket
     */
    SheetPockets(const SplineSpace<3>              &space,
                 const PatchGeometry<3>            &geometry,
                 const SplineSheet                 &tool,
                 const dealii::Tensor<1, 3>        &motion,
                 const SealedPocketOptions         &options,
                 const bool                         counts = true,
                 const std::array<unsigned int, 2> &size   = {{0, 0}});

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

    /** Per metre of the width. */
    LubricantState
    state() const override;

    void
    save(OutputArchive &archive) const override;

    void
    load(InputArchive &archive) override;

  private:
    /** Finds the pockets at the measured displacement; the oil follows. */
    void
    track();

    /** The tracker's pockets as enclosures. */
    void
    enclose();

    /** What the step did to the pockets, and which go through the period and
     *  did not before or the other way round. */
    void
    tell_events();

    const Enclosure *
    enclosure_at(const dealii::Point<2> &parameter) const override;

    SheetVoid            sheet_void;
    dealii::Tensor<1, 3> motion;
    double               length, width; ///< periods [m]
    bool                 counts;
    RegionTracker        tracker; ///< masses over rho_0 [m^3]

    /** As the last accepted step left it. */
    RegionTracker accepted_tracker;
  };
} // namespace asperity

#endif
