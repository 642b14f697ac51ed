#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "sample_parameters.h"

using namespace asperity;

namespace
{
  class ParameterFiles : public testing::Test
  {
  protected:
    void
    SetUp() override
    {
      std::filesystem::create_directories(folder / "sub");
    }

    void
    TearDown() override
    {
      std::filesystem::remove_all(folder);
    }

    std::string
    write(const std::string &name, const std::string &text)
    {
      std::ofstream(folder / name) << text;
      return (folder / name).string();
    }

    std::string
    message_of(const std::string &file)
    {
      Declared declared;
      try
        {
          declared.parameters.read_file(file);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "no error";
    }

    // a folder for each test, as ctest runs them at the same time
    const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      (std::string("asperity_parameters_") +
       testing::UnitTest::GetInstance()->current_test_info()->name());
  };
} // namespace

TEST_F(ParameterFiles, included_files_are_relative_and_later_lines_override)
{
  write("sub/common.prm",
        "include materials.prm\nsubsection Load\n set Pressure = 2 MPa\nend\n");
  write("sub/materials.prm", "set Title = steel\n");
  const std::string file =
    write("main.prm",
          "include sub/common.prm\nsubsection Load\n set Pressure = 7 MPa\n"
          "end\n");
  Declared declared;
  declared.parameters.read_file(file);
  EXPECT_EQ(declared.sample.title, "steel");
  EXPECT_EQ(declared.sample.pressure, 7e6);
}

TEST_F(ParameterFiles, an_error_names_the_included_file)
{
  const std::string inner = write("sub/common.prm", "\n\nset Titel = x\n");
  const std::string file  = write("main.prm", "include sub/common.prm\n");
  EXPECT_EQ(message_of(file),
            inner + ", line 3: There is no entry 'Titel' at the top level; did "
                    "you mean 'Title' at the top level?");
}

TEST_F(ParameterFiles, a_file_that_includes_itself_is_refused)
{
  write("sub/b.prm", "include ../a.prm\n");
  const std::string file    = write("a.prm", "include sub/b.prm\n");
  const std::string message = message_of(file);
  EXPECT_EQ(message,
            (folder / "sub/b.prm").string() + ", line 1: The file '" + file +
              "' includes itself.");
}

TEST_F(ParameterFiles, missing_files_and_folders_are_named)
{
  const std::string missing = (folder / "none.prm").string();
  EXPECT_EQ(message_of(missing),
            "The parameter file '" + missing +
              "' does not exist or cannot be read.");
  EXPECT_EQ(message_of(folder.string()),
            "The parameter file '" + folder.string() + "' is a folder.");
  const std::string file = write("main.prm", "\ninclude none.prm\n");
  EXPECT_EQ(message_of(file),
            file + ", line 2: The parameter file '" + missing +
              "' does not exist or cannot be read.");
}

TEST_F(ParameterFiles, input_files_are_relative_to_the_file_that_names_them)
{
  const std::string map  = write("sub/scan.csv", "1,2\n");
  const std::string file = write("sub/main.prm",
                                 "subsection Chip\n set Density = 1 g/cm3\n"
                                 " set Height map = scan.csv\nend\n");
  Declared          declared(true);
  declared.parameters.read_file(file);
  EXPECT_TRUE(std::filesystem::equivalent(declared.sample.height_map, map));

  // the complete file is written elsewhere and must still find it
  std::ostringstream written;
  declared.parameters.write_prm(written);
  Declared again(true);
  again.parameters.read_file(write("parameters.prm", written.str()));
  EXPECT_TRUE(std::filesystem::equivalent(again.sample.height_map, map));
}

TEST_F(ParameterFiles, chains_of_includes_end)
{
  for (int i = 0; i < 60; ++i)
    write(std::to_string(i) + ".prm",
          "include " + std::to_string(i + 1) + ".prm\n");
  const std::string message = message_of((folder / "0.prm").string());
  EXPECT_NE(message.find("49.prm, line 1: The file"), std::string::npos)
    << message;
  EXPECT_NE(message.find("is included by 50 files inside of each other"),
            std::string::npos)
    << message;
}

TEST_F(ParameterFiles, only_files_of_a_sensible_size_are_read)
{
  EXPECT_EQ(message_of("/dev/zero"),
            "The parameter file '/dev/zero' is a device or a pipe; a file is "
            "expected.");
  const std::string large = write("large.prm", "");
  std::filesystem::resize_file(large, (1 << 24) + 1);
  EXPECT_EQ(message_of(large),
            "The file '" + large +
              "' is too large for a parameter file; at "
              "most 16 MB are expected.");
}

TEST_F(ParameterFiles, floods_of_included_files_end)
{
  // 2^12 of them without a limit
  for (unsigned int i = 0; i < 12; ++i)
    {
      const std::string next = "include " + std::to_string(i + 1) + ".prm\n";
      write(std::to_string(i) + ".prm", next + next);
    }
  write("12.prm", "");
  EXPECT_NE(message_of((folder / "0.prm").string())
              .find("More than 1000 files are included; fewer are expected."),
            std::string::npos);
}

TEST_F(ParameterFiles, lines_may_end_as_on_other_systems)
{
  for (const std::string end : {"\n", "\r\n", "\r"})
    {
      const std::string file =
        write("main.prm",
              "# scene" + end + end + "set Title = steel" + end +
                "subsection Mesh" + end + "set Spans = 40" + end + "end");
      Declared declared;
      declared.parameters.read_file(file);
      EXPECT_EQ(declared.sample.title, "steel");
      EXPECT_EQ(declared.sample.spans, 40u);
      EXPECT_EQ(declared.parameters.where("Title"),
                file + ", line 3, entry 'Title'");
    }
}

TEST_F(ParameterFiles, every_name_of_a_file_is_read_as_it_was_written)
{
  for (const std::string name : {"run #2",
                                 "#2",
                                 "C#1",
                                 " blanks at its ends ",
                                 "tab\t#",
                                 "\"marks\"",
                                 "half a \"mark",
                                 "\"mark\" #2",
                                 "ends with \\",
                                 "\\\" #\\",
                                 "braces {a} $b ${c} %d",
                                 "a = b",
                                 "set a = \"b #c\"",
                                 "an 'apostrophe' #",
                                 "M\xC3\xBCller #\x01"})
    {
      Declared written(true), read(true);
      write(name, "1,2\n");
      written.parameters.set("Title", name);
      written.parameters.set("Chip/Density", "1 g/cm3");
      written.parameters.set("Chip/Height map", (folder / name).string());
      std::ostringstream text;
      written.parameters.write_prm(text);
      read.parameters.read_text(text.str(), "x.prm");
      EXPECT_EQ(read.sample.title, name);
      EXPECT_EQ(read.sample.height_map, (folder / name).string());
    }
}

TEST_F(ParameterFiles, a_value_between_quotation_marks_is_taken_as_it_stands)
{
  write("a #1.prm", "set Title = \"b # \\\"c\\\" \" # set Title = \"d\"\n");
  Declared declared;
  declared.parameters.read_file(
    write("main.prm",
          "include \"a #1.prm\" # a comment\n"
          "subsection Load\n set Pressure = \"7 MPa\"#comment\nend\n"));
  EXPECT_EQ(declared.sample.title, "b # \"c\" ");
  EXPECT_EQ(declared.sample.pressure, 7e6);
}

TEST_F(ParameterFiles, a_quotation_mark_needs_its_partner)
{
  const std::string begin = "x.prm, line 1: ";
  for (const std::string text : {"set Title = \"a # b\n",
                                 "set Title = \"a \\\"\n",
                                 "include \"\n",
                                 "set Title = \\\n \"a # b\"\n"})
    EXPECT_EQ(Declared().message_of(text),
              begin + "The text behind the quotation mark has no second one at "
                      "its end.")
      << text;
  EXPECT_EQ(Declared().message_of("set Title = \"a\" b\n"),
            begin + "Something stands behind the second quotation mark; "
                    "inside of the text it is written \\\".");
}

TEST_F(ParameterFiles, a_line_break_inside_of_a_name_is_refused)
{
  const std::string map = (folder / "two\nlines").string();
  write("two\nlines", "1,2\n");
  Declared declared(true);
  try
    {
      declared.parameters.set("Title", "two\rlines");
      FAIL() << "no error";
    }
  catch (const InputError &error)
    {
      EXPECT_STREQ(error.what(),
                   "entry 'Title': 'two?lines' has a line break, which a "
                   "parameter file cannot hold; a text of one line is "
                   "expected.");
    }
  EXPECT_THROW(declared.parameters.set("Chip/Height map", map), InputError);
}
