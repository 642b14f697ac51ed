#ifndef asperity_experiment_rake_contact_h
#define asperity_experiment_rake_contact_h

namespace asperity
{
  /**
   * The contact of chip and rake face after N. N. Zorev (1963): the pressure
   * falls from the edge as sigma = sigma_0 (1 - x/l)^xi; the shear stress is
   * min(mu sigma, k), so that the chip sticks where mu sigma exceeds its shear
   * limit k, and slides beyond. SI.
   */
  struct RakeContact
  {
    double mean_pressure = 0.; ///< [Pa]
    double exponent      = 2.; ///< xi
    double mu            = 0.; ///< where the chip slides

    /** Shear limit k [Pa]; infinite: the chip slides everywhere. */
    double shear_limit = 0.;

    /** sigma_0 = (xi + 1) times the mean pressure [Pa]. */
    double
    edge_pressure() const;

    /** Part of the contact length over which the chip sticks. */
    double
    sticking() const;

    /** Mean of the pressure where the chip slides [Pa]. */
    double
    sliding_pressure() const;

    /** Friction over normal force of the whole contact: k/p (1 - xi/(xi + 1)
     *  (k/(mu sigma_0))^(1/xi)) if the chip sticks somewhere, else mu. */
    double
    apparent_mu() const;

    /**
     * The contact whose apparent mu is the measured one.
     * @throws InputError if that takes a shear stress above k everywhere
     */
    static RakeContact
    with_apparent_mu(const double mean_pressure,
                     const double exponent,
                     const double apparent_mu,
                     const double shear_limit);
  };
} // namespace asperity

#endif
