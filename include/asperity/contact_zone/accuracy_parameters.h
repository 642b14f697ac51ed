#ifndef asperity_contact_zone_accuracy_parameters_h
#define asperity_contact_zone_accuracy_parameters_h

#include <asperity/base/parameters.h>

namespace asperity
{
  /** What a run is told about its numerical error. */
  enum class AccuracyControl
  {
    off,     ///< nothing
    estimate ///< how large it is, by coarser companions; see error_estimate.h
  };

  struct AccuracyParameters
  {
    double          error   = 0.007; ///< wanted, of mu, relative; 0: none
    AccuracyControl control = AccuracyControl::off;

    void
    declare(ParameterDeclarator &parameters);

    bool
    is_wanted() const
    {
      return control == AccuracyControl::estimate && error > 0.;
    }
  };
} // namespace asperity

#endif
