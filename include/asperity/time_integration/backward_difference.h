#ifndef asperity_time_integration_backward_difference_h
#define asperity_time_integration_backward_difference_h

namespace asperity
{
  /**
   * A difference formula for the rate at the end of a step,
   *   du/dt (t_{n+1}) = now u_{n+1} + old u_n + older u_{n-1}   [1/s].
   * The coefficients add up to zero, so that the same formula reads
   *   now (u_{n+1} - u_n) - older (u_n - u_{n-1}).
   */
  struct BackwardDifference
  {
    double now   = 0.;
    double old   = 0.;
    double older = 0.;

    /** No rate: the steady problem. */
    static BackwardDifference
    steady();

    /** First order. */
    static BackwardDifference
    implicit_euler(const double dt);

    /** Second order for steps of any length, zero-stable while
     *  dt < 2.41 dt_old (R. D. Grigorieff, Numer. Math. 42 (1983) 359-377).
     *  @param dt_old length of the step before [s] */
    static BackwardDifference
    bdf2(const double dt, const double dt_old);
  };
} // namespace asperity

#endif
