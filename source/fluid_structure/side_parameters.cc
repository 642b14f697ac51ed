#include <asperity/base/errors.h>
#include <asperity/fluid_structure/problem_parameters.h>

#include <algorithm>

// The entries of fluid, body, and time steps.
namespace asperity
{
  void
  FluidParameters::declare(ParameterDeclarator &d)
  {
    const auto section = d.subsection("Fluid");
    d.quantity("Density",
               density,
               "kg/m^3",
               Range::between(1e-3, 1e5),
               "Mass density rho of the fluid, which is incompressible.");
    d.quantity("Viscosity",
               viscosity,
               "Pa s",
               Range::between(1e-9, 1e6),
               "Dynamic viscosity eta, Newtonian.");
    d.choice("Time scheme",
             scheme,
             {{"steady", FluidTimeScheme::steady},
              {"implicit Euler", FluidTimeScheme::implicit_euler},
              {"BDF2", FluidTimeScheme::bdf2}},
             "`steady`: without rates, which needs a quasi-static body and "
             "Dirichlet-Neumann coupling; `implicit Euler`, of first order; "
             "`BDF2`, of second order.");
    d.integer("Degree",
              degree,
              Range::between(2, 5),
              "Degree k of the velocity and of the cells' edges; the pressure "
              "has k - 1 (Taylor-Hood).");
    declare_mesh(d);
    d.number("Tolerance",
             tolerance,
             Range::between(1e-14, 1e-3),
             "Residual of the flow, relative to its terms, at which Newton's "
             "method ends.");
    d.number("Kept tangent",
             kept_tangent,
             Range{0., 1., true, false},
             "A tangent of the flow is kept while each step with it reduces "
             "the residual to this share or less; 0: each is new.");
    d.number("Mesh stiffening",
             stiffening,
             Range::between(0., 5.),
             "Exponent chi with which small cells of the fluid's mesh are "
             "stiffer than large ones.");
  }



  void
  FluidParameters::declare_mesh(ParameterDeclarator &d)
  {
    d.integer("Refinements",
              refinements,
              Range::between(0, 6),
              "Uniform refinements of the coarse mesh.");
    d.integer("Wall layers",
              wall_layers,
              Range::between(0, 8),
              "Turek-Hron: further refinements of the cells at cylinder and "
              "flag.");
    d.integer("Corner layers",
              corner_layers,
              Range::between(0, 12),
              "Turek-Hron: further refinements of the cells at the corners of "
              "the flag.");
    d.integer("Cells along",
              cells_along,
              Range::between(4, 2000),
              "Lined channel and enclosed domain: cells of the coarse mesh "
              "along the body.");
    d.integer("Cells across",
              cells_across,
              Range::between(1, 200),
              "Lined channel and enclosed domain: cells of the coarse mesh "
              "across the fluid.");
  }



  void
  BodyParameters::declare(ParameterDeclarator &d)
  {
    const auto section = d.subsection("Body");
    d.flag("Dynamic",
           dynamic,
           "Whether the body has inertia (generalized-alpha) or is "
           "quasi-static.");
    d.integer("Degree",
              degree,
              Range::between(1, 4),
              "Degree of the splines; `automatic`: 3 for the flag, else 2.");
    d.integer("Spans along",
              spans_along,
              Range::between(1, 2000),
              "Elements along the wet edge, for the box those a metre of it; "
              "`automatic`: 16 for the flag, 4 for the box, else as many as "
              "cells of the fluid.");
    d.integer("Spans across",
              spans_across,
              Range::between(1, 200),
              "Elements through the thickness; `automatic`: 8 in the enclosed "
              "domain, else 2.");
    d.number("Spectral radius",
             spectral_radius,
             Range::between(0., 1.),
             "Of generalized-alpha at infinite frequency; 1 damps nothing.");
    d.number("Tolerance",
             tolerance,
             Range::between(1e-14, 1e-3),
             "Residual of the body over the largest load of the run so far at "
             "which Newton's method ends.");
    d.quantity("Load floor",
               load_floor,
               "N/m",
               Range::between(0., 1e12),
               "Smallest load that residuals are compared with.");
  }



  void
  TimeParameters::declare(ParameterDeclarator &d)
  {
    const auto section = d.subsection("Time");
    d.list("Steps",
           steps,
           "s",
           Range::between(1e-15, 1e6),
           "Time steps, one for each of the ends.");
    d.list("Ends",
           ends,
           "s",
           Range::between(1e-15, 1e9),
           "Times, growing, up to which each of the steps is taken; the last "
           "is the end of the run.");
    d.integer("Maximum cuts",
              maximum_cuts,
              Range::between(0, 30),
              "How often a step without solution is halved before the run "
              "gives up.");
  }



  void
  TimeParameters::check(const ParameterDeclarator &parameters) const
  {
    if (steps.empty() || ends.size() != steps.size())
      throw InputError(parameters.where("Time/Ends") + ": found " +
                       std::to_string(ends.size()) + " times; expected " +
                       std::to_string(std::max<std::size_t>(steps.size(), 1)) +
                       ", one for each time step.");
    for (std::size_t i = 1; i < ends.size(); ++i)
      if (ends[i] <= ends[i - 1])
        throw InputError(parameters.where("Time/Ends") + ": found " +
                         format_quantity(ends[i], "s") + " after " +
                         format_quantity(ends[i - 1], "s") +
                         "; expected times that grow.");
  }



  double
  TimeParameters::step_at(const double time) const
  {
    for (std::size_t i = 0; i < ends.size(); ++i)
      if (time < ends[i] - 1e-6 * steps[i])
        return std::min(steps[i], ends[i] - time);
    return 0.;
  }



  double
  TimeParameters::end() const
  {
    return ends.back();
  }
} // namespace asperity
