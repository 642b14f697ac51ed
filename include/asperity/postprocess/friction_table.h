#ifndef asperity_postprocess_friction_table_h
#define asperity_postprocess_friction_table_h

#include <asperity/postprocess/table.h>

#include <string>

namespace asperity
{
  /**
   * What a time step says about friction. SI units; forces are those of the
   * tool on the chip, integrated over one period and per metre of thickness.
   */
  struct FrictionRow
  {
    unsigned int step                 = 0;
    double       time                 = 0.; ///< [s]
    double       sliding_distance     = 0.; ///< [m]
    double       T_x                  = 0.; ///< [N/m]
    double       T_y                  = 0.; ///< [N/m]
    double       mu                   = 0.; ///< 0 as long as nothing is loaded
    double       contact_fraction     = 0.; ///< of the period
    double       max_contact_pressure = 0.; ///< [Pa]
    double       max_plastic_strain   = 0.;
    double       max_temperature      = 0.; ///< [K]
    double       mean_gap             = 0.; ///< [m]
    double       max_penetration      = 0.; ///< [m], positive
    unsigned int newton_iterations    = 0;
    unsigned int factorisations       = 0;
    double       wall_time            = 0.; ///< [s] of this step
  };

  /**
   * `friction.csv` of an output directory (SI) and its companion
   * `friction_units.csv` with the same rows in us, um, MPa and degC.
   */
  class FrictionTable
  {
  public:
    /** A new pair of tables; older ones are replaced. */
    explicit FrictionTable(const std::string &directory);

    /** Continues the tables of a run that restarts after `step`: rows of later
     *  steps are removed. @throws InputError if the headings differ. */
    FrictionTable(const std::string &directory, const unsigned int step);

    /** @throws ComputationError naming the column that is not finite. */
    void
    append(const FrictionRow &row);

  private:
    Table table;
  };
} // namespace asperity

#endif
