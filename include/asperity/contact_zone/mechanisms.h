#ifndef asperity_contact_zone_mechanisms_h
#define asperity_contact_zone_mechanisms_h

#include <string>
#include <vector>

namespace asperity
{
  struct SceneParameters;

  /**
   * What makes the friction of a scene, by the models that it is computed with:
   * "ploughing", the deformation of the chip by the asperities of the tool,
   * and "oil", its pressure on their flanks and, in a film, its shear.
   * @param parameters with the models of the audit instead of `automatic`
   */
  std::vector<std::string>
  mechanisms_of(const SceneParameters &parameters);
} // namespace asperity

#endif
