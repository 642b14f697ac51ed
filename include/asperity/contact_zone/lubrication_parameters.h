#ifndef asperity_contact_zone_lubrication_parameters_h
#define asperity_contact_zone_lubrication_parameters_h

#include <asperity/base/parameters.h>
#include <asperity/constitutive/lubricant_parameters.h>

#include <string>

namespace asperity
{
  /** The rungs of the lubricant ladder. */
  enum class LubricantModel
  {
    automatic, ///< as the scene audit says
    none,
    pocket,
    reynolds
  };

  /** As in parameter files. */
  std::string
  name(const LubricantModel model);

  /** How much oil there is, and how it is modelled. */
  struct LubricationParameters
  {
    LubricantModel model   = LubricantModel::none;
    double         wetting = 1.; ///< w, oil over void at the start

    /** Model `pocket`: gap under which surfaces seal [m]; 0: one connected
     *  void. */
    double sealing_gap = 0.;

    /** Film that stays where surfaces touch [m]; models with flow. */
    double residual_film = 2e-9;

    LubricantParameters oil;

    void
    declare(ParameterDeclarator &parameters);

    /** Relations between entries; throws InputError. */
    void
    check(const ParameterDeclarator &parameters) const;
  };
} // namespace asperity

#endif
