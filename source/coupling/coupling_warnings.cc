#include <asperity/base/quantity.h>
#include <asperity/coupling/coupling_warnings.h>

namespace asperity
{
  namespace
  {
    /** By tools/stability, C4 and C6: with 1e-3 up to 1.5e-4 of what flows into
     *  a box leaks out of it, with 1e-2 a wall moves 3 % less; with 1e-4 these
     *  are 2e-6 and below 0.4 %. */
    constexpr double largest_tolerance = 5e-4;
  } // namespace



  std::string
  loose_tolerance_warning(const CouplingParameters &parameters)
  {
    if (parameters.tolerance <= largest_tolerance)
      return "";
    return "With Coupling/Tolerance = " +
           format_quantity(parameters.tolerance, "1", 2) +
           " the iterations end so early that motions are up to 3 % off and "
           "1.5e-4 of what flows leaks through the interface; expected is 1e-4 "
           "or less.";
  }
} // namespace asperity
