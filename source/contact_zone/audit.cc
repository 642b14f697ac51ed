#include <asperity/contact_zone/audit.h>
#include <asperity/contact_zone/load_protocol.h>

#include <algorithm>
#include <cmath>

#include "interface_audit.h"
#include "lubricant_audit.h"
#include "numerics_audit.h"
#include "surface_audit.h"

namespace asperity
{
  namespace
  {
    template <typename SurfaceType>
    double
    peak_to_valley(const SurfaceType &surface)
    {
      return surface.maximum() - surface.minimum();
    }

    /** Height and length of the asperities of the rougher surface [m]; both are
     *  zero between flat ones. */
    struct Asperities
    {
      double height = 0.;

      /** Half the length of an asperity as steep as the steepest one. */
      double length = 0.;
    };

    template <int dim>
    Asperities
    asperities_of(const Scene<dim> &scene)
    {
      const double tool   = peak_to_valley(scene.tool_surface),
                   chip   = peak_to_valley(scene.chip_surface);
      const double height = std::max(tool, chip);
      // What the splines of flat surfaces leave is round-off.
      if (height < 1e-9 * scene.length)
        return {};
      const SurfaceOf<dim> &rougher =
        tool >= chip ? scene.tool_surface : scene.chip_surface;
      return {height, height / rougher.largest_slope()};
    }

    /** In the direction in which they are fewest: ridges want short elements
     *  across them only. */
    template <int dim>
    double
    elements_across_steepest(const SceneParameters &parameters,
                             const Scene<dim>      &scene,
                             const Asperities      &asperities)
    {
      const auto  &mesh  = parameters.mesh;
      const double along = mesh.spans / scene.length;
      if constexpr (dim == 2)
        return asperities.length * along;
      else
        {
          const double across =
            mesh.n_spans_across(scene.length, scene.width) / scene.width;
          double steepest = 0.; // in heights an element
          for (const auto *surface : {&scene.tool_surface, &scene.chip_surface})
            steepest = std::max({steepest,
                                 surface->largest_slope(0) / along,
                                 surface->largest_slope(1) / across});
          return asperities.height / steepest;
        }
    }

    template <int dim>
    void
    audit_time_scales(const SceneParameters &parameters,
                      const Scene<dim>      &scene,
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
         "above 10 the chip is all but in equilibrium at every moment: "
         "quasi-static; its mass lets it sink in deeper while the load grows: "
         "R0 with 10, 21 and 42 has 4, 0.3 and 0 % more mu at 25 degC, 21, 2 and "
         "0.5 % at 675 degC"});
      // Measured on R0, tools/stability C23; oil that fills the gap damps.
      if (parameters.protocol.inertia == Inertia::dynamic && transits < 10. &&
          scene.gap_flow == nullptr)
        audit.warnings.push_back(
          "The load grows within " + format_quantity(transits, "1", 2) +
          " transits of a wave through the chip, which swings then: mu can be "
          "off by a third; raise Protocol/Ramp fraction to 10 transits, or "
          "leave the mass out (Protocol/Inertia = quasi-static).");
      // A chip that turns back at once has no inertia.
      audit.inertia =
        transits >= 10. || parameters.protocol.reversal_distance > 0. ?
          Inertia::quasi_static :
          Inertia::dynamic;

      const double v        = parameters.load.velocity;
      const double momentum = scene.law->density() * v * v;
      audit.entries.push_back({"rho v^2 over the pressure",
                               momentum / parameters.load.pressure,
                               "share of the load that the chip's momentum can "
                               "carry; far below 1 it does not count"});
    }

    /** How far heat and the chip get. */
    template <int dim>
    void
    audit_ways(const SceneParameters &parameters,
               const Scene<dim>      &scene,
               SceneAudit            &audit)
    {
      const double end_time =
        LoadProtocol(parameters.load, parameters.protocol).end_time();
      // The depth 2 sqrt(a t) at which a suddenly heated half-space has warmed
      // by erfc(1) = 16 % of its surface (Carslaw and Jaeger, Conduction of
      // Heat in Solids, 1959, section 2.4).
      audit.entries.push_back(
        {"heat length over peak-to-valley height",
         std::sqrt(4. * parameters.chip_thermal().diffusivity() * end_time) /
           asperities_of(scene).height,
         std::string(
           "far below 1 no heat leaves the asperity contacts: "
           "adiabatic; near and above 1 adiabatic heating is an upper "
           "bound") +
           (dim == 3 ? "" :
                       ", and Heat/Model = conducting tells what it errs, for "
                       "10 to 25 % more time")});
      audit.entries.push_back(
        {"sliding distance over the period",
         parameters.load.velocity * end_time / scene.period_of_motion(),
         "below about 0.05 the contact is still running "
         "in, and mu depends on the distance: the "
         "blasted tool of the examples has 0.044 after "
         "1 of its 40 um, 0.10 in steady sliding"});
    }

    /** Whether the chip's block is high enough not to matter. */
    void
    audit_height(const SceneParameters &parameters,
                 const Asperities      &asperities,
                 SceneAudit            &audit)
    {
      const double H      = parameters.geometry.height;
      const double height = H / asperities.height;
      audit.entries.push_back(
        {"chip height over peak-to-valley height",
         height,
         "below about 3 the bottom of the chip feels the asperities"});
      if (height < 3.)
        audit.warnings.push_back(
          "The chip is only " + format_quantity(height, "1", 2) +
          " times as high as the tool is rough; its bottom feels the "
          "asperities; raise Geometry/Chip height.");
      audit.entries.push_back(
        {"chip height over the length of an asperity",
         H / asperities.length,
         "below about 4 the floor of the chip stiffens the contacts: at 2.2 "
         "the blasted tool of the examples has 31 % more mu where the interface "
         "bears shear, 3 % without"});
      if (H < 4. * asperities.length)
        audit.warnings.push_back(
          "The chip is only " + format_quantity(H / asperities.length, "1", 2) +
          " times as high as its asperities are long (" +
          format_quantity(asperities.length, "um", 3) +
          "), so that its rigid floor raises mu; raise Geometry/Chip height to "
          "4 times.");
    }

    /** Whether mesh and time steps follow the surfaces. */
    template <int dim>
    void
    audit_resolution(const SceneParameters &parameters,
                     const Scene<dim>      &scene,
                     SceneAudit            &audit)
    {
      const Asperities asperities = asperities_of(scene);
      const double     slope      = scene.tool_surface.largest_slope();
      audit.entries.push_back({"largest slope of the tool",
                               slope,
                               "a bound for mu without adhesion"});
      if (slope > 1.5 && dim == 2) // of patches see audit_flanks()
        audit.warnings.push_back(
          "The tool is steeper than 1.5 somewhere; filter it or scale it.");
      const double penetration = parameters.load.pressure / scene.penalty();
      audit.entries.push_back({"mean penetration over peak-to-valley height",
                               penetration / asperities.height,
                               "above 0.001 the penalty is too soft"});
      if (asperities.height == 0.)
        return;
      // On R0 mu is 1.5 % too small at 3e-4, 11 % at 3e-3.
      if (penetration > 1e-3 * asperities.height &&
          parameters.contact.augmentations == 0)
        audit.warnings.push_back(
          "The contact penalty is soft against the roughness, so that mu is "
          "too small; raise the penalty factor or use augmentations.");
      audit_height(parameters, asperities, audit);
      const double elements =
        elements_across_steepest(parameters, scene, asperities);
      audit.entries.push_back(
        {"elements across the steepest asperity",
         elements,
         "below about 4 the mesh does not resolve the tool"});
      if (elements < 4.)
        audit.warnings.push_back(
          "The mesh has " + format_quantity(elements, "1", 2) +
          " elements across the steepest asperity and does not resolve the "
          "tool; raise the spans (Mesh/Spans, Spans across) or filter the tool.");
    }

    /** Whether the chip slides at all: the first way only turns the forces of
     * the load. Measured on R0 (300 MPa, 25 and 675 degC, 22.5 to 1000 m/min,
     * tools/stability C29): mu over the second half of a way of a ninetieth, a
     * thirtieth, a ninth and a third of an asperity is 90 to 97, 71 to 83, 33
     * to 47 and 8 to 12 % below that of four. */
    template <int dim>
    void
    audit_distance(const SceneParameters &parameters,
                   const Scene<dim>      &scene,
                   SceneAudit            &audit)
    {
      const double distance =
        parameters.load.velocity *
        LoadProtocol(parameters.load, parameters.protocol).end_time();
      const double length = asperities_of(scene).length;
      if (distance < 0.02 * length)
        audit.warnings.push_back(
          "The chip slides only " + format_quantity(distance, "nm", 3) +
          ", less than a fiftieth of the length of an asperity (" +
          format_quantity(length, "um", 3) +
          "): mu is that of the load yet, not of sliding; raise Protocol/Sliding "
          "distance or End time.");
      else if (distance < 0.25 * length)
        audit.warnings.push_back(
          "The chip slides only " + format_quantity(distance, "nm", 3) + ", " +
          format_quantity(distance / length, "1", 2) +
          " of the length of an asperity (" + format_quantity(length, "um", 3) +
          "): mu is that of running in, which is 33 to 47 % below that of "
          "sliding after a ninth of an asperity of R0, 8 to 12 % after a third; "
          "raise Protocol/Sliding distance or End time.");
    }

    /** Whether there are time steps enough for a mean over the way. */
    template <int dim>
    void
    audit_steps(const SceneParameters &parameters,
                const Scene<dim>      &scene,
                SceneAudit            &audit)
    {
      const ProtocolParameters &protocol = parameters.protocol;
      const LoadProtocol        course(parameters.load, protocol);
      const double              ramp   = course.ramp_time();
      const double              step   = course.next_time(ramp) - ramp;
      const double              length = asperities_of(scene).length;
      if (!(step > 0.))
        return;
      const double steps = length / (parameters.load.velocity * step);
      audit.entries.push_back({"time steps across the steepest asperity",
                               steps,
                               "below about 4 asperities are jumped over"});
      if (length > 0. && steps < 4.)
        audit.warnings.push_back(
          "The chip slides over the steepest asperity in " +
          format_quantity(steps, "1", 2) +
          " time steps, and mu depends on them; raise Protocol/Slide steps, or "
          "lower Protocol/Steady step.");
      if (protocol.window == FrictionWindow::time &&
          protocol.window_fraction * course.end_time() < 2. * step)
        audit.warnings.push_back(
          "The window of mu is shorter than two time steps; raise "
          "Protocol/Window fraction or Slide steps.");
    }

    /** Waves that the mesh does not follow, of either surface. */
    void
    audit_waves(const SceneParameters &parameters,
                const Scene<2>        &scene,
                SceneAudit            &audit)
    {
      if (parameters.tool.kind == SurfaceKind::harmonics)
        {
          const unsigned int k = parameters.tool.highest_wave_number();
          const double       elements =
            static_cast<double>(parameters.mesh.spans) / k;
          if (elements < 6.)
            audit.warnings.push_back(
              "The shortest wave of the tool, number " + std::to_string(k) +
              " of a period, has " + format_quantity(elements, "1", 2) +
              " elements of the chip's edge, which cannot follow it; raise "
              "Mesh/Spans or leave the wave out.");
        }
      if (parameters.chip.kind == SurfaceKind::flat)
        return;
      double      missed = 0.;
      const auto &edge   = scene.contact->table();
      for (const auto &position : edge.position)
        missed = std::max(missed,
                          std::abs(position[1] -
                                   scene.chip_surface.height(position[0])));
      const double share = missed / peak_to_valley(scene.chip_surface);
      audit.entries.push_back(
        {"height of the chip that its mesh misses",
         share,
         "over its peak-to-valley height; above 0.05 the mesh does not hold "
         "the chip's surface"});
      if (share > 0.05)
        audit.warnings.push_back(
          "The mesh misses the chip's surface by up to " +
          format_quantity(missed, "nm", 3) + ", " +
          format_quantity(100. * share, "1", 2) +
          " % of its height; raise the spans (Mesh/Spans) or filter the chip.");
    }
  } // namespace



  namespace
  {
    /** What is asked of profiles and of patches. */
    template <int dim>
    SceneAudit
    audit_motion(const SceneParameters &parameters, const Scene<dim> &scene)
    {
      SceneAudit audit;
      audit_time_scales(parameters, scene, audit);
      audit_ways(parameters, scene, audit);
      audit_resolution(parameters, scene, audit);
      audit_numerics(parameters, scene, audit);
      audit_distance(parameters, scene, audit);
      audit_steps(parameters, scene, audit);
      return audit;
    }
  } // namespace



  SceneAudit
  audit_scene(const SceneParameters &parameters, const Scene<2> &scene)
  {
    SceneAudit audit = audit_motion(parameters, scene);
    audit_waves(parameters, scene, audit);
    audit_lubricant(parameters,
                    scene.oil,
                    scene.tool_surface.mean() - scene.chip_surface.mean(),
                    asperities_of(scene).length,
                    audit);
    audit_interface(parameters, audit);
    const bool is_sheared = parameters.interface.law != InterfaceShear::none;
    audit_surface(
      parameters.tool, scene.tool_surface, "Tool", is_sheared, audit);
    audit_surface(
      parameters.chip, scene.chip_surface, "Chip", is_sheared, audit);
    return audit;
  }



  SceneAudit
  audit_scene(const SceneParameters &parameters, const Scene<3> &scene)
  {
    SceneAudit audit = audit_motion(parameters, scene);
    audit_lubricant(parameters,
                    scene.oil,
                    scene.tool_surface.sheet.mean() -
                      scene.chip_surface.sheet.mean(),
                    asperities_of(scene).length,
                    audit);
    audit_interface(parameters, audit);
    audit_flanks(scene.tool_surface, "Tool", audit);
    audit_flanks(scene.chip_surface, "Chip", audit);
    if (scene.tool_surface.topography)
      audit_treatment(parameters.tool.topography,
                      *scene.tool_surface.topography,
                      "Tool",
                      audit);
    return audit;
  }
} // namespace asperity
