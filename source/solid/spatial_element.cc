#include <asperity/base/neighbours.h>
#include <asperity/base/vector_widths.h>
#include <asperity/solid/element_stiffness.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    using neighbours::at;
    using neighbours::Pack;
    using neighbours::width;

    constexpr unsigned int group_size = ElementGradients<3>::group_size;

    ASPERITY_ALL_VECTOR_WIDTHS ASPERITY_INLINE_ALL void
    deform_element(const unsigned int    n_points,
                   const unsigned int    length,
                   const double         *gradients,
                   const double         *u,
                   dealii::Tensor<2, 3> *F)
    {
      for (unsigned int q = 0; q < n_points; ++q)
        for (unsigned int i = 0; i < 3; ++i)
          {
            Pack sum[3] = {};
            for (unsigned int k = 0; k < length; k += width)
              for (unsigned int J = 0; J < 3; ++J)
                sum[J] += at(u + i * length + k) *
                          at(gradients + (3 * q + J) * length + k);
            for (unsigned int J = 0; J < 3; ++J)
              F[q][i][J] = (i == J ? 1. : 0.) + (sum[J][0] + sum[J][1]) +
                           (sum[J][2] + sum[J][3]);
          }
    }



    ASPERITY_ALL_VECTOR_WIDTHS ASPERITY_INLINE_ALL void
    add_point_forces(const unsigned int      n_points,
                     const unsigned int      length,
                     const double           *gradients,
                     const double           *weights,
                     const MaterialResponse *responses,
                     double                 *forces)
    {
      for (unsigned int q = 0; q < n_points; ++q)
        for (unsigned int i = 0; i < 3; ++i)
          {
            const auto  &P        = responses[q].P[i];
            const double stress[] = {weights[q] * P[0],
                                     weights[q] * P[1],
                                     weights[q] * P[2]};
            for (unsigned int k = 0; k < length; k += width)
              for (unsigned int J = 0; J < 3; ++J)
                at(forces + i * length + k) +=
                  stress[J] * at(gradients + (3 * q + J) * length + k);
          }
    }



    /** Row of dP_iJ/dF of a point times weight and gradients, for one i and J:
     *  [l length + b]. */
    inline void
    fill_column(const dealii::Tensor<2, 3> &by_F,
                const double                weight,
                const unsigned int          length,
                const double               *gradients,
                double                     *column)
    {
      for (unsigned int l = 0; l < 3; ++l)
        {
          const double factor[] = {weight * by_F[l][0],
                                   weight * by_F[l][1],
                                   weight * by_F[l][2]};
          for (unsigned int k = 0; k < length; k += width)
            at(column + l * length + k) =
              factor[0] * at(gradients + k) +
              factor[1] * at(gradients + length + k) +
              factor[2] * at(gradients + 2 * length + k);
        }
    }



    /** K_a += sum over points and components J of gradient_a column. */
    inline void
    add_products(const unsigned int n,
                 const unsigned int length,
                 const double      *gradients,
                 const double      *columns,
                 const bool         is_first,
                 double            *K)
    {
      constexpr unsigned int n_terms = 3 * group_size;
      const unsigned int     stride  = 3 * length;
      for (unsigned int k = 0; k < stride; k += width)
        {
          Pack column[n_terms];
          for (unsigned int t = 0; t < n_terms; ++t)
            column[t] = at(columns + t * stride + k);
          for (unsigned int a = 0; a < n; ++a)
            {
              Pack sum = is_first ? Pack{} : at(K + a * stride + k);
              for (unsigned int t = 0; t < n_terms; ++t)
                sum += gradients[t * length + a] * column[t];
              at(K + a * stride + k) = sum;
            }
        }
    }



    ASPERITY_ALL_VECTOR_WIDTHS ASPERITY_INLINE_ALL void
    integrate_group(const unsigned int      n,
                    const unsigned int      length,
                    const unsigned int      n_points,
                    const double           *gradients,
                    const double           *weights,
                    const MaterialResponse *responses,
                    const bool              is_first,
                    double *const          *columns,
                    double *const          *K)
    {
      const unsigned int stride = 3 * length;
      for (unsigned int i = 0; i < 3; ++i)
        {
          for (unsigned int q = 0; q < n_points; ++q)
            for (unsigned int J = 0; J < 3; ++J)
              fill_column(responses[q].tangent[i][J],
                          weights[q],
                          length,
                          gradients + 3 * q * length,
                          columns[i] + (3 * q + J) * stride);
          std::fill(columns[i] + 3 * n_points * stride,
                    columns[i] + 3 * group_size * stride,
                    0.);
          add_products(n, length, gradients, columns[i], is_first, K[i]);
        }
    }
  } // namespace



  template <>
  ElementGradients<3>::ElementGradients(const unsigned int n_functions,
                                        const unsigned int n_points,
                                        const bool)
    : n(n_functions)
    , row_length_(neighbours::padded(n))
    , n_points_(n_points)
    , n_components_(3)
    , values((n_points + group_size - 1) / group_size * group_size * 3 *
               row_length_,
             0.)
  {}



  template <>
  void
  ElementGradients<3>::set(const unsigned int          point,
                           const unsigned int          a,
                           const dealii::Tensor<1, 3> &gradient,
                           const double)
  {
    for (unsigned int J = 0; J < 3; ++J)
      values[(3 * point + J) * row_length_ + a] = gradient[J];
  }



  template <>
  void
  ElementGradients<3>::deform(const double *u, dealii::Tensor<2, 3> *F) const
  {
    deform_element(n_points_, row_length_, values.data(), u, F);
  }



  template <>
  void
  ElementGradients<3>::add_forces(const double           *weights,
                                  const MaterialResponse *responses,
                                  double                 *forces) const
  {
    add_point_forces(
      n_points_, row_length_, values.data(), weights, responses, forces);
  }



  template <>
  void
  ElementStiffness<3>::integrate(const ElementGradients<3> &gradients,
                                 const double              *weights,
                                 const MaterialResponse    *responses)
  {
    n      = gradients.n_functions();
    stride = gradients.size();
    double *column_of[3], *K[3];
    for (unsigned int i = 0; i < 3; ++i)
      {
        columns[i].resize(3 * group_size * stride);
        blocks[i].resize(n * stride);
        column_of[i] = columns[i].data();
        K[i]         = blocks[i].data();
      }
    for (unsigned int q = 0; q < gradients.n_points(); q += group_size)
      integrate_group(n,
                      gradients.row_length(),
                      std::min(group_size, gradients.n_points() - q),
                      gradients.from_point(q),
                      weights + q,
                      responses + q,
                      q == 0,
                      column_of,
                      K);
  }
} // namespace asperity
