#include <asperity/base/errors.h>
#include <asperity/surrogate/sample_table.h>

#include <limits>

#include "../files.h"
#include "example_inputs.h"

using namespace asperity;

namespace
{
  Sample
  finished_run(const unsigned int id, const double mu)
  {
    Sample sample;
    sample.id        = id;
    sample.x         = {300e6, 1. / 3., 298.15};
    sample.outputs   = {mu, 1e9 * mu};
    sample.deviation = 0.01 * mu;
    return sample;
  }

  Sample
  failed_run(const unsigned int id)
  {
    Sample sample;
    sample.id     = id;
    sample.x      = {1300e6, 3., 1173.15};
    sample.role   = SampleRole::test;
    sample.status = SampleStatus::failed;
    sample.reason = "Newton's method, in step 3, found \"nan\"\nand gave up.";
    return sample;
  }

  SampleTable
  example_table()
  {
    SampleTable table(example_inputs(), {{"mu", "-"}, {"oil_pressure", "Pa"}});
    table.add(finished_run(7, 0.1 + 0.2));
    table.add(failed_run(3));
    table.add(finished_run(1, 1. / 3.));
    return table;
  }

  void
  expect_equal(const Sample &a, const Sample &b)
  {
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.role, b.role);
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.outputs, b.outputs);
    EXPECT_EQ(a.deviation, b.deviation);
  }

  /** What the reader says of a table in which one text stands for another. */
  std::string
  complaint(const std::string &from, const std::string &to)
  {
    const std::string path = test_folder() + "/runs.csv";
    example_table().write(path);
    std::string text = content(path);
    const auto  at   = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    overwrite(path, text.replace(at, from.size(), to));
    const auto message =
      message_of<InputError>([&]() { SampleTable::read(path); });
    EXPECT_NE(message.find(path), std::string::npos) << message;
    EXPECT_EQ(message.back(), '.') << message;
    return message;
  }
} // namespace



TEST(SampleTable, reads_back_what_was_written)
{
  const std::string path  = test_folder() + "/a/runs.csv";
  const SampleTable table = example_table();
  table.write(path);
  const SampleTable back = SampleTable::read(path);

  ASSERT_EQ(back.inputs().size(), 3u);
  for (unsigned int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(back.inputs()[i].name, table.inputs()[i].name);
      EXPECT_EQ(back.inputs()[i].symbol, table.inputs()[i].symbol);
      EXPECT_EQ(back.inputs()[i].unit, table.inputs()[i].unit);
      EXPECT_EQ(back.inputs()[i].lower, table.inputs()[i].lower);
      EXPECT_EQ(back.inputs()[i].upper, table.inputs()[i].upper);
      EXPECT_EQ(back.inputs()[i].scale, table.inputs()[i].scale);
    }
  ASSERT_EQ(back.outputs().size(), 2u);
  EXPECT_EQ(back.outputs()[1].name, "oil_pressure");
  EXPECT_EQ(back.outputs()[1].unit, "Pa");
  ASSERT_EQ(back.samples().size(), 3u);
  for (const Sample &sample : table.samples())
    {
      ASSERT_NE(back.find(sample.id), nullptr);
      expect_equal(*back.find(sample.id), sample);
    }
  // only the line break of the reason is gone
  EXPECT_EQ(back.find(3)->reason,
            "Newton's method, in step 3, found \"nan\" and gave up.");
  EXPECT_EQ(back.find(4), nullptr);
  EXPECT_EQ(n_files(test_folder()), 0u);
}



TEST(SampleTable, is_a_table_with_units_that_other_programs_read)
{
  const std::string path = test_folder() + "/runs.csv";
  SampleTable       table(example_inputs(), {{"mu", "-"}});
  Sample            run = failed_run(3);
  table.add(run);
  run         = finished_run(1, 0.25);
  run.outputs = {0.25};
  table.add(run);
  table.write(path);
  EXPECT_EQ(content(path),
            "# Asperity sample table, version 1; values in SI units\n"
            "# input: p; Load/Pressure; MPa; 300000000; 1300000000; linear\n"
            "# input: v; Load/Velocity; m/min; 0.375; 3.3333333333333335; "
            "logarithmic\n"
            "# input: T; Load/Temperature; degC; 298.15; 1173.15; linear\n"
            "id,role,status,p [Pa],v [m/s],T [K],mu [-],deviation of mu [-],"
            "reason\n"
            "1,training,done,300000000,0.3333333333333333,298.15,0.25,0.0025,"
            "\n"
            "3,test,failed,1300000000,3,1173.15,,,\"Newton's method, in step "
            "3, found \"\"nan\"\" and gave up.\"\n");
}



TEST(SampleTable, the_order_in_which_runs_ended_does_not_matter)
{
  const std::string folder = test_folder();
  example_table().write(folder + "/first.csv");
  SampleTable other(example_inputs(), {{"mu", "-"}, {"oil_pressure", "Pa"}});
  other.add(finished_run(1, 1. / 3.));
  other.add(failed_run(3));
  other.add(finished_run(7, 0.1 + 0.2));
  other.write(folder + "/second.csv");
  EXPECT_EQ(content(folder + "/first.csv"), content(folder + "/second.csv"));
}



TEST(SampleTable, gives_the_data_that_a_law_is_trained_on)
{
  SampleTable table = example_table();
  Sample      test  = finished_run(9, 0.5);
  test.role         = SampleRole::test;
  table.add(test);
  EXPECT_EQ(table.count(SampleRole::training, SampleStatus::done), 2u);
  EXPECT_EQ(table.count(SampleRole::test, SampleStatus::done), 1u);
  EXPECT_EQ(table.count(SampleRole::test, SampleStatus::failed), 1u);

  const SampleData mu = table.data(SampleRole::training, "mu");
  EXPECT_EQ(mu.id, (std::vector<unsigned int>{1, 7}));
  EXPECT_EQ(mu.x.size(), 6u);
  EXPECT_EQ(mu.y, (std::vector<double>{1. / 3., 0.1 + 0.2}));
  EXPECT_EQ(mu.deviation,
            (std::vector<double>{0.01 * (1. / 3.), 0.01 * (0.1 + 0.2)}));

  const SampleData oil = table.data(SampleRole::test, "oil_pressure");
  EXPECT_EQ(oil.y, (std::vector<double>{5e8}));
  EXPECT_TRUE(oil.deviation.empty());

  const auto message =
    message_of<InputError>([&]() { table.data(SampleRole::test, "friction"); });
  EXPECT_EQ(message,
            "The sample table has no output 'friction'; it has mu, "
            "oil_pressure.");
}



TEST(SampleTable, refuses_runs_that_do_not_fit)
{
  SampleTable table   = example_table();
  auto        refusal = [&](const auto &change) {
    Sample sample = finished_run(11, 0.2);
    change(sample);
    return message_of<InputError>([&]() { table.add(sample); });
  };
  EXPECT_NE(refusal([](Sample &s) { s.id = 7; }).find("stands twice"),
            std::string::npos);
  EXPECT_NE(refusal([](Sample &s) { s.x.pop_back(); }).find("inputs"),
            std::string::npos);
  EXPECT_NE(refusal([](Sample &s) { s.outputs = {}; }).find("outputs"),
            std::string::npos);
  EXPECT_NE(refusal([](Sample &s) {
              s.outputs[0] = 0. / s.x[0] / 0.;
            }).find("not a finite number"),
            std::string::npos);
  EXPECT_NE(refusal([](Sample &s) { s.deviation = -1.; }).find("deviation -1"),
            std::string::npos);
  EXPECT_NE(refusal([](Sample &s) {
              s.status  = SampleStatus::failed;
              s.outputs = {};
            }).find("without a reason"),
            std::string::npos);

  auto inputs      = example_inputs();
  inputs[1].symbol = "p";
  inputs[1].unit   = "GPa";
  EXPECT_THROW(SampleTable(inputs, {{"mu", "-"}}), InputError);
  inputs[1].symbol = "a;b";
  EXPECT_THROW(SampleTable(inputs, {{"mu", "-"}}), InputError);
  inputs[1].symbol = "v";
  inputs[1].unit   = "furlong";
  EXPECT_NE(message_of<InputError>([&]() {
              SampleTable(inputs, {{"mu", "-"}});
            }).find("'furlong' is not a known unit"),
            std::string::npos);
  EXPECT_THROW(SampleTable(example_inputs(), {}), InputError);
}



TEST(SampleTable, says_what_is_wrong_with_a_file)
{
  EXPECT_NE(complaint("version 1", "version 2")
              .find("the line is not that of a sample table; '# Asperity"),
            std::string::npos);
  EXPECT_NE(complaint("; linear", "").find("Line 2"), std::string::npos);
  EXPECT_NE(complaint("; linear", "; square").find("'linear'"),
            std::string::npos);
  EXPECT_NE(complaint("mu [-]", "mu").find("unit in brackets"),
            std::string::npos);
  EXPECT_NE(complaint("p [Pa]", "p [MPa]").find("headings"), std::string::npos);
  const std::string number =
    complaint("1,training,done,300", "1,training,done,x");
  EXPECT_NE(number.find("Line 6"), std::string::npos);
  EXPECT_NE(number.find("'p [Pa]' 'x000000' is not a plain number"),
            std::string::npos);
  EXPECT_NE(complaint("1,training", "1.5,training").find("whole number"),
            std::string::npos);
  EXPECT_NE(complaint("7,training", "1,training").find("stands twice"),
            std::string::npos);
  EXPECT_NE(complaint("training,done", "practice,done").find("'practice'"),
            std::string::npos);
  EXPECT_NE(complaint("training,done", "training,failed").find("nothing"),
            std::string::npos);
  EXPECT_NE(complaint("gave up.\"", "gave up.").find("not closed"),
            std::string::npos);
  EXPECT_NE(complaint("1,training,done", "1,done").find("columns"),
            std::string::npos);

  const std::string missing = test_folder() + "/missing.csv";
  EXPECT_NE(message_of<InputError>([&]() {
              SampleTable::read(missing);
            }).find(missing),
            std::string::npos);
}
