#ifndef asperity_contact_shear_traction_h
#define asperity_contact_shear_traction_h

#include <asperity/constitutive/interface_law.h>
#include <asperity/contact/contact_pressure_law.h>
#include <asperity/contact/rigid_obstacle.h>
#include <asperity/contact/traction_space.h>

#include <deal.II/lac/vector.h>

namespace asperity
{
  /** The slip of an edge on a rigid surface at the last evaluated displacement,
   *  per point of its table. */
  struct SlipPoint
  {
    dealii::Tensor<1, 2> tangent; ///< s, the normal turned by +90 degrees

    double slip     = 0.; ///< way along s since the last accepted step [m]
    double by_way   = 1.; ///< its derivative along s: slip' = by_way s . dx
    double rotation = 0.; ///< n' = rotation (s . dx) s [1/m]
    double touching = 0.; ///< 1 where the gap is closed, 0 to 1
    double closing  = 0.; ///< derivative of `touching` by the gap [1/m]
  };

  /**
   * Shear between an edge and a rigid surface at rest: the body feels -tau s
   * per reference length, tau along its slip. A return map for each traction of
   * the TractionSpace (J. C. Simo, T. A. Laursen, Comput. Struct. 42 (1992)
   * 97-116; for the mortar L. De Lorenzis et al., IJNME 87 (2011) 1278-1300):
   *
   *   trial   tau_a = tau_a^n + epsilon_t <slip>_a,
   *   stick   where |tau_a| < tau_max,a,
   *   slip    tau_a = sign(trial) tau_max,a,
   *
   * tau_max by InterfaceLaw from the pressure p_a and the means of k and of
   * what touches and is wet. The slip of a point is s . (x - x^n) with the s of
   * the end of the step, right to first order in the step, which slides at a
   * constant direction. k and `wet` are those of the start of the step. A gap g
   * touches to the part 1 + (p/k)^2 - g/delta, 0 to 1, with the p of the last
   * step: well inside of a spot a gap that the elements cannot follow is none,
   * at its ends, where p is small, the gap alone decides.
   *
   * The tangent is exact on each branch, and not symmetric.
   */
  class ShearTraction
  {
  public:
    /** @param penalty epsilon of the pressure [Pa/m]
     *  @param tractions, table must outlive this object */
    ShearTraction(const TractionSpace       &tractions,
                  const BasisTable<2>       &table,
                  const InterfaceParameters &parameters,
                  const double               penalty);

    /** Evaluates the shear.
     *  @param positions of the points, seen from the obstacle
     *  @param pressures one a traction */
    void
    evaluate(const std::vector<dealii::Point<2>> &positions,
             const std::vector<GapPoint>         &gaps,
             const std::vector<ContactPressure>  &pressures);

    /** R_a += int N_a tau s of the last evaluation. */
    void
    add_residual(dealii::Vector<double> &residual) const;

    /** Its derivative, in a symmetric part, of what sticks, and the rest. */
    void
    add_stiffness(dealii::SparseMatrix<double> &symmetric,
                  dealii::SparseMatrix<double> &rest) const;

    /** Shear strength of the body per reference length, k times the stretch of
     *  the edge [Pa], and part that oil covers, per point, of the next
     *  evaluations. */
    void
    set_interface(const std::vector<double> &k, const std::vector<double> &wet);

    /** The last evaluation becomes the start of the next step. */
    void
    accept();

    /** What accept() keeps: tractions, pressures, positions of the points. */
    struct History
    {
      std::vector<double>           tractions; ///< [Pa]
      std::vector<double>           pressures; ///< one a traction [Pa]
      std::vector<dealii::Point<2>> positions; ///< seen from the obstacle
    };

    const History &
    history() const;

    void
    set_history(const History &history);

    /** tau at the points [Pa], along their tangents. */
    const std::vector<double> &
    at_points() const;

    const std::vector<SlipPoint> &
    slip() const;

    /** Adds the force on the body [N/m].
     *  @param sticking becomes the part of the shear that sticks */
    void
    sum_up(dealii::Tensor<1, 2> &force, double &sticking) const;

    /** Work of the shear on its slip since the last accepted step, without what
     *  is stored where it sticks, per reference length; not negative [J/m^2].
     */
    std::vector<double>
    dissipation() const;

    /** Per point, the part of the tractions that stick, 0 to 1. */
    std::vector<double>
    sticking() const;

  private:
    void
    measure(const std::vector<dealii::Point<2>> &positions,
            const std::vector<GapPoint>         &gaps);

    void
    return_map(const std::vector<ContactPressure> &pressures);

    const TractionSpace &tractions;
    const BasisTable<2> &table;
    InterfaceLaw         law;
    double               penalty;    ///< epsilon_t [Pa/m]
    double               transition; ///< delta [m]

    std::vector<double> mean_k, mean_wet; ///< per traction
    std::vector<double> closed_until;     ///< gap that still touches [m]

    History                       start;
    std::vector<dealii::Point<2>> position;
    std::vector<SlipPoint>        slip_;
    std::vector<GapPoint>         gap;

    // Per traction.
    std::vector<double> pressure; ///< p_a
    std::vector<double> mean_slip;
    std::vector<double> traction;    ///< tau_a
    std::vector<double> by_slip;     ///< d tau_a/d<slip>_a, 0 where it slips
    std::vector<double> by_gap;      ///< through the pressure
    std::vector<double> by_touching; ///< d tau_a/d<touching>_a

    std::vector<double> point_traction;
  };
} // namespace asperity

#endif
