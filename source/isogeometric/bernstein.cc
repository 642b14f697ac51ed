#include <asperity/isogeometric/bernstein.h>

#include <algorithm>

namespace asperity
{
  void
  bernstein(const unsigned int   degree,
            const double         t,
            std::vector<double> &values,
            std::vector<double> &derivatives)
  {
    values.assign(degree + 1, 0.);
    derivatives.assign(degree + 1, 0.);
    values[0] = 1.;
    for (unsigned int k = 1; k <= degree; ++k)
      {
        // Before the last elevation the values are those of degree - 1, of
        // which the derivatives are differences.
        if (k == degree)
          for (unsigned int b = 0; b <= degree; ++b)
            derivatives[b] = degree * ((b > 0 ? values[b - 1] : 0.) -
                                       (b < degree ? values[b] : 0.));
        double carried = 0.;
        for (unsigned int b = 0; b < k; ++b)
          {
            const double value = values[b];
            values[b]          = carried + (1. - t) * value;
            carried            = t * value;
          }
        values[k] = carried;
      }
  }



  template <int dim>
  BernsteinTable<dim>::BernsteinTable(
    const unsigned int                     degree,
    const std::vector<dealii::Point<dim>> &points)
  {
    const unsigned int                   n   = degree + 1;
    const unsigned int                   n_b = tensor_size<dim>(n);
    std::array<std::vector<double>, dim> value, derivative;
    for (const auto &point : points)
      {
        for (unsigned int d = 0; d < dim; ++d)
          bernstein(degree, point[d], value[d], derivative[d]);
        values.emplace_back(n_b);
        gradients.emplace_back(n_b);
        for (unsigned int b = 0; b < n_b; ++b)
          {
            const auto index   = tensor_index<dim>(b, n);
            double     product = 1.;
            for (unsigned int d = 0; d < dim; ++d)
              product *= value[d][index[d]];
            values.back()[b] = product;
            for (unsigned int e = 0; e < dim; ++e)
              {
                double factor = 1.;
                for (unsigned int d = 0; d < dim; ++d)
                  factor *= (d == e ? derivative : value)[d][index[d]];
                gradients.back()[b][e] = factor;
              }
          }
      }
  }



  dealii::FullMatrix<double>
  bernstein_half(const unsigned int degree, const bool right)
  {
    // On the left half coefficient b is the mean of c_0 .. c_b with the
    // binomial weights of (1/2 + 1/2)^b; the right half is its mirror image.
    dealii::FullMatrix<double> restriction(degree + 1, degree + 1);
    std::vector<double>        weights, unused;
    for (unsigned int b = 0; b <= degree; ++b)
      {
        bernstein(b, 0.5, weights, unused);
        for (unsigned int a = 0; a <= b; ++a)
          if (right)
            restriction(degree - a, degree - b) = weights[a];
          else
            restriction(a, b) = weights[a];
      }
    return restriction;
  }



  template <int dim>
  dealii::FullMatrix<double>
  tensor_transform(const dealii::FullMatrix<double> &coefficients,
                   const DirectionMatrices<dim>     &matrices)
  {
    // Matrices are stored by rows; plain pointers keep debug builds bearable.
    const unsigned int         n      = matrices[0]->m();
    const unsigned int         n_all  = tensor_size<dim>(n);
    const unsigned int         n_rest = n_all / n;
    dealii::FullMatrix<double> result(coefficients.m(), n_all);
    if (coefficients.m() == 0)
      return result;
    std::vector<double> from(n_all), to(n_all);
    for (unsigned int row = 0; row < coefficients.m(); ++row)
      {
        const double *given = &coefficients(row, 0);
        std::copy(given, given + n_all, from.begin());
        // The transformed direction becomes the slowest, so that the next one
        // is the fastest; after all the order is the old one.
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double *M = &(*matrices[d])(0, 0);
            std::fill(to.begin(), to.end(), 0.);
            for (unsigned int rest = 0; rest < n_rest; ++rest)
              for (unsigned int a = 0; a < n; ++a)
                if (const double c = from[rest * n + a]; c != 0.)
                  for (unsigned int b = 0; b < n; ++b)
                    to[b * n_rest + rest] += c * M[a * n + b];
            from.swap(to);
          }
        std::copy(from.begin(), from.end(), &result(row, 0));
      }
    return result;
  }



  template struct BernsteinTable<1>;
  template struct BernsteinTable<2>;
  template struct BernsteinTable<3>;

  template dealii::FullMatrix<double>
  tensor_transform<1>(const dealii::FullMatrix<double> &,
                      const DirectionMatrices<1> &);
  template dealii::FullMatrix<double>
  tensor_transform<2>(const dealii::FullMatrix<double> &,
                      const DirectionMatrices<2> &);
  template dealii::FullMatrix<double>
  tensor_transform<3>(const dealii::FullMatrix<double> &,
                      const DirectionMatrices<3> &);
} // namespace asperity
