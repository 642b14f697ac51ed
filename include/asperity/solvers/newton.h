#ifndef asperity_solvers_newton_h
#define asperity_solvers_newton_h

#include <asperity/base/convergence_report.h>

#include <deal.II/lac/vector.h>

#include <optional>
#include <string>

namespace asperity
{
  /** Nonlinear equations R(u) = 0 as Newton's method sees them. Prescribed
   *  components of u are the system's business: their rows of R are zero. */
  class NonlinearSystem
  {
  public:
    virtual ~NonlinearSystem() = default;

    /** R(u). @return false if no residual exists at u (an inverted element). */
    virtual bool
    residual(const dealii::Vector<double> &u, dealii::Vector<double> &R) = 0;

    /** R(u) together with its tangent, which stays with the system. */
    virtual bool
    linearize(const dealii::Vector<double> &u, dealii::Vector<double> &R) = 0;

    /** Factorises the tangent of the last linearize() and solves K d = -R.
     *  @return false if the tangent is singular. */
    virtual bool
    direction(const dealii::Vector<double> &R, dealii::Vector<double> &d) = 0;

    /** Why direction() failed last. */
    virtual std::string
    direction_failure() const
    {
      return "the tangent is singular";
    }

    /** A factorised tangent is at hand, of this or an earlier u: direction()
     *  can be called without linearize(). */
    virtual bool
    has_tangent() const
    {
      return false;
    }

    /** The measure of a residual that convergence is judged by: the Euclidean
     *  norm, unless the components of R differ in unit. */
    virtual double
    norm(const dealii::Vector<double> &R) const
    {
      return R.l2_norm();
    }
  };

  /** What a step along Newton's direction has to make smaller. */
  enum class NewtonMerit
  {
    energy,       ///< the directional derivative |R.d|: symmetric tangents
    residual_norm ///< the norm: flows, whose tangent belongs to no energy
  };

  struct NewtonOptions
  {
    /** Norm of the residual, see NonlinearSystem::norm(). */
    double       tolerance          = 1e-8;
    unsigned int maximum_iterations = 25;

    /** Whether the first step is likely to converge, so that no tangent is made
     *  where it ends; unknown: if it starts close by, as for other steps. Only
     *  the cost depends on it. */
    std::optional<bool> first_step_ends;

    NewtonMerit merit = NewtonMerit::energy;

    /** Merit `energy`: only so many first components count in R.d, e.g. those
     *  of a solid beside a fluid whose equations have no energy; 0: all. */
    unsigned int n_energy_components = 0;

    /** A tangent is kept, also that of an earlier call, as long as each step
     *  with it reduces the norm to this share of its value or less; 0: every
     *  step has its own tangent. */
    double kept_tangent_contraction = 0.;

    /** A step is accepted if |R(u + a d).d| <= this times |R(u).d|. */
    double       line_search_tolerance = 0.8;
    unsigned int line_search_trials    = 8;
  };

  /** Counts that tell the cost, summed over calls. */
  struct NewtonStatistics
  {
    unsigned int iterations     = 0; ///< linear solves
    unsigned int linearizations = 0; ///< assemblies with tangent
    unsigned int residuals      = 0; ///< assemblies without

    /** Of an iterative linear solver, if the system has one and counts. */
    unsigned int linear_iterations = 0;
  };

  /**
   * Newton's method with a line search on the directional derivative of the
   * energy, s(a) = R(u + a d).d (M. A. Crisfield, Non-linear Finite Element
   * Analysis of Solids and Structures, vol. 1, sec. 9.4; regula falsi), not on
   * the residual norm, which stalls where contact opens and closes. With
   * NewtonMerit::residual_norm the step is halved until the norm falls.
   *
   * With NewtonOptions::kept_tangent_contraction full steps with kept tangents
   * come first; the method proper goes on where even a new tangent's full step
   * does not make the norm smaller.
   *
   * On failure u is the last iterate; the caller keeps the state to go back to.
   * report.residual is the norm of the system.
   */
  ConvergenceReport
  newton(NonlinearSystem        &system,
         dealii::Vector<double> &u,
         const NewtonOptions    &options,
         NewtonStatistics       &statistics);
} // namespace asperity

#endif
