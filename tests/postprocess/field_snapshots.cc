#include <asperity/base/errors.h>
#include <asperity/postprocess/field_picture.h>
#include <asperity/postprocess/field_snapshots.h>
#include <asperity/postprocess/hdf5_file.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "../files.h"
#include "field_examples.h"
#include "vtu_reader.h"

using namespace asperity;

namespace
{
  std::string
  refusal(const std::string &path)
  {
    return message_of<InputError>([&]() { FieldSnapshots::read(path); });
  }
} // namespace

TEST(FieldSnapshots, are_read_as_they_were_written)
{
  const std::string    path = test_folder() + "/fields.h5";
  const FieldSnapshots kept = two_cells();
  kept.write(path);
  const FieldSnapshots read = FieldSnapshots::read(path);
  EXPECT_EQ(read.places.nodes, kept.places.nodes);
  EXPECT_EQ(read.places.points, kept.places.points);
  EXPECT_EQ(read.places.edge, kept.places.edge);
  EXPECT_TRUE(read.places.is_same_as(kept.places));
  EXPECT_EQ(read.places.period, kept.places.period);
  EXPECT_EQ(read.places.n_cells(), 2u);
  EXPECT_EQ(read.shares, kept.shares);
  EXPECT_TRUE(read.is_complete());
  ASSERT_EQ(read.fields.size(), kept.fields.size());
  for (std::size_t f = 0; f < kept.fields.size(); ++f)
    {
      EXPECT_EQ(read.fields[f].name, kept.fields[f].name);
      EXPECT_EQ(read.fields[f].places, kept.fields[f].places);
      EXPECT_EQ(read.fields[f].n_components, kept.fields[f].n_components);
    }
  ASSERT_EQ(read.snapshots.size(), kept.snapshots.size());
  for (std::size_t i = 0; i < kept.snapshots.size(); ++i)
    {
      EXPECT_EQ(read.snapshots[i].values, kept.snapshots[i].values);
      EXPECT_EQ(read.snapshots[i].mu, kept.snapshots[i].mu);
      EXPECT_EQ(read.snapshots[i].step, kept.snapshots[i].step);
      EXPECT_EQ(read.snapshots[i].direction, kept.snapshots[i].direction);
    }
}

TEST(FieldSnapshots, of_a_run_that_has_not_ended_are_not_complete)
{
  const std::string path   = test_folder() + "/fields.h5";
  FieldSnapshots    fields = two_cells();
  fields.snapshots.pop_back();
  fields.write(path);
  EXPECT_FALSE(FieldSnapshots::read(path).is_complete());
}

TEST(FieldSnapshots, refuse_a_file_that_is_missing_or_none_of_theirs)
{
  const std::string folder = test_folder();
  EXPECT_NE(refusal(folder + "/none.h5").find("could not be opened"),
            std::string::npos);
  overwrite(folder + "/text.h5", "mu = 0.1\n");
  EXPECT_NE(refusal(folder + "/text.h5").find("is no HDF5 file"),
            std::string::npos);
  Hdf5Content other;
  other.texts["format"] = "of somebody else";
  other.write(folder + "/other.h5");
  EXPECT_NE(refusal(folder + "/other.h5").find("'of somebody else'"),
            std::string::npos)
    << refusal(folder + "/other.h5");
}

TEST(FieldSnapshots, refuse_a_file_that_is_cut_anywhere)
{
  const std::string path = test_folder() + "/fields.h5";
  two_cells().write(path);
  const std::string whole = content(path);
  for (const double part : {0.01, 0.3, 0.7, 0.99})
    {
      overwrite(path, whole.substr(0, part * whole.size()));
      EXPECT_NE(refusal(path).find("not complete"), std::string::npos);
    }
}

// libhdf5 itself may crash on such a file.
TEST(FieldSnapshots, refuse_a_file_of_which_any_byte_is_damaged)
{
  const std::string path = test_folder() + "/fields.h5";
  two_cells().write(path);
  const std::string whole = content(path);
  for (std::size_t at = 0; at < whole.size(); at += 997)
    {
      std::string damaged = whole;
      damaged[at]         = static_cast<char>(damaged[at] ^ 0x10);
      overwrite(path, damaged);
      EXPECT_NE(refusal(path).find("damaged"), std::string::npos) << at;
    }
}

TEST(FieldSnapshots, refuse_tables_that_do_not_fit)
{
  const std::string path = test_folder() + "/fields.h5";
  two_cells().write(path);
  Hdf5Content changed = Hdf5Content::read(path, "fields");
  Hdf5Table  &values  = changed.tables.at("1: traction [Pa]");
  values.values[0]    = std::numeric_limits<double>::quiet_NaN();
  changed.write(path);
  EXPECT_NE(refusal(path).find("not finite"), std::string::npos);
  values.values.resize(2);
  values.n_rows = 1;
  changed.write(path);
  EXPECT_NE(refusal(path).find("has 1 values of 'traction [Pa]' at 4 places"),
            std::string::npos)
    << refusal(path);
  changed.tables.erase("1: traction [Pa]");
  changed.write(path);
  EXPECT_NE(refusal(path).find("has no table '1: traction [Pa]'"),
            std::string::npos)
    << refusal(path);
}

TEST(Hdf5Content, keeps_long_and_empty_texts_and_empty_tables)
{
  const std::string path = test_folder() + "/texts.h5";
  Hdf5Content       content;
  content.texts["long"]  = std::string(300000, 'x');
  content.texts["empty"] = "";
  content.tables["none"] = {0, 3, {}};
  content.write(path);
  const Hdf5Content read = Hdf5Content::read(path, "texts");
  EXPECT_EQ(read.texts, content.texts);
  EXPECT_EQ(read.table("none", 3, path).n_rows, 0u);
  EXPECT_NE(message_of<InputError>([&]() {
              read.table("none", 2, path);
            }).find("has 3 columns, where 2 are expected"),
            std::string::npos);
  EXPECT_NE(message_of<InputError>([&]() {
              read.text("name", path);
            }).find("does not say 'name'"),
            std::string::npos);
}

TEST(Hdf5Content, says_why_it_cannot_be_written)
{
  const std::string folder = test_folder();
  overwrite(folder + "/file", "");
  const std::string message = message_of<ComputationError>(
    [&]() { Hdf5Content().write(folder + "/file/fields.h5"); });
  EXPECT_EQ(message,
            "The file '" + folder +
              "/file/fields.h5' could not be written: not a directory.");
}

// A traction of (a, b) over a length L is a force (a L, b L); a column under
// the same nominal stress is in balance with it.
TEST(FieldSnapshots, forces_of_tractions_and_of_stress_are_integrals)
{
  const FieldSnapshots about  = two_cells();
  auto                 values = about.snapshots[0].values;
  const auto           force  = force_of_tractions(about, values);
  EXPECT_NEAR(force[0], 3. * 2., 1e-13);
  EXPECT_NEAR(force[1], -7. * 2. + 1., 1e-13);
  const auto balanced = imbalance_of_stress(about, values);
  EXPECT_NEAR(balanced[0], 0., 1e-13);
  EXPECT_NEAR(balanced[1], 0., 1e-13);
  std::vector<double> &P = values[about.find(field_names::nominal_stress)];
  for (std::size_t i = 0; i < P.size(); i += 2)
    P[i] += 0.5; // over the length of 2
  EXPECT_NEAR(imbalance_of_stress(about, values)[0], 1., 1e-13);
}

TEST(FieldPicture, draws_the_chip_where_it_is_and_its_equivalent_stress)
{
  const FieldSnapshots about  = two_cells();
  const auto          &values = about.snapshots[0].values;
  std::ostringstream   out;
  write_chip_fields(out, about, values, {2., 10., 5});
  const VtuReader picture(out.str());
  EXPECT_EQ(picture.n_cells, 2u);
  EXPECT_EQ(picture.time(), 2.);
  const auto points = picture.points();
  // u = (0.1 Y, 0) and a sliding of 10
  for (std::size_t i = 0; i < 8; ++i)
    {
      const double X = about.places.nodes[3 * i],
                   Y = about.places.nodes[3 * i + 1];
      EXPECT_NEAR(points[3 * i], X + 0.1 * Y + 10., 1e-6);
      EXPECT_NEAR(points[3 * i + 1], Y, 1e-6);
    }
  // pure shear of tau: the equivalent stress is sqrt(3) tau
  for (const float mises : picture.field("von Mises stress [Pa]"))
    EXPECT_NEAR(mises, std::sqrt(3.) * 2., 1e-6);
  for (const float T : picture.field("temperature [degC]"))
    EXPECT_NEAR(T, 26.85, 1e-4);
}

TEST(FieldPicture, draws_and_tabulates_the_edge)
{
  const FieldSnapshots about  = two_cells();
  const auto          &values = about.snapshots[0].values;
  std::ostringstream   out;
  write_edge_fields(out, about, values, {2., 10., 5});
  const VtuReader picture(out.str());
  EXPECT_EQ(picture.n_points, 4u);
  EXPECT_FLOAT_EQ(picture.field("traction [Pa]")[1], -7.f);
  EXPECT_FLOAT_EQ(picture.points()[1], 1.25f); // Y = 1 and u_y = 0.25
  std::ostringstream table;
  write_edge_table(table, about, values);
  std::istringstream lines(table.str());
  std::string        head, first;
  std::getline(lines, head);
  std::getline(lines, first);
  EXPECT_EQ(head,
            "x [m],y [m],weight [m],displacement of the edge [m] x,"
            "displacement of the edge [m] y,contact pressure [Pa],"
            "traction [Pa] x,traction [Pa] y");
  EXPECT_EQ(first, "0.25,1,0.5,0,0.25,7,3,-7");
}

TEST(FieldPicture, refuses_fields_without_displacement)
{
  FieldSnapshots about = two_cells();
  about.fields[0].name = "velocity [m/s]";
  std::ostringstream out;
  EXPECT_NE(message_of<ComputationError>([&]() {
              write_chip_fields(out, about, about.snapshots[0].values, {});
            }).find("have no 'displacement [m]'"),
            std::string::npos);
}
