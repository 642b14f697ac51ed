#include <asperity/base/mechanisms.h>
#include <asperity/base/text.h>

#include <algorithm>

namespace asperity
{
  std::string
  mechanisms_sentence(const std::vector<std::string> &mechanisms)
  {
    if (mechanisms.empty())
      return "Which mechanisms are in this mu is not known: its file is older "
             "than their list.";
    if (mechanisms == std::vector<std::string>{measured_mechanisms})
      return "This mu was fitted to measurements: whatever acted in their "
             "contact is in it.";
    const std::string sentence = "This mu comes from " +
                                 join(mechanisms, " and ") +
                                 (mechanisms.size() == 1 ? " alone" : "");
    const bool has_shear =
      std::find(mechanisms.begin(), mechanisms.end(), "interface shear") !=
      mechanisms.end();
    return sentence + (has_shear ?
                         "; how much shear the interface bears is an input, "
                         "not a result." :
                         "; adhesion, the shear of the dry interface, "
                         "is not in it.");
  }
} // namespace asperity
