#ifndef asperity_law_export_solver_templates_h
#define asperity_law_export_solver_templates_h

#include <asperity/law_export/contact_point_law.h>

#include <string>

namespace asperity
{
  /**
   * User subroutines for chip-formation programs, complete with the law
   * (fortran_source() without the deviation), in mm, t, s, N, MPa and degC; the
   * factors to SI stand at the top of each. All limit the shear stress by k(T):
   * they work with mu_eff = min(mu, k/p). They compile, and are tested by
   * themselves, but have not been run in these programs; their first lines say
   * so.
   */

  /** Abaqus/Standard, FRIC_COEF: mu_eff and its derivatives by slip rate,
   *  pressure and temperature. */
  std::string
  abaqus_fric_coef(const ContactPointLaw &law);

  /** Abaqus/Explicit, VFRICTION for general contact: the tangential force
   *  min(mu_eff F_n, sticking force). */
  std::string
  abaqus_vfriction(const ContactPointLaw &law);

  /** DEFORM, USRBCC: mu_eff as the coefficient of Coulomb's friction. */
  std::string
  deform_usr_bcc(const ContactPointLaw &law);
} // namespace asperity

#endif
