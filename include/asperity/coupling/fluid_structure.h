#ifndef asperity_coupling_fluid_structure_h
#define asperity_coupling_fluid_structure_h

#include <asperity/coupling/ale_fluid.h>
#include <asperity/coupling/partitioned_step.h>
#include <asperity/coupling/spline_solid.h>
#include <asperity/mesh_motion/elastic_mesh_update.h>

#include <functional>
#include <memory>
#include <vector>

namespace asperity
{
  struct FluidStructureOptions
  {
    FluidOptions       fluid;
    SplineSolidOptions solid;
    CouplingParameters coupling;

    /** The mesh is stiffer where its cells are small, ElasticMeshOptions. */
    double mesh_stiffening = 1.;
  };

  /** The elastic body of a FluidStructure: a patch and where it is held. */
  struct SplineBody
  {
    std::shared_ptr<const SplineSpace<2>> space;
    PatchGeometry<2>                      geometry;
    std::shared_ptr<const MaterialLaw>    law;

    std::vector<Edge> clamped;   ///< edges that do not move
    std::vector<Edge> held_in_y; ///< edges that move along x only
    std::vector<Edge> wet;       ///< edges that the fluid touches
  };

  /** The boundaries of the flow that are more than a condition for it. */
  struct FluidWalls
  {
    BoundaryIds wet; ///< on the body's wet edges

    /** Rigid walls and how they move over time, from rest [m]. */
    BoundaryIds      moving;
    AleFluid::Motion motion;

    /** Straight walls along x that the fluid slides along: v_y = 0. */
    BoundaryIds sliding;
  };



  /**
   * A plane flow and an elastic spline body in it, from rest: the flow on a
   * mesh that follows body and moving walls by the elastic mesh update, all
   * other boundaries of the mesh held (nodes of the sliding ones find their x),
   * and the two coupled by PartitionedStep.
   *
   * Boundary conditions of the flow besides those of the wall are set through
   * flow() before the first step.
   */
  class FluidStructure
  {
  public:
    /**
     * @param mesh of the fluid, must outlive this object and not change
     * @throws InputError if mesh and body do not touch
     */
    FluidStructure(const dealii::Triangulation<2> &mesh,
                   const FluidWalls               &walls,
                   const SplineBody               &body,
                   const FluidStructureOptions    &options);

    /** One coupled step; see PartitionedStep::advance(). */
    ConvergenceReport
    advance(const double dt);

    NavierStokes &
    flow();

    const NavierStokes &
    flow() const;

    /** @throws InputError at the first call if the coupling scheme cannot work
     *  with the boundary conditions of the flow */
    PartitionedStep &
    coupling();

    /** Of the body at a parameter of its patch [m]. */
    dealii::Tensor<1, 2>
    displacement(const dealii::Point<2> &parameter) const;

    const SplineSolid &
    solid() const;

    const SplineBody &
    body() const;

    /** With the stresses of the body. */
    const SolidAssembler<2> &
    body_assembler() const;

    /** The last accepted step with all that the next ones depend on: a run
     *  continued from them repeats the one that it comes from. (Kept tangents
     *  are not saved; with them it repeats within the tolerance.) */
    void
    save(OutputArchive &archive);

    /** Takes what save() wrote.
     *  @throws InputError if that is of other meshes */
    void
    load(InputArchive &archive);

    /** Continues from the last accepted step of the same body in a fluid mesh
     *  of other refinement or degree, see interpolate_to_mesh(): a flow
     *  develops at less cost on a coarse mesh.
     *  @throws InputError if the bodies have different numbers of unknowns */
    void
    continue_from(const FluidStructure &other);

  private:
    /** Builds the sides, when all terms are known. */
    void
    start();

    FluidStructureOptions            options;
    SplineBody                       body_;
    NavierStokes                     flow_;
    ElasticMeshUpdate                mesh_update;
    AleFluid                         fluid_side;
    Interface                        interface;
    SolidAssembler<2>                assembler;
    std::unique_ptr<SplineSolid>     solid_side;
    std::unique_ptr<PartitionedStep> step;
  };
} // namespace asperity

#endif
