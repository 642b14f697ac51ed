#ifndef asperity_solid_solid_step_h
#define asperity_solid_solid_step_h

#include <asperity/solid/deformable_body.h>
#include <asperity/solid/equilibrium.h>
#include <asperity/solid/motion_energy.h>
#include <asperity/time_integration/generalized_alpha.h>

#include <memory>
#include <optional>

namespace asperity
{
  class InputArchive;
  class OutputArchive;

  /**
   * The time step of a body: inertia by generalized-alpha on request (see
   * GeneralizedAlpha), Newton's method on the balance, the end of the step as
   * the start of the next one. A step is begun, solved for any number of times
   * and accepted, or begun again with another length. Forces are in N/m, in
   * three dimensions in N.
   */
  class SolidStep
  {
  public:
    using Vector = dealii::Vector<double>;

    /**
     * The references must outlive this object. The body is at rest.
     * @param equilibrium has the solid among its terms
     * @param u displacement at the start [m]
     * @param spectral_radius at infinite frequency, see GeneralizedAlpha;
     *   without: quasi-static
     * @throws InputError if the spectral radius is not in [0, 1]
     */
    SolidStep(DeformableBody             &solid,
              Equilibrium                &equilibrium,
              const Vector               &u,
              const std::optional<double> spectral_radius);

    bool
    is_dynamic() const;

    /** Energy is that of the motion relative to this velocity [m/s], at which
     *  the prescribed components move; without, they are at rest. */
    void
    set_frame(const Vector &velocity);

    /** Of a dynamic body since the start of the run. */
    const MotionEnergy &
    energy() const;

    /**
     * Sets the length of the step [s] and its inertia.
     * @param load dead load at the end of the step [N/m]; empty: leaves
     *   that of the equilibrium, which then has to be zero
     */
    void
    begin(const double dt, const Vector &load = Vector());

    /** Displacement at the end of the step begun, at the acceleration of its
     *  start [m]. */
    Vector
    predict() const;

    /** Solves the balance for u, from u as the first guess. */
    ConvergenceReport
    solve(Vector              &u,
          const NewtonOptions &options,
          NewtonStatistics    &statistics);

    /**
     * Replaces nodal forces [N/m] by the displacements [m] that they cause at
     * the end of the step, by the tangent that solve() has used last.
     * @param u where a tangent is computed if there is none
     * @return false if no tangent exists at u
     */
    bool
    compliance(const Vector &u, Vector &forces);

    /** The next compliance() needs a new tangent, unless solve() makes one. */
    void
    forget_tangent();

    /** The end u of the step becomes the start of the next one. */
    void
    accept(const Vector &u);

    /** All that the next step needs, beside the history in the solid. */
    struct State
    {
      /** Displacement [m], velocity [m/s], acceleration [m/s^2], and the sum of
       *  the force terms minus the load [N/m]; the last three are zero in a
       *  quasi-static body that starts at rest. */
      Vector u, v, a, forces;

      /** Since the start of the run. */
      MotionEnergy energy;

      void
      save(OutputArchive &archive) const;

      /** @throws InputError if the archive has another number of unknowns */
      void
      load(InputArchive &archive);
    };

    /** At the start of the step. */
    State
    state() const;

    /** Continues from the end of an accepted step. */
    void
    set_state(const State &state);

  private:
    /** The end of the last accepted step in the frame, where that has gone
     *  this way since [s]. */
    MotionEnergy::End
    end_in_frame(const double time) const;

    DeformableBody                               &solid;
    Equilibrium                                  &equilibrium;
    GeneralizedAlpha                              motion;
    std::unique_ptr<dealii::SparseMatrix<double>> mass; ///< nullptr: static
    Vector                                        old_forces, load, frame;
    MotionEnergy                                  energy_;
    double                                        dt          = 0.;
    bool                                          has_tangent = false;
  };
} // namespace asperity

#endif
