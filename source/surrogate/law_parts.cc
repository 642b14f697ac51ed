#include "law_parts.h"

namespace asperity
{
  using Json = nlohmann::ordered_json;

  ShearLimit
  read_shear_limit(const LawNode &node, const int version)
  {
    ShearLimit limit;
    limit.k_0      = node.child("k_0").number_above(0., true);
    limit.exponent = node.child("exponent").number_above(0., false);
    limit.transition_temperature =
      node.child("transition_temperature").number();
    limit.melting_temperature = node.child("melting_temperature").number();
    limit.strain              = node.child("strain").number();
    limit.rate                = node.child("rate").number();
    if (version > 3)
      limit.softens = node.child("softens").flag();
    if (version > 5)
      {
        const LawNode hardening = node.child("hardening");
        limit.hardening_ratio = hardening.child("ratio").number_above(0., true);
        limit.hardening_exponent =
          hardening.child("exponent").number_above(0., false);
        limit.strain_limit =
          hardening.child("strain_limit").number_above(0., false);
      }
    if (limit.k_0 > 0. && limit.softens &&
        !(limit.transition_temperature < limit.melting_temperature))
      node.child("melting_temperature").fail("more than the transition's");
    return limit;
  }



  Json
  shear_limit_to_json(const ShearLimit &limit)
  {
    return {{"k_0", limit.k_0},
            {"exponent", limit.exponent},
            {"transition_temperature", limit.transition_temperature},
            {"melting_temperature", limit.melting_temperature},
            {"strain", limit.strain},
            {"rate", limit.rate},
            {"softens", limit.softens},
            {"hardening",
             {{"ratio", limit.hardening_ratio},
              {"exponent", limit.hardening_exponent},
              {"strain_limit", limit.strain_limit}}}};
  }



  std::vector<ChoiceSpread>
  read_choices(const LawNode &node)
  {
    std::vector<ChoiceSpread> choices;
    for (const LawNode &choice : node.children())
      choices.push_back({choice.child("kind").name(),
                         choice.child("below").number_above(0., true),
                         choice.child("above").number_above(0., true)});
    return choices;
  }



  Json
  choices_to_json(const std::vector<ChoiceSpread> &choices)
  {
    Json result = Json::array();
    for (const ChoiceSpread &choice : choices)
      result.push_back({{"kind", choice.kind},
                        {"below", choice.below},
                        {"above", choice.above}});
    return result;
  }
} // namespace asperity
