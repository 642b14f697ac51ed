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

    /** v t [m] */
    double
    displacement(const double time) const;

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
