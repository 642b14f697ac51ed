#include <asperity/base/errors.h>
#include <asperity/campaign/task_counter.h>

#include <set>
#include <stdexcept>

#include "campaign_examples.h"

using namespace asperity;

using CampaignRun = CampaignExample;

namespace
{
  /** A runner that counts, and dies with its process after so many runs. */
  struct MortalRunner
  {
    unsigned int            lives;
    std::set<unsigned int> &computed;

    RunRecord
    operator()(const std::string &scene, const RunOrder &order)
    {
      if (lives-- == 0)
        throw std::runtime_error("killed");
      EXPECT_TRUE(computed.insert(order.id).second)
        << "run " << order.id << " is computed twice";
      return formula_run(scene, order);
    }
  };
} // namespace



TEST(TaskCounter, hands_out_each_number_once)
{
  std::vector<unsigned int> calls(7, 0);
  for_each_task(calls.size(), MPI_COMM_WORLD, [&](const std::size_t i) {
    ++calls[i];
  });
  EXPECT_EQ(calls, std::vector<unsigned int>(7, 1));
}



TEST_F(CampaignRun, grows_to_the_maximum_and_predicts_the_formula)
{
  const CampaignInput input(folder, text());
  Campaign            campaign(input.parameters,
                    input.declarator,
                    MPI_COMM_WORLD,
                    formula_run);
  campaign.run();
  EXPECT_EQ(campaign.plan().n_points(false), 20u);
  EXPECT_EQ(campaign.plan().n_points(true), 10u);
  const auto law =
    campaign.results().train(campaign.results().training_data(20));
  const TestReport report = test_law(law, campaign.results().test_data());
  EXPECT_EQ(report.n_runs, 10u);
  EXPECT_LT(report.mean_relative_error, 1e-3);
  const double x[] = {450e6, 1.5};
  EXPECT_NEAR(law.mean(x), formula(x[0], x[1]), 1e-3 * formula(x[0], x[1]));

  // 8, 12, 16, 20 points; more points, less error
  const auto history = campaign.results().history();
  ASSERT_EQ(history.size(), 4u);
  EXPECT_LT(history.back().test.mean_relative_error,
            history.front().test.mean_relative_error);
}



TEST_F(CampaignRun, stops_when_two_batches_meet_the_target)
{
  CampaignInput input(folder, text());
  input.parameters.design.target_error = 10.;
  Campaign campaign(input.parameters,
                    input.declarator,
                    MPI_COMM_WORLD,
                    formula_run);
  campaign.run();
  EXPECT_EQ(campaign.plan().n_points(false), 12u);
}



TEST_F(CampaignRun, ends_with_the_same_table_however_often_it_is_killed)
{
  CampaignInput          input(folder, text());
  std::set<unsigned int> computed;
  {
    Campaign campaign(input.parameters,
                      input.declarator,
                      MPI_COMM_WORLD,
                      formula_run);
    campaign.run();
  }
  const std::string undisturbed = read("out/runs.csv");
  input.parameters.directory    = (folder / "again").string();
  for (unsigned int lives = 0; read("again/runs.csv") != undisturbed; ++lives)
    {
      ASSERT_LT(lives, 20u);
      try
        {
          Campaign(input.parameters,
                   input.declarator,
                   MPI_COMM_WORLD,
                   MortalRunner{lives, computed})
            .run();
        }
      catch (const std::runtime_error &)
        {}
    }
  EXPECT_EQ(computed.size(), 30u);
}



TEST_F(CampaignRun, records_failures_and_goes_on)
{
  CampaignInput input(folder, text());
  const auto    fragile = [](const std::string &scene, const RunOrder &order) {
    if (order.id != 3 && order.id != 12)
      return formula_run(scene, order);
    RunRecord record;
    record.reason = "Newton's method gave up.";
    return record;
  };
  Campaign campaign(input.parameters,
                    input.declarator,
                    MPI_COMM_WORLD,
                    fragile);
  campaign.run();
  const SampleTable &table = campaign.results().table();
  ASSERT_NE(table.find(3), nullptr);
  EXPECT_EQ(table.find(3)->reason, "Newton's method gave up.");
  EXPECT_EQ(table.count(SampleRole::training, SampleStatus::failed), 1u);
  EXPECT_EQ(table.count(SampleRole::test, SampleStatus::failed), 1u);
  EXPECT_EQ(campaign.results().failed_points().size(), 2u);
  EXPECT_EQ(campaign.results().training_data(20).y.size(), 19u);
}



namespace
{
  /** mu of the profiles is 0.7, 1 and 1.3 times the formula. */
  RunRecord
  run_on_profile(const std::string &scene, const RunOrder &order)
  {
    RunRecord record = formula_run(scene, order);
    record.mu *= 1. + 0.3 * (order.profile - 1.);
    return record;
  }
} // namespace



// Profiles that differ alike at all points leave the law the data of one, with
// no deviation of theirs.
TEST_F(CampaignRun, averages_over_profiles)
{
  use_measured_tool();
  CampaignInput input(folder, text());
  input.parameters.profile_positions   = "10 um, 30 um, 50 um";
  input.parameters.design.batch        = 0;
  input.parameters.design.initial_runs = 20;
  Campaign campaign(input.parameters,
                    input.declarator,
                    MPI_COMM_WORLD,
                    run_on_profile);
  campaign.run();
  const CampaignResults &results = campaign.results();
  const Sample          &sample  = results.table().samples()[0];
  EXPECT_NEAR(sample.outputs[0], formula(sample.x[0], sample.x[1]), 1e-12);
  EXPECT_EQ(sample.deviation, 0.);
  EXPECT_NEAR(results.scatter().total(), 0.3, 1e-12);
  EXPECT_LT(results.scatter().beyond_factor(), 1e-12);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/runs/0001_p3.json"));

  const SampleData data = results.training_data(20);
  ASSERT_EQ(data.y.size(), 20u);
  for (std::size_t i = 0; i < data.y.size(); ++i)
    EXPECT_NEAR(data.y[i], formula(data.x[2 * i], data.x[2 * i + 1]), 1e-12);
  EXPECT_TRUE(data.deviation.empty());
  const FrictionLaw law = results.train(data);
  EXPECT_EQ(law.description().n_profiles, 3u);
  EXPECT_NEAR(law.description().topography_scatter, 0.3, 1e-12);
}



TEST_F(CampaignRun, a_profile_that_fails_is_estimated_from_the_others)
{
  use_measured_tool();
  CampaignInput input(folder, text());
  input.parameters.profile_positions = "10 um, 30 um, 50 um";
  input.parameters.design.batch      = 0;
  const auto runner = [](const std::string &scene, const RunOrder &order) {
    const bool gap  = order.id == 2 && order.profile == 2;
    const bool lost = order.id == 5;
    if (!gap && !lost)
      return run_on_profile(scene, order);
    RunRecord record;
    record.reason = "Newton's method gave up.";
    return record;
  };
  Campaign campaign(input.parameters, input.declarator, MPI_COMM_WORLD, runner);
  campaign.run();
  const CampaignResults &results = campaign.results();
  const Sample          &gap     = *results.table().find(2);
  EXPECT_EQ(gap.status, SampleStatus::done);
  EXPECT_NEAR(gap.outputs[0], formula(gap.x[0], gap.x[1]), 1e-12);
  EXPECT_EQ(gap.reason, "Profile 3: Newton's method gave up.");
  EXPECT_EQ(results.table().find(5)->status, SampleStatus::failed);
  EXPECT_EQ(results.table().find(5)->reason,
            "Profile 1: Newton's method gave up.");
  ASSERT_EQ(results.warnings().size(), 1u);
  EXPECT_NE(results.warnings()[0].find("some profiles have failed: 1;"),
            std::string::npos)
    << results.warnings()[0];
}



TEST_F(CampaignRun, refuses_the_results_of_another_campaign)
{
  CampaignInput input(folder, text());
  input.parameters.design.batch = 0;
  Campaign(input.parameters, input.declarator, MPI_COMM_WORLD, formula_run)
    .run();
  const auto refusal = [&]() -> std::string {
    try
      {
        Campaign(input.parameters,
                 input.declarator,
                 MPI_COMM_WORLD,
                 formula_run);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  };
  EXPECT_EQ(refusal(), "");
  input.parameters.design.test_runs = 12; // more of them is no contradiction
  EXPECT_EQ(refusal(), "");
  input.parameters.design.seed = 2;
  EXPECT_NE(refusal().find("another design or seed"), std::string::npos);
  input.parameters.design.seed  = 1;
  input.parameters.inputs[0].to = "1200 MPa";
  EXPECT_NE(refusal().find("inputs, ranges or profiles"), std::string::npos)
    << refusal();
  input.parameters.inputs[0].to   = "1300 MPa";
  input.parameters.inputs[0].from = "350 MPa";
  EXPECT_NE(refusal().find("inputs, ranges or profiles"), std::string::npos)
    << refusal();
  input.parameters.inputs[0].from = "300 MPa";
  std::ofstream(folder / "scene.prm")
    << "subsection Mesh\n set Spans = 64\n set Refinement levels = 1\nend\n";
  EXPECT_NE(refusal().find("entry 'Mesh/Spans' was 32 and is 64"),
            std::string::npos)
    << refusal();
}



TEST_F(CampaignRun, does_not_record_runs_on_a_surface_that_has_changed)
{
  std::ofstream(folder / "scene.prm")
    << "subsection Tool\n subsection Topography\n  set File = tool.txt\n"
       " end\nend\n";
  std::ofstream(folder / "tool.txt") << "1 2 3 4\n";
  const CampaignInput input(folder, text());
  unsigned int        n_runs = 0;
  const auto runner = [&](const std::string &scene, const RunOrder &order) {
    if (++n_runs == 3)
      std::ofstream(folder / "tool.txt") << "1 2 3 5\n";
    return formula_run(scene, order);
  };
  {
    Campaign campaign(input.parameters,
                      input.declarator,
                      MPI_COMM_WORLD,
                      runner);
    try
      {
        campaign.run();
        ADD_FAILURE() << "the change was not noticed";
      }
    catch (const InputError &error)
      {
        EXPECT_EQ(std::string(error.what())
                    .find("While the campaign ran, a file of the base scene "
                          "has changed: entry 'Tool/Topography/File' was the "
                          "file '"),
                  0u)
          << error.what();
      }
  }
  EXPECT_EQ(n_runs, 3u);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/runs/0002.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out/runs/0003.json"));

  // With the file as it was, the campaign goes on.
  std::ofstream(folder / "tool.txt") << "1 2 3 4\n";
  Campaign campaign(input.parameters,
                    input.declarator,
                    MPI_COMM_WORLD,
                    formula_run);
  campaign.run();
  EXPECT_EQ(campaign.plan().n_points(false), 20u);
}



namespace
{
  /** Runs at low pressure carry no load, and at high pressure the tool pushes
   *  the chip along a little. */
  RunRecord
  run_without_results(const std::string &scene, const RunOrder &order)
  {
    RunRecord record = formula_run(scene, order);
    if (value_of(order, 0) < 400e6)
      record.no_result = "load not carried";
    else if (value_of(order, 0) > 1200e6)
      record.mu = -1e-5;
    return record;
  }
} // namespace



TEST_F(CampaignRun, does_not_learn_from_runs_without_a_result)
{
  CampaignInput input(folder, text());
  input.parameters.design.initial_runs = 20;
  input.parameters.design.batch        = 0;
  input.parameters.design.test_runs    = 0;
  Campaign campaign(input.parameters,
                    input.declarator,
                    MPI_COMM_WORLD,
                    run_without_results);
  campaign.run();
  const CampaignResults &results = campaign.results();
  const SampleData       data    = results.training_data(20);
  unsigned int           n_low = 0, n_high = 0;
  for (const Sample &sample : results.table().samples())
    {
      const double p = sample.x[0];
      n_low += p < 400e6 ? 1 : 0;
      n_high += p > 1200e6 ? 1 : 0;
      if (p < 400e6)
        EXPECT_EQ(sample.reason,
                  "The mean of this run is no friction coefficient: load not "
                  "carried.");
      else if (p > 1200e6)
        EXPECT_EQ(
          sample.reason,
          "The friction coefficient of this run is -1e-05, which has no "
          "logarithm (Friction law/Output scale).");
      else
        EXPECT_EQ(sample.reason, "");
    }
  ASSERT_GT(n_low, 0u);
  ASSERT_GT(n_high, 0u);
  EXPECT_EQ(data.y.size(), 20u - n_low - n_high);
  EXPECT_EQ(results.n_without_result(), n_low + n_high);
  ASSERT_FALSE(results.warnings().empty());
  EXPECT_NE(results.warnings()[0].find("are not learnt from: " +
                                       std::to_string(n_low + n_high)),
            std::string::npos)
    << results.warnings()[0];
  const double x[] = {800e6, 1.5};
  EXPECT_NEAR(results.train(data).mean(x),
              formula(x[0], x[1]),
              1e-2 * formula(x[0], x[1]));
}
