#include <asperity/base/neighbours.h>
#include <asperity/base/vector_widths.h>
#include <asperity/solid/element_stiffness.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    using neighbours::alternate;
    using neighbours::at;
    using neighbours::Pack;
    using neighbours::width;

    constexpr unsigned int group_size = ElementGradients<2>::group_size;

    /** Row of dP_iJ/dF of a point times weight and gradients, for one i and J:
     *  [2 b + l]. */
    template <unsigned int n_components>
    void
    fill_column(const dealii::Tensor<2, 3> &by_F,
                const double                weight,
                const unsigned int          stride,
                const double               *gradients,
                double                     *column)
    {
      Pack factor[n_components];
      for (unsigned int M = 0; M < n_components; ++M)
        factor[M] = weight * (M < 2 ? alternate(by_F[0][M], by_F[1][M]) :
                                      alternate(by_F[2][2], 0.));
      for (unsigned int k = 0; k < stride; k += width)
        {
          Pack sum = factor[0] * at(gradients + k);
          for (unsigned int M = 1; M < n_components; ++M)
            sum += factor[M] * at(gradients + M * stride + k);
          at(column + k) = sum;
        }
    }



    /** K_a,2b+l += sum over points and components J of gradient_a column_b */
    template <unsigned int n_terms>
    void
    add_products(const unsigned int n,
                 const unsigned int stride,
                 const double      *gradients,
                 const double      *columns,
                 const bool         is_first,
                 double            *K)
    {
      for (unsigned int k = 0; k < stride; k += width)
        {
          Pack column[n_terms];
          for (unsigned int t = 0; t < n_terms; ++t)
            column[t] = at(columns + t * stride + k);
          for (unsigned int a = 0; a < n; ++a)
            {
              Pack sum = is_first ? Pack{} : at(K + a * stride + k);
              for (unsigned int t = 0; t < n_terms; ++t)
                sum += gradients[t * stride + 2 * a] * column[t];
              at(K + a * stride + k) = sum;
            }
        }
    }



    template <unsigned int n_components>
    void
    integrate_group(const unsigned int      n,
                    const unsigned int      stride,
                    const unsigned int      n_points,
                    const double           *gradients,
                    const double           *weights,
                    const MaterialResponse *responses,
                    const bool              is_first,
                    double *const          *columns,
                    double *const          *K)
    {
      constexpr unsigned int n_terms = group_size * n_components;
      for (unsigned int i = 0; i < 2; ++i)
        {
          for (unsigned int q = 0; q < n_points; ++q)
            for (unsigned int J = 0; J < n_components; ++J)
              {
                const unsigned int t = q * n_components + J;
                if (J == 2 && i == 1)
                  std::fill_n(columns[i] + t * stride, stride, 0.);
                else
                  fill_column<n_components>(
                    responses[q].tangent[J == 2 ? 2 : i][J],
                    weights[q],
                    stride,
                    gradients + q * n_components * stride,
                    columns[i] + t * stride);
              }
          std::fill(columns[i] + n_points * n_components * stride,
                    columns[i] + n_terms * stride,
                    0.);
          add_products<n_terms>(
            n, stride, gradients, columns[i], is_first, K[i]);
        }
    }



    ASPERITY_ALL_VECTOR_WIDTHS ASPERITY_INLINE_ALL void
    integrate_group(const unsigned int      n_components,
                    const unsigned int      n,
                    const unsigned int      stride,
                    const unsigned int      n_points,
                    const double           *gradients,
                    const double           *weights,
                    const MaterialResponse *responses,
                    const bool              is_first,
                    double *const          *columns,
                    double *const          *K)
    {
      if (n_components == 2)
        integrate_group<2>(n,
                           stride,
                           n_points,
                           gradients,
                           weights,
                           responses,
                           is_first,
                           columns,
                           K);
      else
        integrate_group<3>(n,
                           stride,
                           n_points,
                           gradients,
                           weights,
                           responses,
                           is_first,
                           columns,
                           K);
    }
  } // namespace



  template <>
  void
  ElementStiffness<2>::integrate(const ElementGradients<2> &gradients,
                                 const double              *weights,
                                 const MaterialResponse    *responses)
  {
    n      = gradients.n_functions();
    stride = gradients.size();
    double *column_of[2], *K[2];
    for (unsigned int i = 0; i < 2; ++i)
      {
        columns[i].resize(group_size * gradients.n_components() * stride);
        blocks[i].resize(n * stride);
        column_of[i] = columns[i].data();
        K[i]         = blocks[i].data();
      }
    for (unsigned int q = 0; q < gradients.n_points(); q += group_size)
      integrate_group(gradients.n_components(),
                      n,
                      stride,
                      std::min(group_size, gradients.n_points() - q),
                      gradients.from_point(q),
                      weights + q,
                      responses + q,
                      q == 0,
                      column_of,
                      K);
  }
} // namespace asperity
