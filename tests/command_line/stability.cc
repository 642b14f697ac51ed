#include "program.h"

using namespace asperity;

// tools/stability on a few cells, from end to end.

namespace
{
  class Stability : public Program
  {
  protected:
    Result
    sweep(const std::string &arguments) const
    {
      const std::string command =
        "cd '" + folder.string() +
        "' && /usr/bin/python3 '" ASPERITY_SOURCE_DIR
        "/tools/stability' --asperity '" ASPERITY_PROGRAM
        "' --to maps --jobs 1 " +
        arguments + " >output.txt 2>errors.txt";
      const int status = std::system(command.c_str());
      return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
              read("output.txt"),
              read("errors.txt")};
    }

    bool
    can_draw() const
    {
      return std::system("/usr/bin/python3 -c 'import matplotlib' "
                         "2>/dev/null") == 0;
    }
  };
} // namespace

TEST_F(Stability, sweeps_goes_on_and_writes_maps_and_page)
{
  if (!can_draw())
    GTEST_SKIP() << "matplotlib is missing";
  // A block that slides by Coulomb's law: friction is that of the spots.
  Result result = sweep("--first 2 C14");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output.find("C14: 2 cells, 2 of them new"),
            std::string::npos)
    << result.output;
  result = sweep("--first 1 C14");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output.find("C14: 3 cells, 1 of them new"),
            std::string::npos)
    << result.output;
  const std::string table = read("maps/C14.csv");
  EXPECT_EQ(table.find("# C14: "), 0u);
  for (const char *head :
       {"\n# program: asperity ", "\n# machine: ", "\n# date: "})
    EXPECT_NE(table.find(head), std::string::npos) << table;
  // Without friction at the spots the block slides freely.
  const std::size_t row = table.find("\n2,0,1e-6,");
  ASSERT_NE(row, std::string::npos) << table;
  double mu = 1.;
  EXPECT_EQ(std::sscanf(&table[row], "\n2,0,1e-6,%lf,", &mu), 1) << table;
  EXPECT_NEAR(mu, 0., 1e-12);
  EXPECT_NE(table.find(",values,right,", row), std::string::npos) << table;
  EXPECT_TRUE(std::filesystem::exists(folder / "maps/C14.png"));
  const std::string page = read("maps/README.md");
  EXPECT_NE(page.find("| [C14](#c14) | "), std::string::npos) << page;
  EXPECT_NE(page.find("![C14](C14.png)"), std::string::npos) << page;
}

TEST_F(Stability, refuses_a_mode_that_it_does_not_know)
{
  const Result result = sweep("C30");
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.errors.find("Error: There is no failure mode 'C30' here; "
                               "there are C1, C2, "),
            0u)
    << result.errors;
  EXPECT_FALSE(std::filesystem::exists(folder / "maps"));
}
