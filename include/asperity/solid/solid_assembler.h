#ifndef asperity_solid_solid_assembler_h
#define asperity_solid_solid_assembler_h

#include <asperity/constitutive/material_law.h>
#include <asperity/isogeometric/cell_partition.h>
#include <asperity/isogeometric/spline_space.h>
#include <asperity/solid/deformable_body.h>
#include <asperity/solid/element_gradients.h>
#include <asperity/solid/stiffness_scatter.h>

#include <memory>
#include <vector>

namespace asperity
{
  template <int dim>
  class ElementView;

  /** Of a body in two dimensions; without meaning in three. */
  enum class Kinematics
  {
    plane_strain,
    axisymmetric ///< coordinates r, z; integrals carry 2 pi r
  };

  /**
   * Internal force of the isogeometric solid in total Lagrangian form:
   * R_a = integral over the reference body of P(F) Grad N_a, F = I + Grad u.
   * Plane strain integrates per metre of thickness.
   *
   * In three dimensions the last coordinate is the upward one, and the law has
   * the axes of the body.
   *
   * The history at the end of the step is rewritten by every call; accept()
   * makes it the start of the next step.
   *
   * On several ranks each adds what its own cells give. The table has the
   * functions of these cells only; histories and stresses are complete on every
   * rank after accept(), which is collective then.
   */
  template <int dim>
  class SolidAssembler : public DeformableBody
  {
  public:
    /** @param n_quadrature Gauss points per direction; 0 means degree + 1
     *  @param share which cells are this process's own */
    SolidAssembler(std::shared_ptr<const SplineSpace<dim>> space,
                   const PatchGeometry<dim>               &geometry,
                   std::shared_ptr<const MaterialLaw>      law,
                   const Kinematics   kinematics   = Kinematics::plane_strain,
                   const unsigned int n_quadrature = 0,
                   const CellShare   &share        = CellShare());

    void
    add_couplings(dealii::DynamicSparsityPattern &pattern) const override;

    bool
    add(const dealii::Vector<double> &u,
        dealii::Vector<double>       &residual,
        dealii::SparseMatrix<double> *tangent) override;

    /** Length of the step that the next calls evaluate [s]. */
    void
    set_time_step(const double dt) override;

    /** The end of the step becomes the start of the next one. */
    void
    accept() override;

    /** Every point starts from this state. */
    void
    initialize(const MaterialState &state);

    /** Growth of the equivalent plastic strain from the start of the step to
     *  its end, at the point where it is largest; collective. */
    double
    largest_strain_increment() const;

    /** States at the start of the step, one a point of table(). */
    const std::vector<MaterialState> &
    history() const;

    void
    set_history(const std::vector<MaterialState> &history);

    /** Deformation gradients at the points of table(); collective. @param u [m]
     */
    std::vector<dealii::Tensor<2, 3>>
    deformation(const dealii::Vector<double> &u) const;

    /** Equivalent stress at the last evaluated u, one a point of table() [Pa].
     */
    const std::vector<double> &
    mises_stress() const;

    /** From the next evaluation on stress() is kept. */
    void
    keep_stress()
    {
      stress_.resize(table_.JxW.size());
    }

    /** First Piola-Kirchhoff stress at the last evaluated u, one a point of
     *  table(); empty unless it is kept [Pa]. */
    const std::vector<dealii::Tensor<2, 3>> &
    stress() const
    {
      return stress_;
    }

    /** Consistent mass matrix, integral of rho0 N_a N_b, all components. */
    void
    assemble_mass(dealii::SparseMatrix<double> &mass) const override;

    /** External force of a body force per reference volume [N/m^3]. */
    void
    add_body_force(const dealii::Tensor<1, dim> &force,
                   dealii::Vector<double>       &external) const;

    /** In three dimensions without the gradients of functions, which are
     *  element_gradients() alone. */
    const BasisTable<dim> &
    table() const;

    /** Of the functions of an element, in the order of table(). */
    const ElementGradients<dim> &
    element_gradients(const unsigned int element) const;

    const SplineSpace<dim> &
    space() const;

    const MaterialLaw &
    law() const;

  private:
    struct Scratch;

    /** Unknowns of each element and gradients of its functions. */
    void
    tabulate_elements();

    /** The law at each point, and the end of the step from it. */
    bool
    evaluate_law(const ElementView<dim> &element,
                 const bool              with_tangent,
                 Scratch                &scratch);

    bool
    integrate(const unsigned int            element,
              const dealii::Vector<double> &u,
              const bool                    with_tangent,
              Scratch                      &scratch);

    std::shared_ptr<const SplineSpace<dim>> space_;
    std::shared_ptr<const MaterialLaw>      law_;
    Kinematics                              kinematics;
    CellShare                               share;
    BasisTable<dim>                         table_;

    /** Of each element, in growing order: [dim a + component]. */
    std::vector<std::vector<unsigned int>> dofs;
    std::vector<ElementGradients<dim>>     gradients; ///< of each element
    StiffnessScatter<dim>                  scatter;

    double                     dt = 1.;
    std::vector<MaterialState> old_history, new_history;
    std::vector<double>        mises;

    std::vector<dealii::Tensor<2, 3>> stress_; ///< empty unless it is kept
  };
} // namespace asperity

#endif
