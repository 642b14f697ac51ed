#include <asperity/base/errors.h>

#include "campaign_examples.h"

using namespace asperity;

using Plan = CampaignExample;

namespace
{
  std::string
  refusal(const std::filesystem::path &folder, const std::string &text)
  {
    try
      {
        const CampaignInput input(folder, text);
        CampaignPlan(input.parameters, input.declarator);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  std::string
  replaced(std::string        text,
           const std::string &before,
           const std::string &after)
  {
    return text.replace(text.find(before), before.size(), after);
  }
} // namespace



TEST_F(Plan, gives_runs_in_the_units_of_the_ranges)
{
  const CampaignInput input(folder, text());
  CampaignPlan        plan(input.parameters, input.declarator);
  plan.start(input.parameters, (folder / "plan.json").string());
  ASSERT_EQ(plan.inputs().size(), 2u);
  EXPECT_EQ(plan.inputs()[0].symbol, "p");
  EXPECT_EQ(plan.inputs()[0].lower, 300e6);
  EXPECT_EQ(plan.inputs()[1].unit, "m/min");
  // The middle of the box, on a logarithmic scale of the velocity.
  const RunOrder order = plan.order(plan.points()[0], 0);
  EXPECT_EQ(order.name(1), "0001");
  EXPECT_EQ(order.name(3), "0001_p1");
  EXPECT_EQ(order.changes[0].second, "800 MPa");
  EXPECT_NEAR(value_of(order, 1) * 60., std::sqrt(22.5 * 200.), 1e-10);
}



TEST_F(Plan, every_number_reads_back)
{
  const CampaignInput input(folder, text());
  CampaignPlan        plan(input.parameters, input.declarator);
  plan.start(input.parameters, (folder / "plan.json").string());
  for (const PlannedPoint &point : plan.points())
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_EQ(value_of(plan.order(point, 0), i), point.x[i]);
}



TEST_F(Plan, wrong_input_is_refused_in_one_sentence)
{
  EXPECT_NE(refusal(folder, replaced(text(), "Load/Pressure", "Load/Presure"))
              .find("There is no entry 'Presure' in subsection 'Load'; did you "
                    "mean 'Pressure'"),
            std::string::npos);
  EXPECT_NE(refusal(folder, replaced(text(), "1300 MPa", "1300 mm"))
              .find("'1300 mm' is a length; a stress is expected"),
            std::string::npos);
  EXPECT_NE(refusal(folder, replaced(text(), "1300 MPa", "200 MPa"))
              .find("found 200 MPa; expected more than 300 MPa."),
            std::string::npos);
  EXPECT_NE(refusal(folder, replaced(text(), "1300 MPa", "high"))
              .find("entry 'Campaign/Input 1/To'"),
            std::string::npos);
  EXPECT_NE(refusal(folder, replaced(text(), "Load/Velocity", "Load/Pressure"))
              .find("Load/Pressure is already Input 1"),
            std::string::npos);
  EXPECT_NE(refusal(folder, replaced(text(), "set To = 200 m/min", ""))
              .find("expected an end of its range with a unit"),
            std::string::npos);
  EXPECT_NE(refusal(folder,
                    text("subsection Campaign\n subsection Design\n"
                         "  set Kind = grid\n end\nend\n"))
              .find("expected one for each of the 2 inputs"),
            std::string::npos);
  EXPECT_NE(refusal(folder,
                    replaced(text(), "Maximum runs = 20", "Maximum runs = 7"))
              .find("expected at least the 8 initial runs"),
            std::string::npos);
  EXPECT_NE(refusal(folder, replaced(text(), "scene.prm", "nothing.prm"))
              .find("nothing.prm"),
            std::string::npos);
}



namespace
{
  /** The sentence with which a plan on disk is refused; empty: it is not. */
  std::string
  refusal_of_plan(const std::filesystem::path &folder, const std::string &text)
  {
    try
      {
        const CampaignInput input(folder, text);
        CampaignPlan        plan(input.parameters, input.declarator);
        plan.start(input.parameters, (folder / "plan.json").string());
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST_F(Plan, belongs_to_a_scene_with_the_content_of_its_files)
{
  const auto scene = [&](const std::string &text) {
    std::ofstream(folder / "scene.prm") << text;
  };
  const std::string measured = "subsection Tool\n subsection Topography\n"
                               "  set File = tool.txt\n end\nend\n";
  std::ofstream(folder / "tool.txt") << "1 2 3 4\n";
  std::ofstream(folder / "common.prm")
    << "subsection Mesh\n set Spans = 64\nend\n";
  scene("include common.prm\n" + measured);
  {
    const CampaignInput input(folder, text());
    CampaignPlan        plan(input.parameters, input.declarator);
    plan.start(input.parameters, (folder / "plan.json").string());
    plan.save((folder / "plan.json").string());
    EXPECT_EQ(plan.warning(), "");
    EXPECT_EQ(plan.changed_file(), "");
    std::ofstream(folder / "tool.txt") << "1 2 3 5\n";
    EXPECT_EQ(plan.changed_file().find("entry 'Tool/Topography/File' was the "
                                       "file '"),
              0u);
  }
  const std::string begin = "The base scene is not that of the campaign in " +
                            (folder / "plan.json").string() + ": ";
  EXPECT_EQ(refusal_of_plan(folder, text())
              .find(begin + "entry 'Tool/Topography/File' was the file '"),
            0u)
    << refusal_of_plan(folder, text());
  std::ofstream(folder / "tool.txt") << "1 2 3 4\n";
  EXPECT_EQ(refusal_of_plan(folder, text()), "");

  std::ofstream(folder / "common.prm")
    << "subsection Mesh\n set Spans = 96\nend\n";
  EXPECT_EQ(refusal_of_plan(folder, text()),
            begin + "entry 'Mesh/Spans' was 64 and is 96; take another output "
                    "directory.");
  // where pictures go is of no importance, and so are other words
  scene("subsection Mesh\n set Spans = 6.4e1\nend\n"
        "subsection Output\n set Picture interval = 3\nend\n" +
        measured);
  EXPECT_EQ(refusal_of_plan(folder, text()), "");

  std::ifstream     in(folder / "plan.json");
  const std::string plan{std::istreambuf_iterator<char>(in), {}};
  std::ofstream(folder / "plan.json") << replaced(plan, "plan 2", "plan 1");
  EXPECT_NE(refusal_of_plan(folder, text())
              .find("has the format \"asperity campaign plan 1\", but "
                    "\"asperity campaign plan 2\" is expected"),
            std::string::npos);
  std::ofstream(folder / "plan.json")
    << replaced(plan, "\"program\": \"asperity", "\"program\": \"x");
  const CampaignInput input(folder, text());
  CampaignPlan        other(input.parameters, input.declarator);
  other.start(input.parameters, (folder / "plan.json").string());
  EXPECT_NE(other.warning().find("was begun by another program, x "),
            std::string::npos)
    << other.warning();
}



TEST(RunRecord, reads_back_and_belongs_to_its_order)
{
  const std::string path = testing::TempDir() + "/asperity_record.json";
  RunOrder          order;
  order.id      = 12;
  order.changes = {{"Load/Pressure", "450 MPa"}};
  RunRecord record;
  record.done          = true;
  record.mu            = 0.1 + 0.2;
  record.over_distance = {{0., 1e-7, 0.3}};
  record.warnings      = {"Something."};
  record.lubricant     = "pocket";
  write_record(path, order, record);
  const auto read = read_record(path, order);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->mu, record.mu);
  EXPECT_EQ(read->over_distance[0].mu, 0.3);
  EXPECT_EQ(read->warnings, record.warnings);
  EXPECT_EQ(read->lubricant, "pocket");

  order.changes = {{"Load/Pressure", "460 MPa"}};
  EXPECT_THROW(read_record(path, order), InputError);
  EXPECT_FALSE(read_record(path + ".not", order));
}
