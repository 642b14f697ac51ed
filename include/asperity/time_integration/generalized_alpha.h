#ifndef asperity_time_integration_generalized_alpha_h
#define asperity_time_integration_generalized_alpha_h

#include <deal.II/lac/vector.h>

namespace asperity
{
  /**
   * The generalized-alpha method for M a + f(u) = 0; J. Chung, G. M. Hulbert,
   * J. Appl. Mech. 60 (1993) 371-375:
   *   M [(1 - alpha_m) a_{n+1} + alpha_m a_n]
   *     + (1 - alpha_f) f_{n+1} + alpha_f f_n = 0
   * with Newmark's u_{n+1}(a_{n+1}). Forces are averaged, not evaluated at the
   * averaged displacement, so that the history of a plastic material lives at
   * the ends of the steps. Second order, dissipation set by the spectral radius
   * at infinite frequency; knows no physics.
   */
  class GeneralizedAlpha
  {
  public:
    /** @param rho_infinity in [0, 1]; 1 conserves energy in the linear case
     *  @throws InputError if it is outside */
    explicit GeneralizedAlpha(const double rho_infinity);

    /** Displacement, velocity, acceleration at the start of the step. */
    dealii::Vector<double> u, v, a;

    /** alpha_f: the weight of the old forces. */
    double
    alpha_f() const;

    /** The factor of M u_{n+1} in the balance. */
    double
    mass_factor(const double dt) const;

    /** b with (1 - alpha_m) a_{n+1} + alpha_m a_n = mass_factor u_{n+1} + b. */
    dealii::Vector<double>
    constant(const double dt) const;

    /** Displacement at the end of a step with constant acceleration. */
    dealii::Vector<double>
    predict(const double dt) const;

    /** Takes over the end of the step. */
    void
    advance(const dealii::Vector<double> &u_new, const double dt);

  private:
    double alpha_m_, alpha_f_, beta, gamma;
  };
} // namespace asperity

#endif
