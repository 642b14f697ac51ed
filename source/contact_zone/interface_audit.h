#ifndef asperity_contact_zone_interface_audit_h
#define asperity_contact_zone_interface_audit_h

#include <asperity/contact_zone/audit.h>

namespace asperity
{
  /** What is left out where the interface bears shear. */
  void
  audit_interface(const SceneParameters &parameters, SceneAudit &audit);
} // namespace asperity

#endif
