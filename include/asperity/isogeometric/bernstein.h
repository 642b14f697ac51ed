#ifndef asperity_isogeometric_bernstein_h
#define asperity_isogeometric_bernstein_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace asperity
{
  /**
   * The degree + 1 Bernstein polynomials on [0, 1] at t and their first
   * derivatives; t may lie outside. Piegl and Tiller, The NURBS Book, 2nd ed.,
   * equation (1.8) and algorithm A1.3.
   */
  void
  bernstein(const unsigned int   degree,
            const double         t,
            std::vector<double> &values,
            std::vector<double> &derivatives);

  /**
   * The tensor-product Bernstein polynomials of the unit square at points of
   * it, index b = b_y (degree + 1) + b_x: values at [q][b], gradients alike.
   */
  struct BernsteinTable
  {
    BernsteinTable(const unsigned int                   degree,
                   const std::vector<dealii::Point<2>> &points);

    std::vector<std::vector<double>>               values;
    std::vector<std::vector<dealii::Tensor<1, 2>>> gradients;
  };

  /**
   * Restriction of polynomials of [0, 1] to one of its halves: with
   * coefficients c on [0, 1], the coefficients on the half are
   * d_b = sum_a c_a R(a, b). De Casteljau's subdivision.
   */
  dealii::FullMatrix<double>
  bernstein_half(const unsigned int degree, const bool right);

  /**
   * Rows of `coefficients` are tensor-product coefficients, x fastest; each
   * row c becomes d with d_(b_y, b_x) = sum c_(a_y, a_x) Y(a_y, b_y) X(a_x,
   * b_x).
   */
  dealii::FullMatrix<double>
  tensor_transform(const dealii::FullMatrix<double> &coefficients,
                   const dealii::FullMatrix<double> &x,
                   const dealii::FullMatrix<double> &y);
} // namespace asperity

#endif
