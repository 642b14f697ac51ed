#ifndef asperity_coupling_robin_coefficient_h
#define asperity_coupling_robin_coefficient_h

#include <asperity/coupling/coupling_sides.h>

#include <optional>
#include <vector>

namespace asperity
{
  class InputArchive;
  class OutputArchive;

  /**
   * Impedance of an interface under a load [Pa s/m],
   *   Z = sum_i F_i^2/l_i / (F . v),
   * where the force F changes the velocity by v and l_i is the length that
   * belongs to a component. Under a uniform traction this is the traction over
   * the mean velocity in its direction. Empty if F.v is not positive.
   */
  std::optional<double>
  interface_impedance(const dealii::Vector<double> &force,
                      const dealii::Vector<double> &velocity,
                      const dealii::Vector<double> &lengths);



  /**
   * The coefficient alpha of Robin's condition.
   *
   * For impedances Z_f of the fluid and Z_s of the solid an iteration without
   * acceleration contracts by
   *   q = Z_f |Z_s - alpha| / (Z_s (Z_f + alpha)),
   * for a sealed pocket (Z_f infinite) by |1 - alpha/Z_s|: alpha > 2 Z_s
   * diverges, alpha = Z_s is exact. Z_s, which contains inertia and the step,
   * is the solid's to tell: it is that of the solid's tangent (generalized by
   * the time scheme) under a uniform pressure or traction, whichever finds the
   * interface softest, as only a coefficient that is too large diverges.
   *
   * Secants, from changes of the force between iterations and what they did to
   * the displacement, correct it by what the tangent had foretold of the same
   * change, and stand in where there is no tangent. A coefficient is kept as
   * long as the new one is within a factor of two, since a quasi-Newton method
   * has to forget all its columns with it.
   */
  class RobinCoefficient
  {
  public:
    /** @param fixed value [Pa s/m]; empty: from the solid
     *  @throws InputError if it is not positive */
    explicit RobinCoefficient(const std::optional<double> fixed = {});

    /** Chooses the value for a step.
     *  @return whether there is one: neither given, nor tangent or secant */
    bool
    begin_step(SolidSide &solid, const FluidSide &fluid);

    /** A force of an iteration, and the displacement that it gave. */
    void
    observe(SolidSide                    &solid,
            const FluidSide              &fluid,
            const dealii::Vector<double> &force,
            const dealii::Vector<double> &displacement);

    double
    value() const;

    /** What a restart needs, between steps. */
    void
    save(OutputArchive &archive) const;

    void
    load(InputArchive &archive);

  private:
    /** Of the tangent at the solid's last result. */
    std::optional<double>
    softest_impedance(SolidSide &solid, const FluidSide &fluid) const;

    std::optional<double>  fixed;
    std::optional<double>  secant;          ///< impedance of the last change
    double                 correction = 1.; ///< secant over tangent
    dealii::Vector<double> last_force, last_displacement;
    double                 value_ = 0.;
  };
} // namespace asperity

#endif
