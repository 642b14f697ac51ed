#ifndef asperity_contact_zone_surface_audit_h
#define asperity_contact_zone_surface_audit_h

#include <asperity/contact_zone/audit.h>
#include <asperity/contact_zone/sheet_surface.h>
#include <asperity/contact_zone/surface.h>

#include <string>

namespace asperity
{
  /** What the reader and the treatment of a measured surface complain of, and
   *  whether the filter leaves out what the map shows. */
  void
  audit_treatment(const TopographyParameters &topography,
                  const TopographyReport     &report,
                  const std::string          &whose,
                  SceneAudit                 &audit);

  /**
   * What the reader and the treatment of a measured surface complain of, and
   * what somebody has decided about it, with what that did to mu of the
   * wet-air-blasted tool (parameter_files/friction_law/README.md).
   * @param whose "Tool" or "Chip"
   * @param is_sheared whether the interface has a shear law
   */
  void
  audit_surface(const SurfaceParameters &parameters,
                const Surface           &surface,
                const std::string       &whose,
                const bool               is_sheared,
                SceneAudit              &audit);

  /** Whether a surface in three dimensions is so steep that elements fold.
   *  @param whose "Tool" or "Chip" */
  void
  audit_flanks(const SheetSurface &surface,
               const std::string  &whose,
               SceneAudit         &audit);
} // namespace asperity

#endif
