#ifndef asperity_coupling_spline_solid_h
#define asperity_coupling_spline_solid_h

#include <asperity/coupling/coupling_sides.h>
#include <asperity/coupling/interface.h>
#include <asperity/solid/solid_assembler.h>
#include <asperity/solid/solid_step.h>

#include <vector>

namespace asperity
{
  struct SplineSolidOptions
  {
    /** Inertia, by generalized-alpha; otherwise quasi-static. */
    bool dynamic = true;

    /** At infinite frequency, see GeneralizedAlpha. */
    double spectral_radius = 0.8;

    /** Of Newton's method: residual over the largest load of the run so far. */
    double tolerance = 1e-10;

    /** Smallest load that residuals are compared with (Euclidean norm of the
     *  nodal loads) [N/m]. */
    double load_floor = 0.;

    unsigned int     maximum_iterations = 25;
    LinearSolverKind solver             = LinearSolverKind::umfpack;
  };



  /**
   * The isogeometric solid as one side of a coupled step: its internal force
   * and the fluid's force on the interface, in balance with its inertia, from
   * rest.
   */
  class SplineSolid : public SolidSide
  {
  public:
    /**
     * The arguments must outlive this object.
     * @param constraints of components of u that keep their value, see
     * Equilibrium
     */
    SplineSolid(SolidAssembler<2>                       &solid,
                const dealii::AffineConstraints<double> &constraints,
                const Interface                         &interface,
                const SplineSolidOptions                &options = {});

    void
    begin_step(const double dt) override;

    ConvergenceReport
    solve(const Vector &force, Vector &displacement) override;

    bool
    compliance(const Vector &force, Vector &displacement) override;

    void
    accept() override;

    /** At the end of the present or last step [m]. */
    const Vector &
    displacement() const;

    /** At the start of the step. */
    SolidStep::State
    state() const;

    /** Continues from the end of an accepted step. */
    void
    set_state(const SolidStep::State &state);

    const NewtonStatistics &
    statistics() const;

  private:
    const Interface   &interface;
    SplineSolidOptions options;
    InterfaceLoad      load;
    Equilibrium        equilibrium;
    Vector             u;
    SolidStep          step;
    double             largest_load;      ///< of accepted steps [N/m]
    double             present_load = 0.; ///< of the step [N/m]
    NewtonStatistics   statistics_;
  };
} // namespace asperity

#endif
