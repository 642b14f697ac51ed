#ifndef asperity_contact_zone_audit_h
#define asperity_contact_zone_audit_h

#include <asperity/contact_zone/scene.h>
#include <asperity/contact_zone/unused_entries.h>

#include <string>
#include <vector>

namespace asperity
{
  /** One number that decides about a model. */
  struct AuditEntry
  {
    std::string name; ///< "wave transits of the load ramp"
    double      value = 0.;
    std::string meaning; ///< what it says and what follows
  };

  /** The scene in numbers, and the models that `automatic` chooses by them. */
  struct SceneAudit
  {
    std::vector<AuditEntry>  entries;
    std::vector<std::string> warnings;
    std::vector<UnusedEntry> unused; ///< of the file, if there is one
    Inertia                  inertia   = Inertia::quasi_static;
    LubricantModel           lubricant = LubricantModel::none;
  };

  /** Reads the numbers off the parameters and the built scene. */
  SceneAudit
  audit_scene(const SceneParameters &parameters, const Scene<2> &scene);

  /** See above. */
  SceneAudit
  audit_scene(const SceneParameters &parameters, const Scene<3> &scene);
} // namespace asperity

#endif
