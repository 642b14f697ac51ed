#include <asperity/contact_zone/load_protocol.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  LoadProtocol::LoadProtocol(const LoadParameters     &load,
                             const ProtocolParameters &protocol)
    : load(load)
    , protocol(protocol)
  {}



  double
  LoadProtocol::ramp_time() const
  {
    return protocol.ramp_fraction * protocol.end_time;
  }



  double
  LoadProtocol::pressure(const double time) const
  {
    if (time >= ramp_time())
      return load.pressure;
    return 0.5 * load.pressure * (1. - std::cos(M_PI * time / ramp_time()));
  }



  double
  LoadProtocol::displacement(const double time) const
  {
    return load.velocity *
           (direction(time) > 0. ? time : 2. * reversal_time() - time);
  }



  double
  LoadProtocol::direction(const double time) const
  {
    return time <= reversal_time() * (1. + 1e-12) ? 1. : -1.;
  }



  double
  LoadProtocol::reversal_time() const
  {
    return protocol.reversal_distance > 0. ?
             protocol.reversal_distance / load.velocity :
             end_time();
  }



  double
  LoadProtocol::end_time() const
  {
    if (protocol.window == FrictionWindow::time)
      return protocol.end_time;
    return std::max(ramp_time(), protocol.maximum_distance / load.velocity);
  }



  double
  LoadProtocol::next_time(const double time) const
  {
    const double ramp = ramp_time(), end = end_time();
    // The end of regular step k of n in [begin, begin + length].
    const auto following =
      [time](const double begin, const double length, const double n) {
        const double k = std::floor((time - begin) / length * n + 1e-6) + 1.;
        return begin + std::min(k / n, 1.) * length;
      };
    if (time < ramp * (1. - 1e-9))
      return following(0., ramp, protocol.ramp_steps);
    if (protocol.window == FrictionWindow::time)
      return std::min(following(ramp, end - ramp, protocol.slide_steps),
                      time < reversal_time() * (1. - 1e-9) ? reversal_time() :
                                                             end);
    const double n =
      std::ceil((end - ramp) * load.velocity / protocol.steady_step);
    return following(ramp, end - ramp, n);
  }
} // namespace asperity
