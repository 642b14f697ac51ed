#ifndef asperity_contact_penalty_warnings_h
#define asperity_contact_penalty_warnings_h

#include <string>

namespace asperity
{
  /**
   * A sentence if the rounding of positions is a pressure that Newton's method
   * would have to tell from none, else empty.
   * @param penalty [Pa/m]
   * @param position largest coordinate of the surfaces [m]
   * @param pressure the load [Pa]
   * @param tolerance of Newton's method, over the load
   */
  std::string
  rounding_warning(const double penalty,
                   const double position,
                   const double pressure,
                   const double tolerance);

  /**
   * A sentence if the penalty gives way as much as a small contact does, else
   * empty.
   * @param factor c of a penalty c E/h without augmentation
   */
  std::string
  soft_penalty_warning(const double factor);
} // namespace asperity

#endif
