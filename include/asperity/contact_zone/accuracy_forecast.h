#ifndef asperity_contact_zone_accuracy_forecast_h
#define asperity_contact_zone_accuracy_forecast_h

#include <asperity/contact_zone/audit.h>
#include <asperity/contact_zone/error_estimate.h>

#include <string>
#include <vector>

namespace asperity
{
  /**
   * What error and time of a run will be, from the scene alone: a power law in
   * a few of its numbers, fitted to the sixteen dry reference scenes
   * (parameter_files/reference_scenes/README.md, "What the program says before
   * a run"). The time is good for a factor of two. The error is not where a
   * tool has finer waves than those scenes.
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
