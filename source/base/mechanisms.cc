#include <asperity/base/mechanisms.h>
#include <asperity/base/text.h>

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
    return "This mu comes from " + join(mechanisms, " and ") +
           (mechanisms.size() == 1 ? " alone" : "") +
           "; adhesion, the shear of the dry interface, is not in it.";
  }
} // namespace asperity
