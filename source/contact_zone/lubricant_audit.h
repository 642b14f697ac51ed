#ifndef asperity_contact_zone_lubricant_audit_h
#define asperity_contact_zone_lubricant_audit_h

#include <asperity/contact_zone/audit.h>

namespace asperity
{
  /** What the oil does, and the model that `automatic` chooses.
   *  @param asperity half the length of the steepest one [m] */
  void
  audit_lubricant(const SceneParameters &parameters,
                  const Scene<2>        &scene,
                  const double           asperity,
                  SceneAudit            &audit);
} // namespace asperity

#endif
