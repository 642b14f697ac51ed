#ifndef asperity_campaign_shear_limit_h
#define asperity_campaign_shear_limit_h

#include <asperity/campaign/campaign_parameters.h>
#include <asperity/constitutive/material_parameters.h>

namespace asperity
{
  /** The shear strength of a chip, from its flow stress at the strain and rate
   *  of the law; unknown if it stays elastic.
   *  @throws InputError if the material has no physical meaning */
  ShearLimit
  shear_limit_of(const MaterialParameters &material, const LawParameters &law);
} // namespace asperity

#endif
