#include <asperity/law_export/generated_source.h>
#include <asperity/law_export/solver_templates.h>

#include "export_text.h"
#include "fortran_blocks.h"
#include "law_template.h"

namespace asperity
{
  namespace
  {
    std::string
    with_parameters(const ContactPointLaw &law, const std::string &text)
    {
      const ExportedNumbers numbers(law, false);
      return law_template::fill(text, [&](const std::string &block) {
        return fortran_parameters(numbers, block);
      });
    }

    std::string
    assemble(std::vector<std::string> title,
             const ContactPointLaw   &law,
             const std::string       &routine)
    {
      for (
        const char *const line :
        {"mu is limited by k(T)/p, so that tau = min(mu p, k). Further inputs",
         "of the law are held at the values below.",
         "",
         "Written by asperity; the law and its licence follow below, and",
         "the licence holds for all of this file."})
        title.push_back(line);
      std::string text;
      for (const std::string &line : title)
        text += line.empty() ? "C\n" : "C " + line + "\n";
      return text + with_parameters(law, routine) +
             with_parameters(law, law_template::tribef_f) + "C\n" +
             fortran_source(law, false);
    }
  } // namespace



  std::string
  abaqus_fric_coef(const ContactPointLaw &law)
  {
    return assemble(
      {"FRIC_COEF for Abaqus/Standard: friction coefficient and derivatives.",
       "NOT RUN IN THAT PROGRAM; compiled and tested by itself.",
       "Use: *FRICTION, USER=COEFFICIENT; PROPERTIES=n takes n further inputs",
       "of the law, in SI and in their order, instead of the values below.",
       "Units: mm, t, s, N, MPa, degC; to change them, change FP, FV, T0."},
      law,
      law_template::abaqus_fric_coef_f);
  }



  std::string
  abaqus_vfriction(const ContactPointLaw &law)
  {
    return assemble(
      {"VFRICTION for Abaqus/Explicit, general contact: friction force.",
       "NOT RUN IN THAT PROGRAM; compiled and tested by itself.",
       "Use: *FRICTION, USER; PROPERTIES=n takes n further inputs of the",
       "law, in SI and in their order, instead of the values below. Units:",
       "mm, t, s, N, MPa, degC; to change them, change FP, FV and T0."},
      law,
      law_template::abaqus_vfriction_f);
  }



  std::string
  deform_usr_bcc(const ContactPointLaw &law)
  {
    return assemble(
      {"USRBCC for DEFORM: coefficient of Coulomb friction.",
       "NOT RUN IN THAT PROGRAM; compiled and tested by itself.",
       "Use: FRCFAC with the friction type 2 and the user's routine. Units:",
       "mm, s, N, MPa, degC; to change them, change FP, FV and T0."},
      law,
      law_template::deform_usr_bcc_f);
  }
} // namespace asperity
