#ifndef asperity_coupling_coupling_sides_h
#define asperity_coupling_coupling_sides_h

#include <asperity/base/convergence_report.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace asperity
{
  /**
   * What crosses the interface, in nodal components that both sides number
   * alike. A force is that of the fluid on the solid, consistent with the
   * fluid's velocity space [N/m, per metre of thickness]; displacements [m] and
   * velocities [m/s] are those of the nodes.
   *
   * A side lives in steps: begin_step() goes back to the last accepted state,
   * solve() may be called any number of times and starts from its last result,
   * accept() makes the last result the start of the next step.
   */
  class SolidSide
  {
  public:
    using Vector = dealii::Vector<double>;

    virtual ~SolidSide() = default;

    /** @param dt [s] */
    virtual void
    begin_step(const double dt) = 0;

    /** The displacement at the end of the step under a force. */
    virtual ConvergenceReport
    solve(const Vector &force, Vector &displacement) = 0;

    /**
     * The derivative of the displacement in the direction of a force, at the
     * last result, over the present step.
     * @return false if there is none (no tangent, or a singular one)
     */
    virtual bool
    compliance(const Vector &force, Vector &displacement) = 0;

    virtual void
    accept() = 0;
  };



  /** What the fluid is told at the interface. */
  struct WallCondition
  {
    /**
     * Coefficient alpha of Robin's condition [Pa s/m]; infinite: the fluid has
     * the velocity of the wall (Dirichlet). With v_wall the velocity of the
     * wall and F the given force, the force on the solid is, M the mass matrix
     * of the interface,
     *   F_fluid = F + alpha M (v - v_wall).
     */
    double alpha = 0.;

    dealii::Vector<double> displacement; ///< of the wall at the end of the step
    dealii::Vector<double> force;        ///< F
  };

  struct WallResponse
  {
    dealii::Vector<double> force;         ///< of the fluid on the solid
    dealii::Vector<double> velocity;      ///< of the fluid
    dealii::Vector<double> wall_velocity; ///< the rate of the displacement
  };

  /** See SolidSide. The wall's velocity is the rate of its displacement by the
   *  fluid's own time scheme, so that the fluid conserves volume. */
  class FluidSide
  {
  public:
    using Vector = dealii::Vector<double>;

    virtual ~FluidSide() = default;

    virtual void
    begin_step(const double dt) = 0;

    virtual ConvergenceReport
    solve(const WallCondition &condition, WallResponse &response) = 0;

    virtual void
    accept() = 0;

    /** An incompressible fluid that cannot leave: if the interface has a
     *  prescribed velocity, so has the whole boundary. */
    virtual bool
    is_sealed() const = 0;

    /** Derivative of the wall's velocity with respect to its displacement in
     *  the present step [1/s]; zero in a steady flow. */
    virtual double
    rate_coefficient() const = 0;

    /** Length of the interface that belongs to each component [m]. */
    virtual Vector
    lengths() const = 0;

    /** Forces on the solid by uniform loads of 1 Pa: a pressure, and tractions
     *  along the axes. Robin's coefficient is judged by them. */
    virtual std::vector<Vector>
    uniform_loads() const = 0;
  };
} // namespace asperity

#endif
