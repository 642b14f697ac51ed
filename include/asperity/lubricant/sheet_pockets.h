#ifndef asperity_lubricant_sheet_pockets_h
#define asperity_lubricant_sheet_pockets_h

#include <asperity/lubricant/region_tracker.h>
#include <asperity/lubricant/sealed_pocket.h>
#include <asperity/lubricant/sheet_void.h>

#include <deal.II/base/tensor.h>

namespace asperity
{
  /**
   * Liquid enclosed between a patch of the chip and the sheet of the tool,
   * without flow: what SealedPocket is in two dimensions, with the same law of
   * one pressure a pocket, potential and tangent.
   *
   * With a sealing gap, pockets are the connected regions of the void
   * (find_regions()), found at the start of each step, and their oil goes with
   * their names (RegionTracker). A region that goes through the whole period is
   * a pocket like the others: the surfaces repeat, and the oil has nowhere to
   * leave to; events() tells of it. Without a sealing gap there is one pocket.
   */
  class SheetPockets : public Lubricant
  {
  public:
    /**
     * The chip is undeformed where V is taken first.
     * @param motion unit vector in which the chip slides
     * @param counts whether forces and tangent are added here: on one of
     *   several ranks that share the chip
     * @throws InputError if an oil film finds no pocket
     */
    SheetPockets(const SplineSpace<3>       &space,
                 const PatchGeometry<3>     &geometry,
                 const SplineSheet          &tool,
                 const dealii::Tensor<1, 3> &motion,
                 const SealedPocketOptions  &options,
                 const bool                  counts = true);

    void
    add_couplings(dealii::DynamicSparsityPattern &pattern) const override;

    bool
    add(const dealii::Vector<double> &u,
        dealii::Vector<double>       &residual,
        dealii::SparseMatrix<double> *tangent) override;

    std::vector<RankOneTerm>
    rank_one_terms() const override;

    void
    set_oil(const LubricantParameters &oil) override;

    /** Finds the pockets at the start of the step. */
    void
    begin_step(const dealii::Vector<double> &u,
               const unsigned int            step,
               const double                  time,
               const double                  dt) override;

    Exchange
    exchange(const dealii::Vector<double> &u) override;

    std::string
    reason() const override;

    void
    accept(const dealii::Vector<double> &u) override;

    /** Per metre of the width. */
    LubricantState
    state() const override;

    double
    pressure(const dealii::Point<2> &parameter) const override;

    /** That of the pocket. */
    double
    coverage(const dealii::Point<2> &parameter) const override;

    std::vector<std::string>
    events() const override;

    void
    save(OutputArchive &archive) const override;

    void
    load(InputArchive &archive) override;

  private:
    struct Enclosure
    {
      double                 reference_volume = 0.; ///< V_r [m^3]
      double                 volume           = 0.; ///< V [m^3]
      PocketPressure         oil;
      double                 multiplier = 0.; ///< of the incompressible law
      dealii::Vector<double> gradient;        ///< dV/du [m^2]
    };

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

    /** Nullptr if everything is sealed. */
    const Enclosure *
    enclosure_at(const dealii::Point<2> &parameter) const;

    SealedPocketOptions    options;
    SheetVoid              sheet_void;
    dealii::Tensor<1, 3>   motion;
    double                 length, width; ///< periods [m]
    bool                   counts;
    RegionTracker          tracker; ///< masses over rho_0 [m^3]
    std::vector<Enclosure> pockets; ///< in the tracker's order

    /** As the last accepted step left them; pressures in its order. */
    RegionTracker            accepted_tracker;
    std::vector<double>      accepted_pressures;
    unsigned int             step_     = 0;
    unsigned int             n_passes_ = 0; ///< of exchange() in this step
    std::vector<std::string> events_;
  };
} // namespace asperity

#endif
