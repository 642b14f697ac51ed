#include <asperity/constitutive/hencky_kinematics.h>

#include <cmath>

namespace asperity::hencky
{
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
  trial_strain(const PlaneTensor &F, const std::array<double, 4> &Cp_inverse)
  {
    TrialStrain  t;
    const double J2 = F[0] * F[3] - F[1] * F[2];
    const double det_Cp =
      Cp_inverse[0] * Cp_inverse[1] - Cp_inverse[2] * Cp_inverse[2];
    t.valid = (J2 > 0. && F[4] > 0. && det_Cp > 0. && Cp_inverse[3] > 0.);
    if (!t.valid)
      return t;

    t.F_inverse[0][0] = F[3] / J2;
    t.F_inverse[0][1] = -F[1] / J2;
    t.F_inverse[1][0] = -F[2] / J2;
    t.F_inverse[1][1] = F[0] / J2;
    t.F33_inverse     = 1. / F[4];

    t.G[0][0] = Cp_inverse[0] * F[0] + Cp_inverse[2] * F[1];
    t.G[0][1] = Cp_inverse[0] * F[2] + Cp_inverse[2] * F[3];
    t.G[1][0] = Cp_inverse[2] * F[0] + Cp_inverse[1] * F[1];
    t.G[1][1] = Cp_inverse[2] * F[2] + Cp_inverse[1] * F[3];

    const double b11 = F[0] * t.G[0][0] + F[1] * t.G[1][0];
    const double b22 = F[2] * t.G[0][1] + F[3] * t.G[1][1];
    t.mean           = 0.5 * (b11 + b22);
    t.difference     = 0.5 * (b11 - b22);
    t.shear          = F[0] * t.G[0][1] + F[1] * t.G[1][1];

    const double det_b = J2 * J2 * det_Cp;
    const double mean2 = t.mean * t.mean;
    t.x = (t.difference * t.difference + t.shear * t.shear) / mean2;
    logarithm_coefficient(t.x, det_b / mean2, t.f, t.df);

    const double a = 0.25 * std::log(det_b);
    const double g = 0.5 * t.f / t.mean;
    t.strain       = {a + g * t.difference,
                      a - g * t.difference,
                      g * t.shear,
                      0.5 * std::log(F[4] * F[4] * Cp_inverse[3])};
    t.trace        = 2. * a + t.strain.zz;
    t.valid        = std::isfinite(contract(t.strain, t.strain));
    return t;
  }



  PlaneTensor
  first_piola_kirchhoff(const SymmetricPlane &tau, const TrialStrain &t)
  {
    const auto &Fi = t.F_inverse;
    return {{tau.xx * Fi[0][0] + tau.xy * Fi[0][1],
             tau.xx * Fi[1][0] + tau.xy * Fi[1][1],
             tau.xy * Fi[0][0] + tau.yy * Fi[0][1],
             tau.xy * Fi[1][0] + tau.yy * Fi[1][1],
             tau.zz * t.F33_inverse}};
  }



  void
  fill_tangent(const SpatialTangent &c,
               const TrialStrain    &t,
               const PlaneTensor    &P,
               PlaneTangent         &tangent)
  {
    for (int column = 0; column < 5; ++column)
      {
        const bool           in_plane = (column < 4);
        const int            k = column / 2, L = column % 2;
        const SymmetricPlane d_strain =
          in_plane ? strain_derivative(t, k, L) :
                     SymmetricPlane{0., 0., 0., t.F33_inverse};
        const double volume =
          c.volumetric * (d_strain.xx + d_strain.yy + d_strain.zz);
        const double radial = c.radial * contract(c.s, d_strain);

        // dP = (dtau - P dF^T) F^{-T}
        double M11 = volume + c.shear * d_strain.xx + radial * c.s.xx;
        double M22 = volume + c.shear * d_strain.yy + radial * c.s.yy;
        double M12 = c.shear * d_strain.xy + radial * c.s.xy;
        double M21 = M12;
        double M33 = volume + c.shear * d_strain.zz + radial * c.s.zz;
        if (!in_plane)
          M33 -= P[4];
        else if (k == 0)
          {
            M11 -= P[L];
            M21 -= P[2 + L];
          }
        else
          {
            M12 -= P[L];
            M22 -= P[2 + L];
          }
        const auto &Fi     = t.F_inverse;
        tangent[0][column] = M11 * Fi[0][0] + M12 * Fi[0][1];
        tangent[1][column] = M11 * Fi[1][0] + M12 * Fi[1][1];
        tangent[2][column] = M21 * Fi[0][0] + M22 * Fi[0][1];
        tangent[3][column] = M21 * Fi[1][0] + M22 * Fi[1][1];
        tangent[4][column] = M33 * t.F33_inverse;
      }
  }



  std::array<double, 4>
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
    std::array<double, 4> C   = {{h00 * Fi[0][0] + h01 * Fi[0][1],
                                  h10 * Fi[1][0] + h11 * Fi[1][1],
                                  h00 * Fi[1][0] + h01 * Fi[1][1],
                                  b33 * t.F33_inverse * t.F33_inverse}};
    // det C_p = 1 up to round-off; its first-order correction keeps the
    // round-off of many steps from adding up.
    const double correction =
      1. - ((C[0] * C[1] - C[2] * C[2]) * C[3] - 1.) / 3.;
    for (double &c : C)
      c *= correction;
    return C;
  }
} // namespace asperity::hencky
