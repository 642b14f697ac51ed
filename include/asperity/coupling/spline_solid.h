#ifndef asperity_coupling_spline_solid_h
#define asperity_coupling_spline_solid_h

#include <asperity/coupling/coupling_sides.h>
#include <asperity/coupling/interface.h>
#include <asperity/solid/equilibrium.h>
#include <asperity/solid/solid_assembler.h>
#include <asperity/time_integration/generalized_alpha.h>

#include <memory>
#include <vector>

namespace asperity
{
  class InputArchive;
  class OutputArchive;

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
    DirectSolverKind solver             = DirectSolverKind::umfpack;
  };



  /**
   * The isogeometric solid as one side of a coupled step: its internal force,
   * further terms (contact, loads) and the fluid's force on the interface, in
   * balance with its inertia, from rest.
   */
  class SplineSolid : public SolidSide
  {
  public:
    /**
     * The arguments must outlive this object.
     * @param further_terms besides the internal force
     * @param constraints of components of u that keep their value, see
     * Equilibrium
     */
    SplineSolid(SolidAssembler                          &solid,
                const std::vector<ForceTerm *>          &further_terms,
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

    /** See set_state(). */
    struct State
    {
      Vector u, v, a, forces;

      void
      save(OutputArchive &archive) const;

      /** As FluidState::load(). */
      void
      load(InputArchive &archive);
    };

    State
    state() const;

    /** Continues from the end of an accepted step. */
    void
    set_state(const State &state);

    const NewtonStatistics &
    statistics() const;

  private:
    SolidAssembler                               &solid;
    const Interface                              &interface;
    SplineSolidOptions                            options;
    InterfaceLoad                                 load;
    Equilibrium                                   equilibrium;
    GeneralizedAlpha                              motion;
    std::unique_ptr<dealii::SparseMatrix<double>> mass;
    Vector                                        u;
    Vector           old_forces; ///< of all terms at the start of the step
    double           dt            = 0.;
    double           factorised_dt = 0.; ///< of the tangent at hand; 0: none
    double           largest_load;
    NewtonStatistics statistics_;
  };
} // namespace asperity

#endif
