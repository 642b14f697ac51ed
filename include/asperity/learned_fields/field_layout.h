#ifndef asperity_learned_fields_field_layout_h
#define asperity_learned_fields_field_layout_h

#include <asperity/postprocess/field_snapshots.h>

#include <string>
#include <vector>

namespace asperity
{
  /**
   * The fields of a run as one vector: time after time, field after field, as
   * in a snapshot. Time is another coordinate of a place here, so that one
   * latent code stands for all of a run.
   */
  class FieldLayout
  {
  public:
    FieldLayout() = default;

    /** @param about its snapshots do not count */
    explicit FieldLayout(const FieldSnapshots &about);

    /** Places, fields and shares of t_end, without snapshots. */
    const FieldSnapshots &
    about() const;

    unsigned int
    n_times() const;

    std::size_t
    n_fields() const;

    /** Length of the vector. */
    std::size_t
    size() const;

    /** Where a field at a time begins. */
    std::size_t
    offset(const unsigned int time, const std::size_t field) const;

    /** How many numbers it has. */
    std::size_t
    length(const std::size_t field) const;

    /** @throws InputError naming @p origin if the run is not complete, or has
     *  other places, fields or times */
    std::vector<double>
    pack(const FieldSnapshots &run, const std::string &origin) const;

    /** One vector a field, at a time. */
    std::vector<std::vector<double>>
    unpack(const std::vector<double> &values, const unsigned int time) const;

    /** Squared norm of a field over its places and all times: sum of weight
     *  times square. */
    double
    squared_norm(const std::vector<double> &values,
                 const std::size_t          field) const;

    /** Weights of an inner product of vectors in which each field counts alike:
     *  its place's weight over `variance`, one a field.
     *  @param variance mean squared norm of the deviations from the mean;
     *    positive */
    std::vector<double>
    weights(const std::vector<double> &variance) const;

  private:
    FieldSnapshots           about_;
    std::vector<std::size_t> offsets; ///< of the fields at the first time
  };
} // namespace asperity

#endif
