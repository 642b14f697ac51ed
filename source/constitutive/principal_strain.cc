#include <asperity/constitutive/principal_strain.h>

#include <cmath>

namespace asperity::hencky
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  namespace
  {
    /** V diag(values) W^T */
    Tensor<2, 3>
    turn_back(const Tensor<2, 3> &V,
              const Tensor<1, 3> &values,
              const Tensor<2, 3> &W)
    {
      Tensor<2, 3> result;
      for (int i = 0; i < 3; ++i)
        for (int J = 0; J < 3; ++J)
          for (int a = 0; a < 3; ++a)
            result[i][J] += V[i][a] * values[a] * W[J][a];
      return result;
    }



    /**
     * Half the divided difference of the logarithm, (ln a - ln b)/(2 (a - b)),
     * of positive numbers. With x = ((a - b)/(a + b))^2 it is f(x)/(a + b),
     * analytic at a = b, where it is 1/(2 a).
     */
    double
    half_logarithm_difference(const double a, const double b)
    {
      const double sum   = a + b;
      const double ratio = (a - b) / sum;
      return logarithm_coefficient(ratio * ratio, 4. * (a / sum) * (b / sum))
               .f /
             sum;
    }



    /**
     * A tensor of fourth order that acts between principal frames,
     *   T_aa = sum_c axial_ac X_cc,
     *   T_ab = same_ab X_ab + swapped_ab X_ba  for a != b.
     */
    struct PrincipalOperator
    {
      Tensor<2, 3> axial, same, swapped;
    };



    /**
     * dP_iJ = V_ia W_Jb T_ab by dF_kL with X_ab = V_ka W_Lb. Since
     * C_p^{-1} F^T V = W diag(b_a), the strain changes in the principal frame
     * by deps_aa = X_aa,  deps_ab = g_ab (b_b X_ab + b_a X_ba), where 2 g_ab is
     * the divided difference of the logarithm; and P dF^T changes dP by -tau_a
     * X_ba.
     */
    PrincipalOperator
    principal_operator(const PrincipalTangent &c,
                       const Tensor<1, 3>     &tau,
                       const Tensor<1, 3>     &b)
    {
      PrincipalOperator T;
      for (int m = 0; m < 3; ++m)
        for (int n = 0; n < 3; ++n)
          {
            T.axial[m][n] = c.volumetric + c.radial * c.s[m] * c.s[n];
            if (m == n)
              {
                T.axial[m][m] += c.shear - tau[m];
                continue;
              }
            const double g  = half_logarithm_difference(b[m], b[n]);
            T.same[m][n]    = c.shear * g * b[n];
            T.swapped[m][n] = c.shear * g * b[m] - tau[m];
          }
      return T;
    }
  } // namespace



  PrincipalStrain
  principal_strain(const Tensor<2, 3>          &F,
                   const SymmetricTensor<2, 3> &Cp_inverse)
  {
    PrincipalStrain             t;
    const double                J = determinant(F);
    const Tensor<2, 3>          G = Tensor<2, 3>(Cp_inverse) * transpose(F);
    const SymmetricTensor<2, 3> b = symmetrize(F * G);
    if (!(J > 0.) || !std::isfinite(J) || !std::isfinite(b.norm()))
      return t;

    // Jacobi's method keeps the axes orthogonal where eigenvalues coincide.
    const auto pairs =
      eigenvectors(b, dealii::SymmetricTensorEigenvectorMethod::jacobi);
    for (int a = 0; a < 3; ++a)
      {
        t.b[a] = pairs[a].first;
        if (!(t.b[a] > 0.))
          return t;
        t.strain[a] = 0.5 * std::log(t.b[a]);
        for (int i = 0; i < 3; ++i)
          t.V[i][a] = pairs[a].second[i];
      }
    t.trace = t.strain[0] + t.strain[1] + t.strain[2];
    t.W     = invert(F) * t.V;
    t.valid = true;
    return t;
  }



  Tensor<1, 3>
  deviator(const PrincipalStrain &t)
  {
    Tensor<1, 3> e = t.strain;
    for (int a = 0; a < 3; ++a)
      e[a] -= t.trace / 3.;
    return e;
  }



  Tensor<2, 3>
  nominal_stress(const Tensor<1, 3> &tau, const PrincipalStrain &t)
  {
    return turn_back(t.V, tau, t.W);
  }



  Tensor<4, 3>
  nominal_tangent(const PrincipalTangent &c,
                  const Tensor<1, 3>     &tau,
                  const PrincipalStrain  &t)
  {
    const PrincipalOperator T            = principal_operator(c, tau, t.b);
    const Tensor<2, 3>      W_transposed = transpose(t.W);
    Tensor<2, 3>            dP[3][3]; // by F_kL
    for (int k = 0; k < 3; ++k)
      for (int L = 0; L < 3; ++L)
        {
          Tensor<2, 3> d_principal;
          for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
              {
                d_principal[a][b] += T.same[a][b] * t.V[k][a] * t.W[L][b] +
                                     T.swapped[a][b] * t.V[k][b] * t.W[L][a];
                d_principal[a][a] += T.axial[a][b] * t.V[k][b] * t.W[L][b];
              }
          dP[k][L] = t.V * d_principal * W_transposed;
        }
    Tensor<4, 3> tangent;
    for (int i = 0; i < 3; ++i)
      for (int J = 0; J < 3; ++J)
        for (int k = 0; k < 3; ++k)
          for (int L = 0; L < 3; ++L)
            tangent[i][J][k][L] = dP[k][L][i][J];
    return tangent;
  }



  SymmetricTensor<2, 3>
  updated_Cp_inverse(const PrincipalStrain &t,
                     const Tensor<1, 3>    &deviator,
                     const double           ratio)
  {
    Tensor<1, 3> elastic_b;
    for (int a = 0; a < 3; ++a)
      elastic_b[a] = std::exp(2. * (t.trace / 3. + ratio * deviator[a]));
    const SymmetricTensor<2, 3> C = symmetrize(turn_back(t.W, elastic_b, t.W));
    // as in plane kinematics: det C_p = 1 over many steps
    return (1. - (determinant(C) - 1.) / 3.) * C;
  }
} // namespace asperity::hencky
