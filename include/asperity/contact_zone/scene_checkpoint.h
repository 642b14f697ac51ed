#ifndef asperity_contact_zone_scene_checkpoint_h
#define asperity_contact_zone_scene_checkpoint_h

#include <asperity/contact_zone/sliding_run.h>
#include <asperity/postprocess/checkpoint.h>

#include <string>

namespace asperity
{
  /** The state of a run for Checkpoint::state: all that its next steps depend
   *  on. */
  template <int dim>
  std::string
  save(const SlidingRun<dim> &run, const Scene<dim> &scene);

  /**
   * Continues from what save() wrote for a run of the same inputs.
   * @throws InputError if the bytes are damaged, or of another scene; run and
   *   scene are then useless
   */
  template <int dim>
  void
  load(const std::string &bytes, SlidingRun<dim> &run, Scene<dim> &scene);

  /**
   * Whether a restart may have another value of an entry than the run that it
   * goes on from: where pictures and tables go, how mu is averaged, when a
   * `steady` run ends, and how hard the solvers try. All other entries change
   * the steps that have been made, or make the coming ones steps of another
   * protocol.
   * @param path of the entry, "Load/Pressure"
   */
  bool
  may_differ_on_restart(const std::string &path);

  /**
   * The newest checkpoint that is whole; with a warning if another program
   * wrote it.
   * @throws InputError (half a sentence or one) if there is none, or if it is
   *   of a run with other inputs
   */
  CheckpointFolder::Found
  find_checkpoint(const CheckpointFolder &folder,
                  const InputRecord      &inputs,
                  const std::string      &program);
} // namespace asperity

#endif
