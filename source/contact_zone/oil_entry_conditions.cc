#include <asperity/contact_zone/unused_entries.h>

#include <initializer_list>

#include "entry_conditions.h"

namespace asperity
{
  namespace
  {
    const std::string oil  = "Lubricant/";
    const std::string heat = "Lubricant/Temperature/";

    // What conditions are called.
    const std::string any     = "a lubricant model other than none";
    const std::string volume  = "the lubricant models pocket and Reynolds, and "
                                "a Compressible flow";
    const std::string viscous = "the lubricant models with flow";
    const std::string flooding = "the lubricant models Stokes and "
                                 "Navier-Stokes";

    bool
    is_one_of(const SceneParameters                      &p,
              const std::initializer_list<LubricantModel> models)
    {
      const LubricantModel model = p.lubrication.model;
      if (model == LubricantModel::automatic)
        return true;
      for (const LubricantModel candidate : models)
        if (model == candidate)
          return true;
      return false;
    }

    bool
    has_oil(const SceneParameters &p)
    {
      return p.lubrication.model != LubricantModel::none;
    }

    bool
    is_compressible(const SceneParameters &p)
    {
      return is_one_of(p, {LubricantModel::pocket, LubricantModel::reynolds}) ||
             (has_oil(p) && p.lubrication.flow.compressible);
    }

    bool
    shears(const SceneParameters &p)
    {
      return has_oil(p) && p.lubrication.model != LubricantModel::pocket;
    }

    bool
    fills(const SceneParameters &p)
    {
      return is_one_of(p,
                       {LubricantModel::stokes, LubricantModel::navier_stokes});
    }

    EntryConditions
    conditions_of_amount()
    {
      const auto by_film = [](const SceneParameters &p) {
        return p.lubrication.amount == OilAmount::film_thickness;
      };
      return {{{"Lubrication/Oil amount",
                "Lubrication/Wetting",
                "Lubrication/Oil film",
                "Lubrication/Sealing gap",
                "Lubrication/Pockets",
                "Lubrication/Residual film",
                oil},
               any,
               has_oil},
              {{"Lubrication/Wetting"},
               "an Oil amount that is a part of the void",
               [=](const SceneParameters &p) { return !by_film(p); }},
              {{"Lubrication/Oil film"},
               "the Oil amount film thickness",
               by_film},
              {{"Lubrication/Sealing gap"},
               "the lubricant models pocket, Stokes and Navier-Stokes",
               [](const SceneParameters &p) {
                 return is_one_of(p, {LubricantModel::pocket}) || fills(p);
               }},
              {{"Lubrication/Pockets"},
               "the lubricant models Stokes and Navier-Stokes with a Sealing "
               "gap",
               [](const SceneParameters &p) {
                 return fills(p) && p.lubrication.sealing_gap > 0.;
               }},
              {{"Lubrication/Residual film"}, viscous, shears},
              {{"Lubrication/Residual film"},
               "a Sealing gap of 0 in the models Stokes and Navier-Stokes",
               [](const SceneParameters &p) {
                 return !fills(p) || p.lubrication.sealing_gap == 0.;
               }}};
    }

    EntryConditions
    conditions_of_density()
    {
      const auto law = [](const SceneParameters &p, const DensityLaw law) {
        return p.lubrication.oil.compressibility.law == law;
      };
      const auto has_modulus = [law](const SceneParameters &p) {
        return law(p, DensityLaw::murnaghan) ||
               law(p, DensityLaw::constant_modulus);
      };
      return {{{oil + "Density"},
               "the lubricant model Navier-Stokes",
               [](const SceneParameters &p) {
                 return is_one_of(p, {LubricantModel::navier_stokes});
               }},
              {{oil + "Density law",
                oil + "Bulk modulus",
                oil + "Bulk modulus slope",
                heat + "Bulk modulus decay"},
               volume,
               is_compressible},
              {{oil + "Bulk modulus", heat + "Bulk modulus decay"},
               "the Density laws Murnaghan and constant modulus",
               has_modulus},
              {{oil + "Bulk modulus slope"},
               "the Density law Murnaghan",
               [=](const SceneParameters &p) {
                 return law(p, DensityLaw::murnaghan);
               }}};
    }

    EntryConditions
    conditions_of_viscosity()
    {
      const auto viscosity = [](const SceneParameters &p) {
        return p.lubrication.oil.viscosity;
      };
      return {{{oil + "Viscosity",
                oil + "Shear law",
                oil + "Carreau/",
                oil + "Pressure law",
                oil + "Pressure coefficient",
                oil + "Roelands exponent",
                oil + "Stress limit",
                oil + "Limiting stress",
                oil + "Limiting stress slope",
                heat + "Roelands slope",
                heat + "Vogel constant",
                heat + "Vogel temperature"},
               viscous,
               shears},
              {{oil + "Carreau/"},
               "the Shear law Carreau",
               [=](const SceneParameters &p) {
                 return viscosity(p).shear_law == ShearLaw::carreau;
               }},
              {{oil + "Pressure coefficient"},
               "the Pressure law Barus",
               [=](const SceneParameters &p) {
                 return viscosity(p).pressure_law == PressureLaw::barus;
               }},
              {{oil + "Roelands exponent"},
               "the Pressure law Roelands",
               [=](const SceneParameters &p) {
                 return viscosity(p).pressure_law == PressureLaw::roelands;
               }}};
    }

    EntryConditions
    conditions_of_temperature()
    {
      const auto temperature = [](const SceneParameters &p) {
        return p.lubrication.oil.temperature.law;
      };
      return {{{heat},
               "a Temperature law of the oil",
               [=](const SceneParameters &p) {
                 return temperature(p) != TemperatureLaw::none;
               }},
              {{heat + "Roelands slope"},
               "the Temperature law Roelands",
               [=](const SceneParameters &p) {
                 return temperature(p) == TemperatureLaw::roelands;
               }},
              {{heat + "Vogel constant", heat + "Vogel temperature"},
               "the Temperature law Vogel",
               [=](const SceneParameters &p) {
                 return temperature(p) == TemperatureLaw::vogel;
               }},
              {{heat + "Thermal expansion"},
               "the lubricant models pocket, Reynolds and Navier-Stokes, and a "
               "Compressible flow",
               [](const SceneParameters &p) {
                 return is_compressible(p) ||
                        is_one_of(p, {LubricantModel::navier_stokes});
               }}};
    }

    EntryConditions
    conditions_of_flow()
    {
      return {{{"Film mesh/", "Flow/", "Coupling/"}, flooding, fills},
              {{"Flow/Stiffening"},
               "the Mesh update elastic",
               [](const SceneParameters &p) {
                 return p.lubrication.flow.mesh_update ==
                        MeshUpdateKind::elastic;
               }},
              {{"Flow/Pressure left"},
               "an open left end",
               [](const SceneParameters &p) {
                 return p.lubrication.flow.left.kind != GapEndKind::periodic;
               }},
              {{"Flow/Pressure right"},
               "an open right end",
               [](const SceneParameters &p) {
                 return p.lubrication.flow.right.kind != GapEndKind::periodic;
               }},
              {{"Flow/Resistance left"},
               "the Boundary left resistance",
               [](const SceneParameters &p) {
                 return p.lubrication.flow.left.kind == GapEndKind::resistance;
               }},
              {{"Flow/Resistance right"},
               "the Boundary right resistance",
               [](const SceneParameters &p) {
                 return p.lubrication.flow.right.kind == GapEndKind::resistance;
               }},
              {{"Coupling/Robin coefficient"},
               "the Scheme Robin-Neumann",
               [](const SceneParameters &p) {
                 return p.lubrication.coupling.scheme ==
                        CouplingScheme::robin_neumann;
               }},
              {{"Coupling/Reused steps", "Coupling/Filter"},
               "the Acceleration IQN-ILS",
               [](const SceneParameters &p) {
                 return p.lubrication.coupling.acceleration.kind ==
                        AccelerationKind::iqn_ils;
               }}};
    }

  } // namespace



  EntryConditions
  conditions_of_oil()
  {
    EntryConditions all;
    for (const EntryConditions &list : {conditions_of_amount(),
                                        conditions_of_density(),
                                        conditions_of_viscosity(),
                                        conditions_of_temperature(),
                                        conditions_of_flow()})
      all.insert(all.end(), list.begin(), list.end());
    return all;
  }
} // namespace asperity
