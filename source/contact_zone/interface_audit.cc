#include "interface_audit.h"

namespace asperity
{
  namespace
  {
    /** Shear factor from which the chip may rather shear in itself. */
    constexpr double nearly_welded = 0.9;
  } // namespace



  void
  audit_interface(const SceneParameters &parameters, SceneAudit &audit)
  {
    const InterfaceParameters &interface = parameters.interface;
    if (interface.law == InterfaceShear::none)
      return;
    if (parameters.heat_model() != HeatModel::conducting)
      audit.warnings.push_back(
        "The heat of friction is left out: with Heat/Model = conducting the "
        "work of the interface's shear warms chip and tool.");
    if (interface.uses_shear_strength() &&
        interface.shear_factor >= nearly_welded)
      audit.warnings.push_back(
        "With a Shear factor of " +
        format_quantity(interface.shear_factor, "1") +
        " the interface is nearly as strong as the chip, which then shears in "
        "a layer below the spots that is as thin as the elements: vary "
        "Mesh/Spans, since mu may depend on them.");
  }
} // namespace asperity
