#ifndef asperity_isogeometric_bernstein_h
#define asperity_isogeometric_bernstein_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
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
   * The tensor-product Bernstein polynomials of the unit cell at points of it,
   * the first direction fastest: values at [q][b], gradients alike.
   */
  template <int dim>
  struct BernsteinTable
  {
    BernsteinTable(const unsigned int                     degree,
                   const std::vector<dealii::Point<dim>> &points);

    std::vector<std::vector<double>>                 values;
    std::vector<std::vector<dealii::Tensor<1, dim>>> gradients;
  };

  /**
   * Restriction of polynomials of [0, 1] to one of its halves: with
   * coefficients c on [0, 1], the coefficients on the half are
   * d_b = sum_a c_a R(a, b). De Casteljau's subdivision.
   */
  dealii::FullMatrix<double>
  bernstein_half(const unsigned int degree, const bool right);

  /** A square matrix for each direction of a tensor product. */
  template <int dim>
  using DirectionMatrices = std::array<const dealii::FullMatrix<double> *, dim>;

  /** The same matrix in all directions. */
  template <int dim>
  DirectionMatrices<dim>
  in_all_directions(const dealii::FullMatrix<double> &matrix)
  {
    DirectionMatrices<dim> result;
    result.fill(&matrix);
    return result;
  }

  /**
   * Rows of `coefficients` are tensor-product coefficients, the first direction
   * fastest; each row c becomes d with d_(.., b_y, b_x) = sum over the a of
   * c_(.., a_y, a_x) times the product of the matrices' (a_x, b_x), (a_y, b_y),
   * ...
   */
  template <int dim>
  dealii::FullMatrix<double>
  tensor_transform(const dealii::FullMatrix<double> &coefficients,
                   const DirectionMatrices<dim>     &matrices);

  /** base to the power of dim: the number of functions of a tensor product. */
  template <int dim>
  constexpr unsigned int
  tensor_size(const unsigned int base)
  {
    unsigned int size = 1;
    for (int d = 0; d < dim; ++d)
      size *= base;
    return size;
  }

  /** The digits of a number of a tensor product with the same base in all
   *  directions, the first direction fastest. */
  template <int dim>
  std::array<unsigned int, dim>
  tensor_index(unsigned int number, const unsigned int base)
  {
    std::array<unsigned int, dim> index;
    for (unsigned int &digit : index)
      {
        digit = number % base;
        number /= base;
      }
    return index;
  }
} // namespace asperity

#endif
