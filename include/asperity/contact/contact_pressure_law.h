#ifndef asperity_contact_contact_pressure_law_h
#define asperity_contact_contact_pressure_law_h

namespace asperity
{
  /** Contact pressure and its derivative by the gap. */
  struct ContactPressure
  {
    double value = 0.; ///< p, positive in compression [Pa]
    double slope = 0.; ///< dp/dg, not positive [Pa/m]
  };



  /**
   * The pressure of a penalty law with a multiplier,
   *   p = <lambda - epsilon g>,
   * the derivative by -g of the potential <lambda - epsilon g>^2 / (2 epsilon).
   * At the kink the slope is that of the open side.
   */
  struct ContactPressureLaw
  {
    double penalty; ///< epsilon [Pa/m]

    /** @param gap g, negative where the bodies overlap [m]
     *  @param multiplier lambda [Pa] */
    ContactPressure
    evaluate(const double gap, const double multiplier) const
    {
      const double pressure = multiplier - penalty * gap;
      if (pressure > 0.)
        return {pressure, -penalty};
      return {};
    }
  };
} // namespace asperity

#endif
