#ifndef asperity_constitutive_hencky_kinematics_h
#define asperity_constitutive_hencky_kinematics_h

#include <asperity/base/lanes.h>

/**
 * Logarithmic strain of plane kinematics: from F and C_p^{-1} to the trial
 * elastic strain, and from the Kirchhoff stress back to P, dP/dF and C_p^{-1}.
 * Number is a double or a lanes::Pack of several points.
 */
namespace asperity::hencky
{
  /** Tensor of plane kinematics. */
  template <class Number>
  struct Plane
  {
    Number xx, xy, yx, yy, zz;
  };

  /** Symmetric tensor of plane kinematics. */
  template <class Number>
  struct SymmetricPlane
  {
    Number xx, yy, xy, zz;
  };

  /** a : b */
  template <class Number>
  Number
  contract(const SymmetricPlane<Number> &a, const SymmetricPlane<Number> &b)
  {
    return a.xx * b.xx + a.yy * b.yy + 2. * a.xy * b.xy + a.zz * b.zz;
  }

  /** f(x) = atanh(sqrt x)/sqrt x and its slope. */
  template <class Number>
  struct LogarithmCoefficient
  {
    Number f, df;
  };

  /**
   * The trial elastic strain eps = 1/2 ln(F C_p^{-1} F^T) and what its
   * derivative by F needs. With mean = tr(b)/2 and D = b - mean 1 in the
   * plane, radius^2 = |D|^2/2 and x = (radius/mean)^2,
   *   ln b = 1/2 ln(det b) 1 + (f(x)/mean) D,  f(x) = atanh(sqrt x)/sqrt x.
   * f is analytic at x = 0 (coincident stretches), so no eigenvector is
   * ever needed.
   */
  template <class Number>
  struct TrialStrain
  {
    using Mask = decltype(Number() < Number());

    SymmetricPlane<Number>       strain;
    Number                       trace;
    Number                       inverse_mean;
    Number                       difference, shear; // of b in the plane
    Number                       x;
    LogarithmCoefficient<Number> log;
    Plane<Number>                F_inverse;
    Plane<Number>                G; // C_p^{-1} F^T
    Mask                         valid;
  };

  /** @param one_minus_x 1 - x */
  template <class Number>
  LogarithmCoefficient<Number>
  logarithm_coefficient(const Number &x, const Number &one_minus_x)
  {
    // Below this the terms left out are under 1e-17, and above it the
    // closed form of f' loses less than two digits.
    constexpr double series_below = 0.01;
    constexpr int    n            = 9; // terms x^k/(2 k + 1)
    Number           f            = lanes::broadcast<Number>(1. / (2 * n - 1));
    Number           df           = (n - 1) * f;
    for (int k = n - 2; k > 0; --k)
      {
        f  = f * x + 1. / (2 * k + 1);
        df = df * x + k / (2. * k + 1);
      }
    f = f * x + 1.;

    const auto large = x >= series_below;
    if (!lanes::any(large))
      return {f, df};
    const Number some = lanes::select(large, x, Number() + series_below);
    const Number root = lanes::sqrt(some);
    const Number closed_f =
      lanes::log((1. + root) * (1. + root) / one_minus_x) / (2. * root);
    const Number closed_df = (1. / one_minus_x - closed_f) / (2. * some);
    return {lanes::select(large, closed_f, f),
            lanes::select(large, closed_df, df)};
  }



  /**
   * @param F of plane kinematics, see MaterialLaw
   * @return with valid == false if det F or det C_p^{-1} is not positive, or
   *   anything is not finite
   */
  template <class Number>
  TrialStrain<Number>
  trial_strain(const Plane<Number> &F, const SymmetricPlane<Number> &Cp_inverse)
  {
    const SymmetricPlane<Number> &C = Cp_inverse;
    TrialStrain<Number>           t;
    const Number                  J2     = F.xx * F.yy - F.xy * F.yx;
    const Number                  det_Cp = C.xx * C.yy - C.xy * C.xy;

    const Number inverse_J2 = 1. / J2;
    t.F_inverse             = {F.yy * inverse_J2,
                               -F.xy * inverse_J2,
                               -F.yx * inverse_J2,
                               F.xx * inverse_J2,
                               1. / F.zz};

    t.G = {C.xx * F.xx + C.xy * F.xy,
           C.xx * F.yx + C.xy * F.yy,
           C.xy * F.xx + C.yy * F.xy,
           C.xy * F.yx + C.yy * F.yy,
           C.zz * F.zz};

    const Number b11  = F.xx * t.G.xx + F.xy * t.G.yx;
    const Number b22  = F.yx * t.G.xy + F.yy * t.G.yy;
    const Number mean = 0.5 * (b11 + b22);
    t.difference      = 0.5 * (b11 - b22);
    t.shear           = F.xx * t.G.xy + F.xy * t.G.yy;
    t.inverse_mean    = 1. / mean;

    const Number det_b         = J2 * J2 * det_Cp;
    const Number inverse_mean2 = t.inverse_mean * t.inverse_mean;
    t.x   = (t.difference * t.difference + t.shear * t.shear) * inverse_mean2;
    t.log = logarithm_coefficient(t.x, det_b * inverse_mean2);

    const Number a = 0.25 * lanes::log(det_b);
    const Number g = 0.5 * t.log.f * t.inverse_mean;
    t.strain       = {a + g * t.difference,
                      a - g * t.difference,
                      g * t.shear,
                      0.5 * lanes::log(F.zz * t.G.zz)};
    t.trace        = 2. * a + t.strain.zz;

    const Number size = contract(t.strain, t.strain);
    t.valid           = (J2 > 0.) & (F.zz > 0.) & (det_Cp > 0.) & (C.zz > 0.) &
              (size - size == 0.);
    return t;
  }



  /** The deviator of the trial strain. */
  template <class Number>
  SymmetricPlane<Number>
  deviator(const TrialStrain<Number> &t)
  {
    const Number third = t.trace / 3.;
    return {t.strain.xx - third,
            t.strain.yy - third,
            t.strain.xy,
            t.strain.zz - third};
  }

  /** pressure 1 + shear e. */
  template <class Number>
  SymmetricPlane<Number>
  isotropic_stress(const Number                 &pressure,
                   const Number                 &shear,
                   const SymmetricPlane<Number> &e)
  {
    return {pressure + shear * e.xx,
            pressure + shear * e.yy,
            shear * e.xy,
            pressure + shear * e.zz};
  }

  /** P = tau F^{-T}. */
  template <class Number>
  Plane<Number>
  nominal_stress(const SymmetricPlane<Number> &tau,
                 const TrialStrain<Number>    &t)
  {
    const Plane<Number> &Fi = t.F_inverse;
    return {tau.xx * Fi.xx + tau.xy * Fi.xy,
            tau.xx * Fi.yx + tau.xy * Fi.yy,
            tau.xy * Fi.xx + tau.yy * Fi.xy,
            tau.xy * Fi.yx + tau.yy * Fi.yy,
            tau.zz * Fi.zz};
  }

  /**
   * dtau = volumetric tr(deps) 1 + shear deps + radial (s : deps) s,
   * the form that every isotropic radial return takes.
   */
  template <class Number, class Symmetric = SymmetricPlane<Number>>
  struct SpatialTangent
  {
    Number    volumetric, shear, radial;
    Symmetric s;
  };

  struct Moduli
  {
    double bulk, shear;
  };

  /**
   * With e the trial deviator, q = ratio q_trial and tau_dev = 2 mu ratio e:
   *   dtau_dev = 2 mu ratio de + 2 mu (slope - ratio) (dq_trial/q_trial) e,
   *   dq_trial = 6 mu^2 (e : deps)/q_trial.
   *
   * @param slope dq/dq_trial; 1, with ratio 1, in an elastic step
   */
  template <class Number, class Symmetric>
  SpatialTangent<Number, Symmetric>
  radial_return_tangent(const Moduli    &moduli,
                        const Symmetric &e,
                        const Number    &trial_stress,
                        const Number    &ratio,
                        const Number    &slope)
  {
    const Number shear  = 2. * moduli.shear * ratio;
    const Number factor = moduli.shear / trial_stress;
    const Number radial =
      12. * moduli.shear * (slope - ratio) * factor * factor;
    return {moduli.bulk - shear / 3.,
            shear,
            lanes::select(slope == ratio, Number(), radial),
            e};
  }



  /** d strain/dF_kL in the plane, by G_Lk, G_L(1-k) and F^{-1}_Lk. */
  template <class Number>
  SymmetricPlane<Number>
  strain_derivative(const TrialStrain<Number> &t,
                    const int                  k,
                    const Number              &G_same,
                    const Number              &G_other,
                    const Number              &F_inverse)
  {
    const Number d_mean       = G_same;
    const Number d_difference = (k == 0) ? d_mean : -d_mean;
    const Number d_shear      = G_other;
    const Number d_x =
      2. *
      ((t.difference * d_difference + t.shear * d_shear) * t.inverse_mean -
       t.x * d_mean) *
      t.inverse_mean;
    const Number g   = 0.5 * t.log.f * t.inverse_mean;
    const Number d_g = (0.5 * t.log.df * d_x - g * d_mean) * t.inverse_mean;
    const Number d_a = 0.5 * F_inverse;
    const Number d_d = d_g * t.difference + g * d_difference;
    return {d_a + d_d, d_a - d_d, d_g * t.shear + g * d_shear, Number()};
  }



  /** dtau by the trial strain. */
  template <class Number>
  SymmetricPlane<Number>
  apply(const SpatialTangent<Number> &c, const SymmetricPlane<Number> &d_strain)
  {
    const Number volume =
      c.volumetric * (d_strain.xx + d_strain.yy + d_strain.zz);
    const Number radial = c.radial * contract(c.s, d_strain);
    return {volume + c.shear * d_strain.xx + radial * c.s.xx,
            volume + c.shear * d_strain.yy + radial * c.s.yy,
            c.shear * d_strain.xy + radial * c.s.xy,
            volume + c.shear * d_strain.zz + radial * c.s.zz};
  }



  /** dP by each component of F. */
  template <class Number>
  using PlaneTangent = Plane<Plane<Number>>;

  /** dP/dF = (dtau/dF - P dF^T/dF) F^{-T} for the Kirchhoff stress tau whose P
   *  is given. */
  template <class Number>
  PlaneTangent<Number>
  nominal_tangent(const SpatialTangent<Number> &c,
                  const TrialStrain<Number>    &t,
                  const Plane<Number>          &P)
  {
    const Plane<Number> &Fi = t.F_inverse, &G = t.G;
    const auto           column = [&](const SymmetricPlane<Number> &d_strain,
                            const Plane<Number> &P_dF) -> Plane<Number> {
      const SymmetricPlane<Number> d_tau = apply(c, d_strain);
      const Number M11 = d_tau.xx - P_dF.xx, M12 = d_tau.xy - P_dF.xy,
                   M21 = d_tau.xy - P_dF.yx, M22 = d_tau.yy - P_dF.yy;
      return {M11 * Fi.xx + M12 * Fi.xy,
              M11 * Fi.yx + M12 * Fi.yy,
              M21 * Fi.xx + M22 * Fi.xy,
              M21 * Fi.yx + M22 * Fi.yy,
              (d_tau.zz - P_dF.zz) * Fi.zz};
    };
    const Number o = Number();
    return {
      column(strain_derivative(t, 0, G.xx, G.xy, Fi.xx), {P.xx, o, P.yx, o, o}),
      column(strain_derivative(t, 0, G.yx, G.yy, Fi.yx), {P.xy, o, P.yy, o, o}),
      column(strain_derivative(t, 1, G.xy, G.xx, Fi.xy), {o, P.xx, o, P.yx, o}),
      column(strain_derivative(t, 1, G.yy, G.yx, Fi.yy), {o, P.xy, o, P.yy, o}),
      column({o, o, o, Fi.zz}, {o, o, o, o, P.zz})};
  }



  /**
   * C_p^{-1} = F^{-1} exp(2 eps_e) F^{-T} with eps_e = tr/3 1 + ratio dev.
   *
   * @param deviator dev of the trial strain
   * @param ratio length of the elastic deviator over that of the trial
   */
  template <class Number>
  SymmetricPlane<Number>
  updated_Cp_inverse(const TrialStrain<Number>    &t,
                     const SymmetricPlane<Number> &deviator,
                     const Number                 &ratio)
  {
    const Number d      = ratio * (deviator.xx - deviator.yy);
    const Number s      = 2. * ratio * deviator.xy;
    const Number radius = lanes::sqrt(d * d + s * s);
    const Number scale =
      lanes::exp(2. * t.trace / 3. + ratio * (deviator.xx + deviator.yy));
    const Number growth = lanes::exp(radius), decay = 1. / growth;
    const auto   turns = radius > 1e-8;
    const Number sinhc =
      lanes::select(turns, 0.5 * (growth - decay) / radius, Number() + 1.);
    const Number cosh = 0.5 * (growth + decay);
    const Number b11  = scale * (cosh + sinhc * d);
    const Number b22  = scale * (cosh - sinhc * d);
    const Number b12  = scale * sinhc * s;
    const Number b33  = lanes::exp(2. * (t.trace / 3. + ratio * deviator.zz));

    const Plane<Number>   &Fi  = t.F_inverse;
    const Number           h11 = Fi.xx * b11 + Fi.xy * b12;
    const Number           h12 = Fi.xx * b12 + Fi.xy * b22;
    const Number           h21 = Fi.yx * b11 + Fi.yy * b12;
    const Number           h22 = Fi.yx * b12 + Fi.yy * b22;
    SymmetricPlane<Number> C   = {h11 * Fi.xx + h12 * Fi.xy,
                                  h21 * Fi.yx + h22 * Fi.yy,
                                  h11 * Fi.yx + h12 * Fi.yy,
                                  b33 * Fi.zz * Fi.zz};
    // det C_p = 1 up to round-off; its first-order correction keeps the
    // round-off of many steps from adding up.
    const Number correction =
      1. - ((C.xx * C.yy - C.xy * C.xy) * C.zz - 1.) / 3.;
    return {C.xx * correction,
            C.yy * correction,
            C.xy * correction,
            C.zz * correction};
  }
} // namespace asperity::hencky

#endif
