#ifndef asperity_flow_fluid_outlets_h
#define asperity_flow_fluid_outlets_h

#include <asperity/flow/fluid_assembler.h>

#include <vector>

namespace asperity
{
  /** What is beyond an open end of a flow: a reservoir behind a resistance. */
  struct FluidOutlet
  {
    dealii::types::boundary_id side       = 0;
    double                     pressure   = 0.; ///< P, of the reservoir [Pa]
    double                     resistance = 0.; ///< R, not negative [Pa s/m]
  };

  /** Fluid that has passed an outlet, per metre of thickness [m^2]. */
  struct PassedVolume
  {
    double in = 0., in_old = 0.;   ///< at t_n and t_{n-1}
    double out = 0., out_old = 0.; ///< the same

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &in &in_old &out &out_old;
    }
  };

  /**
   * Open ends of a flow. On each
   *
   *   sigma n = -(P + R q/h) n + eta (grad v)^T n,   q = int (v - w).n ds,
   *
   * h the height of the end, n pointing out and w the velocity of the mesh, so
   * that q [m^2/s] is what leaves. The second term makes it
   * -p n + eta dv/dn = -(P + R q/h) n: a flow that has developed in a long
   * channel, sheared or driven by a pressure, leaves as if the channel went on.
   * (J. G. Heywood, R. Rannacher, S. Turek, Int. J. Numer. Methods Fluids 22
   * (1996) 325-352, section 2.)
   */
  class FluidOutlets
  {
  public:
    using Vector = dealii::Vector<double>;

    /** @param assembler knows the fluid
     *  @throws InputError if a resistance is negative */
    FluidOutlets(const FluidSpace               &space,
                 const MovingMesh               &mesh,
                 const FluidAssembler           &assembler,
                 const std::vector<FluidOutlet> &outlets);

    /** A resistance couples all velocities of its side. */
    void
    add_couplings(dealii::DynamicSparsityPattern &pattern) const;

    /** As FluidAssembler::add(). */
    void
    add(const Vector                            &u,
        const dealii::AffineConstraints<double> &constraints,
        Vector                                  &R,
        Vector                                  &scale,
        dealii::SparseMatrix<double>            *tangent) const;

    /** q of each outlet at u [m^2/s]. */
    std::vector<double>
    outflow(const Vector &u) const;

    /** The step with the mesh's present rate has ended with u. Volumes are
     *  integrated by that formula, so that they fit the continuity equation. */
    void
    accept(const Vector &u);

    const std::vector<PassedVolume> &
    passed() const;

    void
    set_passed(const std::vector<PassedVolume> &passed);

  private:
    /** q = sum_i flux(i) u(dofs[i]) - swept */
    struct Side
    {
      std::vector<dealii::types::global_dof_index> dofs;
      dealii::Vector<double>                       flux;
      double                                       swept  = 0.;
      double                                       height = 0.;
    };

    /** On the present mesh. */
    Side
    measure(const FluidOutlet &outlet) const;

    void
    add_pressure(const FluidOutlet                       &outlet,
                 const Vector                            &u,
                 const dealii::AffineConstraints<double> &constraints,
                 Vector                                  &R,
                 Vector                                  &scale,
                 dealii::SparseMatrix<double>            *tangent) const;

    void
    add_shear(const FluidOutlet                       &outlet,
              const Vector                            &u,
              const dealii::AffineConstraints<double> &constraints,
              Vector                                  &R,
              Vector                                  &scale,
              dealii::SparseMatrix<double>            *tangent) const;

    const FluidSpace              &space;
    const MovingMesh              &mesh;
    const FluidAssembler          &assembler;
    const std::vector<FluidOutlet> outlets;
    std::vector<PassedVolume>      passed_;
  };
} // namespace asperity

#endif
