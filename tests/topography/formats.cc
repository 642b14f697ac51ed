#include <asperity/base/errors.h>
#include <asperity/topography/read_height_map.h>
#include <asperity/topography/zip_archive.h>

#include "synthetic_files.h"

using namespace asperity;
using namespace asperity_test;

namespace
{
  /** The map that all synthetic files hold. */
  void
  expect_the_map(const HeightMap &map, const std::string &format)
  {
    EXPECT_EQ(map.provenance.format, format);
    ASSERT_EQ(map.nx, 3u);
    ASSERT_EQ(map.ny, 2u);
    EXPECT_NEAR(map.dx, 0.5e-6, 1e-13);
    EXPECT_NEAR(map.dy, 0.25e-6, 1e-13);
    const double expected[] = {1, 2, 3, -4, 0, 6};
    for (unsigned int i = 0; i < 6; ++i)
      if (i == 4)
        EXPECT_TRUE(std::isnan(map.heights[i])) << format;
      else
        EXPECT_NEAR(map.heights[i], 1e-6 * expected[i], 1e-12) << format;
    EXPECT_TRUE(map.provenance.has_unit);
  }

  HeightMap
  read_bytes_as(const std::string &name,
                const std::string &bytes,
                const ReadOptions &options = {})
  {
    return read_height_map(write_bytes(name, bytes), options);
  }

  HeightMap
  read_archive(const std::vector<std::pair<std::string, std::string>> &entries)
  {
    const auto file = write_bytes("archive.zip", "");
    write_zip(file, entries);
    return read_height_map(file);
  }

  ReadOptions
  micrometres()
  {
    ReadOptions options;
    options.lateral_unit = 1e-6;
    options.height_unit  = 1e-6;
    options.spacing_x    = 0.5e-6;
    options.spacing_y    = 0.25e-6;
    return options;
  }
} // namespace

// The names of the files say nothing: the content decides.
TEST(Formats, sdf_binary_of_each_data_type)
{
  for (const int type : {5, 6, 7})
    expect_the_map(read_bytes_as("a.dat", sdf_binary(type)), "SDF, binary");
}

TEST(Formats, sdf_ascii)
{
  expect_the_map(read_bytes_as("b.x3p", sdf_ascii()), "SDF, ASCII");
}

TEST(Formats, sur_of_16_and_32_bits_plain_and_compressed)
{
  for (const int bits : {16, 32})
    {
      expect_the_map(read_bytes_as("c.sur", sur(bits, false)), "SUR, plain");
      expect_the_map(read_bytes_as("d.sur", sur(bits, true)),
                     "SUR, compressed");
    }
}

TEST(Formats, gsf_with_each_length_of_padding)
{
  for (const char *title : {"", "a", "ab", "abc"})
    expect_the_map(read_bytes_as("e.gsf", gsf(title)), "GSF");
}

TEST(Formats, al3d_with_padded_rows)
{
  expect_the_map(read_bytes_as("f.al3d", al3d()), "AL3D");
}

TEST(Formats, plux)
{
  expect_the_map(read_archive(plux_entries()), "PLUX");
}

TEST(Formats, x3p_with_signed_integers_offset_and_valid_bits)
{
  std::string raw;
  for (const int um : {1, 2, 3, -4, 0, 6})
    append<std::int16_t>(raw, 1000 * um - 500);
  const std::string axis =
    "<AxisType>A</AxisType><DataType>I</DataType><Increment>1e-9</Increment>"
    "<Offset>5e-7</Offset>";
  expect_the_map(read_archive({{"main.xml", x3p_main(axis, x3p_link(true))},
                               {"bindata/data.bin", raw},
                               {"bindata/valid.bin", "\x2f"}}),
                 "X3P");
}

// iso5436_2.xsd: the increment is for incremental axes and whole numbers.
TEST(Formats, x3p_increment_scales_whole_numbers_and_not_real_heights)
{
  std::string reals, integers;
  for (const int um : {1, 2, 3, -4, 0, 6})
    {
      append<double>(reals, um == 0 ? missing_height : 1e-6 * um);
      append<std::int32_t>(integers, um);
    }
  const auto read = [](const std::string &type,
                       const std::string &increment,
                       const std::string &data) {
    return read_archive({{"main.xml",
                          x3p_main("<AxisType>A</AxisType><DataType>" + type +
                                     "</DataType>" + increment,
                                   x3p_link(false))},
                         {"bindata/data.bin", data}});
  };
  const HeightMap map = read("D", "<Increment>1e-6</Increment>", reals);
  expect_the_map(map, "X3P");
  ASSERT_EQ(map.provenance.warnings.size(), 1u);
  EXPECT_NE(map.provenance.warnings[0].find("Increment"), std::string::npos);
  EXPECT_TRUE(
    read("D", "<Increment>1</Increment>", reals).provenance.warnings.empty());
  EXPECT_NEAR(read("L", "<Increment>1e-6</Increment>", integers)(1, 0),
              2e-6,
              1e-18);
  EXPECT_THROW(read("L", "", integers), InputError);
}

TEST(Formats, x3p_in_a_folder_with_copies_of_macos_and_a_bare_root)
{
  std::string raw;
  for (const float um : {1.f, 2.f, 3.f, -4.f, INFINITY, 6.f})
    append<float>(raw, 1e-6f * um);
  const std::string axis = "<AxisType>A</AxisType><DataType>F</DataType>";
  expect_the_map(read_archive({{"__MACOSX/bindata/data.bin", "nonsense"},
                               {"folder/main.xml",
                                x3p_main(axis, x3p_link(false), "ISO5436")},
                               {"folder/bindata/data.bin", raw},
                               {"folder/bindata/.DS_Store", "nonsense"}}),
                 "X3P");
}

TEST(Formats, x3p_with_a_list_in_its_xml)
{
  const std::string axis = "<AxisType>A</AxisType><DataType>D</DataType>";
  expect_the_map(read_archive(
                   {{"main.xml",
                     x3p_main(axis,
                              "<DataList><Datum>1e-6</Datum><Datum>2.0E-006"
                              "</Datum><Datum>3e-6</Datum><!-- a comment -->"
                              "<Datum>-4e-6</Datum><Datum/><Datum>6e-6</Datum>"
                              "</DataList>")}}),
                 "X3P");
}

TEST(Formats, x3p_is_read_as_it_was_written)
{
  HeightMap map = make_map(37, 21, 0.3e-6, 0.7e-6, [](double x, double y) {
    return std::sin(1e7 * x) * 1e-7 + 0.01 * y;
  });
  map(3, 4)     = missing_height;
  map(36, 20)   = missing_height;
  map.provenance.description = "a <comment> & more";
  const auto file            = write_bytes("written.x3p", "");
  write_x3p(map, file);
  const HeightMap again = read_height_map(file);
  EXPECT_EQ(again.nx, map.nx);
  EXPECT_EQ(again.ny, map.ny);
  EXPECT_EQ(again.dx, map.dx);
  EXPECT_EQ(again.dy, map.dy);
  EXPECT_EQ(again.provenance.description, map.provenance.description);
  EXPECT_TRUE(again.provenance.warnings.empty());
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    if (std::isnan(map.heights[i]))
      EXPECT_TRUE(std::isnan(again.heights[i]));
    else
      EXPECT_EQ(again.heights[i], map.heights[i]);

  const auto first = read_bytes(file);
  write_x3p(map, file);
  EXPECT_EQ(read_bytes(file), first);
}

TEST(Formats, text_matrix_in_its_dialects)
{
  for (const char *text : {"1 2 3\n-4 NaN 6\n",
                           "# heights\n1\t2\t3\r\n-4\tBAD\t6\r\n",
                           "title of it\n1,2,3\n-4,,6",
                           "1.0, 2.0, 3.0\n-4.0, nan, 6e0\n",
                           "1,0;2,0;3,0\n-4,0;;6,0\n",
                           "  1,0\t2,0\t3,0  \n\n -4,0\t---\t6,0\n",
                           "1;2;3;\n-4;*** ;6;\n"})
    expect_the_map(read_bytes_as("g.txt", text, micrometres()), "text, matrix");
}

TEST(Formats, text_points_in_any_order)
{
  expect_the_map(read_bytes_as("h.xyz",
                               "x y z\n0.5 0.25 NaN\n0 0 1\n1.0 0 3\n0.5 0 2\n"
                               "1.0 0.25 6\n0 0.25 -4\n",
                               micrometres()),
                 "text, x y z");
  // A point that is not listed is missing.
  expect_the_map(
    read_bytes_as("i.csv",
                  "10,5,1\n10.5,5,2\n11,5,3\n10,5.25,-4\n11,5.25,6\n",
                  micrometres()),
    "text, x y z");
}

TEST(FormatFixtures, iso5436_samples_hold_one_surface)
{
  const auto folder = measured("format_fixtures/");
  SKIP_WITHOUT(folder + "ISO5436-sample1.x3p");
  const HeightMap list = read_height_map(folder + "ISO5436-sample1.x3p");
  ASSERT_EQ(list.heights.size(), 16u);
  EXPECT_EQ(list.n_valid(), 15u);
  EXPECT_TRUE(std::isnan(list(3, 1)));
  EXPECT_NEAR(list(2, 0), -8.08368571682830e-1, 1e-14);
  EXPECT_NEAR(list.dx, 1.6016e-2, 1e-14);
  const auto expect_same = [&](const std::string &name,
                               const double       tolerance) {
    const HeightMap map = read_height_map(folder + name);
    ASSERT_EQ(map.heights.size(), 16u);
    for (unsigned int i = 0; i < 16; ++i)
      if (std::isnan(list.heights[i]))
        EXPECT_TRUE(std::isnan(map.heights[i])) << name;
      else
        EXPECT_NEAR(map.heights[i], list.heights[i], tolerance) << name;
  };
  expect_same("ISO5436-sample1_bin.x3p", 1e-14);
  expect_same("ISO5436-sample4.x3p", 0.5001e-3);
  expect_same("ISO5436-sample4_bin.x3p", 0.5001e-3);
}

TEST(FormatFixtures, pyramid_is_read_and_carries_no_unit)
{
  const auto file = measured("format_fixtures/pyramid.x3p");
  SKIP_WITHOUT(file);
  const HeightMap map = read_height_map(file);
  EXPECT_EQ(map.nx, 5u);
  EXPECT_EQ(map.ny, 5u);
  EXPECT_FALSE(map.provenance.has_unit);
  ASSERT_FALSE(map.provenance.warnings.empty());
  EXPECT_NE(map.provenance.warnings[0].find("no unit"), std::string::npos);
  const HeightMap in_um = read_height_map(file, micrometres());
  EXPECT_TRUE(in_um.provenance.has_unit);
  EXPECT_EQ(in_um.dx, 1e-6);
  EXPECT_EQ(in_um(2, 2), 1e-6 * map(2, 2));
}

TEST(FormatFixtures, sdf_soft_gauge)
{
  const auto file = measured("format_fixtures/sdf-1.sdf");
  SKIP_WITHOUT(file);
  const HeightMap map = read_height_map(file);
  EXPECT_EQ(map.nx, 7u);
  EXPECT_EQ(map.ny, 4u);
  EXPECT_EQ(map.dx, 1e-6);
  EXPECT_NEAR(map(5, 3), 0.94907e-6, 1e-18);
  EXPECT_NEAR(map(6, 0), 1e-6, 1e-18);
}
