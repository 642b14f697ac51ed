#ifndef asperity_topography_gaussian_filter_h
#define asperity_topography_gaussian_filter_h

#include <asperity/topography/height_map.h>

#include <vector>

namespace asperity
{
  /**
   * The weights of the Gaussian of ISO 16610-21 at the distances k*spacing,
   * k = 0, 1, ...: exp(-pi (x/(alpha cutoff))^2), alpha = sqrt(ln 2/pi), which
   * transmits 50 % of the wavelength cutoff. They end at x = cutoff, where
   * the weight is 0.08 %, and are not normalised.
   */
  std::vector<double>
  gaussian_weights(const double spacing, const double cutoff);

  /**
   * The long waves of @p values. Weights are renormalised at the ends and
   * beside missing points, so a constant stays what it is everywhere. With
   * @p periodic the values wrap around. Missing points stay missing.
   */
  std::vector<double>
  gaussian_low_pass(const std::vector<double> &values,
                    const double               spacing,
                    const double               cutoff,
                    const bool                 periodic = false);

  /** The same for a map (ISO 16610-61), with round weights. */
  HeightMap
  gaussian_low_pass(const HeightMap &map, const double cutoff);

  /**
   * S-filter: keep waves longer than the nesting index [m].
   *
   * @throws InputError if the index is not above two sample spacings, where it
   *   would do nothing.
   */
  void
  apply_s_filter(HeightMap &map, const double nesting_index);

  /**
   * L-filter: keep waves shorter than the nesting index [m].
   *
   * @throws InputError as for the S-filter.
   */
  void
  apply_l_filter(HeightMap &map, const double nesting_index);
} // namespace asperity

#endif
