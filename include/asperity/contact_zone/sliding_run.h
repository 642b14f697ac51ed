#ifndef asperity_contact_zone_sliding_run_h
#define asperity_contact_zone_sliding_run_h

#include <asperity/contact_zone/friction_judgement.h>
#include <asperity/contact_zone/friction_result.h>
#include <asperity/contact_zone/load_protocol.h>
#include <asperity/contact_zone/lubricated_step.h>
#include <asperity/contact_zone/mesh_adaptation.h>
#include <asperity/contact_zone/scene.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  template <int dim>
  class SpaceTransfer;

  /** All that a run must remember between steps, beside the plastic history in
   *  the chip and the multipliers in the contact. */
  struct RunState
  {
    unsigned int             step = 0;
    double                   time = 0.;
    dealii::Vector<double>   u, u_previous;
    double                   dt_previous = 0.;
    std::vector<FrictionRow> rows;

    /** Share of oil in the gap, at the points of the contact. */
    std::vector<double> coverage;

    RemeshReport remeshing;

    /** For archives of Boost.Serialization. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &step &time &u &u_previous &dt_previous &rows &coverage
        &remeshing;
    }
  };

  /**
   * Loads the chip and slides it under the tool: for each step a predictor,
   * Newton's method, the augmented-Lagrange loop on request. A step that does
   * not converge is tried with the next predictor (extrapolation, rigid
   * translation), then halved. With oil that fills the gap, chip and flow are
   * solved in turn, see LubricatedStep.
   */
  template <int dim>
  class SlidingRun
  {
  public:
    SlidingRun(const SceneParameters &parameters, Scene<dim> &scene);

    /** What happens after each step, e.g. output. */
    using Observer = std::function<void(const SlidingRun &)>;

    /**
     * From the present state to the end.
     * @throws ComputationError if a step fails after all cuts; state() is then
     *   the last good one
     */
    void
    run(const Observer &observer);

    /** The mean over the window that the parameters ask for.
     *  @throws ComputationError if no step has been made */
    FrictionResult
    friction() const;

    /** Whether friction() is a friction coefficient.
     *  @throws ComputationError if no step has been made */
    FrictionJudgement
    judgement() const;

    /** Whether a `steady` window found the mean steady. */
    bool
    is_steady() const;

    const RunState &
    state() const;

    /** Continues from a state, whose history and multipliers the scene has. */
    void
    set_state(const RunState &state);

    /** Whether the mesh of the scene follows its contacts. */
    bool
    changes_mesh() const;

    /** Takes other cells, and with them the start of the run, as
     *  Scene::set_mesh(). */
    void
    set_mesh(const std::vector<CellIndex<dim>> &cells);

    /** The step of the chip, with velocity and acceleration if dynamic. */
    SolidStep &
    solid_step();

    /** The step of the chip. */
    const SolidStep &
    solid_step() const;

    /** Nullptr unless oil fills the gap. */
    LubricatedStep *
    lubricated_step() const;

    const LoadProtocol &
    protocol() const;

    /** L of the scene [m]. */
    double
    period() const;

    /** Of the contact edge, times which a pressure is a force [m^(dim - 1)]. */
    double
    area() const;

    /** The mean of tool and chip where they meet, at the last accepted step
     *  [K]; the tool keeps its temperature unless heat is conducted. */
    double
    oil_temperature() const;

    /** A sentence if the shear of the contact exceeds the strength of the chip
     *  in the last evaluation, which Coulomb's law does not know; or empty. */
    std::string
    excess_shear() const;

    /** A sentence if Mesh/Maximum unknowns has made meshes coarser than wanted;
     * or empty. */
    std::string
    coarser_meshes() const;

    /** A sentence if the cells of the oil film are too long for its pressure,
     *  at the last accepted step; or empty. */
    std::string
    coarse_film() const;

    const NewtonStatistics &
    newton_statistics() const;

    unsigned int
    n_cuts() const;

    /** Of the meshes of the run, by their Newton iterations. */
    unsigned int
    mean_unknowns() const;

  private:
    /** What a step begins with, beside state_.u. */
    struct StepStart
    {
      dealii::Vector<double>     u_previous;
      double                     dt_previous = 0., time = 0.;
      std::vector<MaterialState> history;

      typename ShearTraction<dim>::History shear; ///< if there is any
      std::vector<double>                  coverage;
      std::string oil, heat; ///< what they save, if there are any
    };

    /** Now. */
    StepStart
    step_start() const;

    bool
    finished() const;

    /** Accepts a step of at most this length [s].
     *  @throws ComputationError if it fails after all cuts */
    void
    take_step(double dt);

    /** Where something touches for which the mesh is too coarse, the step that
     *  has been accepted is taken again on a mesh that suffices. */
    void
    adapt_mesh(const StepStart &start);

    /** To the start of the accepted step, on the present mesh.
     *  @param before of the state
     *  @param F at the start of the step, on that mesh */
    void
    go_back(const StepStart                         &start,
            const SplineHierarchy<dim>              &before,
            const std::vector<dealii::Tensor<2, 3>> &F);

    /** The part of it for interface, oil and heat. @param transfer of the
     *  displacement */
    void
    go_back_at_face(const StepStart            &start,
                    const SplineHierarchy<dim> &before,
                    const SpaceTransfer<dim>   &transfer);

    /** mu of the last evaluated displacement. */
    double
    present_friction() const;

    bool
    try_step(const double dt, std::string &reason);

    /** Length of the next step [s]: the regular one, unless shorter ones were
     *  needed. */
    double
    proposed_step(const double regular) const;

    /** Whether the plastic strain grows by more than it may in the step that
     *  has been solved. */
    bool
    yields_too_much() const;

    /** Sentences on what in the parameters may keep a step from a solution,
     *  each after a blank; empty if nothing is known. */
    std::string
    remedies() const;

    /** Gives the oil of the next step its temperature. */
    void
    warm_oil();

    /** Gives the interface of the next step the strength of the chip and the
     *  part that oil covers. */
    void
    renew_interface();

    /** Norm of the chip's residual at which Newton's method ends
     *  [N/m^(3 - dim)]. */
    double
    newton_tolerance() const;

    /** Of the chip, under the present load of the oil. */
    ConvergenceReport
    solve(dealii::Vector<double> &u);

    /** A first guess at the displacement of the next step. */
    using Predictor = std::function<dealii::Vector<double>()>;

    /** In the order in which they are tried. */
    std::vector<Predictor>
    predictors(const double dt) const;

    /** Rigid shift in y from u at which contact and oil balance the load p,
     *  were the chip rigid [m]; not negative. */
    double
    touching_shift(const dealii::Vector<double> &u,
                   const double                  pressure) const;

    void
    accept(const dealii::Vector<double> &u, const double dt);

    void
    record(const double seconds);

    void
    record_lubricant(FrictionRow &row) const;

    void
    record_interface(FrictionRow &row) const;

    void
    record_heat(FrictionRow &row) const;

    /** Components of a force along the motion, upwards, and to the left of the
     *  motion, per metre of the width [N/m]. */
    struct LineLoad
    {
      double along, up, across;
    };

    /** See above. @param force on the chip */
    LineLoad
    per_width(const dealii::Tensor<1, dim> &force) const;

    /** k of the chip at the points of the contact, at the start of the step and
     *  as its tractions per reference length of the edge [Pa]. */
    std::vector<double>
    shear_strength() const;

    /** Of the step that is being accepted, of length dt [s], at the points of
     *  the contact and per reference length [W/m^2]. */
    std::vector<double>
    frictional_power(const double dt) const;

    const SceneParameters     &parameters;
    Scene<dim>                &scene;
    LoadProtocol               protocol_;
    std::unique_ptr<SolidStep> step;
    RunState                   state_;
    NewtonStatistics           statistics;
    double                     step_pressure = 0.; ///< load of the step [Pa]
    unsigned int               cuts          = 0;
    unsigned int               recorded_factorisations = 0;

    /** Null unless the mesh changes; and the end of a step on another mesh,
     *  where the next first guess is. */
    std::unique_ptr<MeshAdaptation<dim>>  adaptation;
    std::optional<dealii::Vector<double>> first_guess;

    std::unique_ptr<LubricatedStep> lubricated_step_;
  };
} // namespace asperity

#endif
