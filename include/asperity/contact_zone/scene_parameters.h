#ifndef asperity_contact_zone_scene_parameters_h
#define asperity_contact_zone_scene_parameters_h

#include <asperity/base/parameters.h>
#include <asperity/constitutive/interface_law.h>
#include <asperity/constitutive/material_parameters.h>
#include <asperity/contact/contact_assembler.h>
#include <asperity/contact_zone/accuracy_parameters.h>
#include <asperity/contact_zone/heat_parameters.h>
#include <asperity/contact_zone/lubrication_parameters.h>
#include <asperity/solvers/linear_solver.h>
#include <asperity/topography/topography_parameters.h>

#include <memory>
#include <string>
#include <vector>

namespace asperity
{
  /** Where the heights of a surface come from. */
  enum class SurfaceKind
  {
    flat,
    harmonics, ///< Scale z times the sum of a_k cos(2 pi k x / L + phi_k), in
               ///< three dimensions with k x / L + j y / W
    measured   ///< a profile or a window of a height map
  };

  /** How the spline of a measured profile follows its points. */
  enum class SurfaceFit
  {
    least_squares,
    interpolation
  };

  struct SurfaceParameters
  {
    SurfaceKind         kind = SurfaceKind::flat;
    std::vector<double> wave_numbers;
    std::vector<double> across;     ///< waves along y, or none
    std::vector<double> amplitudes; ///< [m]
    std::vector<double> phases;     ///< [rad]

    /** Spans of the spline over a period; automatic follows the data. */
    std::optional<unsigned int> spans;
    unsigned int                degree = 3;

    SurfaceFit fit = SurfaceFit::least_squares; ///< of measured profiles

    TopographyParameters topography;

    void
    declare(ParameterDeclarator &parameters,
            const std::string   &section,
            const std::string   &whose);

    /** @throws InputError if entries contradict each other */
    void
    check(const ParameterDeclarator &parameters,
          const std::string         &section) const;

    /** @throws InputError if the spline of a measured profile is not
     *  determined */
    void
    check_fit(const ParameterDeclarator &parameters,
              const std::string         &section) const;

    /** Spans of the sheet of harmonics along y, for each wave along it;
     *  a sheet without has as many. */
    static constexpr unsigned int spans_across = 40;

    /** Spans of the spline of harmonics over a period. */
    unsigned int
    n_spans_of_harmonics() const;

    /** The largest of the wave numbers. */
    unsigned int
    highest_wave_number() const;
  };

  struct GeometryParameters
  {
    unsigned int dimension = 2; ///< 3: a patch of the surfaces, not a profile

    /** Period along y, in three dimensions; automatic: as long as along x [m].
     */
    std::optional<double> width;

    double length      = 10e-6;   ///< period L; measured tools bring their own
    double height      = 5e-6;    ///< H
    double initial_gap = 0.02e-6; ///< smallest vertical distance at t = 0

    void
    declare(ParameterDeclarator &parameters);
  };

  enum class Continuity
  {
    smooth,    ///< p - 1 times continuously differentiable: splines
    continuous ///< as the functions of finite elements of degree p
  };

  struct MeshParameters
  {
    static constexpr unsigned int most_spans = 4096, most_levels = 6;

    unsigned int                degree     = 2;
    Continuity                  continuity = Continuity::smooth;
    unsigned int                spans      = 160;
    std::optional<unsigned int> across; ///< elements across, of all levels
    unsigned int                refinement = 3;
    double       strip      = 0.1e-6; ///< depth of the finest cells [m]
    double       grading    = 1.5;    ///< growth of rows with depth
    unsigned int quadrature = 0;      ///< Gauss points; 0: the fewest

    /** Of both surfaces along x, and of sheets along y, too, against the mesh,
     *  in elements of the contact edge. */
    double offset = 0.;

    /** Of the refinement levels, the finest ones that are only where the chip
     *  touches or soon will; and the sliding distance for which they suffice
     *  [m]. */
    unsigned int adaptive_levels = 0;
    double       remesh_distance = 0.1e-6;

    std::optional<unsigned int> halo; ///< cells of each beside what touches

    /** Of a mesh with such levels; 0: no bound. */
    unsigned int most_unknowns = 0;

    void
    declare(ParameterDeclarator &parameters);

    /** Relations between entries.
     *  @param height of the chip [m]
     *  @throws InputError if the splines cannot be built, or their integrals
     *  not be taken */
    void
    check(const ParameterDeclarator &parameters, const double height) const;

    /** Of each knot, in the mesh that the continuity makes. */
    unsigned int
    knot_multiplicity() const;

    /** Gauss points in each direction of an element. */
    unsigned int
    n_quadrature_points() const;

    /** Elements of the contact face along y, a multiple of 2 to the power of
     *  the levels: if not chosen, as long as along x or shorter. */
    unsigned int
    n_spans_across(const double length, const double width) const;

    /** Levels of refinement along the whole edge. */
    unsigned int
    n_even_levels() const;

    /** Whether the number of unknowns of a mesh that changes is. */
    bool
    is_bounded() const;

    /** Whether there is a mesh of half as many spans. */
    bool
    has_coarser() const;

    /** Whether that of a patch has elements twice as long across, too, which
     *  `automatic` promises only where it takes a level away. */
    bool
    has_coarser_across() const;

    /** Takes it, with half of the elements across that are chosen. */
    void
    coarsen();

    /** Whether twice as many spans are still allowed. */
    bool
    has_finer() const;

    /** Takes twice as many spans, with one more level of refinement, so that
     *  the depth stays as coarse as it is. */
    void
    refine();

    /** The fewest with which no motion but a rigid one is free of stress. */
    unsigned int
    fewest_quadrature_points() const;
  };

  struct LoadParameters
  {
    double pressure       = 300e6;
    double velocity       = 200. / 60.;
    double direction      = 0.; ///< of the sliding, to x, of a patch [rad]
    double temperature    = 298.15;
    double plastic_strain = 0.;

    void
    declare(ParameterDeclarator &parameters);
  };

  enum class Inertia
  {
    automatic,
    quasi_static,
    dynamic
  };

  /** When a run ends and over what mu is averaged. */
  enum class FrictionWindow
  {
    time,  ///< end time; the last part of it
    steady ///< until the mean over a sliding distance is steady
  };

  struct ProtocolParameters
  {
    double end_time = 2.5e-7;

    /** Sliding distance at the end, instead of its time [m]. */
    std::optional<double> sliding_distance;

    /** Distance after which the chip slides back [m]; 0: it never does. */
    double reversal_distance = 0.;

    /** Steps in the ramp; automatic: as SceneParameters::resolve() says. */
    std::optional<unsigned int> chosen_ramp_steps;

    double         ramp_fraction    = 0.2;
    unsigned int   ramp_steps       = 24;
    unsigned int   slide_steps      = 96;
    double         strain_increment = 0.; ///< most in a step; 0: any
    Inertia        inertia          = Inertia::automatic;
    double         spectral_radius  = 0.8;
    FrictionWindow window           = FrictionWindow::time;
    double         window_fraction  = 0.5;
    double         steady_distance  = 1e-6;  ///< length of a window [m]
    double         steady_step      = 10e-9; ///< sliding distance a step [m]
    double         steady_tolerance = 0.01;
    double         maximum_distance = 20e-6;

    void
    declare(ParameterDeclarator &parameters);

    /** Relations between entries.
     *  @throws InputError if the steady window could never be judged, or if the
     *  chip turns back while mu is averaged or the load grows
     *  @param velocity v [m/s] */
    void
    check(const ParameterDeclarator &parameters, const double velocity) const;

  private:
    void
    declare_window(ParameterDeclarator &parameters);

    void
    check_reversal(const ParameterDeclarator &parameters,
                   const double               velocity) const;
  };

  struct ContactParameters
  {
    ContactFormulation    formulation    = ContactFormulation::mortar;
    double                penalty_factor = 8.; ///< c in epsilon = c E / h
    std::optional<double> penalty;             ///< overrides the factor [Pa/m]
    unsigned int          quadrature            = 0;
    unsigned int          augmentations         = 0;
    double                penetration_tolerance = 1e-10; ///< [m]

    void
    declare(ParameterDeclarator &parameters);
  };

  struct SolverParameters
  {
    double           tolerance          = 1e-4; ///< of p L (p L W of a patch)
    unsigned int     maximum_iterations = 20;
    unsigned int     maximum_cuts       = 8;
    LinearSolverKind linear_solver      = LinearSolverKind::automatic;

    void
    declare(ParameterDeclarator &parameters);
  };

  struct OutputParameters
  {
    std::string  directory        = "output/run";
    unsigned int picture_interval = 8; ///< steps between VTU files; 0: end only
    unsigned int checkpoint_interval = 10; ///< steps; 0: none
    unsigned int subdivisions        = 2;

    /** Shares of t_end at which fields.h5 gets the fields of the chip; empty:
     *  there is none. */
    std::vector<double> field_times;
    bool                restart = false;

    void
    declare(ParameterDeclarator &parameters);
  };

  /** Everything that a parameter file of a contact scene says. */
  struct SceneParameters
  {
    GeometryParameters    geometry;
    SurfaceParameters     tool, chip;
    MeshParameters        mesh;
    MaterialParameters    material;
    LoadParameters        load;
    ProtocolParameters    protocol;
    ContactParameters     contact;
    InterfaceParameters   interface;
    LubricationParameters lubrication;
    HeatParameters        heat;
    AccuracyParameters    accuracy;
    SolverParameters      solver;
    OutputParameters      output;

    SceneParameters();

    void
    declare(ParameterDeclarator &parameters);

    /** Relations between entries.
     *  @throws InputError naming the entry that contradicts another */
    void
    check(const ParameterDeclarator &parameters) const;

    /** Puts in numbers that follow from others: the end time from the sliding
     *  distance, the steps of the ramp from the law of the interface. */
    void
    resolve();

    /** The heat model with another one for `automatic`: isothermal if the
     *  material says so, conducting if the interface has a shear law, otherwise
     *  adiabatic. */
    HeatModel
    heat_model() const;

    /** The point law of the chip under this model.
     *  @throws InputError if one of its constants has no physical meaning */
    std::unique_ptr<MaterialLaw>
    make_law() const;

    /** What conduction needs to know of the chip. */
    ThermalProperties
    chip_thermal() const;
  };
} // namespace asperity

#endif
