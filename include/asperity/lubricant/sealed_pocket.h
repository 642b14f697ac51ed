#ifndef asperity_lubricant_sealed_pocket_h
#define asperity_lubricant_sealed_pocket_h

#include <asperity/constitutive/lubricant_parameters.h>
#include <asperity/lubricant/lubricant.h>
#include <asperity/lubricant/pocket_tracker.h>
#include <asperity/lubricant/void_volume.h>

#include <memory>
#include <optional>

namespace asperity
{
  struct SealedPocketOptions
  {
    LubricantDensity density;

    /** w: oil at p = 0 over the void at the start. */
    double wetting = 1.;

    /** Volume of the oil at p = 0 over the period [m], instead of w times the
     *  void; pockets share it as they share the void. */
    std::optional<double> oil_film;

    /** Gap under which the surfaces seal [m]; 0: all voids are connected and
     *  share one pressure. */
    double sealing_gap = 0.;

    /** Stiffness of the incompressible law's first guess, -dp/d ln V [Pa];
     *  exchange() then tightens until the volume is met. */
    double penalty_modulus = 3e14;

    /** |V - V_oil| / V_oil at which an incompressible pocket is accepted. Times
     *  the penalty modulus it must be above what the solid's own tolerance
     *  leaves of the pressure. */
    double volume_tolerance = 1e-9;
  };

  /** What the oil of a pocket does in its volume. */
  struct PocketPressure
  {
    double pressure  = 0.; ///< [Pa]
    double stiffness = 0.; ///< -dp/dV [Pa over the unit of V]
  };

  /** The law of SealedPocket; nothing if there is no pressure at this volume.
   *  @param reference_volume V_r, in the unit of V
   *  @param multiplier of the incompressible law [Pa] */
  std::optional<PocketPressure>
  pocket_pressure(const SealedPocketOptions &options,
                  const double               reference_volume,
                  const double               volume,
                  const double               multiplier);

  /**
   * Liquid enclosed between the chip and the tool, without flow: one pressure a
   * pocket,
   *
   *   p >= 0,  V - V_oil(p) >= 0,  p (V - V_oil(p)) = 0,
   *   V_oil = V_r rho_0 / rho(p),
   *
   * with the void V of the pocket and the oil's volume V_r at p = 0. The
   * pressure acts on the whole edge; what the contact adds is the excess over
   * it. So force and tangent derive from the potential - int p dV, and do not
   * jump where contact begins:
   *
   *   R = - p dV/du,   K = - p d^2V/du^2 - dp/dV (dV/du)(dV/du)^T.
   *
   * The second part of K couples a whole edge and is given as rank-one term.
   *
   * With a sealing gap, each void between two seals is a pocket of its own.
   * Where they begin and end is decided at the end of each step, at the starts
   * of elements of the edge, and the oil of a pocket goes with its name (see
   * PocketTracker). Forces on both sides of a seal then differ by the pressure
   * difference times the gap of the seal, which acts on the oil in it.
   */
  class SealedPocket : public Lubricant
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

    std::vector<RankOneTerm>
    rank_one_terms() const override;

    /** Finds the pockets at the start of the step. */
    void
    set_oil(const LubricantParameters &oil) override;

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
    /** One pressure, on a stretch of the edge. */
    struct Enclosure
    {
      VoidVolume::Stretch stretch;
      double              reference_volume = 0.; ///< V_r [m^2]
      double              volume           = 0.; ///< V [m^2]
      double              pressure         = 0.; ///< [Pa]
      double              stiffness        = 0.; ///< -dp/dV [Pa/m^2]
      double              multiplier = 0.; ///< of the incompressible law [Pa]
      dealii::Vector<double> gradient;     ///< dV/du [m]
    };

    /** The pocket to which a parameter of the edge belongs; nullptr if
     *  everything is sealed. */
    const Enclosure *
    enclosure_at(const double parameter) const;

    /** Pressure and stiffness at the pocket's volume; false if none exists. */
    bool
    set_pressure(Enclosure &pocket) const;

    /** Finds the pockets at the measured displacement; the oil follows. */
    void
    track();

    /** The tracker's pockets as enclosures. */
    void
    enclose();

    SealedPocketOptions    options;
    VoidVolume             void_volume;
    double                 length;  ///< period [m]
    PocketTracker          tracker; ///< masses over rho_0, so areas [m^2]
    std::vector<Enclosure> pockets; ///< in the tracker's order

    /** As the last accepted step left them; pressures in its order. */
    PocketTracker       accepted_tracker;
    std::vector<double> accepted_pressures;
    unsigned int        step_     = 0;
    unsigned int        n_passes_ = 0; ///< of exchange() in this step

    std::vector<std::string> events_;
  };
} // namespace asperity

#endif
