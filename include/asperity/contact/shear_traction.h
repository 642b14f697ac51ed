#ifndef asperity_contact_shear_traction_h
#define asperity_contact_shear_traction_h

#include <asperity/constitutive/interface_law.h>
#include <asperity/contact/contact_pressure_law.h>
#include <asperity/contact/rigid_obstacle.h>
#include <asperity/contact/traction_space.h>

#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace asperity
{
  /** The slip of an edge on a rigid surface at the last evaluated displacement,
   *  per point of its table. */
  template <int dim>
  struct SlipPoint
  {
    /** s_k, orthonormal and normal to n: in two dimensions n turned by +90
     *  degrees, in three the part of the direction of the motion that is
     *  normal to n, and n x s_0. */
    std::array<dealii::Tensor<1, dim>, dim - 1> tangent;

    /** Way along s_k since the last accepted step, and its gradient by the
     *  position of the point. */
    std::array<double, dim - 1>                 slip{};
    std::array<dealii::Tensor<1, dim>, dim - 1> by_position;

    /** How they turn with the position of the point: s_k' = -(turn_k . dx) n,
     *  and in three dimensions s_0 by spin . dx towards s_1, too [1/m]. */
    std::array<dealii::Tensor<1, dim>, dim - 1> turn;
    dealii::Tensor<1, dim>                      spin;

    double touching = 0.; ///< 1 where the gap is closed, 0 to 1
    double closing  = 0.; ///< derivative of `touching` by the gap [1/m]
  };

  /**
   * Shear between an edge and a rigid surface at rest: the body feels
   * -sum_k tau_k s_k per reference measure, tau along its slip. A return map
   * for each traction of the TractionSpace (J. C. Simo, T. A. Laursen, Comput.
   * Struct. 42 (1992) 97-116; for the mortar L. De Lorenzis et al., IJNME 87
   * (2011) 1278-1300), for the vector tau_a of dim - 1 components:
   *
   *   trial   tau_a = tau_a^n + epsilon_t <slip>_a,
   *   stick   where |tau_a| < tau_max,a,
   *   slip    tau_a = tau_max,a trial/|trial|,
   *
   * tau_max by InterfaceLaw from the pressure p_a and the means of k and of
   * what touches and is wet. The slip of a point is s . (x - x^n) with the s of
   * the end of the step, right to first order in the step, which slides at a
   * constant direction. k and `wet` are those of the start of the step. A gap g
   * touches to the part t^2 (3 - 2 t), t = 1 + (p/k)^2 - g/delta within 0 and
   * 1, with the p of the last step: well inside of a spot a gap that the
   * elements cannot follow is none, at its ends, where p is small, the gap
   * alone decides.
   *
   * The tangent is exact on each branch, and not symmetric.
   */
  template <int dim>
  class ShearTraction
  {
  public:
    /** @param penalty epsilon of the pressure [Pa/m]
     *  @param element_length see ContactOptions
     *  @param motion unit vector along x and y that s_0 follows in three
     *    dimensions; a traction is a mean over points, whose tangents turn
     *    about it
     *  @param tractions, table must outlive this object */
    ShearTraction(const TractionSpace<dim>    &tractions,
                  const BasisTable<dim>       &table,
                  const InterfaceParameters   &parameters,
                  const double                 penalty,
                  const double                 element_length,
                  const std::array<double, 2> &motion = {{1., 0.}});

    /** Evaluates the shear.
     *  @param positions of the points, seen from the obstacle
     *  @param pressures one a traction */
    void
    evaluate(const std::vector<dealii::Point<dim>> &positions,
             const std::vector<GapPoint<dim>>      &gaps,
             const std::vector<ContactPressure>    &pressures);

    /** R_a += int N_a tau s of the last evaluation. */
    void
    add_residual(dealii::Vector<double> &residual) const;

    /** Its derivative, in a symmetric part, by the slip of what sticks and, in
     *  three dimensions, by the turning of what slips, and the rest. */
    void
    add_stiffness(dealii::SparseMatrix<double> &symmetric,
                  dealii::SparseMatrix<double> &rest) const;

    /** Shear strength of the body per reference measure, k times the stretch of
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
      /** Component by component, [k size + a] [Pa]. */
      std::vector<double>             tractions;
      std::vector<double>             pressures; ///< one a traction [Pa]
      std::vector<dealii::Point<dim>> positions; ///< seen from the obstacle
    };

    const History &
    history() const;

    void
    set_history(const History &history);

    /** tau_k at the points [Pa], along their tangents s_k. */
    const std::vector<double> &
    at_points(const unsigned int k = 0) const;

    /** |tau| at a point [Pa]. */
    double
    size_at(const unsigned int point) const;

    const std::vector<SlipPoint<dim>> &
    slip() const;

    /** Adds the force on the body [N/m^(3 - dim)].
     *  @param sticking becomes the part of the shear that sticks */
    void
    sum_up(dealii::Tensor<1, dim> &force, double &sticking) const;

    /** Work of the shear on its slip since the last accepted step, without what
     *  is stored where it sticks, per reference measure; not negative [J/m^2].
     */
    std::vector<double>
    dissipation() const;

    /** Per point, the part of the tractions that stick, 0 to 1. */
    std::vector<double>
    sticking() const;

  private:
    void
    measure(const std::vector<dealii::Point<dim>> &positions,
            const std::vector<GapPoint<dim>>      &gaps);

    void
    return_map(const std::vector<ContactPressure> &pressures);

    /** Of one traction. @param pressure_slope of its pressure by the gap */
    void
    return_to(const ShearStrength &limit,
              const double         pressure_slope,
              const double         mean_touching,
              const unsigned int   a);

    using Vectors = typename TractionSpace<dim>::Vectors;

    /** What the turning tangents add, point by point. */
    void
    add_turning(const std::array<Vectors, dim - 1> &s,
                const Vectors                      &n,
                dealii::SparseMatrix<double>       &tangent) const;

    const TractionSpace<dim> &tractions;
    const BasisTable<dim>    &table;
    InterfaceLaw              law;
    double                    penalty;    ///< epsilon_t [Pa/m]
    double                    transition; ///< delta [m]
    dealii::Tensor<1, dim>    motion;

    std::vector<double> mean_k, mean_wet; ///< per traction
    std::vector<double> closed_until;     ///< gap that still touches [m]

    History                         start;
    std::vector<dealii::Point<dim>> position;
    std::vector<SlipPoint<dim>>     slip_;
    std::vector<GapPoint<dim>>      gap;

    /** One vector a component k. */
    using Components = std::array<std::vector<double>, dim - 1>;

    // Per traction.
    std::vector<double> pressure; ///< p_a
    std::vector<bool>   sticks;
    Components          mean_slip;
    Components          traction; ///< tau_a
    /** d tau_k/d<slip>_l. */
    std::array<Components, dim - 1> by_slip;
    Components                      by_gap;      ///< through the pressure
    Components                      by_touching; ///< d tau_a/d<touching>_a

    Components point_traction;
  };
} // namespace asperity

#endif
