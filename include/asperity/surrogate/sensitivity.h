#ifndef asperity_surrogate_sensitivity_h
#define asperity_surrogate_sensitivity_h

#include <asperity/surrogate/friction_law.h>

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * Shares of the variance of an output that an input is responsible for, when
   * all inputs are uniformly distributed over their ranges, each on its scale.
   */
  struct SensitivityIndex
  {
    double S1      = 0.; ///< by itself (first order)
    double S1_conf = 0.; ///< half width of its confidence interval
    double ST      = 0.; ///< with all of its interactions (total)
    double ST_conf = 0.;
  };

  struct SensitivityOptions
  {
    /** N; the function is evaluated N (d + 2) times. A power of 2 keeps the
     *  balance of Sobol's points. */
    std::size_t n_points = 4096;

    unsigned int  n_resamples = 200; ///< of the bootstrap
    std::uint64_t seed        = 0;   ///< of the bootstrap
  };

  /** Values of a function at n points of the unit cube, n x d coordinates. */
  using FunctionOfPoints = std::function<
    void(const std::size_t n, const double *unit, double *values)>;

  /**
   * Sobol's indices from the rows A, B of Sobol points in 2 d dimensions and A
   * with column i of B, A_B^i:
   *   S1_i = mean(f(B) (f(A_B^i) - f(A))) / V     (Saltelli et al. 2010, b)
   *   ST_i = mean((f(A) - f(A_B^i))^2) / (2 V)    (Jansen 1999)
   * with f less its mean and V its variance over A and B. The confidence
   * intervals are 1.96 times the standard deviation over resamples of the rows,
   * as SALib has them; they are those of independent points, and Sobol points
   * err less. All indices of a constant function are 0.
   *
   * @throws InputError for more than 20 inputs or fewer than 2 points
   */
  std::vector<SensitivityIndex>
  sensitivity_indices(const unsigned int        n_inputs,
                      const FunctionOfPoints   &function,
                      const SensitivityOptions &options = {});

  /** Of the mean of a law inside its box. */
  std::vector<SensitivityIndex>
  sensitivity_indices(const FrictionLaw        &law,
                      const SensitivityOptions &options = {});

  /**
   * One row an input under the headings of SALib:
   * "input,symbol,S1,S1_conf,ST,ST_conf", after comment lines (#) that say of
   * which output over which ranges.
   */
  void
  write_sensitivity(std::ostream                        &out,
                    const FrictionLawDescription        &description,
                    const std::vector<SensitivityIndex> &indices);

  /** Atomically. @throws ComputationError if it fails */
  void
  write_sensitivity(const std::string                   &path,
                    const FrictionLawDescription        &description,
                    const std::vector<SensitivityIndex> &indices);
} // namespace asperity

#endif
