#ifndef asperity_constitutive_principal_strain_h
#define asperity_constitutive_principal_strain_h

#include <asperity/constitutive/hencky_kinematics.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

/**
 * Logarithmic strain of any deformation, by its principal values: what
 * hencky_kinematics.h does for plane kinematics. Isotropic laws need these
 * alone; the principal axes then turn stress, tangent and C_p^{-1} back.
 */
namespace asperity::hencky
{
  /** The trial elastic strain eps = 1/2 ln b, b = F C_p^{-1} F^T, with
   *  b = V diag(b_a) V^T. */
  struct PrincipalStrain
  {
    dealii::Tensor<1, 3> b;      ///< eigenvalues b_a
    dealii::Tensor<1, 3> strain; ///< 1/2 ln b_a
    double               trace;  ///< of the strain
    dealii::Tensor<2, 3> V;      ///< principal axes, in the columns
    dealii::Tensor<2, 3> W;      ///< F^{-1} V

    /** False if det F or an eigenvalue of b is not positive, or anything is
     *  not finite; then nothing else is set. */
    bool valid = false;
  };

  /** @param F any deformation gradient */
  PrincipalStrain
  principal_strain(const dealii::Tensor<2, 3>          &F,
                   const dealii::SymmetricTensor<2, 3> &Cp_inverse);

  /** The principal values of the deviator of the trial strain. */
  dealii::Tensor<1, 3>
  deviator(const PrincipalStrain &t);

  /** P = tau F^{-T}, given the principal values of the Kirchhoff stress tau,
   *  whose axes are those of the trial strain. */
  dealii::Tensor<2, 3>
  nominal_stress(const dealii::Tensor<1, 3> &tau, const PrincipalStrain &t);

  /** How the Kirchhoff stress of a law changes with the trial strain, c.s
   *  being principal values in its axes. */
  using PrincipalTangent = SpatialTangent<double, dealii::Tensor<1, 3>>;

  /** dP/dF, given the principal values of the Kirchhoff stress tau, whose axes
   *  are those of the trial strain. Exact where stretches coincide, too. */
  dealii::Tensor<4, 3>
  nominal_tangent(const PrincipalTangent     &c,
                  const dealii::Tensor<1, 3> &tau,
                  const PrincipalStrain      &t);

  /**
   * C_p^{-1} = F^{-1} exp(2 eps_e) F^{-T} with eps_e = tr/3 1 + ratio dev.
   *
   * @param deviator dev of the trial strain
   * @param ratio length of the elastic deviator over that of the trial
   */
  dealii::SymmetricTensor<2, 3>
  updated_Cp_inverse(const PrincipalStrain      &t,
                     const dealii::Tensor<1, 3> &deviator,
                     const double                ratio);
} // namespace asperity::hencky

#endif
