#include <asperity/base/folder_lock.h>

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <random>
#include <thread>

#include "program.h"

// `asperity characterize` as its users run it: a small campaign of coarse
// scenes, alone, on two ranks, and killed.

using namespace asperity;

namespace
{
  class Characterize : public Program
  {
  protected:
    void
    SetUp() override
    {
      Program::SetUp();
      write("scene.prm",
            "subsection Mesh\n set Spans = 32\n set Refinement levels = 1\n"
            "end\nsubsection Protocol\n set Ramp steps = 4\n"
            " set Slide steps = 8\n set Inertia = quasi-static\nend\n");
    }

    std::string
    campaign(const std::string &directory) const
    {
      return "subsection Campaign\n set Base scene = scene.prm\n"
             " set Output directory = " +
             directory +
             "\n subsection Input 1\n  set Entry = Load/Pressure\n"
             "  set From = 300 MPa\n  set To = 1300 MPa\n end\n"
             " subsection Input 2\n  set Entry = Load/Temperature\n"
             "  set From = 25 degC\n  set To = 700 degC\n end\n"
             " subsection Design\n  set Initial runs = 6\n  set Batch = 2\n"
             "  set Maximum runs = 10\n  set Target error = 1e-9\n"
             "  set Test runs = 2\n end\nend\n";
    }

    /** Starts the campaign and kills it without warning after a while.
     *  @return whether it was still running */
    bool
    run_and_kill(const std::string &file, const double seconds) const
    {
      const pid_t process = fork();
      if (process == 0)
        {
          const int sink = open("/dev/null", O_WRONLY);
          dup2(sink, 1);
          dup2(sink, 2);
          if (chdir(folder.c_str()) == 0)
            execl(ASPERITY_PROGRAM,
                  "asperity",
                  "characterize",
                  file.c_str(),
                  nullptr);
          _exit(127);
        }
      std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
      kill(process, SIGKILL);
      int status = 0;
      waitpid(process, &status, 0);
      return WIFSIGNALED(status);
    }
  };
} // namespace

TEST_F(Characterize, two_ranks_and_kills_do_not_change_the_result)
{
  using Clock = std::chrono::steady_clock;
  write("one.prm", campaign("one"));
  const auto   start = Clock::now();
  const Result alone = run("characterize one.prm");
  const double seconds =
    std::chrono::duration<double>(Clock::now() - start).count();
  ASSERT_EQ(alone.status, 0) << alone.errors;
  EXPECT_NE(alone.output.find("12 runs, 0 failed"), std::string::npos)
    << alone.output;
  const std::string table = read("one/runs.csv");
  ASSERT_NE(table, "");
  for (const char *name :
       {"friction_law.json", "history.csv", "sensitivity.csv", "summary.json"})
    EXPECT_NE(read(std::string("one/") + name), "") << name;

  write("two.prm", campaign("two"));
  const Result shared = run("characterize two.prm", "mpirun -np 2");
  ASSERT_EQ(shared.status, 0) << shared.errors;
  EXPECT_EQ(read("two/runs.csv"), table);

  // Ten kills at random moments; the last start ends by itself.
  write("killed.prm", campaign("killed"));
  std::mt19937 random(7);
  for (unsigned int i = 0; i < 10; ++i)
    run_and_kill("killed.prm",
                 seconds * (0.02 + 0.3 * (random() % 1000) / 1000.));
  const Result last = run("characterize killed.prm");
  ASSERT_EQ(last.status, 0) << last.errors;
  EXPECT_EQ(read("killed/runs.csv"), table);
  EXPECT_EQ(read("killed/friction_law.json").size(),
            read("one/friction_law.json").size());
}

TEST_F(Characterize, check_tells_the_plan_and_the_scene_and_writes_nothing)
{
  write("one.prm", campaign("one"));
  const Result checked = run("check one.prm");
  EXPECT_EQ(checked.status, 0) << checked.errors;
  for (const std::string text :
       {"6 training points (up to 10 by active learning), 2 test points",
        "p: Load/Pressure, 300 MPa to 1300 MPa",
        "Scene audit:",
        "scene.prm is valid.",
        "one.prm is valid."})
    EXPECT_NE(checked.output.find(text), std::string::npos) << text;
  EXPECT_FALSE(std::filesystem::exists(folder / "one"));
}

TEST_F(Characterize, says_that_no_run_chooses_its_settings)
{
  const std::string sentence = "Accuracy/Control of the base scene does not";
  write("one.prm", campaign("one"));
  EXPECT_EQ(run("check one.prm").output.find(sentence), std::string::npos);
  write("scene.prm",
        read("scene.prm") +
          "subsection Accuracy\n set Control = adaptive\nend\n");
  const Result checked = run("check one.prm");
  EXPECT_EQ(checked.status, 0) << checked.errors;
  EXPECT_NE(checked.output.find(sentence), std::string::npos) << checked.output;
}

TEST_F(Characterize, a_campaign_is_not_run_as_a_scene)
{
  write("one.prm", campaign("one"));
  const Result result = run("one.prm");
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.errors,
            "Error: one.prm describes a campaign; 'asperity characterize "
            "one.prm' runs it.\n");
}

TEST_F(Characterize, wrong_input_ends_with_one_sentence)
{
  const auto errors = [&](const std::string &text) {
    write("campaign.prm", text);
    const Result result = run("characterize campaign.prm");
    EXPECT_EQ(result.status, 2);
    return result.errors;
  };
  EXPECT_EQ(errors("subsection Campaign\nend\n"),
            "Error: campaign.prm: The mandatory entry 'Campaign/Base scene' "
            "(file) is missing.\n");
  EXPECT_EQ(errors("subsection Campaign\n set Base scene = scene.prm\nend\n"),
            "Error: entry 'Campaign/Input 1/Entry': found no input; expected "
            "at least one entry of the base scene, such as Load/Pressure.\n");
  EXPECT_EQ(errors("subsection Campaign\n set Base scene = other.prm\nend\n")
              .find(
                "Error: campaign.prm, line 2, entry 'Campaign/Base scene': "),
            0u);
  EXPECT_EQ(run("characterize").errors,
            "Error: 'asperity characterize' takes one parameter file, as in "
            "'asperity characterize scene.prm'.\n");
}

TEST_F(Characterize, a_folder_takes_one_campaign_at_a_time_and_no_run)
{
  write("one.prm", campaign("one"));
  {
    const FolderLock other((folder / "one").string(), "this test");
    const Result     refused = run("characterize one.prm", "mpirun -np 2");
    EXPECT_EQ(refused.status, 2) << refused.output;
    EXPECT_EQ(refused.errors.find("Error: one.prm, line 3, entry "
                                  "'Campaign/Output directory': another "
                                  "process writes into the folder 'one'"),
              0u)
      << refused.errors;
    EXPECT_FALSE(std::filesystem::exists(folder / "one/plan.json"));
  }
  write("one/plan.json", "{}");
  std::filesystem::create_directories(folder / "one/runs");
  write("run.prm",
        "include scene.prm\nsubsection Output\n set Output directory = one\n"
        "end\n");
  EXPECT_EQ(run("run.prm").errors,
            "Error: run.prm, line 3, entry 'Output/Output directory': the "
            "folder 'one' holds the results of a campaign; expected a folder "
            "of its own.\n");
}

// mu(p, wetting, strain) from few runs, to its advice and its export.
TEST_F(Characterize, further_inputs_end_with_a_law_that_answers)
{
  write(
    "oily.prm",
    "subsection Mesh\n set Spans = 32\n set Refinement levels = 1\nend\n"
    "subsection Protocol\n set Ramp steps = 6\n set Slide steps = 12\n"
    " set Inertia = quasi-static\nend\n"
    "subsection Lubrication\n set Model = pocket\n set Wetting = 0.8\nend\n");
  const std::string text =
    "subsection Campaign\n set Base scene = oily.prm\n set Output directory = "
    "law\n subsection Input 1\n  set Entry = Load/Pressure\n"
    "  set From = 300 MPa\n  set To = 900 MPa\n end\n"
    " subsection Input 2\n  set Entry = Lubrication / Wetting\n"
    "  set From = 20 %\n  set To = 1\n end\n"
    " subsection Input 3\n  set Entry = Load/Plastic strain\n"
    "  set From = 0\n  set To = 2\n end\n"
    " subsection Design\n  set Initial runs = 8\n  set Batch = 0\n end\nend\n"
    "subsection Friction law\n set Output = mu at the end\nend\n";
  write("campaign.prm", text);
  const Result checked = run("check campaign.prm");
  ASSERT_EQ(checked.status, 0) << checked.errors;
  EXPECT_NE(checked.output.find(
              "Wetting: Lubrication/Wetting, 20 % to 100 %; an "
              "argument of exported C and Fortran, 80 % in "
              "exported tables (Export at)"),
            std::string::npos)
    << checked.output;
  const Result result = run("characterize campaign.prm");
  ASSERT_EQ(result.status, 0) << result.errors;
  const std::string sentence =
    "This mu comes from ploughing and oil; adhesion, the shear of the dry "
    "interface, is not in it.\n";
  EXPECT_NE(result.output.find(sentence), std::string::npos) << result.output;
  for (const std::string file : {"law/summary.json", "law/friction_law.json"})
    EXPECT_NE(read(file).find("\"mechanisms\": ["), std::string::npos) << file;

  const std::string mark  = "Ask it: asperity ";
  const std::size_t begin = result.output.find(mark);
  ASSERT_NE(begin, std::string::npos);
  const std::string advice =
    result.output.substr(begin + mark.size(),
                         result.output.find('\n', begin) - begin - mark.size());
  EXPECT_EQ(advice,
            "predict law/friction_law.json -p 600MPa --wetting 60% "
            "--plastic-strain 1");
  const Result answer = run(advice);
  EXPECT_EQ(answer.status, 0) << answer.errors;
  EXPECT_EQ(answer.output.find("mu at the end = "), 0u) << answer.output;
  EXPECT_NE(answer.output.find(sentence), std::string::npos);
  for (const std::string file : {"law/export/tribmu.c",
                                 "law/export/tribmu.f",
                                 "law/export/abaqus_friction.inp",
                                 "law/export/friction_table.csv"})
    EXPECT_NE(read(file).find("ploughing and oil; adhesion"), std::string::npos)
      << file;
}

TEST_F(Characterize, a_sensitivity_is_about_a_scene)
{
  write("scene.prm",
        "subsection Tool\n set Kind = flat\nend\n"
        "subsection Mesh\n set Spans = 16\n set Refinement levels = 0\nend\n"
        "subsection Protocol\n set Ramp steps = 2\n set Slide steps = 2\nend\n"
        "subsection Interface\n set Shear law = Coulomb\nend\n"
        "subsection Output\n set Output directory = results\nend\n");
  const Result result = run("sensitivity scene.prm", "mpirun -np 2");
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output.find("mu of the scene: 0.5\n"), std::string::npos)
    << result.output;
  EXPECT_NE(read("results/sensitivity.csv")
              .find("Interface/Friction coefficient,0.55,constants,0.55"),
            std::string::npos);
  EXPECT_NE(read("results/sensitivity.json").find("\"spread\""),
            std::string::npos);
  // Where nothing can be written, nothing is computed.
  write("nowhere.prm",
        "subsection Output\n set Output directory = scene.prm/results\nend\n");
  const Result nowhere = run("sensitivity nowhere.prm", "mpirun -np 2");
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_NE(nowhere.errors.find("nowhere.prm, line 2, entry 'Output/Output "
                                "directory'"),
            std::string::npos)
    << nowhere.errors;
  EXPECT_EQ(nowhere.output.find("runs"), std::string::npos);
  const Result sobol = run("sensitivity scene.prm --sobol 12");
  EXPECT_EQ(sobol.status, 0) << sobol.errors;
  EXPECT_NE(sobol.output.find("shares of the variance of mu"),
            std::string::npos)
    << sobol.output;
  EXPECT_NE(read("results/sensitivity.json").find("\"S1\""), std::string::npos);
  EXPECT_EQ(run("sensitivity scene.prm --sobol few").errors,
            "Error: --sobol: found 'few'; expected a whole number of runs, at "
            "least 12.\n");
  write("one.prm", campaign("one"));
  EXPECT_EQ(run("sensitivity one.prm").errors,
            "Error: one.prm describes a campaign; expected the parameter file "
            "of a scene.\n");
}
