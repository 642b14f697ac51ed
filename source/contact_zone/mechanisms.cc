#include <asperity/contact_zone/mechanisms.h>
#include <asperity/contact_zone/scene_parameters.h>

namespace asperity
{
  std::vector<std::string>
  mechanisms_of(const SceneParameters &parameters)
  {
    std::vector<std::string> mechanisms = {"ploughing"};
    if (parameters.interface.law != InterfaceShear::none)
      mechanisms.push_back("interface shear");
    if (parameters.lubrication.model != LubricantModel::none)
      mechanisms.push_back("oil");
    return mechanisms;
  }
} // namespace asperity
