#include <asperity/base/version.h>

#include <nlohmann/json.hpp>

#include <utility>

// ASPERITY_VERSION and what stands beside it below are defined for this file
// alone, by cmake/Version.cmake; deal.II's own header would bring its libraries
// along.

namespace asperity
{
  std::string
  version()
  {
    return ASPERITY_VERSION;
  }

  std::string
  git_revision()
  {
    return ASPERITY_GIT_REVISION;
  }

  nlohmann::ordered_json
  version_json()
  {
    nlohmann::ordered_json json;
    json["asperity"]     = version();
    json["git_revision"] = git_revision();
    json["build_type"]   = ASPERITY_BUILD_TYPE;
    for (const auto &[library, version] :
         {std::pair("deal.II", ASPERITY_DEAL_II_VERSION),
          std::pair("Trilinos", ASPERITY_TRILINOS_VERSION),
          std::pair("p4est", ASPERITY_P4EST_VERSION)})
      if (*version != '\0') // deal.II was built with it
        json[library] = version;
    return json;
  }

  std::string
  version_line()
  {
    const nlohmann::ordered_json json = version_json();
    std::string line = "asperity " + version() + " (" + git_revision() + ", " +
                       json["build_type"].get<std::string>();
    for (const char *const library : {"deal.II", "Trilinos", "p4est"})
      if (json.contains(library))
        line +=
          std::string(", ") + library + " " + json[library].get<std::string>();
    return line + ")";
  }
} // namespace asperity
