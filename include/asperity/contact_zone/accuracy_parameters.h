#ifndef asperity_contact_zone_accuracy_parameters_h
#define asperity_contact_zone_accuracy_parameters_h

#include <asperity/base/parameters.h>

namespace asperity
{
  /** What a run does about its numerical error. */
  enum class AccuracyControl
  {
    off,      ///< nothing
    estimate, ///< tells it, by companions; see error_estimate.h
    adaptive  ///< chooses mesh, steps and penalty by it; see accuracy_control.h
  };

  struct AccuracyParameters
  {
    double          error   = 0.007; ///< wanted, of mu, relative; 0: none
    AccuracyControl control = AccuracyControl::off;

    /** Of a mesh that `adaptive` may choose. */
    unsigned int maximum_unknowns = 20000;

    void
    declare(ParameterDeclarator &parameters);

    /** Whether the error is to be told. */
    bool
    is_wanted() const
    {
      return control != AccuracyControl::off && error > 0.;
    }

    /** Whether mesh, steps and penalty are to be chosen. */
    bool
    is_adaptive() const
    {
      return control == AccuracyControl::adaptive && error > 0.;
    }
  };
} // namespace asperity

#endif
