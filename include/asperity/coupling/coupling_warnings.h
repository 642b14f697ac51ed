#ifndef asperity_coupling_coupling_warnings_h
#define asperity_coupling_coupling_warnings_h

#include <asperity/coupling/coupling_parameters.h>

#include <string>

namespace asperity
{
  /** A sentence if iterations end so early that it shows in the results, else
   *  empty. */
  std::string
  loose_tolerance_warning(const CouplingParameters &parameters);
} // namespace asperity

#endif
