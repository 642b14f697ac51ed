#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/fluid_structure/problem_parameters.h>

#include <algorithm>
#include <set>
#include <utility>

namespace asperity
{
  namespace
  {
    const std::vector<std::pair<std::string, ProblemKind>> &
    kinds()
    {
      static const std::vector<std::pair<std::string, ProblemKind>> table = {
        {"Turek-Hron", ProblemKind::turek_hron},
        {"inflatable box", ProblemKind::inflatable_box},
        {"lined channel", ProblemKind::lined_channel},
        {"enclosed domain", ProblemKind::enclosed_domain}};
      return table;
    }

    /** Subsections and entries that only some problems use. */
    const std::vector<std::pair<std::string, std::set<ProblemKind>>> &
    users_of_entries()
    {
      using K = ProblemKind;
      static const std::vector<std::pair<std::string, std::set<K>>> table = {
        {"Problem/Mesh file",
         {K::turek_hron, K::inflatable_box, K::lined_channel}},
        {"Problem/Inflow/End", {K::inflatable_box}},
        {"Problem/Inflow/", {K::turek_hron, K::inflatable_box}},
        {"Problem/Shaking/", {K::turek_hron}},
        {"Problem/Pulse/", {K::lined_channel}},
        {"Problem/Wall motion/", {K::enclosed_domain}},
        {"Geometry/", {K::enclosed_domain}},
        {"Tool/", {K::enclosed_domain}},
        {"Chip surface/", {K::enclosed_domain}},
        {"Fluid/Wall layers", {K::turek_hron}},
        {"Fluid/Corner layers", {K::turek_hron}},
        {"Fluid/Cells along", {K::lined_channel, K::enclosed_domain}},
        {"Fluid/Cells across", {K::lined_channel, K::enclosed_domain}}};
      return table;
    }
  } // namespace



  std::string
  name(const ProblemKind kind)
  {
    return std::find_if(kinds().begin(),
                        kinds().end(),
                        [kind](const auto &entry) {
                          return entry.second == kind;
                        })
      ->first;
  }



  void
  ProblemParameters::declare(ParameterDeclarator &d)
  {
    const auto section = d.subsection("Problem");
    d.choice("Kind",
             kind,
             kinds(),
             "`Turek-Hron`: an elastic flag behind a cylinder in a channel; "
             "`inflatable box`: an elastic box that is filled through a rigid "
             "channel; `lined channel`: a pulse of pressure in half a channel "
             "with an elastic lining; `enclosed domain`: fluid between a rough "
             "rigid tool that moves along x and an elastic chip.");
    d.file("Mesh file",
           mesh_file,
           "Quadrilaterals of the fluid in a format that deal.II reads (.msh, "
           ".inp, .vtk, .unv); none: the mesh is made. Boundary ids as in "
           "parameter_files/fluid_structure/README.md.");
    d.text("Continue from",
           continue_from,
           "Output folder of a run of the same body in a coarser or finer mesh "
           "of the fluid, from whose newest checkpoint this one goes on: a "
           "flow develops at less cost on a coarse mesh. None: from rest.");
    declare_inflow(d);
    declare_pulses(d);
    const auto motion = d.subsection("Wall motion");
    d.quantity("Displacement",
               wall_displacement,
               "um",
               Range::between(-1e-3, 1e-3),
               "Enclosed domain: way of the tool along x towards the chip, "
               "half a cosine over time.");
    d.quantity("Duration",
               wall_duration,
               "us",
               Range::between(1e-12, 1e3),
               "Enclosed domain: time until the tool is there.");
  }



  void
  ProblemParameters::declare_inflow(ParameterDeclarator &d)
  {
    const auto inflow = d.subsection("Inflow");
    d.quantity("Largest velocity",
               largest_inflow,
               "m/s",
               Range::between(0., 1e3),
               "Peak of the parabola over the inlet, 1.5 times the mean.");
    d.quantity("Ramp time",
               inflow_ramp,
               "s",
               Range::between(0., 1e3),
               "Time from rest to the full inflow: half a cosine for the "
               "flag, a quarter of a sine for the box; steady flows have "
               "none.");
    d.quantity("End",
               inflow_end,
               "s",
               Range::between(0., 1e6),
               "Box: time from which the inflow ceases within half a "
               "second; `automatic`: never.");
  }



  void
  ProblemParameters::declare_pulses(ParameterDeclarator &d)
  {
    {
      const auto shake = d.subsection("Shaking");
      d.quantity("Acceleration",
                 shaking,
                 "m/s2",
                 Range::between(0., 1e3),
                 "Amplitude of a vertical body force on the fluid, two periods "
                 "after the ramp, that starts the swing of the flag; nothing "
                 "is left of it but the swing.");
      d.quantity("Frequency",
                 shaking_frequency,
                 "1/s",
                 Range::between(0.01, 1e3),
                 "Frequency of that force.");
    }
    const auto pressure = d.subsection("Pulse");
    d.quantity("Pressure",
               pulse,
               "Pa",
               Range::between(0., 1e9),
               "Lined channel: height of the pulse at the inlet, a square of "
               "a sine.");
    d.quantity("Duration",
               pulse_duration,
               "s",
               Range::between(1e-9, 1e3),
               "Lined channel: how long the pulse takes.");
  }



  FluidStructureParameters::FluidStructureParameters()
  {
    geometry.initial_gap = 1e-6;
    material.choose(StVenantKirchhoffParameters{});
    material.elasticity.density       = 1e3;
    material.elasticity.young_modulus = 1.4e6;
    material.elasticity.poisson_ratio = 0.4;
    coupling.scheme                   = CouplingScheme::dirichlet_neumann;
    coupling.predictor_degree         = 0;
    output.directory                  = "output/fluid_structure";
  }



  void
  FluidStructureParameters::declare(ParameterDeclarator &parameters)
  {
    problem.declare(parameters);
    geometry.declare(parameters);
    tool.declare(parameters, "Tool", "tool");
    chip_surface.declare(parameters, "Chip surface", "chip");
    fluid.declare(parameters);
    body.declare(parameters);
    material.declare(parameters);
    coupling.declare(parameters);
    time.declare(parameters);
    output.declare(parameters);
  }



  void
  FluidStructureParameters::check(const ParameterDeclarator &parameters) const
  {
    if (!output.field_times.empty())
      throw InputError(parameters.where("Output/Field times") +
                       ": found times with a problem without contact; expected "
                       "nothing, since fields are those of a contact scene.");
    tool.check(parameters, "Tool");
    chip_surface.check(parameters, "Chip surface");
    if (geometry.dimension != 2)
      throw InputError(parameters.where("Geometry/Dimension") + ": found " +
                       std::to_string(geometry.dimension) +
                       " in a fluid-structure problem; expected 2.");
    material.check(parameters);
    time.check(parameters);
    if (fluid.scheme == FluidTimeScheme::steady)
      {
        // Without rates a wall has no velocity that Robin's condition could
        // give way to.
        if (coupling.scheme != CouplingScheme::dirichlet_neumann)
          throw InputError(parameters.where("Coupling/Scheme") +
                           ": found Robin-Neumann with a steady flow, whose "
                           "walls have no velocity; expected "
                           "Dirichlet-Neumann.");
        if (body.dynamic)
          throw InputError(parameters.where("Body/Dynamic") +
                           ": found true with a steady flow; expected false.");
      }
  }



  std::string
  FluidStructureParameters::unused_entries(
    const ParameterDeclarator &parameters) const
  {
    std::string list;
    for (const ParameterEntry &entry : parameters.entries())
      {
        if (!entry.given)
          continue;
        const auto user = std::find_if(users_of_entries().begin(),
                                       users_of_entries().end(),
                                       [path = entry.path()](const auto &rule) {
                                         return path.compare(0,
                                                             rule.first.size(),
                                                             rule.first) == 0;
                                       });
        if (user != users_of_entries().end() &&
            user->second.count(problem.kind) == 0)
          list += (list.empty() ? "" : ", ") + quoted_name(entry.path());
      }
    return list.empty() ? "" :
                          "The problem " + quoted_name(name(problem.kind)) +
                            " does not use the entries " + list + ".";
  }
} // namespace asperity
