#ifndef asperity_lubricant_enclosed_oil_h
#define asperity_lubricant_enclosed_oil_h

#include <asperity/constitutive/lubricant_parameters.h>
#include <asperity/lubricant/lubricant.h>

#include <deal.II/lac/vector.h>

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

  /**
   * Liquid enclosed between the chip and the tool, without flow: one pressure a
   * pocket,
   *
   *   p >= 0,  V - V_oil(p) >= 0,  p (V - V_oil(p)) = 0,
   *   V_oil = V_r rho_0 / rho(p),
   *
   * with the void V of the pocket and the oil's volume V_r at p = 0. The
   * pressure acts on all of the surface; what the contact adds is the excess
   * over it. So force and tangent derive from the potential - int p dV, and do
   * not jump where contact begins:
   *
   *   R = - p dV/du,   K = - p d^2V/du^2 - dp/dV (dV/du)(dV/du)^T.
   *
   * The second part of K couples all of a pocket and is given as rank-one term.
   *
   * What a pocket is, and its volume, is for the classes that derive from this
   * one to say: SealedPocket between curves, SheetPockets between sheets.
   */
  class EnclosedOil : public Lubricant
  {
  public:
    std::vector<RankOneTerm>
    rank_one_terms() const override;

    void
    set_oil(const LubricantParameters &oil) override;

    /** Tightens the incompressible law until its volume is met. */
    Exchange
    exchange(const dealii::Vector<double> &u) override;

    std::string
    reason() const override;

    double
    pressure(const dealii::Point<2> &parameter) const override;

    /** That of the pocket. */
    double
    coverage(const dealii::Point<2> &parameter) const override;

    std::vector<std::string>
    events() const override;

  protected:
    /** Volumes are areas in two dimensions. */
    struct Enclosure
    {
      double         reference_volume = 0.; ///< V_r [m^dim]
      double         volume           = 0.; ///< V [m^dim]
      PocketPressure oil;
      double         multiplier = 0.;  ///< of the incompressible law [Pa]
      dealii::Vector<double> gradient; ///< dV/du [m^(dim - 1)]
    };

    explicit EnclosedOil(const SealedPocketOptions &options);

    /** The pocket at a parameter of the surface; nullptr if everything is
     *  sealed. */
    virtual const Enclosure *
    enclosure_at(const dealii::Point<2> &parameter) const = 0;

    /** V_r of each pocket from its volume at the start.
     *  @param extent of the period, over which an oil film is spread
     *    [m^(dim - 1)]
     *  @throws InputError if an oil film finds no pocket */
    std::vector<double>
    oil_at_start(const double extent) const;

    /** Pressure and stiffness at the pocket's volume; false if none exists. */
    bool
    set_pressure(Enclosure &pocket) const;

    /** Before the passes of a step. */
    void
    begin_passes(const unsigned int step);

    /** The multipliers of pockets that keep their names.
     *  @param now, former pockets of a tracker, in the order of `pockets` and
     *    of `accepted_pressures` */
    template <typename Named>
    void
    hand_down_multipliers(const std::vector<Named> &now,
                          const std::vector<Named> &former)
    {
      for (std::size_t i = 0; i < now.size(); ++i)
        for (std::size_t j = 0; j < former.size(); ++j)
          if (former[j].name == now[i].name)
            pockets[i].multiplier = accepted_pressures[j];
    }

    void
    accept_pressures();

    /** Force of the oil on the chip, without that of the contact. */
    template <int dim>
    dealii::Tensor<1, dim>
    pressure_force() const
    {
      dealii::Tensor<1, dim> force;
      for (const Enclosure &pocket : pockets)
        if (pocket.oil.pressure > 0.)
          for (unsigned int i = 0; i < pocket.gradient.size(); ++i)
            force[i % dim] += pocket.oil.pressure * pocket.gradient(i);
      return force;
    }

    /** What is summed over pockets; volumes in their own unit. */
    LubricantState
    sum_of_pockets() const;

    SealedPocketOptions    options;
    std::vector<Enclosure> pockets;

    /** As the last accepted step left them. */
    std::vector<double> accepted_pressures;

    unsigned int             step_ = 0;
    std::vector<std::string> events_;

  private:
    unsigned int n_passes_ = 0; ///< of exchange() in this step
  };
} // namespace asperity

#endif
