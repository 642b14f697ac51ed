#ifndef asperity_contact_contact_assembler_h
#define asperity_contact_contact_assembler_h

#include <asperity/contact/contact_pressure_law.h>
#include <asperity/contact/rigid_obstacle.h>
#include <asperity/contact/shear_traction.h>
#include <asperity/contact/traction_space.h>
#include <asperity/isogeometric/force_term.h>
#include <asperity/isogeometric/spline_space.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace asperity
{
  struct ContactOptions
  {
    ContactFormulation formulation = ContactFormulation::mortar;

    /** epsilon in p = epsilon (-gap) [Pa/m]. */
    double penalty = 1e19;

    /** Gauss points an element of the contact edge; 0 means degree + 2. */
    unsigned int points_per_element = 0;

    InterfaceParameters interface; ///< its shear

    /** Length of the elements that its Transition counts in [m]; 0: of the
     *  largest one. */
    double element_length = 0.;

    /** Unit vector in the plane, along x and y, near which a body in three
     *  dimensions slides: one of the two tangents follows it. */
    std::array<double, 2> motion = {{1., 0.}};
  };

  /** State of the interface at the last evaluated displacement; per metre of
   *  thickness in two dimensions. */
  template <int dim>
  struct ContactState
  {
    dealii::Tensor<1, dim> force; ///< on the deformable body [N/m^(3 - dim)]
    dealii::Tensor<1, dim>
           shear_force;           ///< the part of it by shear [N/m^(3 - dim)]
    double contact_fraction = 0.; ///< share of the reference edge in contact
    double max_pressure     = 0.; ///< [Pa]
    double max_penetration  = 0.; ///< [m]
    double sticking         = 0.; ///< part of the shear that sticks

    /** Largest penetration (or gap under a multiplier) in the sense of the
     *  discrete constraints, |p - lambda| / epsilon over functions (mortar) or
     *  points [m]: what augmentation removes. The mortar's pointwise
     *  penetration also holds what the mesh cannot follow. */
    double constraint_violation = 0.;
    double mean_gap             = 0.; ///< mean of max(gap, 0) over the edge [m]
  };

  /** What touches, per current length (in three dimensions area) of the
   *  edge. */
  struct CurrentContact
  {
    double length        = 0.; ///< of what touches [m^(dim - 1)]
    double mean_pressure = 0.; ///< over it [Pa]
    double max_pressure  = 0.; ///< [Pa]
  };

  /**
   * Contact of an edge with a rigid obstacle, by penalty and optional
   * multipliers; with shear if the interface has a law of it, see
   * ShearTraction. Both formulations of the pressure derive from one potential
   * over the reference edge, so forces balance and the tangent is exact:
   *
   *   mortar:      sum_a W_a / (2 epsilon) <lambda_a - epsilon g_a>^2,
   *                g_a = int N_a g / W_a,  W_a = int N_a
   *   Gauss point: int 1 / (2 epsilon) <lambda - epsilon g>^2
   *
   * so the pressure is p = sum_a N_a <lambda_a - epsilon g_a>, or pointwise,
   * and acts along the obstacle's normal: R_a = - int N_a p n. The pressure
   * counts per reference length; per current length (Lee 2025, section 2.3,
   * equations 15 and 16) it differs by the stretch, which multiplies the
   * penalty only. L. De Lorenzis, I. Temizer, P. Wriggers, G. Zavarise, IJNME
   * 87 (2011) 1278-1300.
   *
   * On several ranks each searches the closest points of its own elements, and
   * adds their forces; the state of the interface is complete on every rank,
   * so that add() is collective.
   */
  template <int dim>
  class ContactAssembler : public ForceTerm
  {
  public:
    ContactAssembler(std::shared_ptr<const SplineSpace<dim>>   space,
                     const PatchGeometry<dim>                 &geometry,
                     const Edge                                edge,
                     std::shared_ptr<const RigidObstacle<dim>> obstacle,
                     const ContactOptions                     &options,
                     const CellShare &share = CellShare());

    ContactAssembler(const ContactAssembler &) = delete;
    ContactAssembler &
    operator=(const ContactAssembler &) = delete;

    void
    add_couplings(dealii::DynamicSparsityPattern &pattern) const override;

    bool
    add(const dealii::Vector<double> &u,
        dealii::Vector<double>       &residual,
        dealii::SparseMatrix<double> *tangent) override;

    /** That of the shear. */
    const dealii::SparseMatrix<double> *
    unsymmetric_tangent() const override;

    /** Translation of the obstacle [m]. */
    void
    set_obstacle_offset(const dealii::Tensor<1, dim> &offset);

    /** The multipliers take the value of the pressures at the last evaluated
     *  displacement (one pass of the augmented-Lagrange loop). */
    void
    augment();

    /** One multiplier an edge function (mortar) or a point (Gauss point). */
    const std::vector<double> &
    multipliers() const;

    void
    set_multipliers(const std::vector<double> &multipliers);

    /** Where the last closest-point search of each point ended; part of the
     *  state of a run that is to be repeated bit for bit. */
    const std::vector<dealii::Point<dim - 1>> &
    hints() const;

    void
    set_hints(const std::vector<dealii::Point<dim - 1>> &hints);

    ContactState<dim>
    state() const;

    /** Edge quadrature points; the arrays below follow its numbering. */
    const BasisTable<dim> &
    table() const;

    const std::vector<double> &
    pressure() const;

    const std::vector<GapPoint<dim>> &
    gaps() const;

    /** Current positions of the points. */
    const std::vector<dealii::Point<dim>> &
    positions() const;

    /** Current over reference length (area) of the edge at each point. */
    std::vector<double>
    stretch(const dealii::Vector<double> &u) const;

    /** The state per current length. @param u the last evaluated
     *  displacement */
    CurrentContact
    current_state(const dealii::Vector<double> &u) const;

    /** Which of the points touch, as the contact fraction counts them. */
    std::vector<bool>
    touching() const;

    const ContactOptions &
    options() const;

    /** Nullptr if the interface bears no shear. */
    ShearTraction<dim> *
    shear();

    /** See above. */
    const ShearTraction<dim> *
    shear() const;

  private:
    /** Where the points are, and their gaps. */
    void
    measure(const dealii::Vector<double> &u);

    /** What the ranks have measured becomes known to all. */
    void
    share_measured();

    void
    set_pressures();

    void
    add_residual(dealii::Vector<double> &residual) const;

    void
    add_stiffness(dealii::SparseMatrix<double> &tangent) const;

    void
    add_shear(dealii::Vector<double>       &residual,
              dealii::SparseMatrix<double> *tangent);

    std::shared_ptr<const SplineSpace<dim>>   space;
    std::shared_ptr<const RigidObstacle<dim>> obstacle;
    ContactOptions                            options_;
    ContactPressureLaw                        law;
    BasisTable<dim>                           table_;
    CellShare                                 share; ///< of table_'s elements
    TractionSpace<dim>                        tractions;
    std::optional<ShearTraction<dim>>         shear_;
    dealii::SparsityPattern                   shear_couplings;
    dealii::SparseMatrix<double>              shear_tangent; ///< not symmetric
    dealii::Tensor<1, dim>                    offset;

    std::vector<double>                 multiplier;
    std::vector<dealii::Point<dim - 1>> hint;
    std::vector<dealii::Point<dim>>     position;
    std::vector<GapPoint<dim>>          gap;
    std::vector<ContactPressure>        traction_pressure; ///< one a multiplier
    std::vector<double>                 point_pressure;    ///< [Pa]
  };
} // namespace asperity

#endif
