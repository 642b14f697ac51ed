#include <asperity/time_integration/backward_difference.h>

namespace asperity
{
  BackwardDifference
  BackwardDifference::steady()
  {
    return {};
  }



  BackwardDifference
  BackwardDifference::implicit_euler(const double dt)
  {
    return {1. / dt, -1. / dt, 0.};
  }



  BackwardDifference
  BackwardDifference::bdf2(const double dt, const double dt_old)
  {
    const double ratio = dt / dt_old;
    return {(1. + 2. * ratio) / (1. + ratio) / dt,
            -(1. + ratio) / dt,
            ratio * ratio / (1. + ratio) / dt};
  }
} // namespace asperity
