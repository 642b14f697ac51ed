#ifndef asperity_contact_zone_load_protocol_h
#define asperity_contact_zone_load_protocol_h

#include <asperity/contact_zone/scene_parameters.h>

namespace asperity
{
  /** Load and motion of the chip's bottom over time, and the time steps. */
  class LoadProtocol
  {
  public:
    LoadProtocol(const LoadParameters     &load,
                 const ProtocolParameters &protocol);

    /** p/2 (1 - cos(pi t/t_r)) until the end of the ramp t_r, then p [Pa]. */
    double
    pressure(const double time) const;

    /** v t until the chip turns back, v (2 t_back - t) then [m]. */
    double
    displacement(const double time) const;

    /** 1 as long as the chip slides along x, -1 once it slides back; at the
     *  moment itself, 1. */
    double
    direction(const double time) const;

    /** At which the chip turns back; the end of the run if it does not. */
    double
    reversal_time() const;

    double
    ramp_time() const;

    /** t_end, or with a steady window the time at the maximal distance. */
    double
    end_time() const;

    /** The end of the regular step that follows this time. */
    double
    next_time(const double time) const;

  private:
    LoadParameters     load;
    ProtocolParameters protocol;
  };
} // namespace asperity

#endif
