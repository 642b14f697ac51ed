#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <sstream>
#include <thread>
#include <vector>

#include "program.h"

// The program is killed without warning, and goes on from its checkpoint.

using namespace asperity;

namespace
{
  class Restart : public Program
  {
  protected:
    /** The reference scene R0 on a coarse mesh. */
    std::string
    scene(const std::string &directory,
          const bool         restart,
          const std::string &further = "") const
    {
      return "subsection Mesh\n set Spans = 32\n set Refinement levels = 1\n"
             "end\nsubsection Protocol\n set Ramp steps = 6\n"
             " set Slide steps = 18\n set Inertia = quasi-static\nend\n"
             "subsection Output\n set Output directory = " +
             directory +
             "\n set Picture interval = 4\n set Checkpoint interval = 3\n"
             " set Restart = " +
             (restart ? "true" : "false") + "\nend\n" + further;
    }

    unsigned int
    n_rows(const std::string &directory) const
    {
      const std::string text = read(directory + "/friction.csv");
      const auto        n    = std::count(text.begin(), text.end(), '\n');
      return n > 0 ? n - 1 : 0;
    }

    /** Starts the program and kills it as soon as its table has so many rows.
     */
    void
    run_and_kill(const std::string &file,
                 const std::string &directory,
                 const unsigned int rows) const
    {
      const pid_t process = fork();
      ASSERT_GE(process, 0);
      if (process == 0)
        {
          const int sink = open("/dev/null", O_WRONLY);
          dup2(sink, 1);
          dup2(sink, 2);
          if (chdir(folder.c_str()) == 0)
            execl(ASPERITY_PROGRAM, "asperity", file.c_str(), nullptr);
          _exit(127);
        }
      int status = 0;
      while (n_rows(directory) < rows &&
             waitpid(process, &status, WNOHANG) == 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
      kill(process, SIGKILL);
      waitpid(process, &status, 0);
      EXPECT_TRUE(WIFSIGNALED(status)) << "the run ended before it was killed";
    }

    /** The rows of the table without the last column, the wall time. */
    std::vector<std::string>
    table(const std::string &directory) const
    {
      std::istringstream       text(read(directory + "/friction.csv"));
      std::vector<std::string> rows;
      for (std::string line; std::getline(text, line);)
        rows.push_back(line.substr(0, line.rfind(',')));
      return rows;
    }

    /** The list of pictures, without its date. */
    std::string
    series(const std::string &directory) const
    {
      const std::string text = read(directory + "/chip.pvd");
      return text.substr(std::min(text.size(), text.find("<Collection>")));
    }
  };
} // namespace

TEST_F(Restart, a_killed_run_goes_on_as_if_nothing_had_happened)
{
  write("whole.prm", scene("whole", false));
  ASSERT_EQ(run("whole.prm").status, 0);
  const auto         expected = table("whole");
  const unsigned int seed     = std::random_device()();
  std::mt19937       random(seed);
  for (unsigned int i = 0; i < 3; ++i)
    {
      // The first checkpoint is complete when the row after it is written.
      const unsigned int kill_at =
        std::uniform_int_distribution<unsigned int>(4, 20)(random);
      const std::string name = "killed" + std::to_string(i);
      SCOPED_TRACE("seed " + std::to_string(seed) + ", killed at step " +
                   std::to_string(kill_at));
      write("first.prm", scene(name, false));
      run_and_kill("first.prm", name, kill_at);
      write("second.prm", scene(name, true));
      const Result rest = run("second.prm");
      EXPECT_EQ(rest.status, 0) << rest.errors;
      EXPECT_NE(rest.output.find("Restart after step"), std::string::npos);
      EXPECT_EQ(table(name), expected);
      EXPECT_EQ(series(name), series("whole"));
    }
}

TEST_F(Restart, a_run_that_gives_up_leaves_its_state_and_a_sentence)
{
  const std::string hopeless = "subsection Solver\n set Maximum iterations = "
                               "2\n set Maximum cuts = 0\nend\n";
  write("scene.prm", scene("run", false, hopeless));
  const Result failed = run("scene.prm");
  EXPECT_EQ(failed.status, 1) << failed.output;
  EXPECT_EQ(failed.errors.find("Error: Step "), 0u) << failed.errors;
  EXPECT_NE(failed.errors.find("failed after 0 cuts"), std::string::npos);
  EXPECT_NE(failed.errors.find("The last good state is in run/checkpoint."),
            std::string::npos)
    << failed.errors;
  EXPECT_EQ(std::count(failed.errors.begin(), failed.errors.end(), '\n'), 1);
  EXPECT_FALSE(std::filesystem::is_empty(folder / "run" / "checkpoint"));
  EXPECT_FALSE(std::filesystem::exists(folder / "run" / "summary.json"));

  // With a solver that is allowed to work, the same run ends well.
  write("scene.prm", scene("run", true));
  const Result rest = run("scene.prm");
  EXPECT_EQ(rest.status, 0) << rest.errors;
  EXPECT_TRUE(std::filesystem::exists(folder / "run" / "summary.json"));
}

TEST_F(Restart, without_a_checkpoint_is_refused)
{
  write("scene.prm", scene("nowhere", true));
  const Result result = run("scene.prm");
  EXPECT_EQ(result.status, 2) << result.output << result.errors;
  EXPECT_NE(result.errors.find("nowhere/checkpoint"), std::string::npos)
    << result.errors;
}
