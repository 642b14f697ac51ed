#ifndef asperity_solid_edge_load_h
#define asperity_solid_edge_load_h

#include <asperity/isogeometric/force_term.h>
#include <asperity/isogeometric/spline_space.h>
#include <asperity/solid/solid_assembler.h>

#include <array>
#include <functional>
#include <vector>

namespace asperity
{
  /**
   * A load on one edge of the body, times a factor that the caller moves from
   * step to step. Two kinds:
   *
   * - dead traction t(X, N): force per reference area, fixed in direction,
   *     R_a = - factor integral t N_a dS;
   * - follower pressure p(X): acts against the outward normal n of the
   *   deformed edge, on the deformed area (positive pushes inwards),
   *     R_a = factor integral p n N_a ds,  n ds = +-rot(dx/dS) dS,
   *   with rot the turn to the right, in three dimensions the product of the
   *   derivatives of x along both tangents. Its tangent is not symmetric in
   *   general (K. Schweizerhof, E. Ramm, Comput. Struct. 18 (1984) 1099).
   *
   * In axisymmetry both carry 2 pi times the radius: R for the dead traction,
   * the deformed r for the pressure.
   */
  template <int dim>
  class EdgeLoad : public ForceTerm
  {
  public:
    /** Traction [Pa] at a reference position X with outward normal N. */
    using Traction =
      std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &,
                                           const dealii::Tensor<1, dim> &)>;

    /** Pressure [Pa] at a reference position X. */
    using Pressure = std::function<double(const dealii::Point<dim> &)>;

    /** @param n_quadrature Gauss points per edge of a cell; 0: degree + 1 */
    static EdgeLoad
    dead_traction(const SplineSpace<dim>   &space,
                  const PatchGeometry<dim> &geometry,
                  const Edge                edge,
                  const Traction           &traction,
                  const Kinematics   kinematics   = Kinematics::plane_strain,
                  const unsigned int n_quadrature = 0);

    /** See dead_traction(). */
    static EdgeLoad
    follower_pressure(const SplineSpace<dim>   &space,
                      const PatchGeometry<dim> &geometry,
                      const Edge                edge,
                      const Pressure           &pressure,
                      const Kinematics   kinematics = Kinematics::plane_strain,
                      const unsigned int n_quadrature = 0);

    /** All loads of this edge are multiplied by this, at first 1. */
    void
    set_factor(const double factor);

    double
    factor() const;

    void
    add_couplings(dealii::DynamicSparsityPattern &pattern) const override;

    bool
    add(const dealii::Vector<double> &u,
        dealii::Vector<double>       &residual,
        dealii::SparseMatrix<double> *tangent) override;

  private:
    EdgeLoad(const SplineSpace<dim>   &space,
             const PatchGeometry<dim> &geometry,
             const Edge                edge,
             const Kinematics          kinematics,
             const unsigned int        n_quadrature);

    /** Derivatives of x along the tangents at a point. */
    using Stretch = std::array<dealii::Tensor<1, dim>, dim - 1>;

    /** n ds/dS, to the outside or the inside. */
    static dealii::Tensor<1, dim>
    area_vector(const Stretch &stretch);

    /** Its derivative by the component j of a function with this gradient. */
    static dealii::Tensor<1, dim>
    area_change(const Stretch                &stretch,
                const dealii::Tensor<1, dim> &gradient,
                const unsigned int            j);

    void
    add_dead(dealii::Vector<double> &residual) const;

    void
    add_follower(const typename BasisTable<dim>::Element &entry,
                 const dealii::Vector<double>            &u,
                 dealii::Vector<double>                  &residual,
                 dealii::SparseMatrix<double>            *tangent) const;

    Kinematics      kinematics;
    BasisTable<dim> table;
    double          factor_ = 1.;

    /** One a point of the table; the other one of the two is empty. */
    std::vector<dealii::Tensor<1, dim>> traction;
    std::vector<double>                 pressure;

    /** area_vector() times this points outwards. */
    double outward;
  };
} // namespace asperity

#endif
