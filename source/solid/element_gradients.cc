#include <asperity/base/neighbours.h>
#include <asperity/base/vector_widths.h>
#include <asperity/solid/element_gradients.h>

namespace asperity
{
  namespace
  {
    using neighbours::alternate;
    using neighbours::at;
    using neighbours::Pack;
    using neighbours::width;

    /** What the component J of a gradient, 2 being the hoop, multiplies: P_iJ
     *  for the force component i. */
    inline Pack
    stress(const dealii::Tensor<2, 3> &P, const unsigned int J)
    {
      return J < 2 ? alternate(P[0][J], P[1][J]) : alternate(P[2][2], 0.);
    }



    template <unsigned int n_components>
    void
    deform_element(const unsigned int    n_points,
                   const unsigned int    stride,
                   const double         *gradients,
                   const double         *u,
                   dealii::Tensor<2, 3> *F)
    {
      for (unsigned int q = 0; q < n_points; ++q)
        {
          Pack sum[n_components] = {};
          for (unsigned int k = 0; k < stride; k += width)
            for (unsigned int J = 0; J < n_components; ++J)
              sum[J] +=
                at(u + k) * at(gradients + (q * n_components + J) * stride + k);
          for (unsigned int J = 0; J < 2; ++J)
            for (unsigned int i = 0; i < 2; ++i)
              F[q][i][J] = (i == J ? 1. : 0.) + sum[J][i] + sum[J][i + 2];
          F[q][2][2] = 1.;
          if constexpr (n_components == 3)
            F[q][2][2] += sum[2][0] + sum[2][2];
        }
    }



    template <unsigned int n_components>
    void
    add_point_forces(const unsigned int      n_points,
                     const unsigned int      stride,
                     const double           *gradients,
                     const double           *weights,
                     const MaterialResponse *responses,
                     double                 *forces)
    {
      for (unsigned int q = 0; q < n_points; ++q)
        {
          Pack weighted[n_components];
          for (unsigned int J = 0; J < n_components; ++J)
            weighted[J] = weights[q] * stress(responses[q].P, J);
          const double *const of_point = gradients + q * n_components * stride;
          for (unsigned int k = 0; k < stride; k += width)
            {
              Pack sum = at(forces + k);
              for (unsigned int J = 0; J < n_components; ++J)
                sum += weighted[J] * at(of_point + J * stride + k);
              at(forces + k) = sum;
            }
        }
    }



    ASPERITY_ALL_VECTOR_WIDTHS ASPERITY_INLINE_ALL void
    deform_element(const unsigned int    n_components,
                   const unsigned int    n_points,
                   const unsigned int    stride,
                   const double         *gradients,
                   const double         *u,
                   dealii::Tensor<2, 3> *F)
    {
      if (n_components == 2)
        deform_element<2>(n_points, stride, gradients, u, F);
      else
        deform_element<3>(n_points, stride, gradients, u, F);
    }



    ASPERITY_ALL_VECTOR_WIDTHS ASPERITY_INLINE_ALL void
    add_point_forces(const unsigned int      n_components,
                     const unsigned int      n_points,
                     const unsigned int      stride,
                     const double           *gradients,
                     const double           *weights,
                     const MaterialResponse *responses,
                     double                 *forces)
    {
      if (n_components == 2)
        add_point_forces<2>(
          n_points, stride, gradients, weights, responses, forces);
      else
        add_point_forces<3>(
          n_points, stride, gradients, weights, responses, forces);
    }
  } // namespace



  template <>
  ElementGradients<2>::ElementGradients(const unsigned int n_functions,
                                        const unsigned int n_points,
                                        const bool         axisymmetric)
    : n(n_functions)
    , row_length_(neighbours::padded(2 * n))
    , n_points_(n_points)
    , n_components_(axisymmetric ? 3 : 2)
    , values((n_points + group_size - 1) / group_size * group_size *
               n_components_ * row_length_,
             0.)
  {}



  template <>
  void
  ElementGradients<2>::set(const unsigned int          point,
                           const unsigned int          a,
                           const dealii::Tensor<1, 2> &gradient,
                           const double                hoop)
  {
    double *const first = &values[point * n_components_ * row_length_ + 2 * a];
    for (unsigned int J = 0; J < 2; ++J)
      first[J * row_length_] = first[J * row_length_ + 1] = gradient[J];
    // Radial displacements alone stretch the hoop.
    if (n_components_ == 3)
      first[2 * row_length_] = hoop;
  }



  template <>
  void
  ElementGradients<2>::deform(const double *u, dealii::Tensor<2, 3> *F) const
  {
    deform_element(n_components_, n_points_, row_length_, values.data(), u, F);
  }



  template <>
  void
  ElementGradients<2>::add_forces(const double           *weights,
                                  const MaterialResponse *responses,
                                  double                 *forces) const
  {
    add_point_forces(n_components_,
                     n_points_,
                     row_length_,
                     values.data(),
                     weights,
                     responses,
                     forces);
  }
} // namespace asperity
