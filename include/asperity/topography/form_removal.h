#ifndef asperity_topography_form_removal_h
#define asperity_topography_form_removal_h

#include <asperity/topography/height_map.h>

namespace asperity
{
  /**
   * F-operator of ISO 25178-3: subtract the least-squares polynomial in x and
   * y of total degree @p degree (1: the plane), fitted to the valid points.
   * A map of one row gets a polynomial in x.
   *
   * @throws InputError if there are fewer valid points than coefficients, or
   *   if they do not determine them (all in one line, say).
   */
  void
  remove_form(HeightMap &map, const unsigned int degree);
} // namespace asperity

#endif
