#include "program.h"

using namespace asperity;

using Commands = Program;

TEST_F(Commands, help_lists_every_command)
{
  const Result result = run("--help");
  EXPECT_EQ(result.status, 0);
  for (const std::string command : {"asperity run FILE.prm",
                                    "asperity check FILE.prm",
                                    "asperity new SURFACE",
                                    "asperity parameters [--campaign | "
                                    "--fluid-structure | --experiment | "
                                    "--shapes | --optimization]",
                                    "asperity reduce CAMPAIGN",
                                    "asperity field MODEL",
                                    "asperity shapes FILE.prm",
                                    "asperity optimize FILE.prm",
                                    "asperity conditions FILE.prm",
                                    "asperity fit MEASURED.csv LAW",
                                    "asperity calibrate LAW",
                                    "asperity characterize FILE.prm",
                                    "asperity sensitivity FILE.prm [--sobol N]",
                                    "asperity predict LAW",
                                    "asperity export LAW DIRECTORY",
                                    "asperity topography FILE.prm"})
    EXPECT_NE(result.output.find(command), std::string::npos) << command;
}

TEST_F(Commands, version_names_the_libraries)
{
  const Result result = run("--version");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output.find("asperity 0."), 0u);
  EXPECT_NE(result.output.find("deal.II"), std::string::npos);
}

TEST_F(Commands, start_without_the_libraries_of_deal_ii)
{
  // Two hundred libraries, whose loading takes longer than an answer of a law.
  const Result loaded = run("", "LD_TRACE_LOADED_OBJECTS=1");
  EXPECT_NE(loaded.output.find("libc.so"), std::string::npos) << loaded.errors;
  for (const std::string library : {"deal.ii", "trilinos", "libmpi"})
    EXPECT_EQ(loaded.output.find(library), std::string::npos) << library;
}

TEST_F(Commands, the_listed_parameters_are_a_valid_scene)
{
  const Result listed = run("parameters");
  EXPECT_EQ(listed.status, 0);
  write("all.prm", listed.output);
  const Result checked = run("check all.prm");
  EXPECT_EQ(checked.status, 0) << checked.errors;
}

TEST_F(Commands, the_reference_explains_every_listed_parameter)
{
  const Result      listed    = run("parameters");
  const Result      reference = run("parameters --markdown");
  const std::string text      = listed.output;
  unsigned int      n_entries = 0;
  for (auto at = text.find("set "); at != std::string::npos;
       at = text.find("\n", at), at = text.find("set ", at))
    {
      const std::string key = text.substr(at + 4, text.find(" =", at) - at - 4);
      EXPECT_NE(reference.output.find("| " + key + " |"), std::string::npos)
        << key;
      ++n_entries;
    }
  EXPECT_GT(n_entries, 40u);
}

TEST_F(Commands, the_printed_reference_is_the_one_in_the_documentation)
{
  std::ifstream     file(ASPERITY_SOURCE_DIR "/doc/parameters.md");
  const std::string documented{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(run("parameters --markdown").output, documented)
    << "renew it: build/asperity parameters --markdown > doc/parameters.md";
}

TEST_F(Commands, the_reference_of_campaigns_is_the_one_in_the_documentation)
{
  std::ifstream     file(ASPERITY_SOURCE_DIR "/doc/campaign_parameters.md");
  const std::string documented{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(run("parameters --campaign --markdown").output, documented)
    << "renew it: build/asperity parameters --campaign --markdown > "
       "doc/campaign_parameters.md";
}

TEST_F(Commands, the_reference_of_problems_is_the_one_in_the_documentation)
{
  std::ifstream file(ASPERITY_SOURCE_DIR "/doc/fluid_structure_parameters.md");
  const std::string documented{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(run("parameters --fluid-structure --markdown").output, documented)
    << "renew it: build/asperity parameters --fluid-structure --markdown > "
       "doc/fluid_structure_parameters.md";
}

TEST_F(Commands, the_reference_of_experiments_is_the_one_in_the_documentation)
{
  std::ifstream     file(ASPERITY_SOURCE_DIR "/doc/experiment_parameters.md");
  const std::string documented{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(run("parameters --experiment --markdown").output, documented)
    << "renew it: build/asperity parameters --experiment --markdown > "
       "doc/experiment_parameters.md";
}

TEST_F(Commands, the_reference_of_shapes_is_the_one_in_the_documentation)
{
  std::ifstream     file(ASPERITY_SOURCE_DIR "/doc/shape_parameters.md");
  const std::string documented{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(run("parameters --shapes --markdown").output, documented)
    << "renew it: build/asperity parameters --shapes --markdown > "
       "doc/shape_parameters.md";
}

TEST_F(Commands, the_reference_of_optimizations_is_the_one_in_the_documentation)
{
  std::ifstream     file(ASPERITY_SOURCE_DIR "/doc/optimization_parameters.md");
  const std::string documented{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(run("parameters --optimization --markdown").output, documented)
    << "renew it: build/asperity parameters --optimization --markdown > "
       "doc/optimization_parameters.md";
}

TEST_F(Commands, an_empty_file_is_said_to_be_the_default_scene)
{
  write("empty.prm", "# nothing\n");
  const std::string note = "empty.prm sets no entry of the scene, so that this "
                           "is the default scene";
  EXPECT_NE(run("check empty.prm").output.find(note), std::string::npos);
  write("load.prm", "subsection Load\n set Pressure = 300 MPa\nend\n");
  EXPECT_EQ(run("check load.prm").output.find("sets no entry"),
            std::string::npos);
}

TEST_F(Commands, check_says_which_entries_the_models_do_not_read)
{
  write("stokes.prm",
        "subsection Lubrication\n set Model = Stokes\n set Oil film = 5 nm\n"
        "end\nsubsection Lubricant\n set Density law = Murnaghan\n"
        " set Viscosity = 0.03 Pa s\nend\n");
  const std::string output = run("check stokes.prm").output;
  EXPECT_NE(output.find(
              "Not used here: Lubrication/Oil film (only with the Oil "
              "amount film thickness).\n"),
            std::string::npos)
    << output;
  EXPECT_NE(output.find("Not used here: Lubricant/Density law (only with the "
                        "lubricant models pocket and Reynolds, and a "
                        "Compressible flow).\n"),
            std::string::npos)
    << output;
  EXPECT_EQ(output.find("Lubricant/Viscosity"), std::string::npos) << output;
}

TEST_F(Commands, wrong_command_lines_are_refused)
{
  const auto errors = [&](const std::string &arguments) {
    const Result result = run(arguments);
    EXPECT_EQ(result.status, 2) << arguments;
    return result.errors;
  };
  EXPECT_EQ(errors(""),
            "Error: No parameter file is given; 'asperity --help' lists the "
            "commands.\n");
  EXPECT_EQ(errors("chek scene.prm"),
            "Error: 'chek' is neither a command nor a parameter file (*.prm); "
            "did you mean 'asperity check'?\n");
  EXPECT_EQ(errors("scene.txt"),
            "Error: 'scene.txt' is neither a command nor a parameter file "
            "(*.prm); 'asperity --help' lists the commands.\n");
  EXPECT_EQ(errors("check"),
            "Error: 'asperity check' takes one parameter file, as in 'asperity "
            "check scene.prm'.\n");
  EXPECT_EQ(errors("a.prm b.prm"),
            "Error: One parameter file is expected, but 'b.prm' follows "
            "'a.prm'.\n");
  write("two\nlines.prm", "set Presure = 3 MPa\n");
  EXPECT_EQ(errors("'two\nlines.prm'").find("Error: two?lines.prm, line 1: "),
            0u);
  EXPECT_EQ(errors("parameters --html"),
            "Error: 'asperity parameters' takes no argument but "
            "'--campaign', '--fluid-structure', '--experiment', '--shapes', "
            "'--optimization' and '--markdown'.\n");
  for (const std::string command : {"", "run ", "check ", "topography "})
    EXPECT_EQ(errors(command + "none.prm"),
              "Error: The parameter file 'none.prm' does not exist or cannot "
              "be read.\n")
      << command;
}

TEST_F(Commands, one_of_several_ranks_says_what_is_wrong)
{
  const Result result = run("none.prm", "mpirun -np 2");
  EXPECT_EQ(result.status, 2);
  const std::string sentence = "Error: The parameter file 'none.prm'";
  const auto        first    = result.errors.find(sentence);
  ASSERT_NE(first, std::string::npos) << result.errors;
  EXPECT_EQ(result.errors.find(sentence, first + 1), std::string::npos);
}

TEST_F(Commands, a_run_tells_the_numerical_error_of_mu_where_that_is_wanted)
{
  const std::string scene =
    "subsection Mesh\n set Spans = 40\n set Refinement levels = 1\nend\n"
    "subsection Protocol\n set Ramp steps = 8\n set Slide steps = 40\nend\n"
    "subsection Output\n set Output directory = run\nend\n";
  write("scene.prm",
        scene + "subsection Accuracy\n set Control = estimate\nend\n");
  const Result result = run("scene.prm");
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output.find("(numerics: mesh "), std::string::npos);
  EXPECT_NE(result.output.find("; corrected for these "), std::string::npos);
  EXPECT_NE(result.output.find(
              "for numerical reasons, more than the 0.7 % that "
              "Accuracy/Error wants, most of it by the mesh, "
              "for which Mesh/Spans and Refinement levels "
              "help."),
            std::string::npos)
    << result.output;
  EXPECT_NE(read("run/summary.json").find("\"accuracy\""), std::string::npos);
  write("scene.prm", scene);
  EXPECT_EQ(run("scene.prm").output.find("numerics"), std::string::npos);
  EXPECT_EQ(read("run/summary.json").find("\"accuracy\""), std::string::npos);
}

namespace
{
  std::string
  adaptive_scene(const std::string &accuracy)
  {
    return "subsection Mesh\n set Spans = 40\n set Refinement levels = 1\nend\n"
           "subsection Protocol\n set Ramp steps = 4\n set Slide steps = 6\nend\n"
           "subsection Accuracy\n set Control = adaptive\n" +
           accuracy +
           "end\nsubsection Output\n set Output directory = run\nend\n";
  }
} // namespace

TEST_F(Commands, a_run_chooses_its_settings_where_that_is_wanted)
{
  // Half of the steps and of the penalty, then finer ones.
  write("scene.prm", adaptive_scene(" set Error = 0.04\n"));
  Result result = run("scene.prm");
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output.find(
              "round 1: 40 spans, 2 + 3 steps, penalty factor 4: mu = "),
            std::string::npos)
    << result.output;
  EXPECT_NE(result.output.find("round 2: "), std::string::npos);
  // Which number keeps the error is said, and nobody warns.
  EXPECT_NE(result.output.find(", keeps the 4 % that Accuracy/Error wants; mu "
                               "of the run "),
            std::string::npos)
    << result.output;
  EXPECT_EQ(result.output.find("Warning: mu"), std::string::npos);
  for (const std::string key : {"rounds", "corrected_mu", "met_by"})
    EXPECT_NE(read("run/summary.json").find('"' + key + '"'),
              std::string::npos);
  // What was chosen can be repeated, and is in the folder.
  EXPECT_NE(read("run/parameters.prm").find("Control = estimate"),
            std::string::npos);
  const std::string last =
    result.output.substr(result.output.rfind("\nmu = "), 20);
  result = run("run/parameters.prm");
  EXPECT_NE(result.output.find(last), std::string::npos);
}

TEST_F(Commands, settings_that_may_not_be_chosen_are_told)
{
  write("scene.prm",
        adaptive_scene(" set Error = 1e-3\n set Maximum unknowns = 500\n"));
  Result result = run("scene.prm");
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output.find(
              "settings that are finer where it matters need more than the "
              "500 unknowns of Accuracy/Maximum unknowns."),
            std::string::npos)
    << result.output;

  EXPECT_NE(run("check scene.prm")
              .output.find("No settings within a few halvings of these keep an "
                           "error of 0.1 %."),
            std::string::npos);

  write("scene.prm",
        adaptive_scene("") + "subsection Output\n set Restart = true\nend\n");
  result = run("scene.prm");
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.errors.find("found true with Accuracy/Control = adaptive"),
            std::string::npos);
  write("scene.prm",
        adaptive_scene("") + "subsection Mesh\n set Offset = 0.5\nend\n");
  EXPECT_NE(
    run("scene.prm")
      .errors.find(
        "'Mesh/Offset': found 0.5 with Accuracy/Control = adaptive, which "
        "changes the elements that it counts in; expected 0."),
    std::string::npos);
}



TEST_F(Commands, a_patch_says_what_its_window_changed_and_where_it_slides)
{
  write("scene.prm",
        "subsection Geometry\n set Dimension = 3\n set Width = 5 um\n"
        " set Chip height = 6 um\nend\n"
        "subsection Tool\n set Kind = measured\n subsection Topography\n"
        "  set File = " ASPERITY_SOURCE_DIR
        "/parameter_files/surfaces/blasted_tool.x3p\n"
        "  set S-filter nesting index = 5 um\n  set Profile length = 5 um\n"
        " end\nend\n"
        "subsection Mesh\n set Spans = 8\n set Refinement levels = 0\nend\n"
        "subsection Load\n set Pressure = 5 MPa\n"
        " set Sliding direction = 30 deg\nend\n"
        "subsection Interface\n set Shear law = Coulomb\n"
        " set Friction coefficient = 0.1\nend\n"
        "subsection Protocol\n set Ramp steps = 2\n set Slide steps = 2\n"
        "end\nsubsection Output\n set Output directory = run\n"
        " set Picture interval = 4\nend\n");
  const Result result = run("scene.prm");
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output.find("Slides at 30 deg to x"), std::string::npos)
    << result.output;
  const std::string summary = read("run/summary.json");
  EXPECT_NE(summary.find("\"sliding_direction\": 0.52359877"), // pi/6
            std::string::npos);
  for (const std::string key :
       {"window", "filled_samples", "Sq_before", "Sq_after", "transverse"})
    EXPECT_NE(summary.find("\"" + key + "\": "), std::string::npos) << key;
  for (const std::string field : {"temperature of the chip [degC]",
                                  "temperature of the tool [degC]",
                                  "heat flux into the tool [W/m^2]"})
    EXPECT_NE(read("run/contact_000004.vtu").find(field), std::string::npos)
      << field;
}



TEST_F(Commands, all_linear_solvers_of_a_scene_give_the_same_friction)
{
  std::string expected;
  for (const std::string solver :
       {"automatic", "cholmod", "umfpack", "klu", "mumps"})
    {
      write(
        "scene.prm",
        "subsection Mesh\n set Spans = 16\n set Refinement levels = 0\nend\n"
        "subsection Load\n set Pressure = 5 MPa\nend\n"
        "subsection Protocol\n set Ramp steps = 2\n set Slide steps = 2\n"
        "end\nsubsection Output\n set Output directory = run\nend\n"
        "subsection Solver\n set Linear solver = " +
          solver + "\nend\n");
      const Result result = run("scene.prm");
      ASSERT_EQ(result.status, 0) << solver << ": " << result.errors;
      const auto begin = result.output.rfind("\nmu = ");
      ASSERT_NE(begin, std::string::npos) << result.output;
      // Four digits: more is round-off of the solvers.
      const std::string mu =
        result.output.substr(begin, result.output.find("+-", begin) - begin);
      if (expected.empty())
        expected = mu;
      EXPECT_EQ(mu, expected) << solver;
    }
}



TEST_F(Commands, krylov_is_for_three_dimensions)
{
  write("scene.prm",
        "subsection Output\n set Output directory = run\nend\n"
        "subsection Solver\n set Linear solver = krylov\nend\n");
  const Result result = run("scene.prm");
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.errors.find("found krylov in two dimensions; expected a "
                               "direct one there"),
            std::string::npos)
    << result.errors;
}
