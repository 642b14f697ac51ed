#include <asperity/contact_zone/unused_entries.h>

#include <cmath>

#include "entry_conditions.h"

namespace asperity
{
  namespace
  {
    bool
    yields(const SceneParameters &p)
    {
      return std::isfinite(p.material.make_law()->shear_limit(0., 0., 0.));
    }

    bool
    conducts(const SceneParameters &p)
    {
      return p.heat_model() == HeatModel::conducting;
    }

    EntryConditions
    conditions_of_interface()
    {
      return {{{"Interface/Friction coefficient"},
               "the Shear laws Coulomb and limited Coulomb",
               [](const SceneParameters &p) {
                 return p.interface.law == InterfaceShear::coulomb ||
                        p.interface.law == InterfaceShear::limited_coulomb;
               }},
              {{"Interface/Shear factor",
                "Interface/Wet shear factor",
                "Interface/Shear layer"},
               "a Shear law with a shear factor",
               [](const SceneParameters &p) {
                 return p.interface.uses_shear_strength();
               }},
              {{"Interface/Wet shear factor"},
               "a lubricant",
               [](const SceneParameters &p) {
                 return p.lubrication.model != LubricantModel::none;
               }},
              {{"Interface/Stick penalty"},
               "a Shear law",
               [](const SceneParameters &p) {
                 return p.interface.law != InterfaceShear::none;
               }},
              {{"Interface/Contact transition"},
               "the Shear laws shear factor and limited Coulomb",
               [](const SceneParameters &p) {
                 return p.interface.law == InterfaceShear::shear_factor ||
                        p.interface.law == InterfaceShear::limited_coulomb;
               }}};
    }

    EntryConditions
    conditions_of_heat()
    {
      return {
        {{"Material/Adiabatic heating", "Material/Heat fraction"},
         "a Law of plasticity",
         yields},
        {{"Material/Heat capacity"},
         "a Law of plasticity, or the Heat model conducting",
         [](const SceneParameters &p) { return yields(p) || conducts(p); }},
        {{"Material/Heat capacity", "Material/Heat fraction"},
         "Adiabatic heating",
         [](const SceneParameters &p) { return p.material.heating.adiabatic; }},
        {{"Material/Adiabatic heating",
          "Material/Heat capacity",
          "Material/Heat fraction"},
         "a Heat model in which the chip warms",
         [](const SceneParameters &p) {
           return p.heat.model != HeatModel::isothermal;
         }},
        {{"Heat/Chip conductivity",
          "Heat/Tool conductivity",
          "Heat/Tool density",
          "Heat/Tool heat capacity",
          "Heat/Tool temperature",
          "Heat/Contact conductance"},
         "the Heat model conducting",
         conducts},
        {{"Heat/Oil conductivity"},
         "the Heat model conducting and a lubricant",
         [](const SceneParameters &p) {
           return conducts(p) && p.lubrication.model != LubricantModel::none;
         }}};
    }

    EntryConditions
    conditions_of_chip()
    {
      EntryConditions conditions = {
        {{"Geometry/Period"},
         "a tool that is not measured",
         [](const SceneParameters &p) {
           return p.tool.kind != SurfaceKind::measured;
         }},
        {{"Geometry/Width", "Mesh/Spans across", "Load/Sliding direction"},
         "Geometry/Dimension = 3",
         [](const SceneParameters &p) { return p.geometry.dimension == 3; }},
        {{"Mesh/Strip depth"},
         "Refinement levels",
         [](const SceneParameters &p) { return p.mesh.refinement > 0; }},
        {{"Mesh/Remesh distance",
          "Mesh/Adaptive halo",
          "Mesh/Maximum unknowns"},
         "Adaptive levels",
         [](const SceneParameters &p) { return p.mesh.adaptive_levels > 0; }},
        {{"Output/Checkpoint interval"},
         "a mesh without Adaptive levels",
         [](const SceneParameters &p) { return p.mesh.adaptive_levels == 0; }},
        {{"Load/Plastic strain"}, "a Law of plasticity", yields},
        {{"Load/Temperature"},
         "a Law of the chip that softens or heats itself, or a Temperature law "
         "of the oil",
         [](const SceneParameters &p) {
           return p.material.softening() || p.material.heats_itself() ||
                  conducts(p) ||
                  (p.lubrication.model != LubricantModel::none &&
                   p.lubrication.oil.temperature.law != TemperatureLaw::none);
         }},
        {{"Contact/Penalty factor"},
         "an automatic Penalty",
         [](const SceneParameters &p) { return !p.contact.penalty; }},
        {{"Contact/Penetration tolerance"},
         "Augmentations",
         [](const SceneParameters &p) { return p.contact.augmentations > 0; }}};
      for (const std::string &name : MaterialParameters::law_names())
        conditions.push_back({{"Material/" + name + "/"},
                              "the Law " + name,
                              [=](const SceneParameters &p) {
                                return p.material.make_law()->name() == name;
                              }});
      return conditions;
    }

    EntryConditions
    conditions_of_run()
    {
      const auto window = [](const FrictionWindow window) {
        return
          [=](const SceneParameters &p) { return p.protocol.window == window; };
      };
      return {
        {{"Protocol/End time"},
         "an automatic Sliding distance",
         [](const SceneParameters &p) { return !p.protocol.sliding_distance; }},
        {{"Accuracy/Error"},
         "the Control estimate or adaptive",
         [](const SceneParameters &p) {
           return p.accuracy.control != AccuracyControl::off;
         }},
        {{"Accuracy/Maximum unknowns"},
         "the Control adaptive",
         [](const SceneParameters &p) { return p.accuracy.is_adaptive(); }},
        {{"Protocol/Spectral radius"},
         "the Inertia dynamic",
         [](const SceneParameters &p) {
           return p.protocol.inertia != Inertia::quasi_static;
         }},
        {{"Protocol/Window fraction", "Protocol/Slide steps"},
         "the Friction window time",
         window(FrictionWindow::time)},
        {{"Protocol/Steady distance",
          "Protocol/Steady step",
          "Protocol/Steady tolerance",
          "Protocol/Maximum distance"},
         "the Friction window steady",
         window(FrictionWindow::steady)},
        {{"Solver/Linear solver"},
         "a symmetric tangent, which the lubricant model Reynolds has "
         "not: LU in the same order stands in for cholmod",
         [](const SceneParameters &p) {
           return p.lubrication.model != LubricantModel::reynolds ||
                  (p.solver.linear_solver != LinearSolverKind::cholmod &&
                   p.solver.linear_solver != LinearSolverKind::automatic);
         }}};
    }

    const EntryConditions &
    all_conditions()
    {
      static const EntryConditions conditions = []() {
        EntryConditions all;
        for (const auto &list :
             {conditions_of_surface("Tool", &SceneParameters::tool),
              conditions_of_surface("Chip surface", &SceneParameters::chip),
              conditions_of_chip(),
              conditions_of_heat(),
              conditions_of_interface(),
              conditions_of_run(),
              conditions_of_oil()})
          all.insert(all.end(), list.begin(), list.end());
        return all;
      }();
      return conditions;
    }

    bool
    is_about(const EntryCondition &condition, const std::string &path)
    {
      for (const std::string &entry : condition.entries)
        if (entry == path ||
            (entry.back() == '/' && path.compare(0, entry.size(), entry) == 0))
          return true;
      return false;
    }
  } // namespace



  std::vector<UnusedEntry>
  unused_entries(const SceneParameters     &parameters,
                 const ParameterDeclarator &declarator)
  {
    std::vector<UnusedEntry> unused;
    for (const ParameterEntry &entry : declarator.entries())
      if (entry.given)
        for (const EntryCondition &condition : all_conditions())
          if (is_about(condition, entry.path()) && !condition.holds(parameters))
            {
              unused.push_back({entry.path(), condition.counts_with});
              break;
            }
    return unused;
  }
} // namespace asperity
