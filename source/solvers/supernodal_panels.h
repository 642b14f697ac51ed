#ifndef asperity_source_solvers_supernodal_panels_h
#define asperity_source_solvers_supernodal_panels_h

#include <cstddef>
#include <vector>

/** The numbers of a supernodal factor: what SupernodalStructure has found out
 *  of it, and the loops over it. */
namespace asperity::supernodal
{
  /** A supernode: columns first to first + width, dense in its rows, of which
   *  the first ones are the columns. */
  struct Panel
  {
    unsigned int first = 0, width = 0, n_rows = 0;
    unsigned int stride  = 0; ///< n_rows, padded
    std::size_t  values  = 0; ///< where the panel begins
    std::size_t  rows    = 0; ///< where its row numbers begin
    std::size_t  updates = 0; ///< where the updates of it end
  };

  /** The product of n_rows and the n_columns first of them of a panel, to be
   *  subtracted from a later one. */
  struct Update
  {
    std::size_t  values = 0; ///< first row in the first column of the source
    unsigned int stride = 0, width = 0; ///< of the source
    unsigned int n_rows = 0, n_columns = 0;
    std::size_t  relative = 0; ///< where the places of the rows begin
  };

  /** Makes the factor of the matrix that stands in the panels.
   *  @param relative places of the updates' rows in the panel updated
   *  @return false if the matrix is not positive definite */
  bool
  factorize(const std::vector<Panel>  &panels,
            const std::vector<Update> &updates,
            const unsigned int        *relative,
            double                    *values);

  /** Makes the factors of A = L U, the diagonal of U is one, out of the lower
   *  triangles of A and A^T that stand in the panels of L and U^T.
   *  @return the largest |L_ij U_jk|, infinite if a pivot is zero or not
   *   finite */
  double
  factorize(const std::vector<Panel>  &panels,
            const std::vector<Update> &updates,
            const unsigned int        *relative,
            double                    *lower,
            double                    *upper);

  /** x = L^-1 x.
   *  @param rows row numbers of all panels
   *  @param work as long as the longest stride */
  void
  substitute_forward(const std::vector<Panel> &panels,
                     const unsigned int       *rows,
                     const double             *values,
                     double                   *work,
                     double                   *x);

  /** x = L^-T x. */
  void
  substitute_backward(const std::vector<Panel> &panels,
                      const unsigned int       *rows,
                      const double             *values,
                      double                   *work,
                      double                   *x);
} // namespace asperity::supernodal

#endif
