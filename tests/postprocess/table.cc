#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/postprocess/friction_table.h>
#include <asperity/postprocess/summary.h>
#include <asperity/postprocess/table.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <sstream>

#include "../files.h"

using namespace asperity;

namespace
{
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();

  std::vector<std::string>
  lines(const std::string &path)
  {
    std::istringstream       in(content(path));
    std::vector<std::string> result;
    for (std::string line; std::getline(in, line);)
      result.push_back(line);
    return result;
  }

  FrictionRow
  row_of_step(const unsigned int step)
  {
    FrictionRow row;
    row.step                 = step;
    row.time                 = step * 1e-9;
    row.sliding_distance     = step * 3.75e-10;
    row.T_x                  = 300.;
    row.T_y                  = -3000.;
    row.mu                   = 0.1;
    row.contact_fraction     = 1. / 3.;
    row.max_contact_pressure = 2.5e9;
    row.max_temperature      = 298.15;
    row.flash_temperature    = 298.15;
    row.newton_iterations    = 4;
    return row;
  }
} // namespace



TEST(FrictionTable, headings_name_every_unit_and_rows_are_on_disk_at_once)
{
  const std::string folder = test_folder();
  FrictionTable     table(folder);
  table.append(row_of_step(8));
  // The table is still open: a kill now must lose nothing.
  const auto rows = lines(folder + "/friction.csv");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(
    rows[0],
    "step,time [s],sliding distance [m],T_x [N/m],T_y [N/m],mu [-],"
    "ploughing [-],interface shear [-],oil shear [-],"
    "interface T_x [N/m],interface T_y [N/m],sticking [-],"
    "contact fraction [-],touching length [m],max contact pressure [Pa],"
    "real contact pressure [Pa],max plastic strain [-],"
    "max temperature [K],flash temperature [K],plastic heat [J/m],"
    "friction heat [J/m],stored heat [J/m],depth heat [J/m],"
    "tool heat [J/m],heat balance error [-],mean gap [m],"
    "max penetration [m],oil pressure [Pa],max oil pressure [Pa],"
    "oil T_x [N/m],shear T_x [N/m],shear T_y [N/m],"
    "void volume [m^2],oil volume [m^2],oil reference volume [m^2],"
    "oil in [m^2],oil out [m^2],pockets [-],"
    "coupling iterations [-],newton iterations [-],"
    "factorisations [-],T_transverse [N/m],wall time [s]");
  EXPECT_EQ(rows[1].substr(0, 8), "8,8e-09,");
  EXPECT_NE(rows[1].find(",0.3333333333333333,0,2500000000,0,0,298.15,"),
            std::string::npos);
}



TEST(FrictionTable, companion_shows_people_units)
{
  const std::string folder = test_folder();
  FrictionTable(folder).append(row_of_step(8));
  const auto rows = lines(folder + "/friction_units.csv");
  ASSERT_EQ(rows.size(), 2u);
  // 8e-9 s, 3e-9 m, 300 N/m, 2.5e9 Pa and 298.15 K by hand; no oil.
  EXPECT_EQ(rows[0].substr(0, 46),
            "step,time [us],sliding distance [um],T_x [N/mm");
  EXPECT_EQ(
    rows[1],
    "8,0.008,0.003,0.3,-3,0.1,0,0,0,0,0,0,0.333333333333,0,2500,0,0,25,25,"
    "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,4,0,0,0");
}



TEST(FrictionTable, a_run_that_goes_on_begins_with_its_earlier_rows)
{
  const std::string        folder = test_folder();
  std::vector<FrictionRow> rows   = {row_of_step(0)};
  {
    FrictionTable table(folder);
    for (unsigned int step = 1; step <= 5; ++step)
      {
        rows.push_back(row_of_step(step));
        table.append(rows.back());
      }
  }
  const std::string whole = content(folder + "/friction.csv");
  // A kill in the middle of a row leaves a torn line; a table that was edited
  // or lost is of no importance, either.
  for (const std::string &old : {whole + "6,6e-0", std::string("x\n")})
    {
      overwrite(folder + "/friction.csv", old);
      FrictionTable table(folder, {rows.begin(), rows.begin() + 4});
      table.append(rows[4]);
      table.append(rows[5]);
      EXPECT_EQ(content(folder + "/friction.csv"), whole);
      EXPECT_EQ(lines(folder + "/friction_units.csv").size(), 6u);
    }
}



TEST(FrictionTable, every_entry_of_a_row_is_a_column_of_its_own)
{
  // Distinct values come back from an archive and stand in the table in order.
  FrictionRow row;
  double      value = 0.;
  for (const FrictionColumn &column : friction_columns())
    std::visit([&](const auto entry) { row.*entry = ++value; }, column.member);
  for (std::size_t i = 0; i < friction_columns().size(); ++i)
    EXPECT_EQ(friction_columns()[i].value(row), i + 1.)
      << friction_columns()[i].name;
  EXPECT_EQ(friction_columns().size(), 43u);

  FrictionRow       copy;
  const std::string bytes =
    to_bytes([&](OutputArchive &archive) { archive << row; });
  from_bytes(bytes, "The row", [&](InputArchive &archive) { archive >> copy; });
  for (const FrictionColumn &column : friction_columns())
    EXPECT_EQ(column.value(copy), column.value(row)) << column.name;
}



TEST(FrictionTable, the_page_on_its_columns_is_up_to_date)
{
  std::ostringstream expected;
  expected << "| friction.csv | friction_units.csv | meaning |\n"
              "| --- | --- | --- |\n";
  for (const FrictionColumn &column : friction_columns())
    expected << "| " << column.heading() << " | " << column.heading(true)
             << " | " << column.meaning << " |\n";
  const std::string page =
    content(ASPERITY_SOURCE_DIR "/doc/friction_columns.md");
  EXPECT_NE(page.find(expected.str()), std::string::npos)
    << "doc/friction_columns.md should hold\n"
    << expected.str();
}



TEST(FrictionTable, a_new_run_replaces_the_old_table)
{
  const std::string folder = test_folder();
  FrictionTable(folder).append(row_of_step(1));
  FrictionTable(folder).append(row_of_step(2));
  EXPECT_EQ(lines(folder + "/friction.csv").size(), 2u);
}



TEST(FrictionTable, a_value_that_is_not_finite_is_refused_by_name)
{
  const std::string folder = test_folder();
  FrictionTable     table(folder);
  FrictionRow       row = row_of_step(1);
  row.mean_gap          = not_a_number;
  const std::string message =
    message_of<ComputationError>([&]() { table.append(row); });
  EXPECT_NE(message.find("mean gap [m]"), std::string::npos);
  EXPECT_EQ(lines(folder + "/friction.csv").size(), 1u);
}



TEST(Table, a_heading_or_row_that_would_break_the_table_is_refused)
{
  const std::string path = test_folder() + "/a.csv";
  EXPECT_THROW(Table(path, {{"a, b", "a"}}), InputError);
  Table table(path, {{"a", "a"}, {"b", "b"}});
  EXPECT_THROW(table.append({1.}), ComputationError);
}



TEST(Summary, reads_back_in_order_and_bit_for_bit)
{
  const std::string      path = test_folder() + "/summary.json";
  nlohmann::ordered_json summary;
  summary["friction"]["mu"]     = 1. / 3.;
  summary["friction"]["mu_end"] = 0.1;
  summary["friction"]["window"] = {1.25e-7, 2.5e-7};
  summary["chip"]["degree"]     = 2;
  summary["a"]                  = "R0 \xc2\xb5";
  write_summary(path, summary);
  EXPECT_EQ(read_summary(path), summary);
  EXPECT_EQ(read_summary(path).dump(), summary.dump());
  EXPECT_EQ(content(path).substr(0, 18), "{\n  \"friction\": {\n");
}



TEST(Summary, a_value_that_is_not_finite_is_refused_by_name)
{
  const std::string      path = test_folder() + "/summary.json";
  nlohmann::ordered_json summary;
  summary["friction"]["window"] = {0., not_a_number};
  const std::string message =
    message_of<ComputationError>([&]() { write_summary(path, summary); });
  EXPECT_NE(message.find("/friction/window/1"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(path));
}



TEST(Summary, missing_and_broken_files_are_input_errors)
{
  const std::string path = test_folder() + "/summary.json";
  EXPECT_THROW(read_summary(path), InputError);
  overwrite(path, "{\"friction\": ");
  EXPECT_THROW(read_summary(path), InputError);
}
