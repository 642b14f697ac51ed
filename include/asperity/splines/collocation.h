#ifndef asperity_splines_collocation_h
#define asperity_splines_collocation_h

#include <asperity/splines/banded_solver.h>
#include <asperity/splines/knot_vector.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace asperity
{
  /** The basis at one datum; control points of the next turn are folded into
   *  the datum, which turns the fit into one of periodic coefficients. */
  struct CollocationRow
  {
    std::vector<unsigned int> functions;
    std::vector<double>       values;
    dealii::Tensor<1, 2>      target;
  };

  /**
   * One row a datum. Parameters of a periodic basis may lie in any turn.
   * @throws InputError if there are not as many parameters as points, or if one
   * is not finite.
   */
  std::vector<CollocationRow>
  collocation(const KnotVector                    &knots,
              const std::vector<dealii::Point<2>> &points,
              const std::vector<double>           &parameters,
              const dealii::Tensor<1, 2>          &period);

  /**
   * The bending term, `bending` times the integral of |C''(t)|^2 dt, as a sum
   * of squares as the data are: second derivatives of the basis at Gauss points
   * @param weights those of the rows are appended
   */
  std::vector<CollocationRow>
  bending_rows(const KnotVector           &knots,
               const double                bending,
               const dealii::Tensor<1, 2> &period,
               std::vector<double>        &weights);

  /** The matrix, not yet factorised, of weighted least squares. */
  BandedSolver
  normal_equations(const KnotVector                  &knots,
                   const std::vector<CollocationRow> &rows,
                   const std::vector<double>         &weights);

  /** The datum minus the curve [m]. */
  dealii::Tensor<1, 2>
  residual(const CollocationRow                &row,
           const std::vector<dealii::Point<2>> &control_points);
} // namespace asperity

#endif
