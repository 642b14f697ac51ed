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



  BernsteinTable::BernsteinTable(const unsigned int                   degree,
                                 const std::vector<dealii::Point<2>> &points)
  {
    const unsigned int  n = degree + 1;
    std::vector<double> value_x, derivative_x, value_y, derivative_y;
    for (const auto &point : points)
      {
        bernstein(degree, point[0], value_x, derivative_x);
        bernstein(degree, point[1], value_y, derivative_y);
        values.emplace_back(n * n);
        gradients.emplace_back(n * n);
        for (unsigned int b_y = 0; b_y < n; ++b_y)
          for (unsigned int b_x = 0; b_x < n; ++b_x)
            {
              const unsigned int b   = b_y * n + b_x;
              values.back()[b]       = value_x[b_x] * value_y[b_y];
              gradients.back()[b][0] = derivative_x[b_x] * value_y[b_y];
              gradients.back()[b][1] = value_x[b_x] * derivative_y[b_y];
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



  dealii::FullMatrix<double>
  tensor_transform(const dealii::FullMatrix<double> &coefficients,
                   const dealii::FullMatrix<double> &x,
                   const dealii::FullMatrix<double> &y)
  {
    // Matrices are stored by rows; plain pointers keep debug builds bearable.
    const unsigned int         n = x.m();
    dealii::FullMatrix<double> result(coefficients.m(), n * n);
    if (coefficients.m() == 0)
      return result;
    const double       *X = &x(0, 0), *Y = &y(0, 0);
    std::vector<double> half(n * n);
    for (unsigned int row = 0; row < coefficients.m(); ++row)
      {
        const double *from = &coefficients(row, 0);
        double       *to   = &result(row, 0);
        std::fill(half.begin(), half.end(), 0.);
        for (unsigned int a_y = 0; a_y < n; ++a_y)
          for (unsigned int a_x = 0; a_x < n; ++a_x)
            if (const double c = from[a_y * n + a_x]; c != 0.)
              for (unsigned int b_x = 0; b_x < n; ++b_x)
                half[a_y * n + b_x] += c * X[a_x * n + b_x];
        for (unsigned int a_y = 0; a_y < n; ++a_y)
          for (unsigned int b_y = 0; b_y < n; ++b_y)
            if (const double c = Y[a_y * n + b_y]; c != 0.)
              for (unsigned int b_x = 0; b_x < n; ++b_x)
                to[b_y * n + b_x] += c * half[a_y * n + b_x];
      }
    return result;
  }
} // namespace asperity
