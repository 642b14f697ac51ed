#ifndef asperity_coupling_quasi_newton_h
#define asperity_coupling_quasi_newton_h

#include <asperity/coupling/acceleration.h>

#include <deque>
#include <utility>

namespace asperity
{
  /**
   * Interface quasi-Newton with the inverse Jacobian from a least-squares
   * model, IQN-ILS (J. Degroote, K.-J. Bathe, J. Vierendeels, Comput. Struct.
   * 87 (2009) 793-801): with the columns V of differences of successive
   * residuals r and W of successive H(x),
   *
   *   x_new = H(x) + W c,  c = argmin |r + V c|.
   *
   * A linear H on n unknowns is solved by n + 1 evaluations.
   *
   * Columns of earlier steps follow those of the present one, newest first. A
   * column whose part orthogonal to all newer ones is below `filter` times its
   * own norm carries noise and is dropped for good (the filter QR2 of R.
   * Haelterman et al., Comput. Struct. 171 (2016) 9-17, per column, so that
   * columns of different size are judged alike). Without columns the step is
   * one of Aitken's.
   */
  class QuasiNewton : public Acceleration
  {
  public:
    /** See AccelerationParameters. */
    QuasiNewton(const double       first_factor,
                const unsigned int reused_steps,
                const double       filter);

    void
    start_step() override;

    Vector
    next(const Vector &x, const Vector &Hx) override;

    void
    finish_step(const bool converged) override;

    void
    reset() override;

    void
    save(OutputArchive &archive) const override;

    void
    load(InputArchive &archive, const std::size_t n_unknowns) override;

    /** Columns in use after the filter. */
    unsigned int
    n_columns() const;

  private:
    struct Column
    {
      Vector residual; ///< of V
      Vector output;   ///< of W

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &residual &output;
      }
    };
    using Step = std::deque<Column>; ///< newest first

    void
    add_column(const Vector &r, const Vector &Hx);

    /** The correction W c; drops dependent columns. Empty without columns. */
    Vector
    correction(const Vector &r);

    unsigned int     reused_steps;
    double           filter;
    AitkenRelaxation relaxation;
    std::deque<Step> steps; ///< newest first; the front is the present one
    Vector           old_residual, old_output;
  };
} // namespace asperity

#endif
