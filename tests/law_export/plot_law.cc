#include <asperity/surrogate/active_learning.h>
#include <asperity/surrogate/design.h>
#include <asperity/surrogate/sample_table.h>
#include <asperity/surrogate/sensitivity.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <sstream>

#include "../files.h"
#include "../surrogate/example_inputs.h"
#include "../surrogate/friction_like_functions.h"

using namespace asperity;

// tools/plot_law.py, with the directory that a campaign leaves behind.

namespace
{
  /** What a campaign is about: inputs, and mu as a function of them. */
  struct Subject
  {
    std::vector<LawInput>                 inputs;
    std::function<double(const double *)> mu;
  };

  const Subject three_inputs = {example_inputs(), friction_like::kinked};

  FrictionLaw
  train(const Subject &subject, const std::vector<double> &x)
  {
    FrictionLawDescription description;
    description.inputs = subject.inputs;
    std::vector<double> y;
    for (std::size_t i = 0; i < x.size(); i += subject.inputs.size())
      y.push_back(subject.mu(&x[i]));
    return FrictionLaw::train(description, x, y);
  }

  void
  add_samples(SampleTable               &table,
              const Subject             &subject,
              const std::vector<double> &x,
              const SampleRole           role)
  {
    const std::size_t d = subject.inputs.size();
    for (std::size_t i = 0; i < x.size(); i += d)
      {
        Sample sample;
        sample.id      = table.samples().size();
        sample.x       = {x.begin() + i, x.begin() + i + d};
        sample.role    = role;
        sample.outputs = {subject.mu(&x[i])};
        table.add(sample);
      }
  }

  /** A row of history.csv. */
  std::string
  history_row(const FrictionLaw         &law,
              const Subject             &subject,
              const std::vector<double> &tests)
  {
    const std::size_t d     = subject.inputs.size();
    const double      n     = tests.size() / d;
    double            error = 0., largest = 0., coverage = 0.;
    for (std::size_t i = 0; i < tests.size(); i += d)
      {
        const auto   answer = law.predict(&tests[i]);
        const double value  = subject.mu(&tests[i]);
        const double e      = std::abs(answer.mean / value - 1.);
        error += e / n;
        largest = std::max(largest, e);
        coverage += (answer.lower < value && value < answer.upper) / n;
      }
    std::ostringstream row;
    row << law.data().y.size() << ',' << cross_validate(law).mean_relative_error
        << ',';
    if (tests.empty())
      row << ",,\n";
    else
      row << error << ',' << largest << ',' << coverage << '\n';
    return row.str();
  }

  /** A campaign of growing designs, the last with the law. */
  void
  write_campaign(const std::string                      &folder,
                 const Subject                          &subject,
                 const std::vector<std::vector<double>> &designs,
                 const unsigned int                      n_tests)
  {
    std::filesystem::create_directories(folder);
    const auto tests =
      design_points(DesignKind::random, n_tests, subject.inputs, 3);
    SampleTable table(subject.inputs, {{"mu", "-"}});
    add_samples(table, subject, designs.back(), SampleRole::training);
    add_samples(table, subject, tests, SampleRole::test);
    Sample failed;
    failed.id = 1000;
    failed.x = {designs[0].begin(), designs[0].begin() + subject.inputs.size()};
    failed.status = SampleStatus::failed;
    failed.reason = "The step was cut, again and again.";
    table.add(failed);
    table.write(folder + "/runs.csv");

    std::string history = "runs,leave one out error [-],test error [-],largest "
                          "test error [-],coverage of the 95 % interval [-]\n";
    for (const auto &design : designs)
      history += history_row(train(subject, design), subject, tests);
    overwrite(folder + "/history.csv", history);

    const FrictionLaw law = train(subject, designs.back());
    law.save(folder + "/friction_law.json");
    write_sensitivity(folder + "/sensitivity.csv",
                      law.description(),
                      sensitivity_indices(law));
  }

  const std::string library = ASPERITY_BINARY_DIR "/libasperity_friction.so";
  const std::string command = "ASPERITY_FRICTION_LIBRARY=" + library + " " +
                              ASPERITY_SOURCE_DIR "/tools/plot_law.py ";

  /** Exit status; what is written to the error stream goes into a file. */
  int
  run(const std::string &call, const std::string &errors = "/dev/null")
  {
    return WEXITSTATUS(
      std::system((call + " > /dev/null 2> " + errors).c_str()));
  }

  /** Why there can be no pictures on this machine, or nothing. */
  std::string
  obstacle()
  {
    if (run("/usr/bin/python3 -c 'import matplotlib, numpy'") != 0)
      return "matplotlib is not installed";
    if (!std::filesystem::exists(library))
      return library + " is not built";
    return "";
  }
} // namespace



TEST(PlotLaw, a_campaign_becomes_five_pictures)
{
  if (!obstacle().empty())
    GTEST_SKIP() << obstacle();
  const std::string                folder = test_folder();
  const auto                       inputs = example_inputs();
  std::vector<std::vector<double>> sobol, grids;
  for (const unsigned int n : {20, 40, 60, 80})
    sobol.push_back(design_points(DesignKind::sobol, n, inputs, 0));
  for (const unsigned int n : {3, 4})
    grids.push_back(design_points(DesignKind::grid, n, inputs, 0));
  write_campaign(folder + "/sobol", three_inputs, sobol, 60);
  write_campaign(folder + "/grid", three_inputs, grids, 60);

  ASSERT_EQ(run(command + folder + "/sobol " + folder + "/grid"), 0);
  for (const std::string name : {"friction_law",
                                 "beyond_the_data",
                                 "test_runs",
                                 "error_over_runs",
                                 "sensitivity"})
    {
      const auto picture = content(folder + "/sobol/" + name + ".png");
      EXPECT_EQ(picture.substr(1, 3), "PNG");
      EXPECT_GT(picture.size(), 15000u) << name << " is blank";
    }
  EXPECT_EQ(run(command + folder + "/grid --temperatures 25,300,900 " +
                "--velocity 30 --to " + folder + "/elsewhere"),
            0);
  EXPECT_EQ(n_files(folder + "/elsewhere"), 5u);
  EXPECT_EQ(n_files(folder + "/grid"), 4u);
}



TEST(PlotLaw, laws_of_fewer_and_of_more_inputs)
{
  if (!obstacle().empty())
    GTEST_SKIP() << obstacle();
  const std::string folder = test_folder();
  Subject           one, four;
  one.inputs = {example_inputs()[0]};
  one.mu     = [](const double *x) {
    const double point[] = {x[0], 1., 600.};
    return friction_like::smooth(point);
  };
  four = three_inputs;
  four.inputs.push_back(
    {"Lubrication/Wetting", "Wetting", "%", 0., 1., Scale::linear});
  four.mu = [](const double *x) {
    return friction_like::smooth(x) * (1. - 0.5 * x[3]);
  };
  write_campaign(folder + "/one",
                 one,
                 {design_points(DesignKind::sobol, 8, one.inputs, 0)},
                 0);
  write_campaign(folder + "/four",
                 four,
                 {design_points(DesignKind::sobol, 60, four.inputs, 0)},
                 5);
  ASSERT_EQ(run(command + folder + "/one"), 0);
  ASSERT_EQ(run(command + folder + "/four --set Wetting=20"), 0);
  // no map of one input, and no test runs
  EXPECT_EQ(n_files(folder + "/one"), 4u + 3u);
  EXPECT_EQ(n_files(folder + "/four"), 4u + 5u);
}



TEST(PlotLaw, says_what_is_missing)
{
  if (!obstacle().empty())
    GTEST_SKIP() << obstacle();
  const std::string folder = test_folder(), errors = folder + "/errors";
  const auto        complaint = [&](const std::string &arguments) {
    EXPECT_EQ(run(command + arguments, errors), 2);
    const std::string text = content(errors);
    EXPECT_EQ(text.substr(0, 13), "plot_law.py: ");
    EXPECT_EQ(text.find("Traceback"), std::string::npos) << text;
    return text;
  };
  EXPECT_NE(complaint(folder + "/none").find("not a directory"),
            std::string::npos);
  EXPECT_NE(complaint(folder).find("runs.csv"), std::string::npos);
  write_campaign(folder,
                 three_inputs,
                 {design_points(DesignKind::sobol, 30, example_inputs(), 0)},
                 0);
  EXPECT_NE(complaint(folder + " --temperatures hot").find("'hot'"),
            std::string::npos);
  EXPECT_NE(complaint(folder + " --set Wetting=1").find("'Wetting'"),
            std::string::npos);
  overwrite(folder + "/history.csv", "runs\n1\n");
  EXPECT_NE(complaint(folder).find("no column 'test error'"),
            std::string::npos);
  overwrite(folder + "/friction_law.json", "{}");
  EXPECT_NE(complaint(folder).find("friction_law.json"), std::string::npos);
}



// A file of measurements is read as strictly as by the program.
TEST(PlotLaw, measurements_stand_beside_a_law)
{
  if (!obstacle().empty())
    GTEST_SKIP() << obstacle();
  const std::string folder = test_folder(), errors = folder + "/errors";
  write_campaign(folder,
                 three_inputs,
                 {design_points(DesignKind::sobol, 30, example_inputs(), 0)},
                 0);
  const std::string measured = folder + "/measured.csv";
  overwrite(measured,
            "# a test\nv [m/min],p [MPa],mu,deviation of mu,series,source\n"
            "40,500,0.1,0.01,dry,\"a, b\"\n90,500,0.11,,dry,\n"
            "40,700,0.05,,wet,\n");
  const std::string call = folder + " --measured " + measured;
  ASSERT_EQ(run(command + call + " --set T=300"), 0);
  EXPECT_GT(content(folder + "/measured.png").size(), 15000u);
  // a law that was fitted to them, by the name of its file
  FrictionLawDescription description;
  description.inputs = {{"Load/Velocity", "v", "m/min"}};
  FrictionLaw::fit_to_measurements(description,
                                   {0.5, 1., 2., 3.},
                                   {0.5, 0.45, 0.35, 0.3},
                                   {})
    .save(folder + "/fitted.json");
  overwrite(measured, "v [m/min],mu\n40,0.4\n90,0.3\n");
  EXPECT_EQ(run(command + folder + "/fitted.json --measured " + measured +
                " --over v --to " + folder + "/fitted"),
            0);
  EXPECT_EQ(n_files(folder + "/fitted"), 1u);

  const auto complaint = [&](const std::string &text) {
    overwrite(measured, text);
    EXPECT_EQ(run(command + call + " --set T=300", errors), 2);
    const std::string message = content(errors);
    EXPECT_EQ(message.find("Traceback"), std::string::npos) << message;
    return message;
  };
  for (const auto &[text, sentence] :
       {std::make_pair(
          "speed,mu\n5,0.3\n",
          "the heading 'speed' was found, but mu, deviation of mu"),
        {"v [m/min],mu\n5,-0.3\n", "a positive number is expected"},
        {"v [m/min],mu\n5,0.3\n", "give it by --set p=NUMBER"},
        {"v [m/min],p [MPa],mu\n5,,0.3\n", "points without p"}})
    EXPECT_NE(complaint(text).find(sentence), std::string::npos)
      << sentence << "\n"
      << content(errors);
}
