#include <asperity/postprocess/friction_table.h>

namespace asperity
{
  namespace
  {
    std::vector<TableColumn>
    friction_columns()
    {
      return {{"step", "step"},
              {"time [s]", "time [us]", 1e6},
              {"sliding distance [m]", "sliding distance [um]", 1e6},
              {"T_x [N/m]", "T_x [N/mm]", 1e-3},
              {"T_y [N/m]", "T_y [N/mm]", 1e-3},
              {"mu [-]", "mu [-]"},
              {"contact fraction [-]", "contact fraction [-]"},
              {"max contact pressure [Pa]", "max contact pressure [MPa]", 1e-6},
              {"max plastic strain [-]", "max plastic strain [-]"},
              {"max temperature [K]", "max temperature [degC]", 1., -273.15},
              {"mean gap [m]", "mean gap [um]", 1e6},
              {"max penetration [m]", "max penetration [um]", 1e6},
              {"newton iterations [-]", "newton iterations [-]"},
              {"factorisations [-]", "factorisations [-]"},
              {"wall time [s]", "wall time [s]"}};
    }

    Table
    open(const std::string &directory, const double keep_until)
    {
      return Table(directory + "/friction.csv",
                   friction_columns(),
                   directory + "/friction_units.csv",
                   keep_until);
    }
  } // namespace



  FrictionTable::FrictionTable(const std::string &directory)
    : table(open(directory, Table::keep_nothing))
  {}



  FrictionTable::FrictionTable(const std::string &directory,
                               const unsigned int step)
    : table(open(directory, step))
  {}



  void
  FrictionTable::append(const FrictionRow &row)
  {
    table.append({static_cast<double>(row.step),
                  row.time,
                  row.sliding_distance,
                  row.T_x,
                  row.T_y,
                  row.mu,
                  row.contact_fraction,
                  row.max_contact_pressure,
                  row.max_plastic_strain,
                  row.max_temperature,
                  row.mean_gap,
                  row.max_penetration,
                  static_cast<double>(row.newton_iterations),
                  static_cast<double>(row.factorisations),
                  row.wall_time});
  }
} // namespace asperity
