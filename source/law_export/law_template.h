#ifndef asperity_law_export_law_template_h
#define asperity_law_export_law_template_h

#include <functional>
#include <string>

namespace asperity
{
  /** The files of source/law_export/templates, which compile as they stand or
   * as a part of tribmu, as they were when the program was built. */
  namespace law_template
  {
    extern const char *const tribmu_h;
    extern const char *const tribmu_c;
    extern const char *const tribmu_f;
    extern const char *const friction_law_js;
    extern const char *const gaussian_process_c;
    extern const char *const gaussian_process_f;
    extern const char *const gaussian_process_js;
    extern const char *const piecewise_power_law_c;
    extern const char *const piecewise_power_law_f;
    extern const char *const piecewise_power_law_js;
    extern const char *const tribef_f;
    extern const char *const abaqus_fric_coef_f;
    extern const char *const abaqus_vfriction_f;
    extern const char *const deform_usr_bcc_f;
    extern const char *const kernel_formulas_h;

    /**
     * Puts the numbers of a law into a template, in place of its sample: what
     * stands between a comment BEGIN with a name (and further words) and the
     * comment END with the same name.
     * @param block by name and further words, "PARAMETERS D NQ"
     */
    std::string
    fill(const std::string                                     &text,
         const std::function<std::string(const std::string &)> &block);
  } // namespace law_template
} // namespace asperity

#endif
