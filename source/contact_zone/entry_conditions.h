#ifndef asperity_contact_zone_entry_conditions_h
#define asperity_contact_zone_entry_conditions_h

#include <asperity/contact_zone/scene_parameters.h>

#include <functional>
#include <string>
#include <vector>

// The table behind unused_entries(), by subject.

namespace asperity
{
  /** When entries count. */
  struct EntryCondition
  {
    /** Paths, or sections, which end with a slash. */
    std::vector<std::string> entries;

    std::string                                  counts_with;
    std::function<bool(const SceneParameters &)> holds;
  };

  using EntryConditions = std::vector<EntryCondition>;

  EntryConditions
  conditions_of_oil();

  /** @param section "Tool", @param surface the member that belongs to it */
  EntryConditions
  conditions_of_surface(const std::string &section,
                        SurfaceParameters SceneParameters::*const surface);
} // namespace asperity

#endif
