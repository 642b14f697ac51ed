#include <asperity/constitutive/hencky_kinematics.h>

#include <cmath>

namespace asperity::hencky
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  namespace
  {
    /** f(x) = atanh(sqrt x)/sqrt x and f', with 1 - x given separately. */
    void
    logarithm_coefficient(const double x,
                          const double one_minus_x,
                          double      &f,
                          double      &df)
    {
      // Below this the terms left out are under 1e-17, and above it the
      // closed form of f' loses less than two digits.
      constexpr double series_below = 0.01;
      constexpr double c[]          = {1.,
                                       1. / 3.,
                                       1. / 5.,
                                       1. / 7.,
                                       1. / 9.,
                                       1. / 11.,
                                       1. / 13.,
                                       1. / 15.,
                                       1. / 17.};
      if (x < series_below)
        {
          f = 1. +
              x * (c[1] +
                   x * (c[2] +
                        x * (c[3] +
                             x * (c[4] +
                                  x * (c[5] +
                                       x * (c[6] + x * (c[7] + x * c[8])))))));
          df = c[1] +
               x * (2. * c[2] +
                    x * (3. * c[3] +
                         x * (4. * c[4] +
                              x * (5. * c[5] +
                                   x * (6. * c[6] +
                                        x * (7. * c[7] + x * 8. * c[8]))))));
        }
      else
        {
          const double root = std::sqrt(x);
          f  = std::log((1. + root) * (1. + root) / one_minus_x) / (2. * root);
          df = (1. / one_minus_x - f) / (2. * x);
        }
    }



    /** d strain/dF_{kL} in the plane. */
    SymmetricPlane
    strain_derivative(const TrialStrain &t, const int k, const int L)
    {
      const double d_mean       = t.G[L][k];
      const double d_difference = (k == 0) ? d_mean : -d_mean;
      const double d_shear      = t.G[L][1 - k];
      const double d_x =
        2. *
        ((t.difference * d_difference + t.shear * d_shear) / t.mean -
         t.x * d_mean) /
        t.mean;
      const double g   = 0.5 * t.f / t.mean;
      const double d_g = 0.5 * t.df * d_x / t.mean - g * d_mean / t.mean;
      const double d_a = 0.5 * t.F_inverse[L][k];
      const double d_d = d_g * t.difference + g * d_difference;
      return {d_a + d_d, d_a - d_d, d_g * t.shear + g * d_shear, 0.};
    }
  } // namespace



  TrialStrain
  trial_strain(const Tensor<2, 3> &F, const SymmetricTensor<2, 3> &Cp_inverse)
  {
    TrialStrain  t;
    const double C11 = Cp_inverse[0][0], C22 = Cp_inverse[1][1],
                 C12 = Cp_inverse[0][1], C33 = Cp_inverse[2][2];
    const double J2     = F[0][0] * F[1][1] - F[0][1] * F[1][0];
    const double det_Cp = C11 * C22 - C12 * C12;
    t.valid             = (J2 > 0. && F[2][2] > 0. && det_Cp > 0. && C33 > 0.);
    if (!t.valid)
      return t;

    t.F_inverse[0][0] = F[1][1] / J2;
    t.F_inverse[0][1] = -F[0][1] / J2;
    t.F_inverse[1][0] = -F[1][0] / J2;
    t.F_inverse[1][1] = F[0][0] / J2;
    t.F33_inverse     = 1. / F[2][2];

    t.G[0][0] = C11 * F[0][0] + C12 * F[0][1];
    t.G[0][1] = C11 * F[1][0] + C12 * F[1][1];
    t.G[1][0] = C12 * F[0][0] + C22 * F[0][1];
    t.G[1][1] = C12 * F[1][0] + C22 * F[1][1];

    const double b11 = F[0][0] * t.G[0][0] + F[0][1] * t.G[1][0];
    const double b22 = F[1][0] * t.G[0][1] + F[1][1] * t.G[1][1];
    t.mean           = 0.5 * (b11 + b22);
    t.difference     = 0.5 * (b11 - b22);
    t.shear          = F[0][0] * t.G[0][1] + F[0][1] * t.G[1][1];

    const double det_b = J2 * J2 * det_Cp;
    const double mean2 = t.mean * t.mean;
    t.x = (t.difference * t.difference + t.shear * t.shear) / mean2;
    logarithm_coefficient(t.x, det_b / mean2, t.f, t.df);

    const double a = 0.25 * std::log(det_b);
    const double g = 0.5 * t.f / t.mean;
    t.strain       = {a + g * t.difference,
                      a - g * t.difference,
                      g * t.shear,
                      0.5 * std::log(F[2][2] * F[2][2] * C33)};
    t.trace        = 2. * a + t.strain.zz;
    t.valid        = std::isfinite(contract(t.strain, t.strain));
    return t;
  }



  void
  fill_stress(const SymmetricPlane &tau, const TrialStrain &t, Tensor<2, 3> &P)
  {
    const auto &Fi = t.F_inverse;
    P[0][0]        = tau.xx * Fi[0][0] + tau.xy * Fi[0][1];
    P[0][1]        = tau.xx * Fi[1][0] + tau.xy * Fi[1][1];
    P[1][0]        = tau.xy * Fi[0][0] + tau.yy * Fi[0][1];
    P[1][1]        = tau.xy * Fi[1][0] + tau.yy * Fi[1][1];
    P[2][2]        = tau.zz * t.F33_inverse;
  }



  namespace
  {
    /** dP/dF_{kL} by the rate of the trial strain that goes with it. */
    void
    fill_column(const SpatialTangent &c,
                const TrialStrain    &t,
                const Tensor<2, 3>   &P,
                const SymmetricPlane &d_strain,
                const int             k,
                const int             L,
                Tensor<4, 3>         &tangent)
    {
      const double volume =
        c.volumetric * (d_strain.xx + d_strain.yy + d_strain.zz);
      const double radial = c.radial * contract(c.s, d_strain);

      // dP = (dtau - P dF^T) F^{-T}
      const double tau_xy  = c.shear * d_strain.xy + radial * c.s.xy;
      double       M[2][2] = {
              {volume + c.shear * d_strain.xx + radial * c.s.xx, tau_xy},
              {tau_xy, volume + c.shear * d_strain.yy + radial * c.s.yy}};
      double M33 = volume + c.shear * d_strain.zz + radial * c.s.zz;
      if (k == 2)
        M33 -= P[2][2];
      else
        for (int i = 0; i < 2; ++i)
          M[i][k] -= P[i][L];
      for (int i = 0; i < 2; ++i)
        for (int J = 0; J < 2; ++J)
          tangent[i][J][k][L] =
            M[i][0] * t.F_inverse[J][0] + M[i][1] * t.F_inverse[J][1];
      tangent[2][2][k][L] = M33 * t.F33_inverse;
    }
  } // namespace



  void
  fill_tangent(const SpatialTangent &c,
               const TrialStrain    &t,
               const Tensor<2, 3>   &P,
               Tensor<4, 3>         &tangent)
  {
    for (int k = 0; k < 2; ++k)
      for (int L = 0; L < 2; ++L)
        fill_column(c, t, P, strain_derivative(t, k, L), k, L, tangent);
    fill_column(c, t, P, {0., 0., 0., t.F33_inverse}, 2, 2, tangent);
  }



  SymmetricTensor<2, 3>
  updated_Cp_inverse(const TrialStrain    &t,
                     const SymmetricPlane &deviator,
                     const double          ratio)
  {
    const double d      = ratio * (deviator.xx - deviator.yy);
    const double s      = 2. * ratio * deviator.xy;
    const double radius = std::sqrt(d * d + s * s);
    const double scale =
      std::exp(2. * t.trace / 3. + ratio * (deviator.xx + deviator.yy));
    const double sinhc = (radius > 1e-8) ? std::sinh(radius) / radius : 1.;
    const double cosh  = std::sqrt(1. + sinhc * radius * sinhc * radius);
    const double b11   = scale * (cosh + sinhc * d);
    const double b22   = scale * (cosh - sinhc * d);
    const double b12   = scale * sinhc * s;
    const double b33   = std::exp(2. * (t.trace / 3. + ratio * deviator.zz));

    const auto           &Fi  = t.F_inverse;
    const double          h00 = Fi[0][0] * b11 + Fi[0][1] * b12;
    const double          h01 = Fi[0][0] * b12 + Fi[0][1] * b22;
    const double          h10 = Fi[1][0] * b11 + Fi[1][1] * b12;
    const double          h11 = Fi[1][0] * b12 + Fi[1][1] * b22;
    SymmetricTensor<2, 3> C;
    C[0][0] = h00 * Fi[0][0] + h01 * Fi[0][1];
    C[1][1] = h10 * Fi[1][0] + h11 * Fi[1][1];
    C[0][1] = h00 * Fi[1][0] + h01 * Fi[1][1];
    C[2][2] = b33 * t.F33_inverse * t.F33_inverse;
    // det C_p = 1 up to round-off; its first-order correction keeps the
    // round-off of many steps from adding up.
    C *= 1. - ((C[0][0] * C[1][1] - C[0][1] * C[0][1]) * C[2][2] - 1.) / 3.;
    return C;
  }
} // namespace asperity::hencky
