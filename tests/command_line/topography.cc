#include "program.h"

using namespace asperity;

using Topography = Program;

namespace
{
  /** Lines of @p n numbers with tabs between them. */
  std::string
  matrix(const unsigned int n, const unsigned int n_rows)
  {
    std::string text;
    for (unsigned int j = 0; j < n_rows; ++j)
      for (unsigned int i = 0; i < n; ++i)
        text +=
          std::to_string((7 * i + 3 * j) % 11) + (i + 1 == n ? "\n" : "\t");
    return text;
  }

  const std::string header =
    "# Width: 16 um\n# Height: 12 um\n# Value units: nm\n";
} // namespace

// The name says nothing; a comment of the map may begin with "set", too.
TEST_F(Topography, takes_a_height_map_itself)
{
  for (const std::string name : {"map.txt", "map.dat"})
    {
      write(name, header + "# set point 5 nN\n" + matrix(16, 12));
      const Result result = run("topography " + name);
      EXPECT_EQ(result.status, 0) << result.errors;
      for (const char *part : {"16 x 12", "1 um x 1 um", "lines of the header"})
        EXPECT_NE(result.output.find(part), std::string::npos) << result.output;
      EXPECT_NE(result.output.find("Written to output/topography/map"),
                std::string::npos);
      EXPECT_NE(read("output/topography/map/report.json").find("\"Sa\""),
                std::string::npos);
    }
}

TEST_F(Topography, refused_map_names_the_entries_and_writes_nothing)
{
  write("map.txt", matrix(16, 12));
  const Result result = run("topography map.txt");
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(result.errors,
            "Error: The surface file 'map.txt' (text, matrix) carries no unit; "
            "give the unit of its heights (Height unit) and the spacing of its "
            "samples (Spacing x, and Spacing y if it differs) in the "
            "subsection Topography of a parameter file.\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "output"));
}

TEST_F(Topography, a_map_with_holes_is_cropped_and_says_so)
{
  std::string text = header;
  for (unsigned int j = 0; j < 12; ++j)
    {
      std::string row = matrix(16, 1);
      text += j < 6 ? row : "Bad\t***" + row.substr(3);
    }
  write("map.txt", text);
  EXPECT_EQ(run("topography map.txt").status, 0);
  std::string most_missing = header + matrix(16, 6);
  for (unsigned int j = 0; j < 6; ++j)
    {
      for (unsigned int i = 0; i < 16; ++i)
        most_missing += i < 15 ? "Bad\t" : "1\n";
    }
  write("holes.txt", most_missing);
  const Result result = run("topography holes.txt");
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output.find("Crop = hole-free was chosen, since 47 % of "),
            std::string::npos)
    << result.output;
}

TEST_F(Topography, skipped_lines_stand_in_the_report)
{
  write("map.txt", "a title\n" + header + matrix(16, 12));
  const Result result = run("topography map.txt");
  EXPECT_NE(result.output.find("3 comments and 1 title line before the first "
                               "row in line 5 were skipped"),
            std::string::npos)
    << result.output;
}
