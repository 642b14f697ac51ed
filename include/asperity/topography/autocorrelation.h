#ifndef asperity_topography_autocorrelation_h
#define asperity_topography_autocorrelation_h

#include <asperity/topography/height_map.h>

#include <vector>

namespace asperity
{
  /**
   * The autocorrelation function of ISO 25178-2: the mean product of the
   * heights, measured from their mean, of two valid points that are a lag
   * apart, over the mean square; for lags up to half of the map.
   */
  class Autocorrelation
  {
  public:
    /** The fastest and slowest decay of ISO 25178-2 are those to this. */
    static constexpr double level = 0.2;

    explicit Autocorrelation(const HeightMap &map);

    /** At a lag [m], linear between those of whole pixels; NaN beyond half of
     *  the map and where no two points are that lag apart. */
    double
    operator()(const double lag_x, const double lag_y) const;

    struct Decay
    {
      double lag;      ///< [m]
      bool   is_found; ///< else the longest lag of the direction
    };

    /** Where the autocorrelation first falls to 0.2, going from lag 0 into a
     *  direction [rad] from x. */
    Decay
    decay(const double direction) const;

    /** Length of the longest lag, half of the map's diagonal [m]. */
    double
    longest_lag() const;

    /** Of the lags [m]: that of the pixels, the smaller one of x and y. */
    double
    spacing() const;

    /** Whether the map has one row. */
    bool
    is_profile() const
    {
      return n_y == 0;
    }

  private:
    /** That of whole pixels, 0 <= i <= n_x, |j| <= n_y. */
    double
    at(const int i, const int j) const
    {
      return values[std::size_t(j + n_y) * (n_x + 1) + i];
    }

    int                 n_x, n_y; // pixels of the longest lags
    double              dx, dy;
    std::vector<double> values;
  };

  /** Lateral parameters of ISO 25178-2. */
  struct ArealTexture
  {
    /** Autocorrelation length, the lag of the fastest decay to 0.2 [m]; NaN if
     *  no direction has one within half of the map. */
    double Sal = missing_height;

    /** Texture aspect ratio, the lag of the fastest decay over that of the
     *  slowest: 1 for an isotropic surface, towards 0 for one of straight
     *  grooves. NaN if a direction has none within half of the map. */
    double Str = missing_height;

    /** What Str is at most: grooves that cross the map have no known Str, but a
     *  small one. */
    double Str_bound = 1.;

    /** Up to this texture aspect ratio a direction stands out. */
    static constexpr double largest_ratio_of_lay = 0.3;

    /** Whether the surface has a lay, as ground ones do: then a profile across
     *  it stands for the surface, and its direction counts. */
    bool
    has_lay() const
    {
      return Str_bound <= largest_ratio_of_lay;
    }
  };

  /** Of the heights from their mean: remove the form first. A map of one row
   *  has no Str. */
  ArealTexture
  areal_texture(const HeightMap &map);
} // namespace asperity

#endif
