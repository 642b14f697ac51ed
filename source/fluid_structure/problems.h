#ifndef asperity_source_fluid_structure_problems_h
#define asperity_source_fluid_structure_problems_h

#include <asperity/fluid_structure/problem.h>

#include <functional>
#include <string>
#include <vector>

/** The parts of make_problem(), a file for each kind. */
namespace asperity
{
  std::unique_ptr<FluidStructureProblem>
  make_turek_hron(const FluidStructureParameters &parameters);

  std::unique_ptr<FluidStructureProblem>
  make_inflatable_box(const FluidStructureParameters &parameters);

  std::unique_ptr<FluidStructureProblem>
  make_lined_channel(const FluidStructureParameters &parameters);

  std::unique_ptr<FluidStructureProblem>
  make_enclosed_domain(const FluidStructureParameters &parameters);

  /** What the entries say of fluid, body and coupling. */
  FluidStructureOptions
  options_of(const FluidStructureParameters &parameters);

  /** Fills the mesh by `generate`, or from the file if one is named.
   *  @param names of the boundary ids that it must have, "0 (inlet)" for 0
   *  @throws InputError if the file cannot be read or has other boundaries */
  void
  make_or_read_mesh(dealii::Triangulation<2>       &mesh,
                    const std::string              &file,
                    const std::vector<std::string> &names,
                    const std::function<void()>    &generate);

  /** 0, 1/n, ..., 1 */
  std::vector<double>
  uniform_breaks(const unsigned int n);

  /** At rest, for boundary conditions. */
  FluidFunction
  no_velocity();
} // namespace asperity

#endif
