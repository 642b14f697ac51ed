#ifndef asperity_constitutive_hencky_kinematics_h
#define asperity_constitutive_hencky_kinematics_h

#include <asperity/constitutive/material_law.h>

/**
 * Logarithmic strain of plane kinematics: from F and C_p^{-1} to the trial
 * elastic strain, and from the Kirchhoff stress back to P, dP/dF and C_p^{-1}.
 */
namespace asperity::hencky
{
  /** Symmetric tensor of plane kinematics. */
  struct SymmetricPlane
  {
    double xx, yy, xy, zz;
  };

  /** a : b */
  inline double
  contract(const SymmetricPlane &a, const SymmetricPlane &b)
  {
    return a.xx * b.xx + a.yy * b.yy + 2. * a.xy * b.xy + a.zz * b.zz;
  }

  /**
   * The trial elastic strain eps = 1/2 ln(F C_p^{-1} F^T) and what its
   * derivative by F needs. With mean = tr(b)/2 and D = b - mean 1 in the
   * plane, radius^2 = |D|^2/2 and x = (radius/mean)^2,
   *   ln b = 1/2 ln(det b) 1 + (f(x)/mean) D,  f(x) = atanh(sqrt x)/sqrt x.
   * f is analytic at x = 0 (coincident stretches), so no eigenvector is
   * ever needed.
   */
  struct TrialStrain
  {
    SymmetricPlane strain;
    double         trace;
    double         mean, difference, shear; // of b in the plane
    double         x, f, df;                // f(x) and f'(x)
    double         F_inverse[2][2];
    double         F33_inverse;
    double         G[2][2]; // C_p^{-1} F^T
    bool           valid;
  };

  /**
   * @param F of plane kinematics, see MaterialLaw
   * @return with valid == false if det F or det C_p^{-1} is not positive, or
   *   anything is not finite
   */
  TrialStrain
  trial_strain(const dealii::Tensor<2, 3>          &F,
               const dealii::SymmetricTensor<2, 3> &Cp_inverse);

  /** The deviator of the trial strain. */
  inline SymmetricPlane
  deviator(const TrialStrain &t)
  {
    const double third = t.trace / 3.;
    return {t.strain.xx - third,
            t.strain.yy - third,
            t.strain.xy,
            t.strain.zz - third};
  }

  /** pressure 1 + shear e. */
  inline SymmetricPlane
  isotropic_stress(const double          pressure,
                   const double          shear,
                   const SymmetricPlane &e)
  {
    return {pressure + shear * e.xx,
            pressure + shear * e.yy,
            shear * e.xy,
            pressure + shear * e.zz};
  }

  /** P = tau F^{-T}, its five components of plane kinematics. */
  void
  fill_stress(const SymmetricPlane &tau,
              const TrialStrain    &t,
              dealii::Tensor<2, 3> &P);

  /**
   * dtau = volumetric tr(deps) 1 + shear deps + radial (s : deps) s,
   * the form that every isotropic radial return takes.
   */
  struct SpatialTangent
  {
    double         volumetric, shear, radial;
    SymmetricPlane s;
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
  inline SpatialTangent
  radial_return_tangent(const Moduli         &moduli,
                        const SymmetricPlane &e,
                        const double          trial_stress,
                        const double          ratio,
                        const double          slope)
  {
    const double shear  = 2. * moduli.shear * ratio;
    const double factor = moduli.shear / trial_stress;
    const double radial =
      (slope == ratio) ? 0. :
                         12. * moduli.shear * (slope - ratio) * factor * factor;
    return {moduli.bulk - shear / 3., shear, radial, e};
  }

  /** dP/dF for the Kirchhoff stress tau whose P is given, its components of
   *  plane kinematics. */
  void
  fill_tangent(const SpatialTangent       &c,
               const TrialStrain          &t,
               const dealii::Tensor<2, 3> &P,
               dealii::Tensor<4, 3>       &tangent);

  /**
   * C_p^{-1} = F^{-1} exp(2 eps_e) F^{-T} with eps_e = tr/3 1 + ratio dev.
   *
   * @param deviator dev of the trial strain
   * @param ratio length of the elastic deviator over that of the trial
   */
  dealii::SymmetricTensor<2, 3>
  updated_Cp_inverse(const TrialStrain    &t,
                     const SymmetricPlane &deviator,
                     const double          ratio);
} // namespace asperity::hencky

#endif
