#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/contact_zone/scene_report.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <map>

namespace asperity
{
  namespace
  {
    /** What was made of the file of a measured surface. */
    void
    print_map(const TopographyReport &report)
    {
      std::cout << "  " << report.sanity.format << ", " << report.sanity.nx
                << " x " << report.sanity.ny << " points, "
                << format_quantity(report.sanity.length_x, "um", 4) << " x "
                << format_quantity(report.sanity.length_y, "um", 4) << "\n";
      for (const std::string &step : report.steps)
        std::cout << "  " << step << "\n";
    }

    void
    print_treatment(const SheetSurface &surface)
    {
      if (surface.topography)
        print_map(*surface.topography);
    }

    void
    print_treatment(const Surface &surface)
    {
      if (!surface.topography)
        return;
      print_map(*surface.topography);
      const ProfileRoughness &roughness = surface.topography->profile_roughness;
      std::cout << "  Finished profile: Rq "
                << format_quantity(roughness.Rq, "um", 3) << ", Rz "
                << format_quantity(roughness.Rz, "um", 3)
                << ", root mean square slope "
                << format_quantity(roughness.Rdq, "1", 3) << "; spline within "
                << format_quantity(surface.fit_rms, "nm", 2) << " rms\n";
    }
  } // namespace



  template <int dim>
  void
  print_scene(const Scene<dim> &scene,
              const SceneAudit &audit,
              const HeatModel   heat,
              const bool        explain)
  {
    std::cout << "Tool: " << scene.tool_surface.description << ", period "
              << format_quantity(scene.length, "um", 4)
              << (dim == 3 ? " x " + format_quantity(scene.width, "um", 4) : "")
              << ", peak to valley "
              << format_quantity(scene.tool_surface.maximum() -
                                   scene.tool_surface.minimum(),
                                 "um",
                                 3)
              << "\n";
    if constexpr (dim == 3)
      if (scene.motion[0] != 1.)
        std::cout << "Slides at "
                  << format_quantity(
                       std::atan2(scene.motion[1], scene.motion[0]), "deg", 4)
                  << " to x\n";
    if (explain)
      print_treatment(scene.tool_surface);
    std::cout << "Chip: " << scene.chip_surface.description << ", "
              << scene.law->name() << ", degree " << scene.space->degree()
              << ", " << scene.space->n_cells() << " elements, "
              << scene.n_unknowns() << " unknowns, penalty "
              << format_quantity(scene.penalty(), "Pa/m", 3) << "\n";
    if (explain)
      print_treatment(scene.chip_surface);
    if (audit.lubricant != LubricantModel::none)
      std::cout << "Oil: " << format_quantity(scene.oil.thickness, "nm", 4)
                << " over the period, "
                << format_quantity(100. * scene.oil.part_at_start, "1", 3)
                << " % of the void at the start\n";
    std::cout << "Scene audit:\n";
    for (const AuditEntry &entry : audit.entries)
      {
        std::cout << "  " << std::left << std::setw(48) << entry.name
                  << (std::isfinite(entry.value) ?
                        format_quantity(entry.value, "1", 3) :
                        "undefined")
                  << "\n";
        if (explain)
          std::cout << "      " << entry.meaning << "\n";
      }
    std::cout << "Models: "
              << (audit.lubricant == LubricantModel::none ?
                    "dry" :
                    "oil by " + name(audit.lubricant))
              << ", "
              << (audit.inertia == Inertia::dynamic ? "dynamic" :
                                                      "quasi-static")
              << ", " << name(heat) << "\n";
  }



  std::string
  name_of_solver(const LinearSolverKind kind)
  {
    switch (kind)
      {
        case LinearSolverKind::cholmod:
          return "cholmod";
        case LinearSolverKind::supernodal_lu:
          return "LU in the order of cholmod";
        case LinearSolverKind::umfpack:
          return "umfpack";
        case LinearSolverKind::klu:
          return "klu";
        case LinearSolverKind::krylov:
          return "krylov";
        default:
          return "mumps";
      }
  }



  template <int dim>
  void
  print_ranks(const Scene<dim> &scene)
  {
    if (dim == 2)
      return;
    std::cout << "Linear solver: " << name_of_solver(scene.linear_solver());
    const unsigned int n = scene.share().ranks.size();
    if (n > 1)
      std::cout << ", on " << n << " ranks, of which one has "
                << format_quantity(100. * (scene.imbalance() - 1.), "1", 2)
                << " % more work than the mean";
    std::cout << "\n";
  }



  void
  print_unused(const std::vector<UnusedEntry> &entries)
  {
    std::map<std::string, std::vector<std::string>> by_condition;
    for (const UnusedEntry &entry : entries)
      by_condition[entry.counts_with].push_back(entry.path);
    for (const auto &[counts_with, paths] : by_condition)
      std::cout << "Not used here: " << join(paths, ", ") << " (only with "
                << counts_with << ").\n";
  }



  void
  print_warnings(const std::vector<std::string> &warnings)
  {
    for (const std::string &warning : warnings)
      std::cout << "Warning: " << warning << "\n";
  }



  template <int dim>
  void
  print_result(const SlidingRun<dim>              &run,
               const SceneParameters              &parameters,
               const std::optional<ErrorEstimate> &error,
               const double                        seconds)
  {
    const FrictionResult friction = run.friction();
    std::cout << std::setprecision(4) << "mu = " << friction.mu << " +- "
              << friction.spread << " (spread over time)";
    if (error)
      std::cout << " +- " << std::setprecision(2)
                << error->total() * std::abs(friction.mu) << " (numerics: mesh "
                << 100. * std::abs(error->mesh) << " %, steps "
                << 100. * std::abs(error->step) << " %, penalty "
                << 100. * std::abs(error->penalty)
                << " %); corrected for these " << std::setprecision(4)
                << error->corrected(friction.mu) << " +- "
                << std::setprecision(2)
                << error->uncertainty() * std::abs(friction.mu)
                << std::setprecision(4);
    std::cout << ", at the end " << friction.mu_end << ", contact fraction "
              << friction.contact_fraction << "\n";
    if (parameters.interface.law != InterfaceShear::none)
      std::cout << "of it " << friction.ploughing << " by ploughing, "
                << friction.interface_shear << " by shear of the interface, "
                << friction.oil_shear << " by shear of the oil\n";
    if (friction.oil_pressure > 0.)
      std::cout << "oil at " << format_quantity(friction.oil_pressure, "MPa", 4)
                << " carries "
                << format_quantity(100. * friction.oil_pressure * run.period() /
                                     std::abs(friction.T_y),
                                   "1",
                                   3)
                << " % of the load\n";
    const FrictionRow &last = run.state().rows.back();
    const double       heat = last.plastic_heat + last.friction_heat;
    if (heat > 0.)
      std::cout << "of " << format_quantity(1e3 * heat, "1", 3)
                << " mJ/m of heat "
                << format_quantity(100. * last.tool_heat / heat, "1", 3)
                << " % have gone into the tool; the interface is at up to "
                << format_quantity(last.flash_temperature, "degC", 4) << "\n";
    std::cout << run.state().step << " steps, "
              << run.newton_statistics().iterations << " Newton iterations, "
              << std::setprecision(3) << seconds << " s; results in "
              << parameters.output.directory << "\n";
  }



  template void
  print_scene(const Scene<2> &,
              const SceneAudit &,
              const HeatModel,
              const bool);
  template void
  print_scene(const Scene<3> &,
              const SceneAudit &,
              const HeatModel,
              const bool);
  template void
  print_ranks(const Scene<2> &);
  template void
  print_ranks(const Scene<3> &);
  template void
  print_result(const SlidingRun<2> &,
               const SceneParameters &,
               const std::optional<ErrorEstimate> &,
               const double);
  template void
  print_result(const SlidingRun<3> &,
               const SceneParameters &,
               const std::optional<ErrorEstimate> &,
               const double);
} // namespace asperity
