#ifndef asperity_base_convergence_report_h
#define asperity_base_convergence_report_h

#include <string>

namespace asperity
{
  /**
   * How an iteration ended. Non-convergence is a value, not an exception: the
   * caller decides whether to cut the step, go on, or stop.
   */
  struct ConvergenceReport
  {
    bool         converged  = false;
    unsigned int iterations = 0;

    /** In the measure of the iteration that reports (see there). */
    double residual = 0.;

    /** Empty if converged, otherwise a half sentence that says why not. */
    std::string reason;
  };
} // namespace asperity

#endif
