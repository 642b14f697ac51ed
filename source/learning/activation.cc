#include <asperity/base/vector_widths.h>
#include <asperity/learning/activation.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    // Each loop writes both results, so that it has no jumps and becomes vector
    // instructions; derivatives that nobody wants go to a row of their own.
    template <typename Number>
    inline void
    activate_row(const Activation  activation,
                 const std::size_t n,
                 Number           *y,
                 Number           *d)
    {
      switch (activation)
        {
          case Activation::identity:
            std::fill_n(d, n, Number(1));
            break;
          case Activation::relu:
            for (std::size_t i = 0; i < n; ++i)
              {
                d[i] = y[i] > Number(0) ? Number(1) : Number(0);
                y[i] *= d[i];
              }
            break;
          case Activation::tanh:
            for (std::size_t i = 0; i < n; ++i)
              {
                y[i] = std::tanh(y[i]);
                d[i] = Number(1) - y[i] * y[i];
              }
            break;
          case Activation::softplus:
            for (std::size_t i = 0; i < n; ++i)
              {
                const Number e   = std::exp(-std::abs(y[i]));
                const Number up  = Number(1) / (Number(1) + e);
                const bool   pos = y[i] > Number(0);
                d[i]             = pos ? up : Number(1) - up;
                y[i] = (pos ? y[i] : Number(0)) + std::log(Number(1) + e);
              }
            break;
          case Activation::sine:
            for (std::size_t i = 0; i < n; ++i)
              {
                d[i] = std::cos(y[i]);
                y[i] = std::sin(y[i]);
              }
            break;
        }
    }



    ASPERITY_ALL_VECTOR_WIDTHS ASPERITY_INLINE_ALL void
    activate_floats(const Activation  activation,
                    const std::size_t n,
                    float            *y,
                    float            *d)
    {
      activate_row(activation, n, y, d);
    }



    ASPERITY_ALL_VECTOR_WIDTHS ASPERITY_INLINE_ALL void
    activate_doubles(const Activation  activation,
                     const std::size_t n,
                     double           *y,
                     double           *d)
    {
      activate_row(activation, n, y, d);
    }



    void
    activate_numbers(const Activation  activation,
                     const std::size_t n,
                     float            *y,
                     float            *d)
    {
      activate_floats(activation, n, y, d);
    }



    void
    activate_numbers(const Activation  activation,
                     const std::size_t n,
                     double           *y,
                     double           *d)
    {
      activate_doubles(activation, n, y, d);
    }
  } // namespace



  std::string
  name_of(const Activation activation)
  {
    switch (activation)
      {
        case Activation::identity:
          return "none";
        case Activation::relu:
          return "ReLU";
        case Activation::tanh:
          return "tanh";
        case Activation::softplus:
          return "softplus";
        case Activation::sine:
          return "sine";
      }
    return "";
  }



  template <typename Number>
  void
  activate(const Activation  activation,
           const std::size_t rows,
           const std::size_t columns,
           const std::size_t stride,
           Number           *values,
           Number           *derivatives)
  {
    constexpr std::size_t part = 256;

    // without gaps the matrix is one long column
    const bool        has_gaps  = stride != rows;
    const std::size_t n_rows    = has_gaps ? rows : rows * columns;
    const std::size_t n_columns = has_gaps ? columns : 1;
    Number            unwanted[part];
    for (std::size_t j = 0; j < n_columns; ++j)
      for (std::size_t i = 0; i < n_rows; i += part)
        activate_numbers(activation,
                         std::min(part, n_rows - i),
                         values + j * stride + i,
                         derivatives == nullptr ? unwanted :
                                                  derivatives + j * n_rows + i);
  }



  template void
  activate(const Activation,
           const std::size_t,
           const std::size_t,
           const std::size_t,
           float *,
           float *);
  template void
  activate(const Activation,
           const std::size_t,
           const std::size_t,
           const std::size_t,
           double *,
           double *);
} // namespace asperity
