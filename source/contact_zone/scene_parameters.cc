#include <asperity/contact_zone/scene_parameters.h>

#include <cmath>

namespace asperity
{
  void
  GeometryParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Geometry");
    parameters.integer("Dimension",
                       dimension,
                       Range::between(2, 3),
                       "2: profiles in plane strain; 3: a patch of the "
                       "surfaces, periodic along x and y, "
                       "with oil in pockets at most.");
    parameters.quantity("Width",
                        width,
                        "um",
                        Range::between(1e-8, 1e-2),
                        "W, the period along y, across x, of a patch "
                        "(Dimension = 3); `automatic`: as the period along "
                        "x.");
    parameters.quantity("Period",
                        length,
                        "um",
                        Range::between(1e-8, 1e-2),
                        "L, the length of the chip block, over which tool and "
                        "chip repeat. A measured tool brings its own length, "
                        "and this entry is not used.");
    parameters.quantity("Chip height",
                        height,
                        "um",
                        Range::between(1e-8, 1e-2),
                        "H, the thickness of the chip block that is modelled.");
    parameters.quantity("Initial gap",
                        initial_gap,
                        "um",
                        Range::between(0., 1e-3),
                        "Smallest vertical distance between tool and chip at "
                        "the start.");
  }



  namespace
  {
    void
    declare_functions(ParameterDeclarator &parameters,
                      unsigned int        &degree,
                      Continuity          &continuity)
    {
      parameters.integer("Degree",
                         degree,
                         Range::between(1, 4),
                         "Degree p of the splines.");
      parameters.choice(
        "Continuity",
        continuity,
        {{"smooth", Continuity::smooth}, {"C0", Continuity::continuous}},
        "Between elements. smooth: splines, p - 1 times "
        "continuously differentiable; C0: with kinks, the "
        "finite elements Q_p, with p times as many functions in "
        "each direction, to compare with.");
    }

    void
    declare_offset(ParameterDeclarator &parameters, double &offset)
    {
      parameters.number("Offset",
                        offset,
                        Range::between(-1., 1.),
                        "Part of an element of the contact edge by which both "
                        "surfaces are moved along x against the mesh, in three "
                        "dimensions along y, too: what this changes of mu is "
                        "numerical error.");
    }

    /** Of a mesh that follows the contacts. */
    void
    declare_adaptation(ParameterDeclarator &parameters, MeshParameters &mesh)
    {
      parameters.integer(
        "Adaptive levels",
        mesh.adaptive_levels,
        Range::between(0, MeshParameters::most_levels),
        "How many of the Refinement levels, the finest ones, "
        "are only where the chip touches the tool or soon will; "
        "the mesh changes during the run. 0: none, all levels "
        "are along the whole contact edge.");
      parameters.quantity(
        "Remesh distance",
        mesh.remesh_distance,
        "um",
        Range::between(1e-10, 1e-2),
        "Sliding distance ahead for which a mesh with Adaptive "
        "levels is refined when it changes.");
      parameters.integer("Adaptive halo",
                         mesh.halo,
                         Range::between(1, 1000),
                         "Cells of each of the Adaptive levels on each side of "
                         "what touches, when the mesh changes; it does so when "
                         "0.6 of them are left. `automatic`: 10, of a patch "
                         "(Dimension = 3) 5.");
      parameters.integer(
        "Maximum unknowns",
        mesh.most_unknowns,
        Range::between(0, 100000000),
        "Of a mesh with Adaptive levels: where contacts want "
        "more, fewer cells beside them are fine, and at last "
        "the finest levels are left out; a warning says so. 0: "
        "no bound.");
    }
  } // namespace



  void
  MeshParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Mesh");
    declare_functions(parameters, degree, continuity);
    parameters.integer("Spans",
                       spans,
                       Range::between(4, most_spans),
                       "Bezier elements along the contact edge over a period.");
    parameters.integer("Spans across",
                       across,
                       Range::between(4, most_spans),
                       "Bezier elements of the contact face along y, across x, "
                       "of a patch (Dimension = 3); `automatic`: as long as "
                       "along x.");
    parameters.integer("Refinement levels",
                       refinement,
                       Range::between(0, most_levels),
                       "Levels of hierarchical refinement between the bottom "
                       "and the contact edge; each halves the element size. "
                       "Spans must be a multiple of 2 to this power.");
    declare_adaptation(parameters, *this);
    parameters.quantity("Strip depth",
                        strip,
                        "um",
                        Range::between(1e-10, 1e-2),
                        "Depth of the strip of finest elements below the "
                        "contact edge; each coarser level reaches twice as "
                        "deep.");
    parameters.number("Row grading",
                      grading,
                      Range::between(1., 10.),
                      "Factor by which rows of the coarsest level grow with "
                      "depth; 1 gives rows of one height.");
    parameters.integer("Quadrature points",
                       quadrature,
                       Range::between(0, 10),
                       "Gauss points in each direction of an element; 0 means "
                       "the degree, at which smooth splines are stable and "
                       "mu changes by 1e-4 against degree + 1, or degree + 1 "
                       "with `Continuity = C0`; fewer leave "
                       "motions without stress and are refused.");
    declare_offset(parameters, offset);
  }



  void
  LoadParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Load");
    parameters.quantity("Pressure",
                        pressure,
                        "MPa",
                        Range::between(1e3, 1e11),
                        "p, the nominal contact pressure: vertical dead load "
                        "on the bottom of the chip.");
    parameters.quantity("Velocity",
                        velocity,
                        "m/min",
                        Range::between(1e-6 / 60., 1e5 / 60.),
                        "v, with which the bottom of the chip slides in x, or "
                        "in Sliding direction.");
    parameters.quantity("Sliding direction",
                        direction,
                        "deg",
                        Range::between(-2. * M_PI, 2. * M_PI),
                        "Angle to x, towards y, in which the chip of a patch "
                        "(Dimension = 3) slides: 90 deg is along y. Friction "
                        "counts along it, `friction.transverse` across it, to "
                        "its left.");
    parameters.quantity("Temperature",
                        temperature,
                        "degC",
                        Range::between(0., 5273.15),
                        "T, of the chip at the start.");
    parameters.number("Plastic strain",
                      plastic_strain,
                      Range::between(0., 20.),
                      "Equivalent plastic strain of the chip at the start, as "
                      "the shear zone has left it.");
  }



  void
  ContactParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Contact");
    parameters.choice("Formulation",
                      formulation,
                      {{"mortar", ContactFormulation::mortar},
                       {"gauss-point", ContactFormulation::gauss_point}},
                      "`mortar`: knot to surface, a pressure for each control "
                      "point; `gauss-point`: a pressure for each quadrature "
                      "point.");
    parameters.number("Penalty factor",
                      penalty_factor,
                      Range::between(1e-3, 1e6),
                      "c in the penalty epsilon = c E/h, h the element length "
                      "at the contact edge.");
    parameters.quantity("Penalty",
                        penalty,
                        "Pa/m",
                        Range::between(1e10, 1e26),
                        "epsilon itself; `automatic` takes c E/h.");
    parameters.integer("Quadrature points",
                       quadrature,
                       Range::between(0, 20),
                       "Gauss points on each element of the contact edge; 0 "
                       "means degree + 2.");
    parameters.integer("Augmentations",
                       augmentations,
                       Range::between(0, 100),
                       "Passes of the augmented-Lagrange loop in a step; 0 "
                       "leaves the penalty alone.");
    parameters.quantity("Penetration tolerance",
                        penetration_tolerance,
                        "nm",
                        Range::between(1e-15, 1e-6),
                        "The augmented-Lagrange loop ends below this largest "
                        "penetration.");
  }



  void
  SolverParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Solver");
    parameters.number("Tolerance",
                      tolerance,
                      Range::between(1e-12, 0.01),
                      "Euclidean norm of the residual over p L (p L W of a "
                      "patch) at which Newton's method ends.");
    parameters.integer("Maximum iterations",
                       maximum_iterations,
                       Range::between(1, 1000),
                       "Newton iterations before the step is cut.");
    parameters.integer("Maximum cuts",
                       maximum_cuts,
                       Range::between(0, 30),
                       "How often a step is halved before the run gives up.");
    parameters.choice(
      "Linear solver",
      linear_solver,
      {{"automatic", LinearSolverKind::automatic},
       {"cholmod", LinearSolverKind::cholmod},
       {"umfpack", LinearSolverKind::umfpack},
       {"klu", LinearSolverKind::klu},
       {"mumps", LinearSolverKind::mumps},
       {"krylov", LinearSolverKind::krylov}},
      "Solver of the tangent: `cholmod`, Cholesky with LU where "
      "the tangent is indefinite, is the fastest direct one on "
      "one rank, `mumps` the one on several; `krylov`, GMRES "
      "with algebraic multigrid, needs the least memory; "
      "`automatic` takes a direct one in two dimensions, and in "
      "three below 8,000 unknowns where the memory has room for "
      "its factor, else `krylov`. `umfpack` and `klu` are for "
      "comparison, on one rank; `krylov` is for three dimensions.");
  }



  SceneParameters::SceneParameters()
  {
    tool.kind = SurfaceKind::harmonics;
    // The reference scene R0.
    tool.wave_numbers = {1, 2, 3, 4, 5, 6};
    tool.amplitudes   = {0.16e-6, 0.12e-6, 0.09e-6, 0.06e-6, 0.04e-6, 0.02e-6};
    tool.phases       = {0.3, 1.9, 4.1, 5.2, 0.9, 2.6};
  }



  void
  SceneParameters::declare(ParameterDeclarator &parameters)
  {
    geometry.declare(parameters);
    tool.declare(parameters, "Tool", "tool");
    chip.declare(parameters, "Chip surface", "chip");
    mesh.declare(parameters);
    material.declare(parameters);
    load.declare(parameters);
    protocol.declare(parameters);
    contact.declare(parameters);
    interface.declare(parameters);
    lubrication.declare(parameters);
    heat.declare(parameters);
    accuracy.declare(parameters);
    solver.declare(parameters);
    output.declare(parameters);
  }



  void
  SceneParameters::resolve()
  {
    if (protocol.sliding_distance)
      protocol.end_time = *protocol.sliding_distance / load.velocity;
    if (protocol.chosen_ramp_steps)
      protocol.ramp_steps = *protocol.chosen_ramp_steps;
    else if (interface.uses_shear_strength())
      protocol.ramp_steps = 36;
  }



  HeatModel
  SceneParameters::heat_model() const
  {
    if (heat.model != HeatModel::automatic)
      return heat.model;
    if (!material.heats_itself())
      return HeatModel::isothermal;
    // The heat of friction arises on the surface: without conduction it has
    // nowhere to go, and the layer that shears would melt by its own heat.
    return interface.law == InterfaceShear::none ? HeatModel::adiabatic :
                                                   HeatModel::conducting;
  }



  std::unique_ptr<MaterialLaw>
  SceneParameters::make_law() const
  {
    MaterialParameters chosen = material;
    if (heat.model == HeatModel::isothermal)
      chosen.heating.adiabatic = false;
    return chosen.make_law();
  }



  ThermalProperties
  SceneParameters::chip_thermal() const
  {
    return {heat.chip_conductivity,
            material.elasticity.density,
            material.heating.heat_capacity};
  }
} // namespace asperity
