#include <asperity/base/errors.h>
#include <asperity/base/input_record.h>
#include <asperity/base/parameters.h>

#include <deal.II/base/parameter_handler.h>

#include "../files.h"

using namespace asperity;

namespace
{
  enum class Kind
  {
    flat,
    measured
  };

  /** The inputs of a program, as a file says them. */
  InputRecord
  record(const std::string &text)
  {
    double                      pressure = 3e8, length = 1e-5;
    std::optional<double>       distance;
    std::optional<unsigned int> spans;
    unsigned int                steps   = 10;
    bool                        restart = false;
    Kind                        kind    = Kind::flat;
    std::vector<double>         amplitudes;
    std::string                 file;
    dealii::ParameterHandler    handler;
    ParameterDeclarator         parameters(handler);
    {
      const auto in_section = parameters.subsection("Load");
      parameters.quantity("Pressure", pressure, "MPa", Range::any(), "p.");
      parameters.quantity("Length", length, "um", Range::any(), "L.");
      parameters.quantity("Distance", distance, "um", Range::any(), "s.");
      parameters.integer("Steps", steps, Range::any(), "n.");
      parameters.integer("Spans", spans, Range::any(), "m.");
      parameters.flag("Restart", restart, "Whether.");
      parameters.choice("Kind",
                        kind,
                        {{"flat", Kind::flat}, {"measured", Kind::measured}},
                        "Which.");
      parameters.list("Amplitudes", amplitudes, "um", Range::any(), "a.");
      parameters.file("File", file, "The map.");
    }
    parameters.read_text("subsection Load\n" + text + "end\n", "a.prm");
    return InputRecord(parameters);
  }

  std::string
  change(const std::string &then, const std::string &now)
  {
    return record(now).change_since(record(then), [](const std::string &path) {
      return path == "Load/Restart";
    });
  }
} // namespace



TEST(InputRecord, the_same_values_in_other_words_agree)
{
  for (const auto &[then, now] :
       std::vector<std::pair<const char *, const char *>>{
         {"", "set Pressure = 0.3 GPa\n"},
         {"set Length = 160 nm\n", "set Length = 0.16 um\n"},
         {"set Steps = 10\n", "set Steps = 1e1\n"},
         {"set Distance = automatic\n", ""},
         {"set Distance = 1 mm\n", "set Distance = 1000 um\n"},
         {"set Amplitudes = 160 nm, 0.2 um\n",
          "set Amplitudes = 0.16, 0.20 um\n"},
         {"", "set Restart = true\n"}})
    EXPECT_EQ(change(then, now), "") << then << now;
}



TEST(InputRecord, an_entry_that_changed_is_named_with_both_values)
{
  EXPECT_EQ(change("set Pressure = 300 MPa\n", "set Pressure = 0.9 GPa\n"),
            "entry 'Load/Pressure' was 300 MPa and is 900 MPa");
  EXPECT_EQ(change("", "set Distance = 2 um\n"),
            "entry 'Load/Distance' was automatic and is 2 um");
  EXPECT_EQ(change("set Spans = 4\n", "set Spans = 8\n"),
            "entry 'Load/Spans' was 4 and is 8");
  EXPECT_EQ(change("", "set Kind = measured\n"),
            "entry 'Load/Kind' was flat and is measured");
  EXPECT_EQ(change("set Amplitudes = 1, 2 um\n", "set Amplitudes = 1 um\n"),
            "entry 'Load/Amplitudes' was 1 um, 2 um and is 1 um");
  // a part in 1e14 is no rounding error
  EXPECT_NE(change("set Length = 1 um\n", "set Length = 1.00000000000001 um\n"),
            "");
}



TEST(InputRecord, files_agree_if_their_contents_do)
{
  const std::string a = test_folder() + "/a", b = a + "b";
  overwrite(a, "heights");
  overwrite(b, "heights");
  const std::string set = "set File = ";
  EXPECT_EQ(change(set + a + "\n", set + b + "\n"), "");

  // of the same length
  const InputRecord before = record(set + a + "\n");
  EXPECT_EQ(before.changed_file(), "");
  overwrite(a, "Heights");
  // the digests are those of md5sum
  const std::string sentence = "entry 'Load/File' was the file '" + a +
                               "' (MD5 e5439f340ec51b34d51348e0885bcdf1) and "
                               "is the file '" +
                               a + "' (MD5 a95d49e1976931a8122edecbcffaf610)";
  EXPECT_EQ(before.changed_file(), sentence);
  EXPECT_EQ(record(set + a + "\n")
              .change_since(before, [](const std::string &) { return false; }),
            sentence);
  EXPECT_EQ(change("", set + b + "\n")
              .find("entry 'Load/File' was no file and is the file '" + b +
                    "'"),
            0u);
  std::filesystem::remove(a);
  EXPECT_THROW(before.changed_file(), InputError);
}



TEST(InputRecord, entries_of_newer_programs_do_not_count)
{
  InputRecord earlier = record(""), now = earlier;
  earlier.entries.erase(earlier.entries.begin());
  const auto none = [](const std::string &) { return false; };
  EXPECT_EQ(now.change_since(earlier, none), "");
  EXPECT_EQ(earlier.change_since(now, none),
            "entry 'Load/Pressure' was 300 MPa and is unknown to this program");
}
