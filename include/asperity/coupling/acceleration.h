#ifndef asperity_coupling_acceleration_h
#define asperity_coupling_acceleration_h

#include <deal.II/lac/vector.h>

#include <memory>
#include <vector>

namespace asperity
{
  class InputArchive;
  class OutputArchive;

  enum class AccelerationKind
  {
    relaxation, ///< constant factor
    aitken,     ///< factor from the last two residuals
    iqn_ils     ///< quasi-Newton, inverse by least squares
  };

  struct AccelerationParameters
  {
    AccelerationKind kind = AccelerationKind::iqn_ils;

    /** The constant factor; of the others that of the first iteration. */
    double relaxation = 1.;

    /** Quasi-Newton: steps whose columns are used besides those of the present
     *  step. */
    unsigned int reused_steps = 5;

    /** Quasi-Newton: a column is dropped if less than this share of its norm is
     *  orthogonal to the newer ones. */
    double filter = 1e-3;
  };

  /**
   * Turns a fixed-point iteration x <- H(x), repeated in each time step, into a
   * faster or a convergent one. With r = H(x) - x:
   *
   *   start_step();
   *   repeat  x = next(x, H(x))  until r is small;
   *   finish_step(converged);
   *
   * Every method returns H(x) itself where r = 0, and never divides by zero:
   * not at rest, where nothing changes, and not where two inputs are the same.
   */
  class Acceleration
  {
  public:
    using Vector = dealii::Vector<double>;

    virtual ~Acceleration() = default;

    virtual void
    start_step() = 0;

    /** The next input. */
    virtual Vector
    next(const Vector &x, const Vector &Hx) = 0;

    /** What an unconverged step has taught is forgotten with all the rest. */
    virtual void
    finish_step(const bool converged);

    /** Forgets what earlier steps have taught: H has changed. */
    virtual void
    reset();

    /** What earlier steps have taught; between steps. */
    virtual void
    save(OutputArchive &archive) const;

    /** Takes what save() wrote.
     *  @throws InputError if that is of another number of unknowns */
    virtual void
    load(InputArchive &archive, const std::size_t n_unknowns);
  };

  /** x + omega r. */
  class ConstantRelaxation : public Acceleration
  {
  public:
    explicit ConstantRelaxation(const double factor);

    void
    start_step() override;

    Vector
    next(const Vector &x, const Vector &Hx) override;

  private:
    double factor;
  };

  /**
   * Aitken's factor for vectors, omega <- -omega r_old.(r - r_old)/|r -
   * r_old|^2 (B. M. Irons, R. C. Tuck, IJNME 1 (1969) 275-277). A step starts
   * with the first factor, since the last one of a step belongs to what was
   * left of r.
   */
  class AitkenRelaxation : public Acceleration
  {
  public:
    explicit AitkenRelaxation(const double first_factor);

    void
    start_step() override;

    Vector
    next(const Vector &x, const Vector &Hx) override;

  private:
    double first_factor, factor;
    Vector old_residual; ///< empty in the first iteration of a step
  };

  /** @throws InputError if the relaxation factor is not in (0, 2] */
  std::unique_ptr<Acceleration>
  make_acceleration(const AccelerationParameters &parameters);
} // namespace asperity

#endif
