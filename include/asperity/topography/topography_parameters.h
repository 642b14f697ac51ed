#ifndef asperity_topography_topography_parameters_h
#define asperity_topography_topography_parameters_h

#include <asperity/topography/periodic_continuation.h>

#include <optional>
#include <string>

namespace asperity
{
  class ParameterDeclarator;

  enum class CropChoice
  {
    none,
    hole_free,
    window
  };

  enum class FormChoice
  {
    none,
    plane,
    polynomial
  };

  /**
   * The way from a file to a periodic profile. Lengths in metres; positions
   * count from the first sample of the cropped map.
   */
  struct TopographyParameters
  {
    std::string file;

    /** Spelled units for files that carry none, or empty. */
    std::string lateral_unit;
    std::string height_unit;

    /** Of a text matrix. */
    std::optional<double> spacing_x;
    std::optional<double> spacing_y;

    /** In robust standard deviations; zero switches the search off. */
    double spike_threshold = 0.;

    CropChoice crop = CropChoice::none;

    /** "all", "60 .. 195" (inclusive) or "380 um .. 1250 um". */
    std::string crop_columns = "all";
    std::string crop_rows    = "all";

    FormChoice   form              = FormChoice::plane;
    unsigned int polynomial_degree = 2;

    /** Nesting indices; zero switches a filter off. */
    double s_filter = 0.;
    double l_filter = 0.;

    /** Of the profile: angle to x [rad] and where it crosses the map. */
    double direction = 0.;

    /** "middle", "row 30", "column 12" or a length such as "33 um". */
    std::string position = "middle";

    /** Arc length of the first sample, and of all if length is zero. */
    double start  = 0.;
    double length = 0.;

    /** More missing points than this fraction of the profile are an error. */
    double largest_missing_fraction = 0.1;

    /** Factors on the finished profile. */
    double scale_x = 1.;
    double scale_z = 1.;

    Continuation         continuation = Continuation::wrapped_spline;
    WrappedSplineOptions spline;

    /** Declares all entries in the subsection that is open. */
    void
    declare(ParameterDeclarator &parameters);
  };
} // namespace asperity

#endif
