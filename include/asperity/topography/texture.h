#ifndef asperity_topography_texture_h
#define asperity_topography_texture_h

#include <asperity/topography/height_map.h>

namespace asperity
{
  /** Which way the lay of a surface runs, by its slopes, if it has one
   *  (ArealTexture::has_lay()). */
  struct Texture
  {
    /** Of the direction of the largest root mean square slope, across the lay,
     *  to x [rad], in (-pi/2, pi/2]; 0 for a map of one row. */
    double direction = 0.;

    /** Root mean square slope along that direction, and across it. */
    double largest_slope  = 0.;
    double smallest_slope = 0.;
  };

  /**
   * The principal axes of the mean of grad z (x) grad z over all points that
   * have three valid neighbours on either side (slope_at()). Pixel noise has
   * slopes in all directions: filter it first.
   */
  Texture
  measure_texture(const HeightMap &map);

  /**
   * Standard deviation [m] of the noise that differs from pixel to pixel: the
   * median of the absolute second differences along the rows, over their
   * standard deviation sqrt(6) under white noise of standard deviation 1 (the
   * median as in robust statistics, 1.4826 of it being one standard deviation).
   * A surface with waves of two or three pixels counts as noise, too.
   */
  double
  pixel_noise(const HeightMap &map);

  /**
   * Root mean square slope in one direction that white noise of the standard
   * deviation @p noise [m] keeps behind a Gaussian S-filter: with the standard
   * deviation s = 0.187 cutoff of its weights and a pixel area A,
   * noise sqrt(A/(8 pi)) / s^2.
   */
  double
  filtered_noise_slope(const HeightMap &map,
                       const double     noise,
                       const double     cutoff);

  /** The smallest nesting index of ISO 25178-3 (1, 2, 2.5, 5, 8 times a power
   * of ten) that is not below @p length [m]. */
  double
  nesting_index_of_at_least(const double length);
} // namespace asperity

#endif
