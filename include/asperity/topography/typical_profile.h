#ifndef asperity_topography_typical_profile_h
#define asperity_topography_typical_profile_h

#include <asperity/topography/height_map.h>

namespace asperity
{
  /** A piece of a profile that stands for the map it is taken from. */
  struct TypicalProfile
  {
    /** Whether @p line is a column, that is whether the profile is nearer to y
     *  than to x, and the row or column that it crosses the map's middle at. */
    bool         along_y = false;
    unsigned int line    = 0;

    /** Arc length [m] of its first sample, and its length up to the next sample
     *  after its last one: that of its period. */
    double start  = 0.;
    double length = 0.;

    /** Root mean square height [m] about its own straight line, and root mean
     *  square slope; and the medians of these over all pieces. */
    double Rq         = 0.;
    double Rdq        = 0.;
    double median_Rq  = 0.;
    double median_Rdq = 0.;

    std::size_t n_pieces  = 0; ///< looked at
    std::size_t n_missing = 0; ///< points of this one
  };

  /** Length [m] of the profile through the middle of the map. */
  double
  length_through_middle(const HeightMap &map, const double direction);

  /**
   * Of all pieces of the given length in one direction, among those with the
   * fewest missing points, the one nearest to the medians of Rq and Rdq (in the
   * logarithms of both) when make_periodic() has joined its ends, which should
   * change Rq little. Only the nearest thirty are joined, and a large jump at
   * the ends counts against a piece before. A map of one row has pieces along x
   * only.
   *
   * @param map without form, filtered as the profile will be
   * @param direction angle to x [rad]
   * @param length of the piece [m]; if the map is shorter, all of it
   * @param margin distance [m] to the edges of the map, which filters distort,
   *   kept as far as the map leaves room for it
   *
   * @throws InputError if no line of the map holds ten samples.
   */
  TypicalProfile
  find_typical_profile(const HeightMap &map,
                       const double     direction,
                       const double     length,
                       const double     margin);
} // namespace asperity

#endif
