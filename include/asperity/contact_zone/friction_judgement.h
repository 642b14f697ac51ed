#ifndef asperity_contact_zone_friction_judgement_h
#define asperity_contact_zone_friction_judgement_h

#include <asperity/contact_zone/friction_result.h>
#include <asperity/contact_zone/load_protocol.h>

#include <string>
#include <vector>

namespace asperity
{
  /** Whether the mean of a run is a friction coefficient, and if not, why. */
  enum class FrictionStatus
  {
    valid,
    load_not_carried, ///< the mean vertical force is not the mean load
    contact_lost,     ///< after a touch, nothing carried the chip for a while
    along_the_motion, ///< the tool pushes the chip along its way: mu < 0
    scattered         ///< mu varies over the window by more than its mean
  };

  /** As in summary.json: "valid", "load not carried", ... */
  std::string
  name(const FrictionStatus status);

  /** What judge_friction() finds. */
  struct FrictionJudgement
  {
    /** The first that applies, in the order of the enum. */
    FrictionStatus status = FrictionStatus::valid;

    /** Mean vertical force over the mean load p L of the window. */
    double carried_load = 0.;

    /** A sentence for each that applies, with numbers and what to do. */
    std::vector<std::string> warnings;
  };

  /**
   * Judges the mean of a run. A dynamic chip may fly through the gap or bounce,
   * and a short way may end before friction has a sense: such means are numbers
   * but no friction coefficients. A window carries its load if the two agree to
   * 5 %; a coefficient below 1e-4 counts as zero, which is what the tolerances
   * of the solvers leave of it.
   *
   * @param rows of the whole run, in order of time
   * @param friction their mean, see average_friction()
   * @param length period of the scene [m]
   */
  FrictionJudgement
  judge_friction(const std::vector<FrictionRow> &rows,
                 const FrictionResult           &friction,
                 const LoadProtocol             &protocol,
                 const double                    length);
} // namespace asperity

#endif
