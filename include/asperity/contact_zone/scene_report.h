#ifndef asperity_contact_zone_scene_report_h
#define asperity_contact_zone_scene_report_h

#include <asperity/contact_zone/audit.h>
#include <asperity/contact_zone/error_estimate.h>
#include <asperity/contact_zone/sliding_run.h>

#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  // What the program prints of a scene on standard output.

  /** Surfaces, mesh, audit and models.
   *  @param heat the model in use
   *  @param explain with the treatment of measured surfaces, and what the
   *  numbers of the audit say */
  template <int dim>
  void
  print_scene(const Scene<dim> &scene,
              const SceneAudit &audit,
              const HeatModel   heat,
              const bool        explain);

  /** The solver of the tangent, as the parameters name it. */
  std::string
  name_of_solver(const LinearSolverKind kind);

  /** The solver and the ranks of a scene in three dimensions; nothing in two.
   */
  template <int dim>
  void
  print_ranks(const Scene<dim> &scene);

  /** The entries that the models do not read, by what they count with. */
  void
  print_unused(const std::vector<UnusedEntry> &entries);

  /** A line each. */
  void
  print_warnings(const std::vector<std::string> &warnings);

  /** mu and what belongs to it at the end of a run.
   *  @param error of mu, if it is known
   *  @param seconds that all of it has taken */
  template <int dim>
  void
  print_result(const SlidingRun<dim>              &run,
               const SceneParameters              &parameters,
               const std::optional<ErrorEstimate> &error,
               const double                        seconds);
} // namespace asperity

#endif
