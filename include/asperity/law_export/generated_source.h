#ifndef asperity_law_export_generated_source_h
#define asperity_law_export_generated_source_h

#include <asperity/law_export/contact_point_law.h>

#include <string>

namespace asperity
{
  /**
   * A law as source code that needs nothing but a compiler. All numbers are SI:
   * Pa, m/s, K. Outside of the box of the training data the code answers as
   * FrictionLaw does and says that it is not to be trusted; it answers with
   * finite numbers, to infinite ones as well; to what is not a number it
   * answers with none. It keeps no state, so that threads may share it.
   *
   * C99: tribmu() gives mu, its three derivatives and whether the point lies in
   * the box; tribmu_sigma() the standard deviation and `trusted`; tribmu_k()
   * the shear limit; tribmu_tau() min(mu p, k).
   */
  std::string
  c_header(const ContactPointLaw &law);

  /** @param with_deviation whether the triangular factor is included (n^2/2
   *   numbers for n runs); without it sigma is -1 and `trusted` means inside of
   *   the box only, which the text says */
  std::string
  c_source(const ContactPointLaw &law, const bool with_deviation);

  /**
   * The same in fixed-form Fortran 77 without a line beyond column 72 or more
   * than 19 continuation lines: the subroutines TRIBMU, TRIBSD, TRIBK and the
   * function TRIBTA. A work array is the caller's, so that compilers that put
   * local arrays into static memory do no harm.
   */
  std::string
  fortran_source(const ContactPointLaw &law, const bool with_deviation);

  /** The same in JavaScript, for pages and Node.js: friction_law.evaluate()
   *  gives mu, its deviation, both 95 % intervals, `inside`, `trusted`, k and
   *  tau; friction_law.inputs says what there is to set. */
  std::string
  js_source(const ContactPointLaw &law, const bool with_deviation);
} // namespace asperity

#endif
