#include <asperity/base/neighbours.h>
#include <asperity/base/vector_widths.h>
#include <asperity/heat/fourier_basis.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace asperity
{
  using dealii::Point;
  using Factor = dealii::LAPACKFullMatrix<double>;
  using Vector = dealii::Vector<double>;

  template <int dim>
  FourierBasis<dim>::FourierBasis(const Directions<double>       &periods,
                                  const Directions<unsigned int> &n_waves)
    : periods(periods)
    , n_waves(n_waves)
  {}



  template <int dim>
  unsigned int
  FourierBasis<dim>::size() const
  {
    unsigned int n = 1;
    for (const unsigned int waves : n_waves)
      n *= 1 + 2 * waves;
    return n;
  }



  template <int dim>
  double
  FourierBasis<dim>::area() const
  {
    double product = 1.;
    for (const double period : periods)
      product *= period;
    return product;
  }



  template <int dim>
  typename FourierBasis<dim>::template Directions<unsigned int>
  FourierBasis<dim>::numbers(unsigned int m) const
  {
    Directions<unsigned int> result;
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        result[d] = m % (1 + 2 * n_waves[d]);
        m /= 1 + 2 * n_waves[d];
      }
    return result;
  }



  namespace
  {
    /** kappa of a function of one direction [1/m]. */
    double
    wave_number_along(const double period, const unsigned int number)
    {
      return 2. * dealii::numbers::PI * ((number + 1) / 2) / period;
    }
  } // namespace



  template <int dim>
  double
  FourierBasis<dim>::wave_number(const unsigned int m) const
  {
    const auto n     = numbers(m);
    double     kappa = wave_number_along(periods[0], n[0]);
    if constexpr (dim == 3)
      kappa = std::hypot(kappa, wave_number_along(periods[1], n[1]));
    return kappa;
  }



  template <int dim>
  double
  FourierBasis<dim>::norm(const unsigned int m) const
  {
    double product = 1.;
    for (unsigned int d = 0; d < dim - 1; ++d)
      product *= (numbers(m)[d] == 0 ? 1. : 2.) / periods[d];
    return product;
  }



  namespace
  {
    using neighbours::at;
    using neighbours::width;

    /** Cosines c and sines s of n angles, each turned by one of others. */
    ASPERITY_ALL_VECTOR_WIDTHS void
    turn(const unsigned int n,
         const double      *cosine,
         const double      *sine,
         const double      *c,
         const double      *s,
         double            *turned_c,
         double            *turned_s)
    {
      unsigned int q = 0;
      for (; q + width <= n; q += width)
        {
          at(turned_c + q) =
            at(c + q) * at(cosine + q) - at(s + q) * at(sine + q);
          at(turned_s + q) =
            at(s + q) * at(cosine + q) + at(c + q) * at(sine + q);
        }
      for (; q < n; ++q)
        {
          turned_c[q] = c[q] * cosine[q] - s[q] * sine[q];
          turned_s[q] = s[q] * cosine[q] + c[q] * sine[q];
        }
    }
  } // namespace



  template <int dim>
  Factor
  FourierBasis<dim>::values(const std::vector<Point<dim - 1>> &places,
                            const unsigned int                 direction) const
  {
    const unsigned int n = places.size(), waves = n_waves[direction];
    Factor             f(n, 1 + 2 * waves);
    for (unsigned int q = 0; q < n; ++q)
      f(q, 0) = 1.;
    if (waves == 0 || n == 0)
      return f;
    const double kappa = wave_number_along(periods[direction], 1);
    for (unsigned int q = 0; q < n; ++q)
      {
        f(q, 1) = std::cos(kappa * places[q][direction]);
        f(q, 2) = std::sin(kappa * places[q][direction]);
      }
    // Down the columns, in which the matrix is stored. Each wave turns by the
    // first: powers of a number of modulus one lose a digit in a thousand.
    for (unsigned int k = 2; k <= waves; ++k)
      turn(n,
           &f(0, 1),
           &f(0, 2),
           &f(0, 2 * k - 3),
           &f(0, 2 * k - 2),
           &f(0, 2 * k - 1),
           &f(0, 2 * k));
    return f;
  }



  template <int dim>
  std::vector<Point<dim - 1>>
  places_along(const std::vector<Point<dim>> &positions)
  {
    std::vector<Point<dim - 1>> places(positions.size());
    for (unsigned int q = 0; q < places.size(); ++q)
      for (unsigned int d = 0; d < dim - 1; ++d)
        places[q][d] = positions[q][d];
    return places;
  }



  template <int dim>
  FourierValues<dim>::FourierValues(const FourierBasis<dim>           &basis,
                                    const std::vector<Point<dim - 1>> &places)
  {
    for (unsigned int d = 0; d < dim - 1; ++d)
      factors[d] = basis.values(places, d);
  }



  template <int dim>
  unsigned int
  FourierValues<dim>::n_points() const
  {
    return factors[0].m();
  }



  template <int dim>
  double
  FourierValues<dim>::operator()(const unsigned int q,
                                 const unsigned int m) const
  {
    const unsigned int n = factors[0].n();
    double             f = factors[0](q, m % n);
    if constexpr (dim == 3)
      f *= factors[1](q, m / n);
    return f;
  }



  template <>
  Vector
  FourierValues<2>::at_points(const Vector &coefficients) const
  {
    Vector result(n_points());
    factors[0].vmult(result, coefficients);
    return result;
  }



  template <>
  Vector
  FourierValues<2>::sums(const Vector &weights) const
  {
    Vector result(factors[0].n());
    factors[0].Tvmult(result, weights);
    return result;
  }



  template <>
  Vector
  FourierValues<3>::at_points(const Vector &coefficients) const
  {
    const unsigned int n_x = factors[0].n(), n_y = factors[1].n();
    Factor             c(n_x, n_y), sums_over_x(n_points(), n_y);
    for (unsigned int j = 0; j < n_y; ++j)
      for (unsigned int i = 0; i < n_x; ++i)
        c(i, j) = coefficients(i + j * n_x);
    factors[0].mmult(sums_over_x, c);
    Vector result(n_points());
    for (unsigned int j = 0; j < n_y; ++j)
      for (unsigned int q = 0; q < result.size(); ++q)
        result(q) += sums_over_x(q, j) * factors[1](q, j);
    return result;
  }



  template <>
  Vector
  FourierValues<3>::sums(const Vector &weights) const
  {
    const unsigned int n_x = factors[0].n(), n_y = factors[1].n();
    Factor             weighted(n_points(), n_y), products(n_x, n_y);
    for (unsigned int j = 0; j < n_y; ++j)
      for (unsigned int q = 0; q < n_points(); ++q)
        weighted(q, j) = weights(q) * factors[1](q, j);
    factors[0].Tmmult(products, weighted);
    Vector result(n_x * n_y);
    for (unsigned int j = 0; j < n_y; ++j)
      for (unsigned int i = 0; i < n_x; ++i)
        result(i + j * n_x) = products(i, j);
    return result;
  }



  template class FourierBasis<2>;
  template class FourierBasis<3>;
  template class FourierValues<2>;
  template class FourierValues<3>;
  template std::vector<Point<1>>
  places_along(const std::vector<Point<2>> &);
  template std::vector<Point<2>>
  places_along(const std::vector<Point<3>> &);
} // namespace asperity
