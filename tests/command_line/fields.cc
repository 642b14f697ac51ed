#include <string>

#include "program.h"

// Fields of runs and campaigns: what is kept, what is refused.

using namespace asperity;

namespace
{
  namespace fs = std::filesystem;

  class Fields : public Program
  {
  protected:
    /** A coarse scene of twelve steps. @param output entries of its Output */
    static std::string
    scene(const std::string &output, const std::string &further = "")
    {
      return "subsection Mesh\n set Spans = 32\n set Refinement levels = 1\n"
             "end\nsubsection Protocol\n set Ramp steps = 4\n"
             " set Slide steps = 8\n set Inertia = quasi-static\nend\n" +
             further + "subsection Output\n" + output + "end\n";
    }

    static std::string
    campaign(const std::string &directory)
    {
      return "subsection Campaign\n set Base scene = scene.prm\n"
             " set Output directory = " +
             directory +
             "\n subsection Input 1\n  set Entry = Load/Pressure\n"
             "  set From = 300 MPa\n  set To = 1300 MPa\n end\n"
             " subsection Input 2\n  set Entry = Load/Temperature\n"
             "  set From = 25 degC\n  set To = 700 degC\n end\n"
             " subsection Design\n  set Initial runs = 10\n  set Batch = 0\n"
             "  set Maximum runs = 10\n  set Test runs = 3\n end\nend\n";
    }

    /** What is said of Field times with these entries of other sections. */
    std::string
    refusal_of_times(const std::string &times, const std::string &further = "")
    {
      const std::string errors = refusal(
        "subsection Output\n set Field times = " + times + "\nend\n" + further);
      EXPECT_EQ(errors.find("Error: scene.prm, line 2, entry 'Output/Field "
                            "times': found "),
                0u)
        << errors;
      return errors;
    }
  };
} // namespace

TEST_F(Fields, of_a_run_are_kept_only_if_they_are_asked_for)
{
  write("scene.prm", scene(" set Output directory = out\n"));
  ASSERT_EQ(run("scene.prm").status, 0);
  EXPECT_FALSE(fs::exists(folder / "out/fields.h5"));
  write("scene.prm",
        scene(" set Output directory = out\n set Field times = 0.5, 1\n"));
  const Result result = run("scene.prm");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_TRUE(fs::exists(folder / "out/fields.h5"));
}

TEST_F(Fields, go_on_with_a_run_or_are_missed)
{
  const std::string output = " set Output directory = out\n"
                             " set Field times = 0.2, 1\n"
                             " set Checkpoint interval = 6\n";
  write("scene.prm", scene(output));
  ASSERT_EQ(run("scene.prm").status, 0);
  write("scene.prm", scene(output + " set Restart = true\n"));
  const Result again = run("scene.prm");
  EXPECT_EQ(again.status, 0) << again.errors;
  EXPECT_TRUE(fs::exists(folder / "out/fields.h5"));
  fs::remove(folder / "out/fields.h5");
  const Result missed = run("scene.prm");
  EXPECT_EQ(missed.status, 2);
  EXPECT_EQ(missed.errors,
            "Error: scene.prm, line 14, entry 'Output/Restart': The file "
            "'out/fields.h5' could not be opened; fields of a run are "
            "expected.\n");
}

TEST_F(Fields, refuse_what_they_cannot)
{
  EXPECT_NE(
    refusal_of_times("0.5, 0.2")
      .find(
        "times that do not grow; expected shares of t_end in growing order."),
    std::string::npos);
  EXPECT_NE(refusal_of_times("1",
                             "subsection Geometry\n set Dimension = 3\nend\n")
              .find("times with a patch; expected nothing, or "
                    "Geometry/Dimension = 2."),
            std::string::npos);
  EXPECT_NE(
    refusal_of_times("1",
                     "subsection Mesh\n set Adaptive levels = 1\nend\n"
                     "subsection Protocol\n set Inertia = quasi-static\nend\n")
      .find("times with a mesh that changes; expected nothing, or "
            "Mesh/Adaptive levels = 0."),
    std::string::npos);
  EXPECT_NE(
    refusal_of_times("1", "subsection Accuracy\n set Control = adaptive\nend\n")
      .find("Accuracy/Control = adaptive, which changes the mesh"),
    std::string::npos);
  EXPECT_NE(refusal_of_times(
              "1", "subsection Protocol\n set Friction window = steady\nend\n")
              .find("times with a window that ends when mu is steady"),
            std::string::npos);
  EXPECT_NE(refusal_of_times(
              "1", "subsection Problem\n set Kind = inflatable box\nend\n")
              .find("times with a problem without contact"),
            std::string::npos);
}

TEST_F(Fields, of_each_run_of_a_campaign_are_kept_with_it)
{
  write("scene.prm", scene(" set Field times = 0.5, 1\n"));
  write("one.prm", campaign("one"));
  const Result first = run("characterize one.prm");
  ASSERT_EQ(first.status, 0) << first.errors;
  EXPECT_NE(first.output.find("each run keeps its fields"), std::string::npos);
  for (const char *name : {"0001", "0010", "0013"})
    EXPECT_TRUE(fs::exists(folder / "one/runs" / (std::string(name) + ".h5")))
      << name;
  // A run whose fields are gone is computed again, and no other.
  const auto kept = fs::last_write_time(folder / "one/runs/0001.h5");
  fs::remove(folder / "one/runs/0002.h5");
  ASSERT_EQ(run("characterize one.prm").status, 0);
  EXPECT_TRUE(fs::exists(folder / "one/runs/0002.h5"));
  EXPECT_EQ(fs::last_write_time(folder / "one/runs/0001.h5"), kept);
}

// The whole way: runs, model, fields at a point inside of the box and outside.
TEST_F(Fields, are_learnt_from_a_campaign_and_predicted_where_they_are_trusted)
{
  write("scene.prm", scene(" set Field times = 0.5, 1\n"));
  write("one.prm", campaign("one"));
  ASSERT_EQ(run("characterize one.prm").status, 0);
  const Result reduced = run("reduce one --decoder pod --latent 3");
  ASSERT_EQ(reduced.status, 0) << reduced.errors;
  for (const char *text : {"Fields of 10 runs, 3 more are held out",
                           "Decoder pod, latent size 3",
                           "contact pressure [Pa]",
                           "mu at 1 of the time",
                           "asperity field one/field_model.h5 -p 800MPa"})
    EXPECT_NE(reduced.output.find(text), std::string::npos) << text << "\n"
                                                            << reduced.output;
  EXPECT_EQ(read("one/field_errors.csv").find("quantity,mean error"), 0u);

  const Result inside =
    run("field one/field_model.h5 -p 700MPa -T 300degC --output here");
  ASSERT_EQ(inside.status, 0) << inside.errors;
  EXPECT_NE(inside.output.find("of sliding: mu = "), std::string::npos);
  for (const char *name : {"chip.pvd",
                           "chip_000002.vtu",
                           "contact_000001.vtu",
                           "edge_1.csv",
                           "edge_2.csv"})
    EXPECT_TRUE(fs::exists(folder / "here" / name)) << name;
  EXPECT_EQ(read("here/edge_2.csv").find("x [m],y [m],weight [m]"), 0u);

  const Result outside = run("field one/field_model.h5 -p 2GPa -T 300degC");
  EXPECT_EQ(outside.status, 0) << outside.errors;
  EXPECT_NE(outside.output.find("these fields are not to be trusted, since p = "
                                "2000 MPa is outside of the data, 300 MPa to "
                                "1300 MPa"),
            std::string::npos)
    << outside.output;
  EXPECT_TRUE(fs::exists(folder / "one/field/chip.pvd"));
}

TEST_F(Fields, say_what_is_wrong_with_a_command)
{
  const auto errors = [&](const std::string &command) {
    const Result result = run(command);
    EXPECT_EQ(result.status, 2) << command;
    EXPECT_EQ(result.output, "") << command;
    return result.errors;
  };
  EXPECT_EQ(errors("reduce"),
            "Error: 'asperity reduce' takes the folder of one campaign, as in "
            "'asperity reduce output/campaign --latent 4'.\n");
  EXPECT_EQ(errors("reduce here --latent many"),
            "Error: The option '--latent' is 'many'; a number of 1 to 100 is "
            "expected.\n");
  EXPECT_EQ(errors("reduce here --latent 2.5"),
            "Error: The option '--latent' is '2.5'; a whole number is "
            "expected.\n");
  EXPECT_EQ(errors("reduce here --epochs 2.5"),
            "Error: The option '--epochs' is '2.5'; a whole number is "
            "expected.\n");
  EXPECT_EQ(errors("reduce here --epochs 0"),
            "Error: The option '--epochs' is '0'; a number of 1 to 100000 is "
            "expected.\n");
  EXPECT_EQ(errors("reduce here --decoder pod --epochs 9"),
            "Error: The option '--epochs' is given with '--decoder pod', which "
            "trains no network; expected without.\n");
  EXPECT_EQ(
    errors("reduce here --decoder magic"),
    "Error: The option '--decoder' is 'magic'; 'pod', 'manifold' or 'network' is "
    "expected.\n");
  EXPECT_EQ(errors("reduce here --held-out 95%"),
            "Error: The option '--held-out' is '95%'; a number of 0.01 to 0.9 "
            "is expected.\n");
  EXPECT_EQ(errors("reduce here"),
            "Error: The folder 'here' has no runs.csv; the output directory of "
            "a campaign is expected, as 'asperity characterize' makes it.\n");
  EXPECT_EQ(errors("field"),
            "Error: 'asperity field' takes one model, as in 'asperity field "
            "field_model.h5 -p 450MPa -v 90m/min -T 300degC'.\n");
  EXPECT_EQ(errors("field model.h5 -p 1GPa"),
            "Error: The file 'model.h5' could not be opened; the fields that "
            "'asperity reduce' learns are expected.\n");
  write("model.h5", "no model");
  EXPECT_EQ(errors("field model.h5 -p 1GPa"),
            "Error: The file 'model.h5' is no HDF5 file of this program, not "
            "complete, or damaged; the fields that 'asperity reduce' learns "
            "are expected.\n");
}
