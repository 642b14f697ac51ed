#include <gtest/gtest.h>

#include <sstream>

#include "sample_parameters.h"

using namespace asperity;

TEST(Parameters, defaults_are_the_values_of_the_struct)
{
  const Declared declared;
  const Sample   fresh;
  EXPECT_EQ(declared.sample.pressure, fresh.pressure);
  EXPECT_EQ(declared.sample.temperature, fresh.temperature);
  EXPECT_FALSE(declared.sample.step);
  EXPECT_EQ(declared.sample.rows, fresh.rows);
  EXPECT_EQ(declared.sample.heights, fresh.heights);
  EXPECT_EQ(declared.parameters.get("Load/Pressure"), "300 MPa");
  EXPECT_EQ(declared.parameters.get("Load/Temperature"), "675 degC");
  EXPECT_EQ(declared.parameters.get("Load/Time step"), "automatic");
  EXPECT_EQ(declared.parameters.get("Load/Inertia"), "quasi-static");
  EXPECT_EQ(declared.parameters.get("Mesh/Heights"), "1 um, 2.5 um");
}

TEST(Parameters, values_with_units_reach_their_variables)
{
  Declared declared;
  declared.parameters.read_text("set Title = wire, cut # comment\n"
                                "subsection Load\n"
                                "  set Pressure = 1.3 GPa\n"
                                "  set Time step = 0.25 ns\n"
                                "  set Inertia = dynamic\n"
                                "  set Restart = true\n"
                                "end\n"
                                "subsection Mesh\n"
                                "  set Spans = 1e2\n"
                                "  set Rows = automatic\n"
                                "  set Heights = 1, \\\n"
                                "    200 nm, 3 mm\n"
                                "  subsection Contact\n"
                                "    set Penalty = 12.5\n"
                                "  end\n"
                                "end\n",
                                "x.prm");
  EXPECT_EQ(declared.sample.title, "wire, cut");
  EXPECT_EQ(declared.sample.pressure, 1.3e9);
  EXPECT_EQ(declared.sample.step.value(), 2.5e-10);
  EXPECT_EQ(declared.sample.inertia, Inertia::full);
  EXPECT_TRUE(declared.sample.restart);
  EXPECT_EQ(declared.sample.spans, 100u);
  EXPECT_FALSE(declared.sample.rows);
  EXPECT_EQ(declared.sample.heights, (std::vector<double>{1e-3, 2e-7, 3e-3}));
  EXPECT_EQ(declared.sample.penalty, 12.5);
}

TEST(Parameters, misspelt_entry_is_refused_with_the_nearest_name)
{
  EXPECT_EQ(Declared().message_of("subsection Load\n set Presure = 1 MPa\nend"),
            "x.prm, line 2: There is no entry 'Presure' in subsection 'Load'; "
            "did you mean 'Pressure' in subsection 'Load'?");
}

TEST(Parameters, entry_in_the_wrong_subsection_is_refused_with_the_right_one)
{
  EXPECT_EQ(Declared().message_of("\nset Penalty = 3\n"),
            "x.prm, line 2: There is no entry 'Penalty' at the top level; did "
            "you mean 'Penalty' in subsection 'Mesh/Contact'?");
  EXPECT_EQ(Declared().message_of("subsection Lod\n set Pressure = 1 MPa\nend"),
            "x.prm, line 2: There is no entry 'Pressure' in subsection 'Lod'; "
            "did you mean 'Pressure' in subsection 'Load'?");
}

TEST(Parameters, entry_without_a_similar_name_points_to_the_reference)
{
  EXPECT_EQ(Declared().message_of("set Wavelength of light = 3 nm"),
            "x.prm, line 1: There is no entry 'Wavelength of light' at the top "
            "level; 'asperity parameters' lists all entries.");
}

TEST(Parameters, wrong_dimension_lists_the_units_accepted)
{
  EXPECT_EQ(
    Declared().message_of("subsection Load\nset Pressure = 3 um\nend"),
    "x.prm, line 2, entry 'Load/Pressure': '3 um' is a length; a stress "
    "is expected, in one of the units Pa, kPa, MPa, GPa, bar, N/m2, "
    "N/mm2.");
}

TEST(Parameters, value_out_of_range_tells_the_range)
{
  EXPECT_EQ(Declared().message_of("subsection Load\nset Pressure=-1 GPa\nend"),
            "x.prm, line 2, entry 'Load/Pressure': '-1 GPa' is out of range; "
            "more than 0 MPa is expected.");
  EXPECT_EQ(Declared().message_of("subsection Mesh\nsubsection Contact\n"
                                  "set Penalty = 2000\nend\nend"),
            "x.prm, line 3, entry 'Mesh/Contact/Penalty': '2000' is out of "
            "range; 0.1 to 1000 is expected.");
}

TEST(Parameters, integers_flags_and_choices_say_what_they_expect)
{
  EXPECT_EQ(Declared().message_of("subsection Mesh\nset Spans = 2.5\nend"),
            "x.prm, line 2, entry 'Mesh/Spans': '2.5' is not a whole number; a "
            "whole number, at least 2 is expected.");
  EXPECT_EQ(Declared().message_of("subsection Mesh\nset Rows = 0\nend"),
            "x.prm, line 2, entry 'Mesh/Rows': '0' is out of range; a whole "
            "number, at least 1 is expected, or the word 'automatic'.");
  EXPECT_EQ(Declared().message_of("subsection Load\nset Restart = yes\nend"),
            "x.prm, line 2, entry 'Load/Restart': 'yes' is neither 'true' nor "
            "'false'.");
  EXPECT_EQ(Declared().message_of("subsection Load\nset Inertia = some\nend"),
            "x.prm, line 2, entry 'Load/Inertia': 'some' is not a choice; one "
            "of quasi-static, dynamic is expected.");
}

TEST(Parameters, all_missing_mandatory_entries_are_named_at_once)
{
  EXPECT_EQ(Declared(true).message_of(""),
            "x.prm: The mandatory entries 'Chip/Density' (density), "
            "'Chip/Height map' (file) are missing.");
  EXPECT_EQ(Declared(true).message_of(
              "subsection Chip\nset Height map = nowhere.x3p\nend"),
            "x.prm, line 2, entry 'Chip/Height map': the file 'nowhere.x3p' "
            "does not exist or cannot be read.");
}

TEST(Parameters, broken_structure_is_refused_with_its_line)
{
  EXPECT_EQ(Declared().message_of("subsection Load\n"),
            "x.prm: The file ends inside of subsection 'Load'; an 'end' is "
            "missing.");
  EXPECT_EQ(Declared().message_of("end\n"),
            "x.prm, line 1: This 'end' closes no subsection.");
  EXPECT_EQ(Declared().message_of("\nset Title wire\n"),
            "x.prm, line 2: This 'set' has no '=' between entry and value.");
  EXPECT_EQ(Declared().message_of("Title = wire"),
            "x.prm, line 1: The line is not understood; it should be "
            "'subsection NAME', 'set KEY = VALUE', 'end', 'include FILE' or a "
            "comment after '#'.");
  EXPECT_EQ(Declared().message_of("set Title = a\nset Title = b\n"),
            "x.prm, line 2: The entry 'Title' has already been set in line 1.");
}

TEST(Parameters, a_comment_begins_after_a_blank_only)
{
  Declared declared;
  declared.parameters.read_text(
    "# first\nset Title = a#1/out#2 # set Title = b\n"
    "subsection Load\t# of the chip\n#end\nend",
    "x.prm");
  EXPECT_EQ(declared.sample.title, "a#1/out#2");
}

TEST(Parameters, marks_of_text_encodings_are_skipped_or_named)
{
  Declared declared;
  declared.parameters.read_text("\xEF\xBB\xBFset Title = b\r\n", "x.prm");
  EXPECT_EQ(declared.sample.title, "b");
  EXPECT_EQ(Declared().message_of(std::string("\xFF\xFEs\0e\0t\0", 8)),
            "x.prm: The text is in UTF-16; UTF-8 is expected (an editor's "
            "'save as' offers it).");
  EXPECT_EQ(Declared().message_of(std::string("\nset\0Title = a\n", 16)),
            "x.prm, line 2: There are bytes that are no text; a parameter file "
            "is expected.");
}

TEST(Parameters, words_of_a_foreign_file_stay_in_it)
{
  const std::string message = Declared().message_of("password = hunter2\n");
  EXPECT_EQ(message.find("hunter2"), std::string::npos) << message;
  EXPECT_EQ(message.find("password"), std::string::npos) << message;
}

TEST(Parameters, long_lines_are_shown_in_part)
{
  const std::string x(1000000, 'x');
  EXPECT_EQ(Declared().message_of("set " + x + " = 1\n"),
            "x.prm, line 1: There is no entry '" + x.substr(0, 57) +
              "...' at the top level; 'asperity parameters' lists all "
              "entries.");
  for (const std::string &text :
       {x,
        "subsection Mesh\nset Spans = " + x + "\nend",
        "subsection Mesh\nset Heights = " + x + "\nend",
        "subsection Load\nset Pressure = " + x + "\nend",
        "subsection Load\nset Pressure = 1 " + x + "\nend",
        "subsection Load\nset Inertia = " + x + "\nend",
        "subsection Load\nset Restart = " + x + "\nend",
        "subsection " + x + "\nset Title = a\nend"})
    EXPECT_LT(Declared().message_of(text).size(), 400u);
}

TEST(Parameters, a_decimal_comma_is_refused)
{
  const auto heights = [](const std::string &text) {
    return Declared().message_of("subsection Mesh\nset Heights = " + text +
                                 "\nend");
  };
  const std::string refusal =
    " has a comma between two digits; decimals take a point, and a comma "
    "between two numbers is followed by a blank.";
  for (const std::string text : {"0,16 um", "0,16 um, 0,12 um", "1, 0,16 um"})
    EXPECT_EQ(heights(text),
              "x.prm, line 2, entry 'Mesh/Heights': '" + text + "'" + refusal);
  Declared declared;
  for (const std::string text : {"1, 16 um", "1 um,16 um", "1e-3 mm,16 um"})
    {
      declared.parameters.set("Mesh/Heights", text);
      EXPECT_EQ(declared.sample.heights, (std::vector<double>{1e-6, 16e-6}));
    }
  EXPECT_EQ(Declared().message_of("subsection Load\nset Pressure = 300,5 MPa\n"
                                  "end"),
            "x.prm, line 2, entry 'Load/Pressure': '300,5 MPa' has a decimal "
            "comma; a decimal point is expected.");
  EXPECT_EQ(Declared().message_of("subsection Mesh\nsubsection Contact\n"
                                  "set Penalty = 0,5\nend\nend"),
            "x.prm, line 3, entry 'Mesh/Contact/Penalty': '0,5' has a decimal "
            "comma; a decimal point is expected.");
}

TEST(Parameters, relations_between_entries_can_name_their_place)
{
  Declared declared;
  declared.parameters.read_text("\nset Title = x\n", "x.prm");
  EXPECT_EQ(declared.parameters.where("Title"), "x.prm, line 2, entry 'Title'");
  EXPECT_EQ(declared.parameters.where("Mesh/Rows"), "entry 'Mesh/Rows'");
}

TEST(Parameters, an_entry_is_set_by_its_path)
{
  Declared declared;
  declared.parameters.set("Load/Pressure", "2 GPa");
  EXPECT_EQ(declared.sample.pressure, 2e9);
  EXPECT_THROW(declared.parameters.set("Load/Presure", "2 GPa"), InputError);
  EXPECT_THROW(declared.parameters.set("", "2 GPa"), InputError);
}

TEST(Parameters, a_wrong_default_or_a_second_declaration_is_a_programming_error)
{
  dealii::ParameterHandler handler;
  ParameterDeclarator      parameters(handler);
  double                   negative = -1, positive = 1;
  EXPECT_THROW(parameters.number("a", negative, Range::positive(), "A."),
               std::logic_error);
  parameters.number("b", positive, Range::positive(), "B.");
  EXPECT_THROW(parameters.number("b", positive, Range::positive(), "B."),
               std::logic_error);
}

TEST(Parameters, the_written_file_read_again_gives_the_same_values)
{
  Declared first;
  first.parameters.read_text("subsection Load\n set Pressure = 0.7 N/mm2\n"
                             " set Temperature = 71.3 degF\n"
                             " set Inertia = dynamic\nend\n"
                             "subsection Mesh\n set Rows = automatic\nend\n",
                             "x.prm");
  std::ostringstream written;
  first.parameters.write_prm(written);
  EXPECT_NE(written.str().find("set Pressure = 0.7 N/mm2"), std::string::npos)
    << "values are written as they were given";

  Declared second;
  second.parameters.read_text(written.str(), "parameters.prm");
  EXPECT_EQ(second.sample.title, first.sample.title);
  EXPECT_EQ(second.sample.pressure, first.sample.pressure);
  EXPECT_EQ(second.sample.temperature, first.sample.temperature);
  EXPECT_EQ(second.sample.inertia, first.sample.inertia);
  EXPECT_EQ(second.sample.rows, first.sample.rows);
  EXPECT_EQ(second.sample.heights, first.sample.heights);
  EXPECT_EQ(second.sample.penalty, first.sample.penalty);
  std::ostringstream again;
  second.parameters.write_prm(again);
  EXPECT_EQ(again.str(), written.str());
}

TEST(Parameters, the_written_file_is_one_that_deal_ii_reads)
{
  Declared           declared;
  std::ostringstream written;
  declared.parameters.write_prm(written);
  dealii::ParameterHandler handler;
  Sample                   sample;
  ParameterDeclarator      parameters(handler);
  sample.declare(parameters);
  handler.parse_input_from_string(written.str());
  EXPECT_EQ(handler.get({"Mesh", "Contact"}, "Penalty"), "20");
}

TEST(Parameters, the_reference_holds_default_range_and_meaning)
{
  Declared           declared(true);
  std::ostringstream out;
  declared.parameters.write_markdown(out);
  const std::string reference = out.str();
  for (const std::string line :
       {"## Mesh/Contact\n",
        "| Pressure | `300 MPa` | stress: more than 0 MPa | Load p. |\n",
        "| Penalty | `20` | number: 0.1 to 1000 | Dimensionless penalty c in c "
        "E/h. |\n",
        "| Inertia | `quasi-static` | choice: quasi-static, dynamic | Whether "
        "mass resists. |\n",
        "| Density | **mandatory** | density: more than 0 kg/m3 | Mass "
        "density. |\n"})
    EXPECT_NE(reference.find(line), std::string::npos) << line << reference;
}

TEST(Parameters, a_comment_may_follow_a_number_or_a_word_without_a_blank)
{
  Declared declared;
  declared.parameters.read_text("set Title = a#1/b # comment\n"
                                "subsection Mesh# comment\n"
                                "set Spans = 40# comment\nend# comment\n",
                                "x.prm");
  EXPECT_EQ(declared.sample.title, "a#1/b");
  EXPECT_EQ(declared.sample.spans, 40u);
}
