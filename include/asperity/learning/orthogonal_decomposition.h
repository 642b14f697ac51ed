#ifndef asperity_learning_orthogonal_decomposition_h
#define asperity_learning_orthogonal_decomposition_h

#include <cstddef>
#include <vector>

namespace asperity
{
  /**
   * Proper orthogonal decomposition of snapshots (Sirovich 1987): with their
   * mean s and the inner product (a, b) = sum over k of w_k a_k b_k,
   *
   *   s_i = s + sum over j of c_ij phi_j,  (phi_i, phi_j) = delta_ij,
   *
   * the modes phi_j being left singular vectors of the weighted deviations. No
   * other r modes have a smaller sum of squared errors over the snapshots than
   * the first r, and it is that of the squares of the other singular values
   * (Eckart and Young 1936). By LAPACK's dgesdd, so that small singular values
   * are exact, too.
   */
  class OrthogonalDecomposition
  {
  public:
    /**
     * @param snapshots one after the other, all of one length
     * @param n_snapshots at least 1
     * @param weights of the inner product, positive; 1 if there are none
     * @throws InputError if the numbers do not agree or are none,
     *   ComputationError if LAPACK fails
     */
    OrthogonalDecomposition(const std::vector<double> &snapshots,
                            const std::size_t          n_snapshots,
                            const std::vector<double> &weights = {});

    std::size_t
    n_modes() const
    {
      return singular_values_.size();
    }

    /** Length of a snapshot. */
    std::size_t
    size() const
    {
      return mean_.size();
    }

    const std::vector<double> &
    mean() const
    {
      return mean_;
    }

    /** Descending; their squares sum up to that of all deviations' norms. */
    const std::vector<double> &
    singular_values() const
    {
      return singular_values_;
    }

    /** Of a mode, size() numbers. */
    const double *
    mode(const std::size_t i) const
    {
      return modes.data() + i * size();
    }

    /** Coefficients of a field in the first modes.
     *  @throws InputError if the field has another length or there are fewer
     *   modes */
    std::vector<double>
    project(const std::vector<double> &field, const std::size_t n) const;

    /** Field of as many coefficients. @throws InputError if there are more
     *  than modes */
    std::vector<double>
    reconstruct(const std::vector<double> &coefficients) const;

    /** Root of the sum over the snapshots of squared errors with n modes. */
    double
    truncation_error(const std::size_t n) const;

  private:
    std::vector<double> mean_, weights, modes, singular_values_;
  };
} // namespace asperity

#endif
