#ifndef asperity_contact_zone_accuracy_forecast_h
#define asperity_contact_zone_accuracy_forecast_h

#include <asperity/contact_zone/audit.h>
#include <asperity/contact_zone/error_estimate.h>

#include <string>
#include <vector>

namespace asperity
{
  /**
   * What error and time of a run will be, from the scene alone: power laws in a
   * few of its numbers, fitted to dry scenes
   * (parameter_files/reference_scenes/README.md, "What the program says before
   * a run"). Good for a factor of two: the time in ten of ten scenes, the error
   * in nine before its sources cancel and in six as it is.
   */
  struct AccuracyForecast
  {
    /** Relative errors of mu; their signs are not known. */
    ErrorEstimate error;

    /** Over the time of R0 at 300 MPa, 200 m/min and 25 degC with the default
     *  settings. */
    double time = 0.;

    /** Of all sources; not negative. */
    double
    total() const;
  };

  /** What the forecast depends on. */
  struct ForecastNumbers
  {
    double elements = 0.; ///< of the contact edge, in the steepest asperity
    double way      = 0.; ///< sliding distance over the length of an asperity
    double contact  = 0.; ///< share of the edge that touches, about
    double steps    = 0.; ///< time steps
    double penalty_factor = 0.; ///< of E/h
    double unknowns       = 0.;

    /** Of the spots that touch, as they are if the tool is cut off at the
     *  height below which it has the share of the edge that touches: elements
     *  of the contact edge in a mean one; sliding distance over its length and
     *  over that of an element; and how far the penalty lets the tool in under
     *  the pressure there, over the mean depth that is cut off. */
    double elements_in_spot = 0., way_over_spot = 0., elements_passed = 0.,
           softness = 0.;
  };

  /** @throws InputError if the chip has no strength */
  ForecastNumbers
  forecast_numbers(const SceneParameters &parameters, const Scene<2> &scene);

  AccuracyForecast
  forecast(const ForecastNumbers &numbers, const LubricantModel lubricant);

  /** Sentences for `asperity check`: the forecast of the scene as it is, and
   *  the cheapest settings that keep the wanted error. Empty if a surface is
   *  flat on a flat one. */
  std::vector<std::string>
  advise(const SceneParameters &parameters, const Scene<2> &scene);
} // namespace asperity

#endif
