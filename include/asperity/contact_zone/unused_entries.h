#ifndef asperity_contact_zone_unused_entries_h
#define asperity_contact_zone_unused_entries_h

#include <asperity/contact_zone/scene_parameters.h>

#include <string>
#include <vector>

namespace asperity
{
  /** An entry that is set, but not read by the models in use. */
  struct UnusedEntry
  {
    std::string path;        ///< "Lubricant/Density law"
    std::string counts_with; ///< "the lubricant models pocket and Reynolds"
  };

  /**
   * The entries that a file or a command sets and that have no influence on
   * the friction of this scene, in the order of their declaration. One table
   * says when an entry counts; entries that are not in it always do.
   *
   * @param parameters with the models in use; `automatic` may become any
   */
  std::vector<UnusedEntry>
  unused_entries(const SceneParameters     &parameters,
                 const ParameterDeclarator &declarator);
} // namespace asperity

#endif
