#ifndef asperity_campaign_campaign_inputs_h
#define asperity_campaign_campaign_inputs_h

#include <asperity/campaign/campaign_parameters.h>
#include <asperity/contact_zone/scene_input.h>

#include <string>
#include <vector>

namespace asperity
{
  /** What a campaign varies in its base scene. */
  struct CampaignInputs
  {
    /**
     * Reads the base scene and lets it judge every corner of the box of inputs.
     * @throws InputError naming the entry of the campaign if an entry does not
     *   exist in the base scene or cannot vary, or if the scene refuses a
     * range, a combination of its ends, or a profile
     */
    CampaignInputs(const CampaignParameters  &parameters,
                   const ParameterDeclarator &declarator);

    std::vector<LawInput> inputs; ///< ranges in SI

    /** One an input: its entry takes whole numbers only. */
    std::vector<bool> is_whole_number;

    std::string base_scene_text; ///< all entries, files by their full paths
    InputRecord base_scene;      ///< its entries and the contents of its files

    /** Whether the base scene asks for its error or for settings by it, which
     *  no run of a campaign does. */
    bool wants_accuracy = false;

    /** Whether each run keeps its fields. */
    bool wants_fields = false;
  };

  /** The entry that tells profiles of a measured tool apart. */
  extern const char *const profile_entry;
} // namespace asperity

#endif
