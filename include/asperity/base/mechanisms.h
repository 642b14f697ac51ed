#ifndef asperity_base_mechanisms_h
#define asperity_base_mechanisms_h

#include <string>
#include <vector>

namespace asperity
{
  /** The mechanism of a law that was fitted to measurements. */
  constexpr const char *measured_mechanisms = "measurements";

  /**
   * One sentence for people on what a friction coefficient holds and what it
   * does not, which travels with it into every file and every interface.
   * @param mechanisms as in `mechanisms` of summary.json and
   *   friction_law.json: "ploughing", "interface shear", "oil", or
   *   measured_mechanisms alone; empty if they are not known
   */
  std::string
  mechanisms_sentence(const std::vector<std::string> &mechanisms);
} // namespace asperity

#endif
