#ifndef asperity_postprocess_friction_table_h
#define asperity_postprocess_friction_table_h

#include <asperity/postprocess/table.h>

#include <string>

namespace asperity
{
  /**
   * What a time step says about friction. SI units; forces are those of the
   * tool and the oil on the chip, integrated over one period and per metre of
   * thickness. Volumes are per metre of thickness, too.
   */
  struct FrictionRow
  {
    unsigned int step                 = 0;
    double       time                 = 0.; ///< [s]
    double       sliding_distance     = 0.; ///< [m]
    double       T_x                  = 0.; ///< contact and oil [N/m]
    double       T_y                  = 0.; ///< contact and oil [N/m]
    double       mu                   = 0.; ///< 0 as long as nothing is loaded
    double       contact_fraction     = 0.; ///< of the period
    double       max_contact_pressure = 0.; ///< [Pa]
    double       max_plastic_strain   = 0.;
    double       max_temperature      = 0.; ///< [K]
    double       mean_gap             = 0.; ///< [m]
    double       max_penetration      = 0.; ///< [m], positive
    double       oil_pressure         = 0.; ///< vertical force over L [Pa]
    double       max_oil_pressure     = 0.; ///< [Pa]
    double       oil_T_x              = 0.; ///< by the oil's pressure [N/m]
    double       shear_T_x            = 0.; ///< by the oil's shear [N/m]
    double       shear_T_y            = 0.; ///< by the oil's shear [N/m]
    double       void_volume          = 0.; ///< between the surfaces [m^2]
    double       oil_volume           = 0.; ///< at its pressure [m^2]
    double       oil_reference_volume = 0.; ///< at p = 0, its mass [m^2]
    unsigned int pockets              = 0;
    unsigned int coupling_iterations  = 0;
    unsigned int newton_iterations    = 0;
    unsigned int factorisations       = 0;
    double       wall_time            = 0.; ///< [s] of this step
  };

  /** Calls f with each entry of a row, in the order of the table's columns. */
  template <typename Row, typename Function>
  void
  for_each_entry(Row &row, const Function &f)
  {
    f(row.step);
    f(row.time);
    f(row.sliding_distance);
    f(row.T_x);
    f(row.T_y);
    f(row.mu);
    f(row.contact_fraction);
    f(row.max_contact_pressure);
    f(row.max_plastic_strain);
    f(row.max_temperature);
    f(row.mean_gap);
    f(row.max_penetration);
    f(row.oil_pressure);
    f(row.max_oil_pressure);
    f(row.oil_T_x);
    f(row.shear_T_x);
    f(row.shear_T_y);
    f(row.void_volume);
    f(row.oil_volume);
    f(row.oil_reference_volume);
    f(row.pockets);
    f(row.coupling_iterations);
    f(row.newton_iterations);
    f(row.factorisations);
    f(row.wall_time);
  }

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
