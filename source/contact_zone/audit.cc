#include <asperity/contact_zone/audit.h>
#include <asperity/contact_zone/load_protocol.h>

#include <cmath>

namespace asperity
{
  namespace
  {
    /** Thermal conductivity of steel, for the audit's estimate only [W/(m K)].
     */
    constexpr double conductivity = 45.;

    void
    audit_time_scales(const SceneParameters &parameters,
                      const Scene           &scene,
                      SceneAudit            &audit)
    {
      const double E          = scene.law->young_modulus(),
                   nu         = scene.law->poisson_ratio();
      const double M          = E * (1. - nu) / ((1. + nu) * (1. - 2. * nu));
      const double wave_speed = std::sqrt(M / scene.law->density());
      const double transits   = parameters.protocol.ramp_fraction *
                              parameters.protocol.end_time * wave_speed /
                              (2. * parameters.geometry.height);
      audit.entries.push_back(
        {"wave transits of the chip during the load ramp",
         transits,
         "above 10 the chip is in equilibrium at every moment: quasi-static"});
      audit.inertia =
        transits >= 10. ? Inertia::quasi_static : Inertia::dynamic;

      const double v        = parameters.load.velocity;
      const double momentum = scene.law->density() * v * v;
      audit.entries.push_back({"rho v^2 over the pressure",
                               momentum / parameters.load.pressure,
                               "share of the load that the chip's momentum can "
                               "carry; far below 1 it does not count"});

      const double diffusivity = conductivity / (scene.law->density() * 450.);
      const double end_time =
        LoadProtocol(parameters.load, parameters.protocol).end_time();
      const double heat_length = std::sqrt(diffusivity * end_time);
      const double roughness =
        scene.tool_surface.maximum() - scene.tool_surface.minimum();
      audit.entries.push_back(
        {"heat length over peak-to-valley height",
         heat_length / roughness,
         "far below 1 no heat leaves the asperity contacts: adiabatic; near "
         "and above 1 adiabatic heating is an upper bound"});
      audit.entries.push_back({"sliding distance over the period",
                               v * end_time / scene.length,
                               "below about 0.05 the contact is still running "
                               "in, and mu depends on the distance"});
    }

    void
    audit_resolution(const SceneParameters &parameters,
                     const Scene           &scene,
                     SceneAudit            &audit)
    {
      const double slope = scene.tool_surface.largest_slope();
      audit.entries.push_back({"largest slope of the tool",
                               slope,
                               "a bound for mu without adhesion"});
      if (slope > 1.5)
        audit.warnings.push_back(
          "The tool is steeper than 1.5 somewhere; filter it or scale it.");
      const double penetration = parameters.load.pressure / scene.penalty();
      const double roughness =
        scene.tool_surface.maximum() - scene.tool_surface.minimum();
      audit.entries.push_back({"mean penetration over peak-to-valley height",
                               penetration / roughness,
                               "above 0.001 the penalty is too soft"});
      if (penetration > 1e-2 * roughness)
        audit.warnings.push_back(
          "The contact penalty is soft against the roughness; raise the "
          "penalty factor or use augmentations.");
      const double height = parameters.geometry.height / roughness;
      audit.entries.push_back(
        {"chip height over peak-to-valley height",
         height,
         "below about 3 the bottom of the chip feels the asperities"});
      if (height < 3.)
        audit.warnings.push_back(
          "The chip is only " + format_quantity(height, "1", 2) +
          " times as high as the tool is rough; its bottom feels the "
          "asperities.");
      const double elements =
        roughness / std::max(slope, 1e-12) / scene.contact_element_length();
      audit.entries.push_back(
        {"elements across the steepest asperity",
         elements,
         "below about 4 the mesh does not resolve the tool"});
      if (elements < 4.)
        audit.warnings.push_back(
          "The mesh has " + format_quantity(elements, "1", 2) +
          " elements across the steepest asperity and does not resolve the "
          "tool; raise the spans or filter the tool.");
    }

    /** Mean vertical distance of the surfaces at the start [m]. */
    double
    mean_gap(const Scene &scene)
    {
      constexpr unsigned int n   = 2000;
      double                 sum = 0.;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double x = scene.length * i / n;
          sum += scene.tool_surface.height(x) - scene.chip_surface.height(x);
        }
      return sum / n;
    }

    /** The rung that the numbers ask for. In a void that is not full, oil has
     *  to leave the gaps that close, and one pressure of a whole pocket knows
     *  nothing of the films that hold them open until it has
     *  (tools/benchmarks/README.md, "Thin oil"). */
    LubricantModel
    choose_lubricant(const double wetting,
                     const double flow_pressure,
                     const double squeeze_pressure)
    {
      if (wetting == 0.)
        return LubricantModel::none;
      const bool yields = wetting == 1. || squeeze_pressure < 0.001;
      return yields && flow_pressure < 0.01 ? LubricantModel::pocket :
                                              LubricantModel::reynolds;
    }

    void
    audit_lubricant(const SceneParameters &parameters,
                    const Scene           &scene,
                    SceneAudit            &audit)
    {
      const LubricationParameters &lubrication = parameters.lubrication;
      audit.lubricant                          = lubrication.model;
      if (lubrication.model == LubricantModel::none)
        return;
      const LubricantParameters &oil = lubrication.oil;
      const double p = parameters.load.pressure, v = parameters.load.velocity,
                   eta = oil.viscosity.viscosity, h = mean_gap(scene);
      const double height =
        scene.tool_surface.maximum() - scene.tool_surface.minimum();
      // Half the length of an asperity as steep as the steepest one.
      const double asperity = height / scene.tool_surface.largest_slope();

      audit.entries.push_back(
        {"compression of the oil at the load",
         1. - 1. / oil.compressibility.ratio(p),
         "how far the void must shrink until full pockets carry the load; "
         "above 0.01 an incompressible oil is too stiff a model"});
      const double flow_pressure = 12. * eta * v * asperity / (h * h * p);
      audit.entries.push_back(
        {"pressure differences by flow over the load",
         flow_pressure,
         "below 0.01 sliding leaves one pressure to the oil; else the film's "
         "own pressure counts"});
      const double ramp_time =
        LoadProtocol(parameters.load, parameters.protocol).ramp_time();
      const double squeeze_pressure =
        12. * eta * asperity * asperity / (h * h * ramp_time * p);
      audit.entries.push_back(
        {"squeeze pressure in closing gaps over the load",
         squeeze_pressure,
         "in a void that is not full; below 0.001 the oil gives way before "
         "the asperities touch; else it holds them apart"});
      audit.entries.push_back({"viscous shear over the load",
                               eta * v / (h * p),
                               "what the oil itself adds to mu"});
      audit.entries.push_back(
        {"reduced Reynolds number of the film",
         oil.density * v * h / eta * h / asperity,
         "far below 1 the oil has no inertia: Reynolds or Stokes"});
      if (lubrication.model == LubricantModel::automatic)
        audit.lubricant = choose_lubricant(lubrication.wetting,
                                           flow_pressure,
                                           squeeze_pressure);
      // Only its mass holds a chip whose balance and flow are solved in turn.
      if (fills_gap(audit.lubricant))
        audit.inertia = Inertia::dynamic;
    }

    /** What the reader and the treatment of measured surfaces complain of. */
    void
    audit_surface(const Surface     &surface,
                  const std::string &whose,
                  SceneAudit        &audit)
    {
      if (!surface.topography)
        return;
      for (const auto &list :
           {surface.topography->sanity.warnings, surface.topography->warnings})
        for (const std::string &warning : list)
          audit.warnings.push_back(whose + " surface: " + warning);
    }
  } // namespace



  SceneAudit
  audit_scene(const SceneParameters &parameters, const Scene &scene)
  {
    SceneAudit audit;
    audit_time_scales(parameters, scene, audit);
    audit_resolution(parameters, scene, audit);
    audit_lubricant(parameters, scene, audit);
    audit_surface(scene.tool_surface, "Tool", audit);
    audit_surface(scene.chip_surface, "Chip", audit);
    return audit;
  }
} // namespace asperity
