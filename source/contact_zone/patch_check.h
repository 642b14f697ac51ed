#ifndef asperity_contact_zone_patch_check_h
#define asperity_contact_zone_patch_check_h

#include <asperity/contact_zone/scene_parameters.h>

namespace asperity
{
  /** What a scene in three dimensions cannot have.
   *  @throws InputError naming the entry */
  void
  check_patch(const SceneParameters     &scene,
              const ParameterDeclarator &parameters);

  /** What belongs to three dimensions only.
   *  @throws InputError naming the entry */
  void
  check_profiles(const SceneParameters     &scene,
                 const ParameterDeclarator &parameters);
} // namespace asperity

#endif
