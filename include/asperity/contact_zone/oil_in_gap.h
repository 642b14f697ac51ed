#ifndef asperity_contact_zone_oil_in_gap_h
#define asperity_contact_zone_oil_in_gap_h

#include <asperity/contact_zone/lubrication_parameters.h>

#include <optional>
#include <string>

namespace asperity
{
  /** The oil between the surfaces of a scene, at ambient pressure. */
  struct OilInGap
  {
    double thickness     = 0.; ///< volume over the area of the period [m]
    double part_at_start = 0.; ///< of the void at the start
    double part_at_touch = 0.; ///< of the void at first touch

    /** The thickness unless it is a part of the void at the start [m]. */
    std::optional<double> film;

    /** Smallest vertical distance of the surfaces at the start [m]: the one
     *  asked for, or a larger one in which all of the oil has room. */
    double initial_gap = 0.;

    /** That the oil leaves no void when the surfaces touch, and why; empty if
     *  that is not so, or if the parameters ask for a full void. */
    std::string warning;
  };

  /**
   * The oil that the parameters ask for. Surfaces that are moved towards each
   * other lose the same volume everywhere, so with the mean distance h_t at
   * first touch the void is h_t plus the smallest distance, times the period.
   *
   * @param initial_gap that the parameters ask for [m]
   * @param touch_gap h_t [m]
   * @throws InputError if the oil is a part of a void that does not exist
   */
  OilInGap
  oil_in_gap(const LubricationParameters &lubrication,
             const double                 initial_gap,
             const double                 touch_gap);
} // namespace asperity

#endif
