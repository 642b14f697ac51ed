#include <asperity/postprocess/friction_table.h>


namespace asperity
{
  namespace
  {
    using Row = FrictionRow;

    const ResultUnit order, number{"-", "-"}, seconds{"s", "us", 1e6},
      wall{"s", "s"}, length{"m", "um", 1e6}, line_load{"N/m", "N/mm", 1e-3},
      pressure{"Pa", "MPa", 1e-6}, temperature{"K", "degC", 1., -273.15},
      volume{"m^2", "um^2", 1e12}, heat{"J/m", "mJ/mm"};

    const std::vector<FrictionColumn> columns = {
      {"step", order, "Number of the time step.", &Row::step, ""},
      {"time", seconds, "At the end of the step.", &Row::time, "/end/time"},
      {"sliding distance",
       length,
       "Way of the bottom of the chip; falls where it slides back.",
       &Row::sliding_distance,
       "/end/sliding_distance"},
      {"T_x",
       line_load,
       "Force on the chip along x (of a patch along Load/Sliding direction), of "
       "contact and oil.",
       &Row::T_x,
       ""},
      {"T_y",
       line_load,
       "Force on the chip along y (in three dimensions z, to the tool), of "
       "contact and oil; negative presses.",
       &Row::T_y,
       ""},
      {"mu",
       number,
       "Force against the motion over the load; negative where the tool pushes "
       "the chip along its way, 0 as long as nothing is loaded.",
       &Row::mu,
       ""},
      {"ploughing",
       number,
       "Part of mu by the pressures of contact and oil, which act on slopes.",
       &Row::ploughing,
       ""},
      {"interface shear",
       number,
       "Part of mu by the shear of the contact.",
       &Row::interface_shear,
       ""},
      {"oil shear",
       number,
       "Part of mu by the shear of the oil.",
       &Row::oil_shear,
       ""},
      {"interface T_x",
       line_load,
       "Part of T_x by the shear of the contact.",
       &Row::interface_T_x,
       ""},
      {"interface T_y",
       line_load,
       "Part of T_y by the shear of the contact.",
       &Row::interface_T_y,
       ""},
      {"sticking",
       number,
       "Part of the contact's shear that sticks.",
       &Row::sticking,
       ""},
      {"contact fraction",
       number,
       "Part of the chip's surface, as it was at the start, in contact.",
       &Row::contact_fraction,
       ""},
      {"touching length",
       length,
       "Present length of what is in contact; in three dimensions its area over "
       "the width.",
       &Row::touching_length,
       "/end/touching_length"},
      {"max contact pressure",
       pressure,
       "Largest pressure of the contact, per present length (area).",
       &Row::max_contact_pressure,
       "/end/max_contact_pressure"},
      {"real contact pressure",
       pressure,
       "Mean pressure of the part in contact, over its present length (area).",
       &Row::real_contact_pressure,
       "/end/real_contact_pressure"},
      {"max plastic strain",
       number,
       "Largest equivalent plastic strain of the chip.",
       &Row::max_plastic_strain,
       "/end/max_plastic_strain"},
      {"max temperature",
       temperature,
       "Largest temperature of the chip.",
       &Row::max_temperature,
       "/end/max_temperature"},
      {"flash temperature",
       temperature,
       "Highest temperature of the interface: of tool and chip where heat is "
       "conducted, else of the top of the chip.",
       &Row::flash_temperature,
       "/end/flash_temperature"},
      {"plastic heat",
       heat,
       "Heat of the plastic work since the start; this and the following are "
       "0 unless heat is conducted.",
       &Row::plastic_heat,
       "/heat/end/plastic"},
      {"friction heat",
       heat,
       "Heat of the interface since the start.",
       &Row::friction_heat,
       "/heat/end/friction"},
      {"stored heat",
       heat,
       "Heat in the chip that is modelled beyond that of the start.",
       &Row::stored_heat,
       "/heat/end/stored"},
      {"depth heat",
       heat,
       "Heat that has gone into the chip below.",
       &Row::depth_heat,
       "/heat/end/depth"},
      {"tool heat",
       heat,
       "Heat that has gone into the tool.",
       &Row::tool_heat,
       "/heat/end/tool"},
      {"heat balance error",
       number,
       "Of the step: what its plastic and friction heat differ from what was "
       "stored and given on, over the sum of all five.",
       &Row::heat_balance_error,
       ""},
      {"mean gap",
       length,
       "Mean distance of the surfaces; penetration counts as none.",
       &Row::mean_gap,
       ""},
      {"max penetration",
       length,
       "Largest penetration that the penalty allows.",
       &Row::max_penetration,
       "/end/max_penetration"},
      {"oil pressure",
       pressure,
       "Vertical force of the oil's pressure over the period.",
       &Row::oil_pressure,
       "/oil/end/pressure"},
      {"max oil pressure",
       pressure,
       "Largest pressure of the oil.",
       &Row::max_oil_pressure,
       "/oil/end/max_pressure"},
      {"oil T_x",
       line_load,
       "Part of T_x by the oil's pressure.",
       &Row::oil_T_x,
       ""},
      {"shear T_x",
       line_load,
       "Part of T_x by the oil's shear.",
       &Row::shear_T_x,
       ""},
      {"shear T_y",
       line_load,
       "Part of T_y by the oil's shear.",
       &Row::shear_T_y,
       ""},
      {"void volume",
       volume,
       "Between the surfaces, per metre of the width.",
       &Row::void_volume,
       "/oil/end/void_volume"},
      {"oil volume",
       volume,
       "Of the oil at its pressure.",
       &Row::oil_volume,
       "/oil/end/oil_volume"},
      {"oil reference volume",
       volume,
       "Of the same oil at no pressure: its mass.",
       &Row::oil_reference_volume,
       ""},
      {"oil in",
       volume,
       "Of the oil that has come in through open ends.",
       &Row::oil_in,
       "/oil/end/oil_in"},
      {"oil out",
       volume,
       "Of the oil that has left through open ends.",
       &Row::oil_out,
       "/oil/end/oil_out"},
      {"pockets",
       number,
       "Number of pockets of enclosed oil.",
       &Row::pockets,
       "/oil/end/pockets"},
      {"coupling iterations",
       number,
       "Exchanges between chip and oil.",
       &Row::coupling_iterations,
       ""},
      {"newton iterations",
       number,
       "Of the chip's balance.",
       &Row::newton_iterations,
       ""},
      {"factorisations",
       number,
       "Of the tangent, by this process.",
       &Row::factorisations,
       ""},
      {"T_transverse",
       line_load,
       "Force on the chip across Load/Sliding direction in three dimensions, to "
       "its left (y where that is x), per metre of the width W as T_x and T_y.",
       &Row::T_transverse,
       ""},
      {"wall time", wall, "Of the step.", &Row::wall_time, ""}};
  } // namespace



  const std::vector<FrictionColumn> &
  friction_columns()
  {
    return columns;
  }



  std::string
  FrictionColumn::heading(const bool people) const
  {
    return unit.si.empty() ?
             name :
             name + " [" + (people ? unit.people : unit.si) + "]";
  }



  double
  FrictionColumn::value(const FrictionRow &row) const
  {
    return std::visit(
      [&row](const auto entry) { return static_cast<double>(row.*entry); },
      member);
  }



  namespace
  {
    std::vector<TableColumn>
    table_columns()
    {
      std::vector<TableColumn> columns;
      for (const FrictionColumn &column : friction_columns())
        columns.push_back({column.heading(),
                           column.heading(true),
                           column.unit.factor,
                           column.unit.offset});
      return columns;
    }
  } // namespace



  FrictionTable::FrictionTable(const std::string              &directory,
                               const std::vector<FrictionRow> &earlier)
    : table(directory + "/friction.csv",
            table_columns(),
            directory + "/friction_units.csv")
  {
    for (const FrictionRow &row : earlier)
      if (row.step > 0)
        append(row);
  }



  void
  FrictionTable::append(const FrictionRow &row)
  {
    std::vector<double> values;
    for (const FrictionColumn &column : friction_columns())
      values.push_back(column.value(row));
    table.append(values);
  }
} // namespace asperity
