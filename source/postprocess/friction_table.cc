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
              {"oil pressure [Pa]", "oil pressure [MPa]", 1e-6},
              {"max oil pressure [Pa]", "max oil pressure [MPa]", 1e-6},
              {"oil T_x [N/m]", "oil T_x [N/mm]", 1e-3},
              {"shear T_x [N/m]", "shear T_x [N/mm]", 1e-3},
              {"shear T_y [N/m]", "shear T_y [N/mm]", 1e-3},
              {"void volume [m^2]", "void volume [um^2]", 1e12},
              {"oil volume [m^2]", "oil volume [um^2]", 1e12},
              {"oil reference volume [m^2]",
               "oil reference volume [um^2]",
               1e12},
              {"pockets [-]", "pockets [-]"},
              {"coupling iterations [-]", "coupling iterations [-]"},
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
    std::vector<double> values;
    for_each_entry(row, [&](const auto entry) { values.push_back(entry); });
    table.append(values);
  }
} // namespace asperity
