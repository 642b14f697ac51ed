#ifndef asperity_contact_zone_field_recorder_h
#define asperity_contact_zone_field_recorder_h

#include <asperity/contact_zone/sliding_run.h>
#include <asperity/postprocess/field_snapshots.h>

#include <string>

namespace asperity
{
  /**
   * Takes the fields of a chip in plane strain at the first accepted step at or
   * after each of the times of `Output/Field times`. Its places are those of
   * the mesh, so that runs of one mesh can be compared place by place.
   */
  class FieldRecorder
  {
  public:
    FieldRecorder(const SceneParameters &parameters, const Scene<2> &scene);

    /** After a step. @return whether its fields have been taken */
    bool
    step(const SlidingRun<2> &run);

    /** So far. */
    const FieldSnapshots &
    fields() const;

    /**
     * The snapshots that a run had taken which goes on from a step.
     * @param path of their file
     * @throws InputError if there is no such file, if it is of another mesh or
     *   of other times, or if it misses one of the times that are over
     */
    void
    go_on(const std::string &path, const RunState &state);

  private:
    FieldSnapshot
    take(const SlidingRun<2> &run) const;

    void
    take_chip(const dealii::Vector<double> &u,
              const double                  sliding,
              FieldSnapshot                &snapshot) const;

    void
    take_edge(const dealii::Vector<double> &u,
              const double                  sliding,
              FieldSnapshot                &snapshot) const;

    /** Sets the values of a field, if the chip has it. */
    void
    set(const std::string    &name,
        std::vector<double> &&values,
        FieldSnapshot        &snapshot) const;

    /** Of the next snapshot [s]. */
    double
    next_time() const;

    const SceneParameters &parameters;
    const Scene<2>        &scene;
    BasisTable<2>          nodes;
    double                 end_time;
    FieldSnapshots         fields_;
  };
} // namespace asperity

#endif
