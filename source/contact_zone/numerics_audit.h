#ifndef asperity_contact_zone_numerics_audit_h
#define asperity_contact_zone_numerics_audit_h

#include <asperity/contact_zone/audit.h>

namespace asperity
{
  /** Choices of elements, contact and time integration that are known to fail,
   *  by the maps of tools/stability. */
  template <int dim>
  void
  audit_numerics(const SceneParameters &parameters,
                 const Scene<dim>      &scene,
                 SceneAudit            &audit);
} // namespace asperity

#endif
