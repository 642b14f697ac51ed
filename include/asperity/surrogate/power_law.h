#ifndef asperity_surrogate_power_law_h
#define asperity_surrogate_power_law_h

#include <asperity/surrogate/friction_law.h>

#include <string>
#include <vector>

namespace asperity
{
  /**
   * The empirical laws that machining knows, fitted to the runs of a friction
   * law so that both can be compared: by least squares in the logarithms. Both
   * are products of powers; all numbers are SI, temperatures in K.
   */
  struct PowerLaw
  {
    /** One factor max(x, floor)^exponent for each input of the friction law. */
    double              coefficient = 0.;
    std::vector<double> exponents;
    std::vector<double> floors;

    /** Mean of |error| / value over the runs that it was fitted to, and the
     *  same with each run left out of the fit that predicts it; the latter is
     *  the counterpart of FrictionLawDescription::leave_one_out_error. */
    double mean_relative_error = 0.;
    double leave_one_out_error = 0.;

    /** @param x an entry for each input */
    double
    operator()(const double *x) const;
  };

  /**
   * mu = c p^a v^b T^d, one factor an input, as the user routines of practice
   * have it (Filzek's law in the VFRICTION routine of RWTH Aachen's WZL). The
   * floors, which keep it finite as p and v go to 0, are the lower ends of the
   * ranges. An input whose range is not positive gets the exponent 0.
   *
   * @throws InputError if a value is not positive, or if there are fewer runs
   *   than two more than exponents, or if the runs do not determine them
   */
  PowerLaw
  fit_power_law(const FrictionLaw &law);

  /**
   * The law of Lee (2025), section 2.1, over the velocity alone, see
   * PiecewisePowerLaw: with a constant part up to the floor of the velocity, or
   * without it, as fits better; a quarter of the runs lies beyond it.
   *
   * @throws InputError as fit_power_law(), or if no input has the symbol v
   */
  PowerLaw
  fit_velocity_law(const FrictionLaw &law);

  /** "mu = 2.31 p^-0.12 v^-0.05 T^-0.2 (SI), p >= 3e+08, ..." */
  std::string
  to_string(const PowerLaw &power_law, const std::vector<LawInput> &inputs);
} // namespace asperity

#endif
