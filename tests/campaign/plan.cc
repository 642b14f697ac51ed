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
              .find("'Load/Pressure' is already Input 1"),
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
  const std::string begin = "The base scene is not that of the campaign in '" +
                            (folder / "plan.json").string() + "': ";
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



// What would end in a campaign without a law is refused before its runs.
TEST_F(Plan, campaigns_that_cannot_give_a_law_are_refused)
{
  const auto expect = [&](const std::string &campaign,
                          const std::string &sentence) {
    EXPECT_NE(refusal(folder, campaign).find(sentence), std::string::npos)
      << refusal(folder, campaign);
  };
  const auto design = [&](const std::string &entries) {
    return text("subsection Campaign\n subsection Design\n" + entries +
                " end\nend\n");
  };
  expect(replaced(text(), "Load/Velocity", "Load / Pressure"),
         "'Load/Pressure' is already Input 1; expected each entry once.");
  expect(replaced(text(), "Initial runs = 8", "Initial runs = 3"),
         "found 3 runs; expected at least 4 for a law of 2 inputs");
  expect(design("  set Kind = grid\n  set Grid points = 2.5, 3\n"),
         "found 2.5; expected whole numbers.");
  expect(design("  set Kind = grid\n  set Grid points = 1000, 1000\n"),
         "found 1e+06 runs; expected at least 4 for a law of 2 inputs and at "
         "most 5000.");
  expect(design("  set Kind = grid\n  set Grid points = 5, 5\n"),
         "found 20; expected at least the 25 initial runs.");
  expect(text("subsection Campaign\n set Profile positions = row 1\nend\n"),
         "found 'row 1', but the tool of the base scene is not measured "
         "(Tool/Kind); expected nothing.");
  expect(text("subsection Campaign\n set Profile positions = a, a\nend\n"),
         "found 'a' twice; expected positions that differ.");
  expect(replaced(text(), (folder / "out").string(), " "),
         "found nothing; expected a folder for the campaign.");
  expect(replaced(text(), "Load/Velocity", "Mesh/Spans"), "'22.5 m/min'");
  expect(
    replaced(text(), "Load/Velocity", "Lubrication/Model"),
    "found 'Lubrication/Model', whose value is no number; expected an entry "
    "that takes a number.");
  expect(replaced(text(), "Load/Velocity", "Output/Picture interval"),
         "expected an entry that is not of the subsection Output.");
  expect(text("subsection Export\n set Table tolerance = 1\nend\n"),
         "Table tolerance");
}



TEST_F(Plan, profiles_beyond_the_map_are_refused)
{
  use_measured_tool();
  EXPECT_NE(refusal(folder,
                    text("subsection Campaign\n set Profile positions = 10 um, "
                         "10 mm\nend\n"))
              .find("entry 'Campaign/Profile positions': "),
            std::string::npos);
}



// At which a table over p, v and T alone is written.
TEST_F(Plan, further_inputs_have_a_value_for_tables)
{
  std::ofstream(folder / "scene.prm")
    << "subsection Lubrication\n set Model = pocket\n set Wetting = 0.8\nend\n";
  const auto reference = [&](const std::string &from, const std::string &at) {
    const CampaignInput input(folder,
                              replaced(replaced(replaced(text(),
                                                         "Load/Velocity",
                                                         "Lubrication/Wetting"),
                                                "22.5 m/min",
                                                from),
                                       "200 m/min",
                                       "1" + at));
    return *CampaignPlan(input.parameters, input.declarator)
              .inputs()[1]
              .reference;
  };
  EXPECT_EQ(reference("0.2", ""), 0.8);
  EXPECT_DOUBLE_EQ(reference("0.9", ""), std::sqrt(0.9)); // logarithmic
  EXPECT_EQ(reference("0.2", "\n  set Export at = 40 %"), 0.4);
  const CampaignInput input(
    folder,
    replaced(replaced(replaced(text(), "Load/Velocity", "Lubrication/Wetting"),
                      "22.5 m/min",
                      "0.2"),
             "200 m/min",
             "1"));
  EXPECT_NE(CampaignPlan(input.parameters, input.declarator)
              .description(input.parameters)
              .find("Wetting: Lubrication/Wetting, 0.2 to 1; an argument of "
                    "exported C and Fortran, 0.8 in exported tables (Export "
                    "at)\n"),
            std::string::npos);
  EXPECT_NE(refusal(folder,
                    replaced(text(),
                             "set To = 200 m/min",
                             "set To = 200 m/min\n  set Export at = 3 m/s"
                             "\n  set Export at = 5 m/s"))
              .find("Export at"),
            std::string::npos);
}



TEST_F(Plan, entries_of_whole_numbers_get_whole_numbers)
{
  const CampaignInput input(
    folder,
    replaced(replaced(replaced(text(), "Load/Velocity", "Mesh/Spans"),
                      "22.5 m/min",
                      "16"),
             "200 m/min",
             "64"));
  CampaignPlan plan(input.parameters, input.declarator);
  plan.start(input.parameters, (folder / "plan.json").string());
  for (const PlannedPoint &point : plan.points())
    EXPECT_EQ(point.x[1], std::round(point.x[1]));
  EXPECT_EQ(plan.inputs()[1].symbol, "Spans");
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



TEST_F(Plan, takes_an_oil_film_and_refuses_what_no_model_reads)
{
  const std::string by_film =
    replaced(replaced(replaced(text(), "Load/Velocity", "Lubrication/Oil film"),
                      "22.5 m/min",
                      "20 nm"),
             "200 m/min",
             "300 nm");
  const std::string oil = "subsection Lubrication\n set Model = pocket\n";
  std::ofstream(folder / "scene.prm") << oil << "end\n";
  EXPECT_NE(refusal(folder, by_film)
              .find("entry 'Campaign/Input 2/Entry': found 'Lubrication/Oil "
                    "film', on which the friction of the base scene does not "
                    "depend; it counts only with the Oil amount film "
                    "thickness."),
            std::string::npos)
    << refusal(folder, by_film);

  std::ofstream(folder / "scene.prm")
    << oil << " set Oil amount = film thickness\nend\n";
  EXPECT_EQ(refusal(folder, by_film), "");
}
