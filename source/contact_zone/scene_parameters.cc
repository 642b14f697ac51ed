#include <asperity/base/errors.h>
#include <asperity/contact_zone/scene_parameters.h>

namespace asperity
{
  void
  GeometryParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Geometry");
    parameters.quantity("Period",
                        length,
                        "um",
                        Range::positive(),
                        "L, the length of the chip block, over which tool and "
                        "chip repeat. A measured tool brings its own length, "
                        "and this entry is not used.");
    parameters.quantity("Chip height",
                        height,
                        "um",
                        Range::positive(),
                        "H, the thickness of the chip block that is modelled.");
    parameters.quantity("Initial gap",
                        initial_gap,
                        "um",
                        Range::any(),
                        "Smallest vertical distance between tool and chip at "
                        "the start; a negative one would overlap and is "
                        "refused.");
  }



  void
  MeshParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Mesh");
    parameters.integer("Degree",
                       degree,
                       Range::between(1, 4),
                       "Degree p of the splines; they are p - 1 times "
                       "continuously differentiable.");
    parameters.integer("Spans",
                       spans,
                       Range::between(4, 4096),
                       "Bezier elements along the contact edge over a period.");
    parameters.integer("Refinement levels",
                       refinement,
                       Range::between(0, 6),
                       "Levels of hierarchical refinement between the bottom "
                       "and the contact edge; each halves the element size. "
                       "Spans must be a multiple of 2 to this power.");
    parameters.quantity("Strip depth",
                        strip,
                        "um",
                        Range::positive(),
                        "Depth of the strip of finest elements below the "
                        "contact edge; each coarser level reaches twice as "
                        "deep.");
    parameters.number("Row grading",
                      grading,
                      Range::at_least(1.),
                      "Factor by which rows of the coarsest level grow with "
                      "depth; 1 gives rows of one height.");
    parameters.integer("Quadrature points",
                       quadrature,
                       Range::between(0, 10),
                       "Gauss points in each direction of an element; 0 means "
                       "the degree, at which the smooth splines are stable and "
                       "mu changes by 1e-4 against degree + 1.");
  }



  void
  LoadParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Load");
    parameters.quantity("Pressure",
                        pressure,
                        "MPa",
                        Range::positive(),
                        "p, the nominal contact pressure: vertical dead load "
                        "on the bottom of the chip.");
    parameters.quantity("Velocity",
                        velocity,
                        "m/min",
                        Range::positive(),
                        "v, with which the bottom of the chip slides in x.");
    parameters.quantity("Temperature",
                        temperature,
                        "degC",
                        Range::at_least(0.),
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
                      Range::positive(),
                      "c in the penalty epsilon = c E/h, h the element length "
                      "at the contact edge.");
    parameters.quantity("Penalty",
                        penalty,
                        "Pa/m",
                        Range::positive(),
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
                        Range::positive(),
                        "The augmented-Lagrange loop ends below this largest "
                        "penetration.");
  }



  void
  SolverParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Solver");
    parameters.number("Tolerance",
                      tolerance,
                      Range::between(1e-12, 0.1),
                      "Euclidean norm of the residual over p L at which "
                      "Newton's method ends.");
    parameters.integer("Maximum iterations",
                       maximum_iterations,
                       Range::between(1, 1000),
                       "Newton iterations before the step is cut.");
    parameters.integer("Maximum cuts",
                       maximum_cuts,
                       Range::between(0, 30),
                       "How often a step is halved before the run gives up.");
    parameters.choice("Linear solver",
                      linear_solver,
                      {{"cholmod", DirectSolverKind::cholmod},
                       {"umfpack", DirectSolverKind::umfpack},
                       {"klu", DirectSolverKind::klu},
                       {"mumps", DirectSolverKind::mumps}},
                      "Direct solver of the tangent: `cholmod`, Cholesky with "
                      "LU where the tangent is indefinite, is the fastest; "
                      "`umfpack`, `klu` and `mumps` for comparison.");
  }



  void
  OutputParameters::declare(ParameterDeclarator &parameters)
  {
    const auto in_section = parameters.subsection("Output");
    parameters.text("Output directory",
                    directory,
                    "Folder of the results, made if it does not exist.");
    parameters.integer("Picture interval",
                       picture_interval,
                       Range::between(0, 1000000),
                       "Steps between VTU files; 0 writes only the end.");
    parameters.integer("Checkpoint interval",
                       checkpoint_interval,
                       Range::between(0, 1000000),
                       "Steps between checkpoints; 0 writes none.");
    parameters.integer("Subdivisions",
                       subdivisions,
                       Range::between(1, 10),
                       "Pieces into which pictures divide an element in each "
                       "direction.");
    parameters.flag(
      "Restart",
      restart,
      "Go on from the newest checkpoint of the output directory.");
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
    lubrication.declare(parameters);
    solver.declare(parameters);
    output.declare(parameters);
  }



  void
  SceneParameters::resolve()
  {
    if (protocol.sliding_distance)
      protocol.end_time = *protocol.sliding_distance / load.velocity;
  }



  void
  SceneParameters::check(const ParameterDeclarator &parameters) const
  {
    tool.check(parameters, "Tool");
    chip.check(parameters, "Chip surface");
    lubrication.check(parameters);
    if (fills_gap(lubrication.model) &&
        protocol.inertia == Inertia::quasi_static)
      throw InputError(parameters.where("Protocol/Inertia") +
                       ": found quasi-static with the lubricant model `" +
                       name(lubrication.model) +
                       "`; expected dynamic or automatic, since a chip that "
                       "floats on oil is held by its mass alone while the flow "
                       "is solved for.");
    if (geometry.initial_gap < 0.)
      throw InputError(parameters.where("Geometry/Initial gap") + ": found " +
                       format_quantity(geometry.initial_gap, "um") +
                       ", so that tool and chip overlap at the start; expected "
                       "a gap >= 0 um.");
    if (mesh.spans % (1u << mesh.refinement) != 0)
      throw InputError(parameters.where("Mesh/Spans") + ": found " +
                       std::to_string(mesh.spans) +
                       "; expected a multiple of " +
                       std::to_string(1u << mesh.refinement) +
                       ", 2 to the power of the refinement levels.");
    if (mesh.spans >> mesh.refinement < 2 * mesh.degree + 2)
      throw InputError(
        parameters.where("Mesh/Spans") + ": found " +
        std::to_string(mesh.spans) + " with " +
        std::to_string(mesh.refinement) +
        " refinement levels; expected at least " +
        std::to_string((2 * mesh.degree + 2) << mesh.refinement) +
        ", so that the coarsest level has 2 p + 2 spans.");
    if (mesh.strip >= geometry.height)
      throw InputError(parameters.where("Mesh/Strip depth") + ": found " +
                       format_quantity(mesh.strip, "um") +
                       "; expected less than the chip height of " +
                       format_quantity(geometry.height, "um") + ".");
  }
} // namespace asperity
