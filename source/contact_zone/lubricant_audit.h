#ifndef asperity_contact_zone_lubricant_audit_h
#define asperity_contact_zone_lubricant_audit_h

#include <asperity/contact_zone/audit.h>

namespace asperity
{
  /** What the oil does, and the model that `automatic` chooses.
   *  @param mean_gap between the surfaces at the start [m]
   *  @param asperity half the length of the steepest one [m] */
  void
  audit_lubricant(const SceneParameters &parameters,
                  const OilInGap        &in_gap,
                  const double           mean_gap,
                  const double           asperity,
                  SceneAudit            &audit);
} // namespace asperity

#endif
