#ifndef asperity_topography_roughness_h
#define asperity_topography_roughness_h

#include <asperity/topography/height_map.h>

#include <vector>

namespace asperity
{
  /**
   * Areal parameters of ISO 25178-2 over all valid points of a map, heights
   * measured from their mean [m]; Ssk, Sku, Sdq, Sdr without unit.
   */
  struct ArealRoughness
  {
    double Sa  = 0.;
    double Sq  = 0.;
    double Sp  = 0.;
    double Sv  = 0.;
    double Sz  = 0.;
    double Ssk = 0.;
    double Sku = 0.;

    /** Root mean square slope by slope_at(); NaN if no point has one. */
    double Sdq = 0.;

    /** Developed interfacial area ratio: what the surface has more area than
     *  its projection, mean of sqrt(1 + |grad z|^2) - 1 over the same points.
     */
    double Sdr = 0.;
  };

  /**
   * Profile parameters of ISO 4287 over the valid points of a profile, heights
   * measured from their mean [m]; Rsk, Rku, Rdq without unit.
   */
  struct ProfileRoughness
  {
    double Ra = 0.;
    double Rq = 0.;

    /** Mean of the peak-to-valley heights of five sections of equal length. */
    double Rz = 0.;

    /** Peak-to-valley height of the whole profile. */
    double Rt  = 0.;
    double Rsk = 0.;
    double Rku = 0.;

    /** Root mean square slope by slope_at(); NaN if no point has one. */
    double Rdq = 0.;
  };

  ArealRoughness
  areal_roughness(const HeightMap &map);

  ProfileRoughness
  profile_roughness(const std::vector<double> &heights, const double spacing);

  /**
   * dz/dx by the seven-point formula of ISO 4287,
   * (z[3] - 9 z[2] + 45 z[1] - 45 z[-1] + 9 z[-2] - z[-3]) / (60 dx),
   * NaN where one of the points is missing or outside. @p get returns z[k].
   */
  template <typename Get>
  double
  slope_at(const Get &get, const double spacing)
  {
    return (get(3) - 9. * get(2) + 45. * get(1) - 45. * get(-1) + 9. * get(-2) -
            get(-3)) /
           (60. * spacing);
  }
} // namespace asperity

#endif
