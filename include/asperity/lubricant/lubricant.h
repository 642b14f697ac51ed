#ifndef asperity_lubricant_lubricant_h
#define asperity_lubricant_lubricant_h

#include <asperity/base/convergence_report.h>
#include <asperity/isogeometric/force_term.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace asperity
{
  struct LubricantParameters;
  class InputArchive;
  class OutputArchive;

  /** What a lubricant does at the last accepted step, over one period and per
   *  metre of thickness, of a patch per metre of its width. Forces are along
   * the motion and upwards. */
  struct LubricantState
  {
    dealii::Tensor<1, 2> pressure_force; ///< on the chip [N/m]
    dealii::Tensor<1, 2> shear_force;    ///< on the chip [N/m]
    double transverse = 0.; ///< of the pressure, to the left of the motion

    double       mean_pressure = 0.; ///< pressure_force[1] / L, positive [Pa]
    double       max_pressure  = 0.; ///< [Pa]
    double       void_volume   = 0.; ///< between the surfaces [m^2]
    double       reference_volume    = 0.; ///< of the oil at p = 0 [m^2]
    double       oil_volume          = 0.; ///< of the oil at its pressure [m^2]
    double       oil_in              = 0.; ///< through open ends so far [m^2]
    double       oil_out             = 0.; ///< the same
    double       smallest_film       = 0.; ///< [m]
    unsigned int n_pockets           = 0;
    unsigned int coupling_iterations = 0;
  };

  /**
   * A rung of the lubricant ladder as the coupled step sees it. It is a force
   * term of the chip, so that Newton's method of the solid sees its pressure
   * and tangent; what it cannot solve together with the chip (a fluid of its
   * own, a constraint) it does in exchange(), after which the chip is solved
   * for again.
   */
  class Lubricant : public ForceTerm
  {
  public:
    enum class Exchange
    {
      converged,
      repeat, ///< loads have changed: solve for the chip again
      failed  ///< the step must be cut; reason() says why
    };

    /** Takes the oil as it is at its present temperature, before a step; no
     *  mass is lost. */
    virtual void
    set_oil(const LubricantParameters &oil) = 0;

    /** Before the iterations of step `step`, which lasts dt and ends at `time`
     *  [s]; u is the last accepted displacement. A step that is cut begins
     *  again. */
    virtual void
    begin_step(const dealii::Vector<double> &u,
               const unsigned int            step,
               const double                  time,
               const double                  dt)
    {}

    /** After each equilibrium u of the chip. */
    virtual Exchange
    exchange(const dealii::Vector<double> &u)
    {
      return Exchange::converged;
    }

    /** Why exchange() or add() failed, or what in the oil keeps its balance
     * with the chip from a solution; empty if it knows of nothing. */
    virtual std::string
    reason() const
    {
      return "";
    }

    /** The step is accepted with u. */
    virtual void
    accept(const dealii::Vector<double> &u) = 0;

    /** At the last evaluated displacement. */
    virtual LubricantState
    state() const = 0;

    /** Pressure on the chip at a parameter of its edge, in [0, L), or of its
     *  face, in [0, L) x [0, W), as state() [Pa].
     *  @param parameter of an edge its first component counts */
    virtual double
    pressure(const dealii::Point<2> &parameter) const = 0;

    /** Share of the gap that is full of oil at such a parameter, at the last
     *  evaluated displacement. */
    virtual double
    coverage(const dealii::Point<2> &parameter) const = 0;

    /** What happened to the pockets so far, as "step 12: pocket B has become
     *  part of A". */
    virtual std::vector<std::string>
    events() const
    {
      return {};
    }

    /** All that a restart needs. */
    virtual void
    save(OutputArchive &archive) const = 0;

    /** Takes what save() wrote.
     *  @throws InputError if it does not fit this lubricant */
    virtual void
    load(InputArchive &archive) = 0;
  };
} // namespace asperity

#endif
