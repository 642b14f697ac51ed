#ifndef asperity_coupling_partitioned_step_h
#define asperity_coupling_partitioned_step_h

#include <asperity/coupling/coupling_parameters.h>
#include <asperity/coupling/coupling_sides.h>
#include <asperity/coupling/robin_coefficient.h>

#include <deque>
#include <memory>
#include <vector>

namespace asperity
{
  /**
   * How far the two sides are from each other after an iteration; root mean
   * squares over the components of the interface. Where an incompressible fluid
   * or a balance of forces holds the interface at rest, its motion is no scale
   * for errors; then the displacement that the whole force would cause, by the
   * solid's tangent, is one, and its rate.
   */
  struct CouplingResidual
  {
    /** Change of the displacement that the force not yet carried would cause,
     *  by the solid's tangent, over the change in the step; without a tangent,
     *  the change since the last iteration. */
    double displacement = 0.;

    /** Difference between the fluid's force and the one that the solid carries,
     *  over the former. */
    double force = 0.;

    /** Difference between the velocities of fluid and wall over the larger of
     *  the two. */
    double velocity_jump = 0.;

    /** The largest of the three. */
    double
    maximum() const;
  };



  /**
   * A time step of a fluid and a solid that share an interface, by iterations
   * between the two. The unknown of the iteration is the force F on the solid:
   *
   *   F from earlier steps
   *   repeat
   *     d = solid(F)                           Neumann
   *     F_fluid, v = fluid(d, F)               Robin or Dirichlet
   *     until d, F and v - v_wall are settled
   *     F = acceleration(F, F_fluid)
   *
   * Robin: F_fluid = F + alpha M (v - v_wall), so that the fluid may cross the
   * wall as long as the force is not yet the right one; at the end it does not,
   * since the jump of velocity is one of the measures.
   * (S. Badia, F. Nobile, C. Vergara, J. Comput. Phys. 227 (2008) 7027-7051;
   * T. Spenke, M. Make, N. Hosters, IJNME 124 (2023) 979-997.) Dirichlet: v =
   * v_wall; diverges without acceleration if the fluid is the heavier of the
   * two, and has no solution at all if the fluid is sealed.
   */
  class PartitionedStep
  {
  public:
    using Vector = dealii::Vector<double>;

    /** The sides must outlive this object.
     *  @throws InputError if the scheme cannot work: Dirichlet-Neumann with a
     *  sealed fluid */
    PartitionedStep(SolidSide                &solid,
                    FluidSide                &fluid,
                    const CouplingParameters &parameters);

    /**
     * Computes and accepts a step. report.residual is the last
     * CouplingResidual::maximum(). On failure nothing is accepted: a shorter
     * step may be tried from the same start.
     */
    ConvergenceReport
    advance(const double dt);

    /** One an iteration of the last step. */
    const std::vector<CouplingResidual> &
    residuals() const;

    /** [Pa s/m] in the last step. */
    double
    robin_coefficient() const;

    /** On the solid, at the end of the last accepted step; empty before. */
    const Vector &
    force() const;

    /** See force(). */
    const Vector &
    displacement() const;

    /** Starts from this force and displacement at time zero of this object, as
     *  a restart does. */
    void
    set_state(const Vector &force, const Vector &displacement);

    /** All that goes on from step to step, for a restart that repeats the run:
     *  forces, displacement, coefficient and acceleration. */
    void
    save(OutputArchive &archive) const;

    /** Takes what save() wrote.
     *  @throws InputError if that is of another interface */
    void
    load(InputArchive &archive);

  private:
    ConvergenceReport
    iterate(const double dt);

    Vector
    predict(const double dt) const;

    CouplingResidual
    measure(const WallCondition &condition,
            const WallResponse  &response,
            const Vector        &last_displacement);

    struct Accepted
    {
      double time = 0.;
      Vector force;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &time &force;
      }
    };

    SolidSide                    &solid;
    FluidSide                    &fluid;
    CouplingParameters            parameters;
    std::unique_ptr<Acceleration> acceleration;
    RobinCoefficient              robin;
    WallCondition                 condition;
    Vector                        old_displacement;
    std::deque<Accepted>          history; ///< newest first
    std::vector<CouplingResidual> residuals_;
  };
} // namespace asperity

#endif
