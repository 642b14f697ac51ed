#ifndef asperity_contact_zone_scene_output_h
#define asperity_contact_zone_scene_output_h

#include <asperity/base/input_record.h>
#include <asperity/contact_zone/accuracy_control.h>
#include <asperity/contact_zone/audit.h>
#include <asperity/contact_zone/field_recorder.h>
#include <asperity/contact_zone/sliding_run.h>
#include <asperity/postprocess/checkpoint.h>
#include <asperity/postprocess/chip_output.h>
#include <asperity/postprocess/friction_table.h>
#include <asperity/postprocess/vtu_series.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * The output directory of a run: friction.csv, pictures of chip, tool,
   * contact line and flow, fields, checkpoints, and at the end summary.json. On
   * several ranks each draws its cells of the chip, and the first one writes.
   */
  template <int dim>
  class SceneOutput
  {
  public:
    /**
     * @param inputs go into the checkpoints
     * @param state of the run when it begins: rows and pictures up to its step
     *   are kept
     * @throws ComputationError if the folder cannot be written, on the first
     *   rank
     */
    SceneOutput(const SceneParameters &parameters,
                const InputRecord     &inputs,
                const Scene<dim>      &scene,
                const RunState        &state);

    /** Table row always; pictures and checkpoints at their intervals, fields
     *  at their times.
     *  Collective. */
    void
    step(const SlidingRun<dim> &run);

    /** The last pictures, and summary.json. Collective.
     *  @param accuracy what is known of the error of mu; nothing is shown if
     *    none is wanted */
    void
    finish(const SlidingRun<dim>          &run,
           const SceneAudit               &audit,
           const AccuracyReport           &accuracy,
           const std::vector<std::string> &warnings,
           const double                    wall_time);

    /** Writes a checkpoint now, e.g. before the run gives up. On the first rank
     *  only. */
    void
    write_checkpoint(const SlidingRun<dim> &run) const;

    /** Seconds that writing has taken. */
    double
    seconds() const;

  private:
    struct Files
    {
      /** @param keep_until_step up to which pictures stay */
      Files(const std::string              &directory,
            const std::vector<FrictionRow> &rows,
            const int                       keep_until_step);

      FrictionTable              table;
      VtuSeries                  chip, tool, contact_line;
      std::unique_ptr<VtuSeries> oil; ///< of an oil that fills the gap
      CheckpointFolder           checkpoints;
    };

    void
    write_pictures(const SlidingRun<dim> &run);

    void
    write_chip(const SlidingRun<dim> &run);

    void
    write_fields(const SlidingRun<dim> &run);

    void
    write_tool(const unsigned int step, const double time);

    /** The contact edge: a line, or a surface in three dimensions. */
    void
    write_contact(const dealii::Vector<double> &u,
                  const unsigned int            step,
                  const double                  time);

    const SceneParameters         &parameters;
    const InputRecord             &inputs;
    const Scene<dim>              &scene;
    std::optional<ChipOutput<dim>> chip_output; ///< of the mesh below
    std::shared_ptr<const SplineHierarchy<dim>> drawn_mesh;
    std::unique_ptr<Files>                      files; ///< of the first rank
    unsigned int                                last_picture = 0;
    double                                      seconds_     = 0.;
    std::unique_ptr<FieldRecorder> recorder; ///< of a profile whose fields go
                                             ///< into fields.h5
  };

  template <>
  void
  SceneOutput<2>::write_tool(const unsigned int step, const double time);
  template <>
  void
  SceneOutput<3>::write_tool(const unsigned int step, const double time);
  template <>
  void
  SceneOutput<2>::write_contact(const dealii::Vector<double> &u,
                                const unsigned int            step,
                                const double                  time);
  template <>
  void
  SceneOutput<3>::write_contact(const dealii::Vector<double> &u,
                                const unsigned int            step,
                                const double                  time);
} // namespace asperity

#endif
