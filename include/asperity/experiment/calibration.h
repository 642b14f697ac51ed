#ifndef asperity_experiment_calibration_h
#define asperity_experiment_calibration_h

#include <asperity/surrogate/friction_law.h>

#include <optional>
#include <vector>

namespace asperity
{
  /** An input of a law that was found from measurements; SI. */
  struct Calibration
  {
    double value = 0.;

    /** From the curvature and the scatter; empty: one measurement without a
     *  deviation has none. */
    std::optional<double> standard_error;

    /** What the law's own deviation at the measurements adds to that, as if it
     *  were the same at all of them. */
    double error_of_law = 0.;

    std::vector<LawPrediction> computed; ///< with this value, one a measurement
  };

  /** Measurements at known inputs of a law. */
  struct CalibrationData
  {
    /** One a measurement: all inputs of the law in SI; what is calibrated is
     *  not read. */
    std::vector<std::vector<double>> x;

    std::vector<double> mu;
    std::vector<double> deviation; ///< standard, of each mu; or empty
  };

  /**
   * The value of one input of a law with which the law meets measurements best:
   * the least sum of ((mu - law)/s)^2, s the deviations or, without them, the
   * same part of each mu. The least of 64 intervals of the input's range, then
   * Brent's method in it. Standard error s/sqrt(sum of (d law/d input/s_i)^2):
   * s^2 is the sum of squares over n - 1, and with deviations at least 1 (Birge
   * 1932).
   *
   * @param input number of the input
   * @throws InputError if the measurements do not determine it: mu hardly
   *   depends on it, or the best value is an end of its range
   */
  Calibration
  calibrate(const FrictionLaw     &law,
            const std::size_t      input,
            const CalibrationData &data);
} // namespace asperity

#endif
