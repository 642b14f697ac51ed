#include <asperity/base/folder_lock.h>

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <random>
#include <sstream>
#include <thread>
#include <tuple>
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

    /** 16 x 4 heights in um. */
    std::string
    map(const double amplitude) const
    {
      std::ostringstream text;
      text << std::fixed << std::setprecision(4);
      for (unsigned int j = 0; j < 4; ++j)
        for (unsigned int i = 0; i < 16; ++i)
          text << 1. + amplitude * std::sin(2. * M_PI * i / 16.)
               << (i < 15 ? " " : "\n");
      return text.str();
    }

    /** The tool of a scene, from such a map. */
    std::string
    measured(const std::string &file) const
    {
      return "subsection Tool\n set Kind = measured\n subsection Topography\n"
             "  set File = " +
             file +
             "\n  set Height unit = um\n"
             "  set Spacing x = 0.6 um\n  set Spacing y = 0.6 um\n"
             "  set F-operator = none\n  set S-filter nesting index = 0 um\n"
             "  set L-filter nesting index = 0 um\n end\nend\n";
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
  EXPECT_NE(failed.errors.find("The last good state is in 'run/checkpoint'."),
            std::string::npos)
    << failed.errors;
  EXPECT_EQ(std::count(failed.errors.begin(), failed.errors.end(), '\n'), 1);
  EXPECT_FALSE(std::filesystem::is_empty(folder / "run" / "checkpoint"));
  EXPECT_FALSE(std::filesystem::exists(folder / "run" / "summary.json"));

  // With a solver that is allowed to work, the same run ends well.
  write("scene.prm", scene("run", true));
  const Result rest = run("scene.prm");
  EXPECT_EQ(rest.status, 0) << rest.errors;
  EXPECT_NE(
    read("run/summary.json").find("\"mechanisms\": [\n    \"ploughing\"\n  ]"),
    std::string::npos);
}

TEST_F(Restart, without_a_checkpoint_is_refused)
{
  write("scene.prm", scene("nowhere", true));
  const Result result = run("scene.prm");
  EXPECT_EQ(result.status, 2) << result.output << result.errors;
  EXPECT_EQ(result.errors,
            "Error: scene.prm, line 14, entry 'Output/Restart': The folder "
            "'nowhere/checkpoint' holds no checkpoint to restart from.\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "nowhere"));
  std::filesystem::create_directories(folder / "nowhere" / "checkpoint");
  EXPECT_EQ(run("scene.prm").errors, result.errors);
}

TEST_F(Restart, with_other_inputs_is_refused_and_touches_nothing)
{
  write("first.prm", scene("run", false));
  ASSERT_EQ(run("first.prm").status, 0);
  const std::string summary    = read("run/summary.json");
  const std::string parameters = read("run/parameters.prm");
  for (const auto &[section, entry, change] :
       std::vector<std::tuple<std::string, std::string, std::string>>{
         {"Load", "Pressure = 900 MPa", "was 300 MPa and is 900 MPa"},
         {"Load", "Temperature = 600 degC", "was 25 degC and is 600 degC"},
         {"Load", "Velocity = 2 m/s", "was 200 m/min and is 120 m/min"},
         {"Geometry", "Chip height = 6 um", "was 5 um and is 6 um"},
         {"Mesh", "Degree = 3", "was 2 and is 3"},
         {"Contact", "Penalty factor = 9", "was 8 and is 9"},
         {"Material",
          "Density = 7000 kg/m3",
          "was 7800 kg/m3 and is 7000 kg/m3"},
         {"Solver", "Tolerance = 1e-5", "was 0.0001 and is 1e-05"}})
    {
      write("second.prm",
            scene("run",
                  true,
                  "subsection " + section + "\n set " + entry + "\nend\n"));
      const Result      result = run("second.prm");
      const std::string name   = entry.substr(0, entry.find(" ="));
      EXPECT_EQ(result.status, 2) << result.output;
      EXPECT_EQ(result.output, "");
      EXPECT_EQ(result.errors.find(
                  "Error: second.prm, line 14, entry "
                  "'Output/Restart': the checkpoint "
                  "'run/checkpoint/step_24.checkpoint' is of a "
                  "run with other inputs: entry '" +
                  section + "/" + name + "' " + change),
                0u)
        << result.errors;
    }
  EXPECT_EQ(read("run/summary.json"), summary);
  EXPECT_EQ(read("run/parameters.prm"), parameters);
}

TEST_F(Restart, in_other_words_or_with_another_output_goes_on)
{
  write("first.prm", scene("run", false));
  ASSERT_EQ(run("first.prm").status, 0);
  const auto expected = table("run");
  write("common.prm", "subsection Load\n set Pressure = 0.3 GPa\nend\n");
  write("second.prm",
        "include common.prm\n" +
          scene("run",
                true,
                "subsection Solver\n set Maximum iterations = 30\nend\n"));
  std::filesystem::remove(folder / "run/checkpoint/step_24.checkpoint");
  const Result rest = run("second.prm");
  ASSERT_EQ(rest.status, 0) << rest.errors;
  EXPECT_NE(rest.output.find("Restart after step 21\n"), std::string::npos);
  EXPECT_EQ(table("run"), expected);

  // A run that has ended ends again, here with another mean.
  std::string text  = scene("run", true);
  const auto  place = text.find(" set Ramp steps");
  write("second.prm", text.insert(place, " set Window fraction = 0.25\n"));
  const Result again = run("second.prm");
  ASSERT_EQ(again.status, 0) << again.errors;
  EXPECT_EQ(table("run"), expected);
  EXPECT_NE(read("run/summary.json").find("1.875e-07"), std::string::npos);

  // What an included file says belongs to the inputs.
  write("common.prm", "subsection Load\n set Pressure = 0.4 GPa\nend\n");
  write("second.prm", "include common.prm\n" + scene("run", true));
  EXPECT_NE(
    run("second.prm").errors.find("'Load/Pressure' was 300 MPa and is 400 MPa"),
    std::string::npos);
}

TEST_F(Restart, with_another_height_map_is_refused)
{
  write("tool.txt", map(0.2));
  write("first.prm", scene("run", false, measured("tool.txt")));
  const Result first = run("first.prm");
  ASSERT_EQ(first.status, 0) << first.errors;
  write("second.prm", scene("run", true, measured("tool.txt")));
  std::filesystem::copy(folder / "tool.txt", folder / "same.txt");
  ASSERT_EQ(run("second.prm").status, 0);
  write("tool.txt", map(0.3));
  const Result second = run("second.prm");
  EXPECT_EQ(second.status, 2) << second.output;
  EXPECT_NE(second.errors.find("entry 'Tool/Topography/File' was the file "
                               "'tool.txt' (MD5 "),
            std::string::npos)
    << second.errors;
  // By another name, the old content is the same tool.
  std::string moved = scene("run", true, measured("tool.txt"));
  moved.replace(moved.find("tool.txt"), 8, "same.txt");
  write("second.prm", moved);
  EXPECT_EQ(run("second.prm").status, 0);
}

TEST_F(Restart, goes_on_by_its_written_parameters_whatever_names_hold)
{
  write("tool #1 \\.txt", map(0.2));
  write("first.prm",
        scene("\"run #1\"", false, measured("\"tool #1 \\\\.txt\"")));
  const Result first = run("first.prm");
  ASSERT_EQ(first.status, 0) << first.errors;
  std::filesystem::remove(folder / "run #1/checkpoint/step_24.checkpoint");
  std::string text = read("run #1/parameters.prm");
  text.replace(text.find("set Restart = false"), 19, "set Restart = true");
  std::filesystem::create_directories(folder / "elsewhere");
  write("elsewhere/second.prm", text);
  const Result second = run("elsewhere/second.prm");
  EXPECT_EQ(second.status, 0) << second.errors;
  EXPECT_NE(second.output.find("Restart after step 21\n"), std::string::npos)
    << second.output;
}

TEST_F(Restart, goes_back_to_the_newest_checkpoint_that_is_whole)
{
  write("first.prm", scene("run", false));
  ASSERT_EQ(run("first.prm").status, 0);
  const auto        expected = table("run");
  const std::string newest   = read("run/checkpoint/step_24.checkpoint");
  write("run/checkpoint/step_24.checkpoint",
        newest.substr(0, newest.size() / 2));
  write("second.prm", scene("run", true));
  const Result rest = run("second.prm");
  EXPECT_EQ(rest.status, 0) << rest.errors;
  EXPECT_NE(rest.output.find(
              "Warning: The checkpoint 'run/checkpoint/step_24.checkpoint'"),
            std::string::npos)
    << rest.output;
  EXPECT_NE(rest.output.find("Restart after step 21\n"), std::string::npos);
  EXPECT_EQ(table("run"), expected);
  EXPECT_NE(read("run/summary.json").find("it was cut short"),
            std::string::npos);

  // An older format is named.
  std::string old = newest;
  old[8]          = 1;
  for (const char *step : {"21", "24"})
    write("run/checkpoint/step_" + std::string(step) + ".checkpoint", old);
  const Result refused = run("second.prm");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.errors.find("step_24.checkpoint' has format version 1, but "
                                "this program reads version 4"),
            std::string::npos)
    << refused.errors;
}

TEST_F(Restart, a_new_run_removes_the_results_of_the_old_one)
{
  write("first.prm", scene("run", false));
  ASSERT_EQ(run("first.prm").status, 0);
  const std::string summary = read("run/summary.json");

  // not before its own input is known to be good ...
  write("second.prm",
        scene("run", false, "subsection Tool\n set Kind = measured\nend\n"));
  EXPECT_EQ(run("second.prm").status, 2);
  EXPECT_EQ(read("run/summary.json"), summary);

  // ... and then also if it fails,
  const std::string hopeless = "subsection Load\n set Pressure = 900 MPa\n"
                               "end\nsubsection Solver\n set Maximum "
                               "iterations = 1\n set Maximum cuts = 0\nend\n";
  write("second.prm", scene("run", false, hopeless));
  EXPECT_EQ(run("second.prm").status, 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "run" / "summary.json"));
  EXPECT_EQ(n_rows("run"), 0u);
  EXPECT_FALSE(
    std::filesystem::exists(folder / "run/checkpoint/step_24.checkpoint"));

  // so that its restart cannot take the end of the old one for its own.
  ASSERT_EQ(run("first.prm").status, 0);
  write("second.prm",
        scene("run", false, "subsection Load\n set Pressure = 900 MPa\nend\n"));
  std::filesystem::remove(folder / "run/friction.csv");
  run_and_kill("second.prm", "run", 1);
  write("third.prm",
        scene("run", true, "subsection Load\n set Pressure = 900 MPa\nend\n"));
  EXPECT_EQ(run("third.prm").errors,
            "Error: third.prm, line 14, entry 'Output/Restart': The folder "
            "'run/checkpoint' holds no checkpoint to restart from.\n");
}

TEST_F(Restart, a_folder_takes_one_run_at_a_time)
{
  write("first.prm", scene("run", false));
  std::filesystem::create_directories(folder / "run");
  std::filesystem::create_directory_symlink("run", folder / "link");
  write("second.prm", scene("link", false));
  {
    const FolderLock other((folder / "run").string(), "this test");
    for (const char *file : {"first.prm", "second.prm"})
      {
        const Result refused = run(file);
        EXPECT_EQ(refused.status, 2) << refused.output;
        EXPECT_EQ(refused.output, "");
        EXPECT_NE(refused.errors.find("entry 'Output/Output directory': "
                                      "another process writes into the folder"),
                  std::string::npos)
          << refused.errors;
      }
    EXPECT_FALSE(std::filesystem::exists(folder / "run/parameters.prm"));
  }
  // The lock of a run goes with its process.
  run_and_kill("first.prm", "run", 3);
  EXPECT_EQ(run("second.prm").status, 0);
}
