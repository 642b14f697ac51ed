#ifndef asperity_heat_fourier_basis_h
#define asperity_heat_fourier_basis_h

#include <deal.II/base/point.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace asperity
{
  /**
   * The real Fourier functions on the face of a body in dim dimensions, with
   * the period L along the one direction of the face, or with the periods L and
   * W along its two. Those of one direction are
   *
   *   f_0 = 1,  f_{2k-1} = cos(kappa_k x),  f_{2k} = sin(kappa_k x),
   *   kappa_k = 2 pi k/L,  k = 1 .. n,
   *
   * those of two directions all products f_i(x) g_j(y), with i running first
   * and the wave number (kappa_i^2 + kappa_j^2)^(1/2).
   *
   * The projection of a function q on them has the coefficients
   * q_m = norm(m) int q f_m dS, with norm 1/L for f_0 and 2/L for the others in
   * one direction, and the product of both in two.
   */
  template <int dim>
  class FourierBasis
  {
  public:
    /** A number for each direction of the face. */
    template <typename Number>
    using Directions = std::array<Number, dim - 1>;

    /** @param periods [m]
     *  @param n_waves of the shortest wave in a period; 0: the mean alone */
    FourierBasis(const Directions<double>       &periods,
                 const Directions<unsigned int> &n_waves);

    /** Number of functions, the product of 1 + 2 n. */
    unsigned int
    size() const;

    /** Of one period [m^(dim - 1)]. */
    double
    area() const;

    /** kappa of a function [1/m]. */
    double
    wave_number(const unsigned int m) const;

    /** See above [1/m^(dim - 1)]. */
    double
    norm(const unsigned int m) const;

    /** Those of one direction, f_i(x_q) as entry (q, i), at any places. */
    dealii::LAPACKFullMatrix<double>
    values(const std::vector<dealii::Point<dim - 1>> &places,
           const unsigned int                         direction) const;

  private:
    /** The number of a function in each direction. */
    Directions<unsigned int>
    numbers(unsigned int m) const;

    Directions<double>       periods;
    Directions<unsigned int> n_waves;
  };

  /** Where points are along a face that is normal to the last axis [m]. */
  template <int dim>
  std::vector<dealii::Point<dim - 1>>
  places_along(const std::vector<dealii::Point<dim>> &positions);

  /**
   * The functions of a FourierBasis at points. In two directions they are kept
   * as factors, so that sums over N points and M functions take N M^(1/2)
   * numbers, and products of matrices.
   */
  template <int dim>
  class FourierValues
  {
  public:
    using Vector = dealii::Vector<double>;

    FourierValues(const FourierBasis<dim>                   &basis,
                  const std::vector<dealii::Point<dim - 1>> &places);

    unsigned int
    n_points() const;

    /** f_m(x_q) */
    double
    operator()(const unsigned int q, const unsigned int m) const;

    /** sum_m f_m(x_q) c_m for each point. */
    Vector
    at_points(const Vector &coefficients) const;

    /** sum_q f_m(x_q) w_q for each function. */
    Vector
    sums(const Vector &weights) const;

  private:
    /** By direction, see FourierBasis::values(). */
    std::array<dealii::LAPACKFullMatrix<double>, dim - 1> factors;
  };
} // namespace asperity

#endif
