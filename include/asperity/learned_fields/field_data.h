#ifndef asperity_learned_fields_field_data_h
#define asperity_learned_fields_field_data_h

#include <asperity/learned_fields/field_layout.h>
#include <asperity/surrogate/friction_law.h>

#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  /** A run of a campaign with its fields. */
  struct FieldRun
  {
    unsigned int        id   = 0;
    bool                held = false; ///< judges the model, does not train it
    std::vector<double> x;            ///< inputs, SI
    std::vector<double> values;       ///< of the FieldLayout
    std::vector<double> mu;           ///< at each time
  };

  /** What a time of a campaign's runs has in common. */
  struct FieldTime
  {
    double share            = 1.; ///< of t_end
    double time             = 0.; ///< mean over the runs [s]
    double sliding_distance = 0.; ///< mean over the runs [m]
    double direction        = 1.; ///< of the sliding along x
    double pressure         = 0.; ///< load over Load/Pressure, or the load [Pa]
                                  ///< if that is no input
  };

  /** The runs of a campaign that have fields. */
  struct FieldData
  {
    /** Inputs and what laws see of them. */
    FrictionLawDescription description;
    FieldLayout            layout;
    std::vector<FieldTime> times;
    std::vector<FieldRun>  runs;

    std::vector<std::string> warnings;

    std::size_t
    n_runs(const bool held) const;
  };

  /** Number of the input Load/Pressure, if the law has it. */
  std::optional<std::size_t>
  pressure_of(const FrictionLawDescription &description);

  /**
   * Reads the folder of a campaign: runs.csv, runs/0001.h5 and so on, and, if
   * it is there, friction_law.json, from which it takes what laws see of the
   * inputs.
   * @param held_out share of all runs that are held out, every so manieth; if
   *   none is given, the test runs of the campaign, or a fifth without any
   * @throws InputError if the folder is no campaign's, if its runs have no
   *   fields, several profiles, or too few runs are left to train with
   */
  FieldData
  read_fields(const std::string          &campaign,
              const std::optional<double> held_out = {});
} // namespace asperity

#endif
