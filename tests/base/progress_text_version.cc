#include <asperity/base/progress.h>
#include <asperity/base/text.h>
#include <asperity/base/version.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

using namespace asperity;

TEST(Progress, a_log_stays_short_and_always_has_the_last_step)
{
  std::ostringstream out;
  {
    ProgressLine progress(out, ProgressLine::Mode::log);
    for (unsigned int step = 1; step <= 1000; ++step)
      progress.update(step / 1000., "mu = 0.21 at " + std::to_string(step));
  }
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
  EXPECT_EQ(text.find("mu = 0.21 at 1  ("), 0u) << text;
  EXPECT_NE(text.find("\nmu = 0.21 at 1000  ("), std::string::npos);
  EXPECT_EQ(text.find('\r'), std::string::npos);
}

TEST(Progress, a_terminal_line_is_rewritten_in_place)
{
  std::ostringstream out;
  {
    ProgressLine progress(out, ProgressLine::Mode::terminal);
    progress.update(0.5, "half");
    progress.note("The step was cut.");
    progress.update(1., "all");
  }
  const std::string text = out.str();
  EXPECT_EQ(text.substr(0, 6), "\rhalf ");
  EXPECT_NE(text.find("left)\nThe step was cut.\n\rall"), std::string::npos)
    << text;
  EXPECT_EQ(text.back(), '\n');
}

TEST(Progress, a_silent_line_prints_nothing)
{
  std::ostringstream out;
  ProgressLine       progress(out, ProgressLine::Mode::silent);
  progress.update(1., "all");
  progress.note("nothing");
  EXPECT_TRUE(out.str().empty());
}

TEST(Progress, durations_are_written_for_people)
{
  EXPECT_EQ(format_duration(0.04), "0.0 s");
  EXPECT_EQ(format_duration(7.26), "7.3 s");
  EXPECT_EQ(format_duration(9.96), "10 s");
  EXPECT_EQ(format_duration(200.4), "3 min 20 s");
  EXPECT_EQ(format_duration(7500), "2 h 5 min");
}

TEST(Text, edit_distance_counts_elementary_edits)
{
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("Pressure", "pressure"), 0u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("Titel", "Title"), 1u); // a swap
  EXPECT_EQ(edit_distance("", "abc"), 3u);
}

TEST(Text, split_and_join_are_inverse)
{
  const std::vector<std::string> parts = {"a b", "", "c"};
  EXPECT_EQ(split("a b,, c ", ','), parts);
  EXPECT_EQ(join(parts, ","), "a b,,c");
  EXPECT_TRUE(split("  ", ',').empty());
}

TEST(Text, that_somebody_wrote_is_quoted_in_part_and_a_name_in_full)
{
  EXPECT_EQ(quoted_text("7 cats"), "'7 cats'");
  EXPECT_EQ(quoted_text(""), "''");
  const std::string sixty(60, 'x');
  EXPECT_EQ(quoted_text(sixty), "'" + sixty + "'");
  EXPECT_EQ(quoted_text(sixty + "y"), "'" + sixty.substr(3) + "...'");
  EXPECT_EQ(quoted_name(sixty + "y"), "'" + sixty + "y'");
  EXPECT_EQ(quoted_name(std::string(4096, 'x')).size(), 4098u);
  EXPECT_EQ(quoted_name(std::string(4097, 'x')),
            "'" + std::string(57, 'x') + "...'");
}

TEST(Text, in_messages_has_no_control_characters_and_no_half_ones)
{
  EXPECT_EQ(printable("a\tb\n\x1b[2Jc\x7f"), "a?b??[2Jc?");
  EXPECT_EQ(printable("M\xC3\xBCller \xE2\x82\xAC"), // umlaut, euro sign
            "M\xC3\xBCller \xE2\x82\xAC");
  EXPECT_EQ(printable("\xC2\x9B \xFF \xC3"), "? ? ?");
  // 56 and 2 bytes: the umlaut would be cut into halves
  EXPECT_EQ(quoted_text(std::string(56, 'x') + "\xC3\xBCyyyyyy"),
            "'" + std::string(56, 'x') + "...'");
}

TEST(Version, names_the_program_and_its_libraries)
{
  EXPECT_EQ(version_line().find("asperity " + version() + " ("), 0u);
  const nlohmann::ordered_json json = version_json();
  for (const char *const key : {"git_revision", "build_type", "deal.II"})
    EXPECT_FALSE(json[key].get<std::string>().empty()) << key;
}
