#include <asperity/base/version.h>

#include <deal.II/base/config.h>

#include <nlohmann/json.hpp>

// ASPERITY_VERSION, ASPERITY_GIT_REVISION and ASPERITY_BUILD_TYPE are defined
// for this file alone, by cmake/Version.cmake.

namespace asperity
{
  namespace
  {
    std::string
    dotted(const int major, const int minor, const int subminor)
    {
      return std::to_string(major) + "." + std::to_string(minor) + "." +
             std::to_string(subminor);
    }
  } // namespace

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
    json["deal.II"]      = DEAL_II_PACKAGE_VERSION;
#ifdef DEAL_II_WITH_TRILINOS
    json["Trilinos"] = dotted(DEAL_II_TRILINOS_VERSION_MAJOR,
                              DEAL_II_TRILINOS_VERSION_MINOR,
                              DEAL_II_TRILINOS_VERSION_SUBMINOR);
#endif
#ifdef DEAL_II_WITH_P4EST
    json["p4est"] = dotted(DEAL_II_P4EST_VERSION_MAJOR,
                           DEAL_II_P4EST_VERSION_MINOR,
                           DEAL_II_P4EST_VERSION_SUBMINOR);
#endif
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
