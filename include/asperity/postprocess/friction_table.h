#ifndef asperity_postprocess_friction_table_h
#define asperity_postprocess_friction_table_h

#include <asperity/postprocess/table.h>

#include <string>
#include <variant>
#include <vector>

namespace asperity
{
  /**
   * What a time step says about friction, as the columns of friction_columns()
   * explain. SI units; forces are those of the tool and the oil on the chip,
   * integrated over one period and per metre of thickness. Volumes are per
   * metre of thickness, too.
   */
  struct FrictionRow
  {
    unsigned int step                  = 0;
    double       time                  = 0.;
    double       sliding_distance      = 0.;
    double       T_x                   = 0.;
    double       T_y                   = 0.;
    double       T_transverse          = 0.;
    double       mu                    = 0.;
    double       ploughing             = 0.;
    double       interface_shear       = 0.;
    double       oil_shear             = 0.;
    double       interface_T_x         = 0.;
    double       interface_T_y         = 0.;
    double       sticking              = 0.;
    double       contact_fraction      = 0.;
    double       touching_length       = 0.;
    double       max_contact_pressure  = 0.;
    double       real_contact_pressure = 0.;
    double       max_plastic_strain    = 0.;
    double       max_temperature       = 0.;
    double       flash_temperature     = 0.;
    double       plastic_heat          = 0.;
    double       friction_heat         = 0.;
    double       stored_heat           = 0.;
    double       depth_heat            = 0.;
    double       tool_heat             = 0.;
    double       heat_balance_error    = 0.;
    double       mean_gap              = 0.;
    double       max_penetration       = 0.;
    double       oil_pressure          = 0.;
    double       max_oil_pressure      = 0.;
    double       oil_T_x               = 0.;
    double       shear_T_x             = 0.;
    double       shear_T_y             = 0.;
    double       void_volume           = 0.;
    double       oil_volume            = 0.;
    double       oil_reference_volume  = 0.;
    double       oil_in                = 0.;
    double       oil_out               = 0.;
    unsigned int pockets               = 0;
    unsigned int coupling_iterations   = 0;
    unsigned int newton_iterations     = 0;
    unsigned int factorisations        = 0;
    double       wall_time             = 0.;

    /** For archives of Boost.Serialization; all columns. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int);
  };

  /** A unit in which results are stored, and the one that people read. */
  struct ResultUnit
  {
    std::string si, people; ///< "m", "um"; empty: a number of an order
    double      factor = 1., offset = 0.; ///< people = factor * SI + offset
  };

  /** One entry of a FrictionRow wherever it appears: in friction.csv,
   *  friction_units.csv, summary.json, checkpoints and documentation. */
  struct FrictionColumn
  {
    std::string name; ///< "sliding distance"
    ResultUnit  unit;
    std::string meaning; ///< a sentence

    std::variant<double FrictionRow::*, unsigned int FrictionRow::*> member;

    /** Where summary.json has its value at the end of a run, as a JSON pointer;
     *  empty: nowhere. */
    std::string summary;

    /** "time [s]", and "time [us]" in people's units. */
    std::string
    heading(const bool people = false) const;

    double
    value(const FrictionRow &row) const;
  };

  /** All entries of a FrictionRow, in the order of the table's columns. */
  const std::vector<FrictionColumn> &
  friction_columns();

  /**
   * `friction.csv` of an output directory (SI) and its companion
   * `friction_units.csv` with the same rows in us, um, MPa and degC.
   */
  class FrictionTable
  {
  public:
    /**
     * A new pair of tables; older ones are replaced.
     * @param earlier rows of the run that is continued; that of step 0 has no
     *   line
     * @throws ComputationError as append()
     */
    explicit FrictionTable(const std::string              &directory,
                           const std::vector<FrictionRow> &earlier = {});

    /** @throws ComputationError naming the column that is not finite, or the
     *  file that cannot be written */
    void
    append(const FrictionRow &row);

  private:
    Table table;
  };



  template <typename Archive>
  void
  FrictionRow::serialize(Archive &archive, const unsigned int)
  {
    for (const FrictionColumn &column : friction_columns())
      std::visit([&](const auto member) { archive &(this->*member); },
                 column.member);
  }
} // namespace asperity

#endif
