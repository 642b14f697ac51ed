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
