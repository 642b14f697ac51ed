#ifndef asperity_fluid_structure_problem_parameters_h
#define asperity_fluid_structure_problem_parameters_h

#include <asperity/constitutive/material_parameters.h>
#include <asperity/contact_zone/scene_parameters.h>
#include <asperity/coupling/coupling_parameters.h>
#include <asperity/flow/navier_stokes.h>

#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  enum class ProblemKind
  {
    turek_hron, ///< elastic flag behind a cylinder in a channel
    inflatable_box,
    lined_channel,  ///< half a channel with an elastic lining
    enclosed_domain ///< fluid between a rough rigid wall and an elastic body
  };

  /** What flows where, and what drives it. */
  struct ProblemParameters
  {
    ProblemKind kind = ProblemKind::turek_hron;

    /** Of the fluid, read instead of made; empty: none. */
    std::string mesh_file;

    /** Output folder of a run on another mesh to go on from; empty: none. */
    std::string continue_from;

    double largest_inflow = 0.3; ///< peak of the parabola [m/s]
    double inflow_ramp    = 2.;  ///< [s]

    /** From which the inflow ceases within half a second [s]. */
    std::optional<double> inflow_end;

    /** Two periods of a vertical body force after the ramp. */
    double shaking           = 0.; ///< [m/s^2]
    double shaking_frequency = 5.; ///< [1/s]

    double pulse          = 20.;  ///< at the inlet of the lined channel [Pa]
    double pulse_duration = 5e-3; ///< [s]

    double wall_displacement = 0.5e-6; ///< of the enclosed domain [m]
    double wall_duration     = 1e-6;   ///< [s]

    void
    declare(ParameterDeclarator &parameters);

  private:
    void
    declare_inflow(ParameterDeclarator &parameters);

    /** What acts on fluid or walls for a short time. */
    void
    declare_pulses(ParameterDeclarator &parameters);
  };

  /** The fluid and its elements. */
  struct FluidParameters
  {
    double          density       = 1e3;
    double          viscosity     = 1.;
    FluidTimeScheme scheme        = FluidTimeScheme::steady;
    unsigned int    degree        = 2; ///< of velocity and geometry
    unsigned int    refinements   = 1; ///< uniform, of the coarse mesh
    unsigned int    wall_layers   = 1; ///< of the channel with the flag
    unsigned int    corner_layers = 0; ///< of the channel with the flag
    unsigned int    cells_along   = 50;
    unsigned int    cells_across  = 2;
    double          tolerance     = 1e-9;

    /** FluidOptions::kept_tangent_contraction */
    double kept_tangent = 0.;

    /** ElasticMeshOptions::stiffening_exponent */
    double stiffening = 1.;

    void
    declare(ParameterDeclarator &parameters);

  private:
    void
    declare_mesh(ParameterDeclarator &parameters);
  };

  /** The splines and the motion of the elastic body. */
  struct BodyParameters
  {
    bool                        dynamic = false;
    std::optional<unsigned int> degree;
    std::optional<unsigned int> spans_along;  ///< along the wet edge
    std::optional<unsigned int> spans_across; ///< through the thickness
    double                      spectral_radius = 0.8;
    double                      tolerance       = 1e-10;

    /** SplineSolidOptions::load_floor */
    double load_floor = 1.;

    void
    declare(ParameterDeclarator &parameters);
  };

  /** Time steps, each kind up to a time. */
  struct TimeParameters
  {
    std::vector<double> steps{1.}; ///< [s]
    std::vector<double> ends{1.};  ///< [s]
    unsigned int        maximum_cuts = 4;

    void
    declare(ParameterDeclarator &parameters);

    /** @throws InputError if steps and ends do not belong together */
    void
    check(const ParameterDeclarator &parameters) const;

    /** The step that starts at a time; 0 at the end [s]. */
    double
    step_at(const double time) const;

    double
    end() const;
  };

  /** All that a parameter file of a fluid-structure problem says. */
  struct FluidStructureParameters
  {
    ProblemParameters  problem;
    GeometryParameters geometry;           ///< of the enclosed domain
    SurfaceParameters  tool, chip_surface; ///< of the enclosed domain
    FluidParameters    fluid;
    BodyParameters     body;
    MaterialParameters material;
    CouplingParameters coupling;
    TimeParameters     time;
    OutputParameters   output;

    /** FSI1 of Turek and Hron on a coarse mesh. */
    FluidStructureParameters();

    void
    declare(ParameterDeclarator &parameters);

    /** Relations between entries.
     *  @throws InputError naming the entry that contradicts another */
    void
    check(const ParameterDeclarator &parameters) const;

    /** A sentence about the entries that a file sets and this kind of problem
     *  does not use; empty if there are none. */
    std::string
    unused_entries(const ParameterDeclarator &parameters) const;
  };

  /** "enclosed domain" */
  std::string
  name(const ProblemKind kind);
} // namespace asperity

#endif
