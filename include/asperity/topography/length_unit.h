#ifndef asperity_topography_length_unit_h
#define asperity_topography_length_unit_h

#include <string>

namespace asperity
{
  /**
   * Metres in one @p unit as instruments spell it: m, mm, um (also with a
   * micro sign in UTF-8 or Latin-1), nm, pm, A. Zero if it is none of these.
   */
  double
  metres_per(const std::string &unit);
} // namespace asperity

#endif
