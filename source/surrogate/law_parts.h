#ifndef asperity_source_surrogate_law_parts_h
#define asperity_source_surrogate_law_parts_h

#include <asperity/surrogate/friction_law.h>

#include "law_document.h"

/** Parts of a law's document. */
namespace asperity
{
  ShearLimit
  read_shear_limit(const LawNode &node, const int version);

  nlohmann::ordered_json
  shear_limit_to_json(const ShearLimit &limit);

  std::vector<ChoiceSpread>
  read_choices(const LawNode &node);

  nlohmann::ordered_json
  choices_to_json(const std::vector<ChoiceSpread> &choices);
} // namespace asperity

#endif
