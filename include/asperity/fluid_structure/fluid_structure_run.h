#ifndef asperity_fluid_structure_fluid_structure_run_h
#define asperity_fluid_structure_fluid_structure_run_h

#include <asperity/fluid_structure/problem.h>
#include <asperity/postprocess/table.h>

#include <functional>
#include <string>
#include <vector>

namespace asperity
{
  /** What is reported of an accepted step. */
  struct FluidStructureRow
  {
    double               time = 0.;          ///< [s]
    dealii::Tensor<1, 2> displacement;       ///< of the watched point [m]
    dealii::Tensor<1, 2> force;              ///< drag and lift [N/m]
    double               mean_pressure = 0.; ///< of the fluid [Pa]
    double               volume        = 0.; ///< of the fluid [m^2]
    double               iterations    = 0.; ///< of the coupling

    /** In the order of columns(). */
    std::vector<double>
    values() const;

    static std::vector<TableColumn>
    columns();

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &time &displacement[0] & displacement[1] & force[0] & force[1] &
        mean_pressure &volume &iterations;
    }
  };

  /** The steps of a fluid-structure problem over time. */
  class FluidStructureRun
  {
  public:
    /** Both must outlive this object. */
    FluidStructureRun(const FluidStructureParameters &parameters,
                      FluidStructureProblem          &problem);

    /**
     * Computes all steps that are left. A step without solution is halved.
     * @param after_step is called with each accepted step
     * @throws ComputationError if halving does not help
     */
    void
    run(const std::function<void(const FluidStructureRun &)> &after_step);

    /** Goes on from the end of a run of the same body on another mesh, see
     *  FluidStructure::continue_from().
     *  @throws InputError if the bodies have different numbers of unknowns */
    void
    continue_from(const FluidStructureRun &other);

    double
    time() const;

    /** Accepted steps. */
    const std::vector<FluidStructureRow> &
    rows() const;

    unsigned int
    n_cuts() const;

    /** Of the fluid, at the start [m^2]. */
    double
    initial_volume() const;

    const FluidStructureProblem &
    problem() const;

    /** All that a run which goes on depends on. Tangents of the flow that are
     *  kept from step to step are forgotten here and in load(), so that the run
     *  that is continued repeats the one that goes on. */
    std::string
    save() const;

    /** Takes what save() returned.
     *  @throws InputError if that is of other meshes */
    void
    load(const std::string &bytes);

  private:
    void
    step(double dt);

    const FluidStructureParameters &parameters;
    FluidStructureProblem          &problem_;
    double                          time_ = 0.;
    double                          initial_volume_;
    unsigned int                    n_cuts_ = 0;
    std::vector<FluidStructureRow>  rows_;
  };
} // namespace asperity

#endif
