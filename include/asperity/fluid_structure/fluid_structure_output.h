#ifndef asperity_fluid_structure_fluid_structure_output_h
#define asperity_fluid_structure_fluid_structure_output_h

#include <asperity/base/input_record.h>
#include <asperity/fluid_structure/fluid_structure_run.h>
#include <asperity/postprocess/checkpoint.h>
#include <asperity/postprocess/chip_output.h>
#include <asperity/postprocess/vtu_series.h>

#include <string>
#include <vector>

namespace asperity
{
  /** The output folder of a fluid-structure run: fluid_structure.csv, pictures
   *  of fluid and body, checkpoints, and at the end summary.json. */
  class FluidStructureOutput
  {
  public:
    /** @param run whose rows and pictures so far are kept
     *  @throws ComputationError if the folder cannot be written */
    FluidStructureOutput(const FluidStructureParameters &parameters,
                         const InputRecord              &inputs,
                         const FluidStructureRun        &run);

    /** Table row always; pictures and checkpoints at their intervals. */
    void
    step(const FluidStructureRun &run);

    /** The last pictures, and summary.json. */
    void
    finish(const FluidStructureRun        &run,
           const std::vector<std::string> &warnings,
           const double                    wall_time);

    /** Writes a checkpoint now, e.g. before the run gives up. */
    void
    write_checkpoint(const FluidStructureRun &run) const;

  private:
    void
    write_pictures(const FluidStructureRun &run);

    const FluidStructureParameters &parameters;
    const InputRecord              &inputs;
    Table                           table;
    ChipOutput<2>                   body_output;
    VtuSeries                       fluid, body;
    CheckpointFolder                checkpoints;
    unsigned int                    last_picture;
  };
} // namespace asperity

#endif
