#ifndef asperity_topography_profile_h
#define asperity_topography_profile_h

#include <asperity/topography/height_map.h>

#include <vector>

namespace asperity
{
  /**
   * Heights z(x_i) [m] at x_i = i*spacing [m]. A periodic profile repeats
   * after heights.size()*spacing: the value at the end of the period is the
   * first one again and is not stored.
   */
  struct Profile
  {
    std::vector<double> heights;
    double              spacing  = 0.;
    bool                periodic = false;

    /** The period, or the length from the first to the last sample. */
    double
    length() const
    {
      return (periodic ? heights.size() : heights.size() - 1) * spacing;
    }
  };

  /**
   * The line in a map along which a profile is taken. With t = (cos a, sin a)
   * it consists of the points @p point + s t with @p from <= s <= @p to.
   */
  struct ProfileLine
  {
    double angle = 0.;
    double x     = 0.;
    double y     = 0.;

    /** Arc lengths [m] of the ends; the whole map if both are zero. */
    double from = 0.;
    double to   = 0.;
  };

  /**
   * Heights along the line, bilinear between samples, with the sample spacing
   * of the map along x or y, else with the smaller of the two. A line along x
   * or y is moved to the nearest row or column, so that it holds measured
   * heights only. A point is missing where one of its neighbours is.
   *
   * @throws InputError if fewer than @p min_points of the line lie in the map.
   */
  Profile
  extract_profile(const HeightMap   &map,
                  const ProfileLine &line,
                  const unsigned int min_points = 10);

  /**
   * Heights at another distance [m], from the first sample on, by the cubic
   * spline through the samples of an open profile without missing ones. At most
   * one spacing beyond the last sample, which stays there.
   */
  Profile
  resample(const Profile &profile, const double spacing, const std::size_t n);
} // namespace asperity

#endif
