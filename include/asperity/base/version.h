#ifndef asperity_base_version_h
#define asperity_base_version_h

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace asperity
{
  /** "0.1.0" */
  std::string
  version();

  /** The commit that was configured, or "unknown" outside a git checkout. */
  std::string
  git_revision();

  /** "asperity 0.1.0 (1a2b3c4, Release, deal.II 9.4.1, Trilinos 13.2.0, ...)"
   */
  std::string
  version_line();

  /** The same as an object, for `summary.json`. */
  nlohmann::ordered_json
  version_json();
} // namespace asperity

#endif
