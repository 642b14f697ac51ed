#ifndef asperity_flow_fluid_assembler_h
#define asperity_flow_fluid_assembler_h

#include <asperity/constitutive/lubricant_density.h>
#include <asperity/constitutive/lubricant_viscosity.h>
#include <asperity/flow/moving_mesh.h>

#include <deal.II/base/function.h>
#include <deal.II/lac/sparse_matrix.h>

#include <functional>
#include <memory>

namespace asperity
{
  /** A vector field of the current position [m] and time [s]. */
  using FluidFunction =
    std::function<dealii::Tensor<1, 2>(const dealii::Point<2> &, const double)>;

  /** What flows. */
  struct FluidModel
  {
    double              density = 800.; ///< rho_0 [kg/m^3]
    ViscosityParameters viscosity;
    bool                convection = true; ///< false: Stokes, unsteady too
    FluidFunction       body_force;        ///< b [m/s^2], none if empty

    /** Of the continuity equation. The momentum balance keeps rho_0: inertia
     *  that compression changes by a tenth is small itself where compression
     *  counts. */
    LubricantDensity compressibility = {DensityLaw::incompressible};

    bool
    is_compressible() const;
  };

  /**
   * The cells' part of the momentum balance and the continuity equation, in
   * ALE form on the mesh at the end of the step, per metre of thickness:
   *
   *   R_u(w) = int rho (dv/dt|_X + (v - w_mesh).grad v - b).w
   *              + 2 eta D(v) : D(w) - p div w      [N/m]
   *   R_p(q) = - int q div v                        [m^2/s]
   *
   * and of a compressible fluid with the density ratio r(p) = rho/rho_0
   *
   *   R_p(q) = - int q (r div(v - w_mesh) + (v - w_mesh).grad r + a_0 r),
   *
   * to which the history of the content belongs, MovingMesh::
   * add_content_history(). r is interpolated from its nodal values, as p is.
   * D the symmetric gradient, eta of the shear rate sqrt(2 D : D) and p. Equal
   * order adds, with the residual r of the momentum balance in the cell
   * (without the gradient of eta, which vanishes for a Newtonian fluid),
   *
   *   int tau r.(rho (v - w_mesh).grad w) - int tau r.grad q
   *     + int tau_C e div w,
   *   tau = ((2 rho a_0)^2 + rho^2 c.G c + 36 eta^2 G : G)^(-1/2),
   *   tau_C = (rho^2 c.G c + 36 eta^2 G : G)^(1/2)/tr G
   *
   * e = div v + (dr/dt|_X + (v - w_mesh).grad r)/r (SUPG, PSPG, LSIC; T. E.
   * Tezduyar, S. Sathe (2003); Y. Bazilevs et al., CMAME 197 (2007) 173), where
   * G is the metric of the map to the reference cell and a_0 the coefficient of
   * the new velocity in its rate. Since tau rho a_0 <= 1/2, the equation of the
   * pressure keeps its sign for all time steps, and tau falls with dt as the
   * velocity's own Schur complement does. tau_C leaves the time step out: else
   * the divergence that an interpolated velocity has would act as a force of
   * the order of 1/dt.
   */
  class FluidAssembler
  {
  public:
    using Vector = dealii::Vector<double>;

    FluidAssembler(const FluidSpace &space,
                   const MovingMesh &mesh,
                   const FluidModel &model);

    ~FluidAssembler();

    /** What flows from now on. */
    void
    set_model(const FluidModel &model);

    /** Rates are now u + history, where history = old u_n + older u_{n-1}.
     *  @param history of the velocity; of the density ratio, by unknowns of the
     *    pressure
     *  @param time end of the step [s] */
    void
    set_step(const BackwardDifference &rate,
             const Vector             &history,
             const double              time);

    /** r by unknowns of the pressure, zero for those of the velocity. */
    Vector
    density_ratio(const Vector &u) const;

    /**
     * Adds the cells' residual, condensed by the space's topology, and,
     * unless tangent is null, its derivative, condensed by `constraints`.
     * @param scale the absolute values of the terms are added to it: the size
     *   that a residual is to be compared with
     * @return false if a cell has no residual, as oil under too low a pressure,
     *   which has no density: the sums are then of no use
     */
    bool
    add(const Vector                            &u,
        const dealii::AffineConstraints<double> &constraints,
        Vector                                  &R,
        Vector                                  &scale,
        dealii::SparseMatrix<double>            *tangent) const;

    /** Adds R_p without stabilisation, condensed by the space's topology. */
    void
    add_continuity(const Vector &u, Vector &R) const;

    /**
     * Adds what SchurEstimate wants to know: the pressure's mass matrix, at u
     * over the viscosity and times a_0 dr/dp, condensed, and the diagonal of
     * rho a_0 times the velocity's mass matrix.
     * @param pressure_topology with pressure unknowns numbered from 0
     */
    void
    add_schur_estimate(
      const Vector                            &u,
      const dealii::AffineConstraints<double> &pressure_topology,
      dealii::SparseMatrix<double>            &mass,
      Vector                                  &inertia) const;

    const FluidModel &
    model() const;

  private:
    struct Shapes;
    struct Point;
    struct Cell;
    struct Stabilisation; // what the stabilising terms need at a point

    /** The nodal values in a cell. */
    void
    reinit(Cell                   &cell,
           const FluidSpace::Cell &it,
           const Vector           &u,
           const Vector           &w) const;

    /** The fields at a quadrature point, with the shape functions. */
    Point
    evaluate(Cell &cell, const unsigned int q) const;

    /** The shape functions and their gradients. */
    void
    set_functions(Cell &cell, Point &point, const unsigned int q) const;

    void
    set_compression(const Cell &cell, Point &point, const unsigned int q) const;

    void
    integrate(Cell &cell, const bool with_tangent) const;

    /** Absolute values of the terms. */
    void
    add_size(Cell &cell, const Point &point) const;

    void
    galerkin(Cell &cell, const Point &point, const bool with_tangent) const;

    /** Derivative of R_p by the pressure. */
    void
    add_compression_tangent(Cell &cell, const Point &point) const;

    Stabilisation
    stabilisation(const Cell &cell, const Point &point) const;

    /** Those of the velocity's shape functions. */
    void
    set_second_derivatives(Cell              &cell,
                           const Point       &point,
                           const unsigned int q) const;

    void
    stabilise(Cell              &cell,
              const Point       &point,
              const unsigned int q,
              const bool         with_tangent) const;

    void
    add_stabilised_tangent(Cell                &cell,
                           const Point         &point,
                           const Stabilisation &stabilisation) const;

    const FluidSpace                   &space;
    const MovingMesh                   &mesh;
    const std::unique_ptr<const Shapes> shapes;
    FluidModel                          model_;
    LubricantViscosity                  viscosity;
    BackwardDifference                  rate;
    Vector                              history;
    double                              time = 0.;
  };
} // namespace asperity

#endif
