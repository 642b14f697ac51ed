#ifndef asperity_fluid_sealed_pocket_h
#define asperity_fluid_sealed_pocket_h

#include <asperity/constitutive/lubricant_density.h>
#include <asperity/fluid/lubricant.h>
#include <asperity/fluid/void_volume.h>

#include <memory>

namespace asperity
{
  struct SealedPocketOptions
  {
    LubricantDensity density;

    /** w: oil at p = 0 over the void at the start. */
    double wetting = 1.;

    /** Gap under which the surfaces seal [m]; 0: all voids are connected and
     *  share one pressure. */
    double sealing_gap = 0.;

    /** Stiffness of the incompressible law's first guess, dp/d ln V [Pa];
     *  exchange() then tightens until the volume is met. */
    double penalty_modulus = 2e14;

    /** |V - V_oil| / V_oil at which an incompressible pocket is accepted. */
    double volume_tolerance = 1e-10;
  };

  /**
   * Liquid enclosed between the chip and the tool, without flow: one pressure a
   * pocket (DESIGN, "Wetting, and the sealed-pocket model"),
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
   */
  class SealedPocket : public Lubricant
  {
  public:
    /** The chip is undeformed where V is taken first. */
    SealedPocket(const SplineSpace         &space,
                 const PatchGeometry       &geometry,
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

    Exchange
    exchange(const dealii::Vector<double> &u) override;

    void
    accept(const dealii::Vector<double> &u, const unsigned int step) override;

    void
    reject() override;

    LubricantState
    state() const override;

    std::vector<double>
    save() const override;

    void
    load(const std::vector<double> &data) override;

  private:
    struct Pocket
    {
      VoidVolume::Stretch    stretch;
      double                 reference_volume = 0.; ///< V_r [m^2]
      double                 volume           = 0.; ///< V [m^2]
      double                 pressure         = 0.; ///< [Pa]
      double                 stiffness        = 0.; ///< -dp/dV [Pa/m^2]
      double                 multiplier       = 0.; ///< incompressible [Pa]
      dealii::Vector<double> gradient;              ///< dV/du [m]
    };

    /** Pressure and stiffness at the pocket's volume; false if none exists. */
    bool
    set_pressure(Pocket &pocket) const;

    SealedPocketOptions options;
    VoidVolume          void_volume;
    double              length; ///< period [m]
    std::vector<Pocket> pockets;
    std::vector<double> accepted_multipliers;
  };
} // namespace asperity

#endif
