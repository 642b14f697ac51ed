#ifndef asperity_postprocess_field_picture_h
#define asperity_postprocess_field_picture_h

#include <asperity/postprocess/field_snapshots.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace asperity
{
  /** When and where a picture of fields is. */
  struct FieldMoment
  {
    double       time             = 0.; ///< [s]
    double       sliding_distance = 0.; ///< by which the chip is moved [m]
    unsigned int step             = 0;
  };

  /**
   * Writes the chip with displacement, strain, temperature [degC], stress and
   * equivalent stress as VTU: the picture that ChipOutput draws of the run.
   * @param values one vector a field, as in a snapshot
   * @throws ComputationError if there is no displacement, or a number is not
   *   finite
   */
  void
  write_chip_fields(std::ostream                           &out,
                    const FieldSnapshots                   &about,
                    const std::vector<std::vector<double>> &values,
                    const FieldMoment                      &moment);

  /** Writes the contact edge with all that stands on it as VTU. */
  void
  write_edge_fields(std::ostream                           &out,
                    const FieldSnapshots                   &about,
                    const std::vector<std::vector<double>> &values,
                    const FieldMoment                      &moment);

  /** Columns of write_edge_table(), with units. */
  std::vector<std::string>
  edge_columns(const FieldSnapshots &about);

  /** A row for each point of the edge: reference position, weight, and every
   *  component of the fields on it, as comma-separated values in SI units. */
  void
  write_edge_table(std::ostream                           &out,
                   const FieldSnapshots                   &about,
                   const std::vector<std::vector<double>> &values);
} // namespace asperity

#endif
