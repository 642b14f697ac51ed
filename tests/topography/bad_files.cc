#include <asperity/base/errors.h>
#include <asperity/topography/file_content.h>
#include <asperity/topography/read_height_map.h>
#include <asperity/topography/zip_archive.h>

#include "synthetic_files.h"

using namespace asperity;
using namespace asperity_test;

namespace
{
  std::string
  refusal(const std::string &file, const ReadOptions &options = {})
  {
    return message_of<InputError>([&]() { read_height_map(file, options); });
  }

  std::string
  refusal_of(const std::string &bytes, const ReadOptions &options = {})
  {
    return refusal(write_bytes("bad", bytes), options);
  }

  std::string
  refusal_of_archive(
    const std::vector<std::pair<std::string, std::string>> &entries)
  {
    const auto file = write_bytes("bad.zip", "");
    write_zip(file, entries);
    return refusal(file);
  }

  void
  expect_in(const std::string &part, const std::string &message)
  {
    EXPECT_NE(message.find(part), std::string::npos) << message;
    // One sentence that names the file.
    EXPECT_NE(message.find("bad"), std::string::npos) << message;
    EXPECT_EQ(message.back(), '.') << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }

  /** @p bytes with the number at @p offset replaced. */
  template <typename T>
  std::string
  with(std::string bytes, const std::size_t offset, const T value)
  {
    std::string number;
    append<T>(number, value);
    return bytes.replace(offset, sizeof(T), number);
  }

  const std::string axis = "<AxisType>A</AxisType><DataType>D</DataType>";
} // namespace

TEST(BadFiles, missing_empty_and_unknown)
{
  expect_in("does not exist", refusal("no/such/bad.x3p"));
  expect_in("is empty", refusal_of(""));
  expect_in("is none of X3P", refusal_of(std::string("\x89PNG\0\0\x01", 7)));
  expect_in("no line of numbers", refusal_of("Dear reader,\nthis is prose.\n"));
  std::filesystem::create_directories(ASPERITY_BINARY_DIR
                                      "/test_topography_bad");
  expect_in("is not a file",
            refusal(ASPERITY_BINARY_DIR "/test_topography_bad"));
}

TEST(BadFiles, text_without_units_or_spacing)
{
  expect_in("carries no unit", refusal_of("1 2 3\n4 5 6\n"));
  expect_in("carries no unit", refusal_of("0 0 1\n1 0 2\n0 1 3\n1 1 4\n"));
  ReadOptions options;
  options.height_unit = 1e-6;
  expect_in("Spacing x", refusal_of("1 2 3\n4 5 6\n", options));
  expect_in("Lateral unit",
            refusal_of("0 0 1\n1 0 2\n0 1 3\n1 1 4\n", options));
}

TEST(BadFiles, text_that_is_not_rectangular_or_not_numbers)
{
  ReadOptions options;
  options.height_unit = options.spacing_x = options.spacing_y = 1e-6;
  expect_in("line 2", refusal_of("1 2 3\n4 5\n", options));
  expect_in("line 3", refusal_of("1 2 3\n4 5 6\n7 oops 9\n", options));
  expect_in("no valid height", refusal_of("nan nan\nnan nan\n", options));
}

TEST(BadFiles, x3p_of_kinds_that_are_no_height_map)
{
  const auto change = [](const std::string &from, const std::string &to) {
    std::string xml = x3p_main(axis, x3p_link(false));
    xml.replace(xml.find(from), from.size(), to);
    return refusal_of_archive(
      {{"main.xml", xml}, {"bindata/data.bin", std::string(48, '\0')}});
  };
  expect_in("point cloud", change("SUR", "PCL"));
  expect_in("absolute coordinates along X",
            change("<CX><AxisType>I", "<CX><AxisType>A"));
  expect_in("absolute coordinates along Y",
            change("<CY><AxisType>I", "<CY><AxisType>A"));
  expect_in("more than one layer", change("<SizeZ>1", "<SizeZ>2"));
  expect_in("more than 2^28", change("<SizeX>3", "<SizeX>3000000000"));
  expect_in("is cut off", change("<SizeX>3", "<SizeX>30000"));
  expect_in("-3 x 2 points", change("<SizeX>3", "<SizeX>-3"));
  expect_in("whole number", change("<SizeX>3", "<SizeX>3.5"));
  expect_in("a number is expected", change("<SizeX>3", "<SizeX>three"));
  expect_in("Increment of zero", change("5.0e-007", "0"));
  expect_in("data type",
            change("<CZ>" + axis.substr(0, 32) + "D",
                   "<CZ>" + axis.substr(0, 32) + "Q"));
  expect_in("lacks its heights", change("data.bin", "other.bin"));
  expect_in("cannot be parsed", change("<Record3>", "<Record3"));
}

TEST(BadFiles, x3p_and_zip_archives_that_lack_parts)
{
  expect_in("neither main.xml", refusal_of_archive({{"readme", "hello"}}));
  expect_in("without the element",
            refusal_of_archive({{"main.xml", "<other/>"}}));
  expect_in("describes no axes",
            refusal_of_archive({{"main.xml", "<ISO5436/>"}}));
  expect_in("is cut off",
            refusal_of_archive({{"main.xml", x3p_main(axis, x3p_link(false))},
                                {"bindata/data.bin", "short"}}));
  expect_in("more than the expected",
            refusal_of_archive({{"main.xml", x3p_main(axis, x3p_link(false))},
                                {"bindata/data.bin", std::string(1000, 'x')}}));
  expect_in("valid.bin",
            refusal_of_archive({{"main.xml", x3p_main(axis, x3p_link(true))},
                                {"bindata/data.bin", std::string(48, '\0')}}));
  std::string deep = "<ISO5436>";
  for (unsigned int i = 0; i < 200000; ++i)
    deep += "<a>";
  expect_in("nested too deeply", refusal_of_archive({{"main.xml", deep}}));
}

// The parser is recursive: what it will make of the text has to be foreseen.
TEST(BadFiles, xml_that_would_exhaust_the_stack_or_time)
{
  const auto repeat = [](const std::string &text, const unsigned int n) {
    std::string result;
    for (unsigned int i = 0; i < n; ++i)
      result += text;
    return result;
  };
  const auto refuse = [](const std::string &xml) {
    return refusal_of_archive({{"main.xml", xml}});
  };
  const unsigned int n = 200000;
  expect_in("nested too deeply",
            refuse(repeat("<a b=\"/>\">", n) + repeat("</a>", n)));
  expect_in("nested too deeply",
            refuse("<!-- " + repeat("</x>", n) + " -->" + repeat("<a>", n)));
  expect_in("nested too deeply",
            refuse("<a><![CDATA[" + repeat("</x>", n) + "]]>" +
                   repeat("<a>", n)));
  expect_in("cannot be parsed", refuse("<a\">" + repeat("<b>", n) + "\">"));
  expect_in("document type", refuse(repeat("<!", 4000000)));
  expect_in("cannot be parsed", refuse(repeat("<!--", 1000000)));
  expect_in("cannot be parsed", refuse(repeat("</a>", 10)));
  expect_in("entities",
            refuse("<!DOCTYPE x [<!ENTITY a \"aaaa\">"
                   "<!ENTITY b \"&a;&a;&a;\">]><ISO5436>&b;</ISO5436>"));
  expect_in("more than 1048576 elements",
            refuse("<a>" + repeat("<b/>", 1100000) + "</a>"));
}

// A file of some kilobytes must not take the memory of the machine.
TEST(BadFiles, archives_that_unpack_to_much_more_than_they_are)
{
  const std::string zeros(80 << 20, '\0');
  expect_in("at most a hundred times as many",
            refusal_of_archive({{"main.xml", zeros}}));
  std::string xml = x3p_main(axis, x3p_link(false));
  xml.replace(xml.find("<SizeX>3"), 8, "<SizeX>5242880");
  expect_in("at most a hundred times as many",
            refusal_of_archive(
              {{"main.xml", xml}, {"bindata/data.bin", zeros}}));
  // The size alone, without the data, takes none.
  xml.replace(xml.find("<SizeX>5242880"), 14, "<SizeX>100000000");
  expect_in("is cut off",
            refusal_of_archive({{"main.xml", xml},
                                {"bindata/data.bin", std::string(48, '\0')}}));
  std::string list = x3p_main(axis, "<DataList><Datum>1</Datum></DataList>");
  list.replace(list.find("<SizeX>3"), 8, "<SizeX>100000000");
  expect_in("is cut off", refusal_of_archive({{"main.xml", list}}));
}

// A smaller size would shear the rows: 3 x 2 points are stored.
TEST(BadFiles, headers_that_state_less_than_the_data_are_refused)
{
  const std::string part = "another size than its data";
  expect_in(part, refusal_of(with<std::uint16_t>(sdf_binary(5), 44, 1)));
  expect_in(part, refusal_of(with<std::uint16_t>(sdf_binary(7), 42, 2)));
  expect_in(part, refusal_of(with<std::int32_t>(sur(16, false), 112, 1)));
  expect_in(part, refusal_of(with<std::int32_t>(sur(32, false), 108, 2)));
  expect_in("more compressed heights",
            refusal_of(with<std::int32_t>(sur(32, true), 108, 2)));
  const auto replaced =
    [](std::string bytes, const std::string &from, const std::string &to) {
      return refusal_of(bytes.replace(bytes.find(from), from.size(), to));
    };
  expect_in(part, replaced(gsf("t"), "XRes = 3", "XRes = 2"));
  expect_in(part, replaced(gsf("t"), "YRes = 2", "YRes = 1"));
  expect_in(part,
            replaced(al3d(),
                     std::string("Rows") + std::string(16, '\0') + "2",
                     std::string("Rows") + std::string(16, '\0') + "1"));
  expect_in("with '*'",
            replaced(sdf_ascii(), "NumPoints = 3", "NumPoints = 2"));
}

TEST(BadFiles, trailers_of_text_are_told_and_not_read)
{
  const auto warnings =
    read_height_map(FileContent("map", sdf_binary(5) + "* operator: x *"), {})
      .provenance.warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("15 bytes behind the 3 x 2 heights"),
            std::string::npos)
    << warnings[0];
}

TEST(BadFiles, heights_beyond_all_surfaces_are_missing_in_binary_maps_too)
{
  const HeightMap map =
    read_height_map(FileContent("map", with<double>(sdf_binary(7), 81, 1e300)),
                    {});
  EXPECT_TRUE(std::isnan(map(0, 0)));
  EXPECT_NEAR(map(1, 0), 2e-6, 1e-15);
  ASSERT_EQ(map.provenance.warnings.size(), 1u);
  EXPECT_NE(map.provenance.warnings[0].find("beyond 1 km"), std::string::npos);
  expect_in("m apart", refusal_of(with<double>(sdf_binary(5), 46, 1e200)));
}

TEST(BadFiles, damaged_archive_is_noticed_by_its_checksum)
{
  const auto file = write_bytes("bad.x3p", "");
  write_x3p(make_map(50, 50, 1., 1., [](double x, double y) { return x * y; }),
            file);
  auto bytes = read_bytes(file);
  bytes[bytes.find("data.bin") + 200] ^= 0x55;
  expect_in("damaged", refusal_of(bytes));
}

TEST(BadFiles, sizes_and_scales_that_make_no_sense)
{
  expect_in("cut off",
            refusal_of(with<std::uint16_t>(sdf_binary(5), 42, 65535)));
  expect_in("DataType 9", refusal_of(with<char>(sdf_binary(5), 79, 9)));
  expect_in("compressed", refusal_of(with<char>(sdf_binary(5), 78, 1)));
  expect_in("spacing", refusal_of(with<double>(sdf_binary(5), 46, -1.)));
  expect_in("scale", refusal_of(with<double>(sdf_binary(5), 62, 0.)));
  expect_in("at least 2 x 1",
            refusal_of(with<std::uint16_t>(sdf_binary(5), 44, 0)));

  expect_in("2^28",
            refusal_of(with<std::int32_t>(sur(32, false), 108, 1 << 30)));
  expect_in("-5 x 2", refusal_of(with<std::int32_t>(sur(32, false), 108, -5)));
  expect_in("bits a point",
            refusal_of(with<std::uint16_t>(sur(32, false), 98, 8)));
  expect_in("type 7", refusal_of(with<std::uint16_t>(sur(32, false), 18, 7)));
  expect_in("unit along x", refusal_of(with<char>(sur(32, false), 180, 'V')));
  expect_in("damaged", refusal_of(with<char>(sur(32, true), 540, 'V')));

  const auto gsf_with = [](const std::string &from, const std::string &to) {
    std::string bytes = gsf("t");
    return refusal_of(bytes.replace(bytes.find(from), from.size(), to));
  };
  expect_in("a number is", gsf_with("XRes = 3", "XRes = e"));
  expect_in("no XRes", gsf_with("XRes", "Xres"));
  expect_in("unit of length", gsf_with("ZUnits = nm", "ZUnits = mV"));
  expect_in("not positive", gsf_with("XReal = 1.5", "XReal = -15"));
}

// Whatever is lost, the answer is an error and never a crash. In text and
// ASCII the last digits can go unnoticed, so these only must not crash.
TEST(BadFiles, each_format_cut_off_at_every_length)
{
  const std::vector<std::pair<std::string, std::string>> files = {
    {"SDF binary", sdf_binary(5)},
    {"SUR", sur(16, false)},
    {"SUR compressed", sur(32, true)},
    {"GSF", gsf("title")},
    // The last row may end without its padding.
    {"AL3D", al3d().substr(0, al3d().size() - 4)}};
  for (const auto &[name, bytes] : files)
    for (std::size_t n = 1; n < bytes.size(); ++n)
      EXPECT_THROW(read_height_map(FileContent("cut", bytes.substr(0, n)), {}),
                   InputError)
        << name << " of " << n << " bytes";

  ReadOptions options;
  options.height_unit = options.lateral_unit = 1e-6;
  options.spacing_x = options.spacing_y = 1e-6;
  for (const std::string &text : {sdf_ascii(), std::string("1 2 3\n4 5 6\n")})
    for (std::size_t n = 1; n < text.size(); ++n)
      try
        {
          read_height_map(FileContent("cut", text.substr(0, n)), options);
        }
      catch (const InputError &)
        {}
}

TEST(BadFiles, archives_cut_off_at_every_length)
{
  const std::string data(48, '\1');
  for (const auto &entries : {plux_entries(),
                              {{"main.xml", x3p_main(axis, x3p_link(false))},
                               {"bindata/data.bin", data}}})
    {
      const auto file = write_bytes("whole.zip", "");
      write_zip(file, entries);
      const auto bytes = read_bytes(file);
      EXPECT_NO_THROW(read_height_map(file));
      for (std::size_t n = 0; n < bytes.size(); ++n)
        EXPECT_THROW(read_height_map(write_bytes("cut", bytes.substr(0, n))),
                     InputError)
          << n << " of " << bytes.size() << " bytes";
    }
}

// Each byte is set to a few hostile values.
TEST(BadFiles, single_wrong_bytes_never_crash_a_reader)
{
  unsigned int n_read = 0, n_refused = 0;
  const auto   try_to_read = [&](const auto &...arguments) {
    try
      {
        read_height_map(arguments...);
        ++n_read;
      }
    catch (const InputError &)
      {
        ++n_refused;
      }
  };
  for (const std::string &bytes :
       {sdf_binary(6), sdf_ascii(), sur(16, true), gsf("t"), al3d()})
    for (std::size_t i = 0; i < bytes.size(); ++i)
      for (const int value : {0, 0x7f, 0xff, 0x39})
        {
          std::string wrong = bytes;
          wrong[i]          = static_cast<char>(value);
          EXPECT_NO_THROW(
            try_to_read(FileContent("wrong", wrong), ReadOptions()))
            << i;
        }

  const auto file = write_bytes("whole.zip", "");
  write_zip(file, plux_entries());
  const auto bytes = read_bytes(file);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    {
      std::string wrong = bytes;
      wrong[i]          = static_cast<char>(wrong[i] ^ 0xff);
      EXPECT_NO_THROW(try_to_read(write_bytes("wrong", wrong))) << i;
    }
  // Both occur: some bytes are heights, others say how to read them.
  EXPECT_GT(n_read, 1000u);
  EXPECT_GT(n_refused, 1000u);
}

TEST(FormatFixtures, point_cloud_and_absolute_axis_are_refused)
{
  const auto folder = measured("format_fixtures/");
  SKIP_WITHOUT(folder + "ISO5436-sample2.x3p");
  const auto cloud = refusal(folder + "ISO5436-sample2.x3p");
  EXPECT_NE(cloud.find("point cloud (FeatureType PCL)"), std::string::npos)
    << cloud;
  const auto absolute = refusal(folder + "ISO5436-sample3.x3p");
  EXPECT_NE(absolute.find("absolute coordinates along Y"), std::string::npos)
    << absolute;
}

TEST(FormatFixtures, measured_files_cut_off_are_refused)
{
  for (const char *name : {"alicona_al3d-1.al3d", "wire_cut_aluminium.x3p"})
    {
      SKIP_WITHOUT(measured(name));
      const auto bytes = read_bytes(measured(name));
      for (const double part : {0.001, 0.01, 0.1, 0.4, 0.45})
        EXPECT_THROW(read_height_map(write_bytes(
                       "cut", bytes.substr(0, part * bytes.size()))),
                     InputError)
          << name << ", " << part;
    }
}
