#ifndef asperity_fluid_structure_problem_h
#define asperity_fluid_structure_problem_h

#include <asperity/coupling/fluid_structure.h>
#include <asperity/fluid_structure/problem_parameters.h>

#include <deal.II/grid/tria.h>

#include <memory>
#include <string>

namespace asperity
{
  /** A fluid, an elastic body in it, and what is watched of them. */
  struct FluidStructureProblem
  {
    dealii::Triangulation<2>        mesh; ///< of the fluid
    std::unique_ptr<FluidStructure> system;

    /** Parameter of the body's patch whose displacement is reported. */
    dealii::Point<2> watched;

    /** Boundaries whose force is reported as drag and lift: those of the body
     *  and, of Turek and Hron's flag, the cylinder. */
    BoundaryIds loaded;

    dealii::Tensor<1, 2>
    displacement() const;

    /** The mean over the fluid [Pa]. */
    double
    mean_pressure() const;
  };

  /**
   * The problem that the parameters describe, at rest.
   * @throws InputError if a mesh file cannot be read, has other boundaries than
   *   the problem needs, or does not touch the body; if surfaces cross; and if
   *   the coupling scheme cannot work with the boundary conditions
   */
  std::unique_ptr<FluidStructureProblem>
  make_problem(const FluidStructureParameters &parameters);

  /** sqrt(M h/(rho H)), the speed of a long wave in the lined channel [m/s],
   *  with the modulus of uniaxial strain M = lambda + 2 mu of the lining, its
   *  thickness H, and height h and density rho of the fluid: the plane form of
   *  Moens and Korteweg's speed. */
  double
  wave_speed_of_lined_channel(const FluidStructureParameters &parameters);

  /** Volume that flows into the inflatable box [m^2/s]. */
  double
  inflow_of_box(const ProblemParameters &parameters, const double time);
} // namespace asperity

#endif
