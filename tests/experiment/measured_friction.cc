#include <asperity/base/errors.h>
#include <asperity/experiment/measured_friction.h>

#include <gtest/gtest.h>

#include "../files.h"

using namespace asperity;

namespace
{
  MeasuredFriction
  read(const std::string &text)
  {
    const std::string path = test_folder() + "/measured.csv";
    overwrite(path, text);
    return MeasuredFriction::read(path);
  }

  /** The sentence behind the place and the name of the file. */
  std::string
  complaint(const std::string &text)
  {
    const std::string message = message_of<InputError>([&] { read(text); });
    EXPECT_EQ(message.rfind("Line ", 0), 0u) << message;
    return message.substr(0, message.find(" of the measurements")) +
           message.substr(message.find(".csv: ") + 4);
  }
} // namespace

TEST(MeasuredFriction, reads_units_texts_and_gaps)
{
  MeasuredFriction measured =
    read("\xef\xbb\xbf# AISI 1045\r\n"
         "v [m/min],T [degC],mu,deviation of mu,series,source\r\n"
         "\r\n"
         "# slow\n"
         "5, 300 ,0.54,0.02,dry,\"Lee (2025), section 2.1\"\n"
         "120,,0.31,,wet,\"says \"\"wet\"\"\"\n");
  ASSERT_EQ(measured.points().size(), 2u);
  const MeasuredPoint &slow = measured.points()[0],
                      &fast = measured.points()[1];
  EXPECT_EQ(slow.line, 5u);
  EXPECT_DOUBLE_EQ(measured.value(slow, "v"), 5. / 60.);
  EXPECT_DOUBLE_EQ(measured.value(slow, "T"), 573.15);
  EXPECT_EQ(slow.mu, 0.54);
  EXPECT_EQ(slow.deviation, 0.02);
  EXPECT_EQ(slow.series, "dry");
  EXPECT_EQ(slow.source, "Lee (2025), section 2.1");
  EXPECT_EQ(fast.source, "says \"wet\"");
  EXPECT_FALSE(fast.deviation);
  EXPECT_NE(message_of<InputError>([&] {
              measured.value(fast, "T");
            }).find(" has no T, but a number is expected."),
            std::string::npos);
  EXPECT_NE(message_of<InputError>([&] {
              measured.value(fast, "p");
            }).find(" have no column 'p'; they have v, T."),
            std::string::npos);
  EXPECT_NE(message_of<InputError>([&] {
              measured.deviations();
            }).find("1 of 2 have a deviation of mu; all or none"),
            std::string::npos);

  EXPECT_EQ(measured.series(), (std::vector<std::string>{"dry", "wet"}));
  EXPECT_NE(message_of<InputError>([&] {
              measured.choose("");
            }).find("are of the series dry, wet; one or more of them"),
            std::string::npos);
  EXPECT_NE(message_of<InputError>([&] {
              measured.choose("damp");
            }).find("have no series 'damp'; they have dry, wet."),
            std::string::npos);
  measured.choose("dry");
  EXPECT_EQ(measured.points().size(), 1u);
  EXPECT_EQ(measured.deviations(), std::vector<double>{0.02});
}

TEST(MeasuredFriction, says_what_is_wrong_with_a_file)
{
  EXPECT_EQ(complaint("mu,speed\n0.3,5\n"),
            "Line 1: the heading 'speed' was found, but mu, deviation of mu, "
            "series, source, or an input with its unit, such as 'v [m/min]', "
            "is expected.");
  EXPECT_EQ(complaint("mu,v [MPa]\n0.3,5\n"),
            "Line 1: the heading 'v [MPa]' was found, but a unit of a velocity "
            "is expected.");
  EXPECT_NE(complaint("mu,v [knots]\n0.3,5\n").find("'v [knots]'"),
            std::string::npos);
  EXPECT_EQ(complaint("v [m/s]\n5\n"),
            "Line 1: the headings have no column 'mu', but the friction "
            "coefficient is expected.");
  EXPECT_EQ(complaint("mu,v [m/s],v [m/min]\n0.3,5,5\n"),
            "Line 1: two columns are called 'v [m/min]', but different names "
            "are expected.");
  EXPECT_EQ(complaint("# nothing\nmu\n0.3,5\n"),
            "Line 3: 2 columns were found, but 1 are expected.");
  EXPECT_EQ(complaint("mu\n-0.3\n"),
            "Line 2: in the column 'mu' '-0.3' was found, but a positive "
            "number is expected.");
  EXPECT_NE(complaint("mu\n\n0,3\n").find("2 columns were found"),
            std::string::npos);
  EXPECT_NE(complaint("mu\nabout 0.3\n").find("in the column 'mu'"),
            std::string::npos);
  EXPECT_NE(complaint("mu\nnan\n").find("in the column 'mu'"),
            std::string::npos);
  EXPECT_EQ(complaint("mu,source\n0.3,\"open\n"),
            "Line 2: a quote is opened, but not closed.");
  EXPECT_EQ(complaint("# a comment\n"),
            "Line 1: the file ends before its headings, but a line such as 'v "
            "[m/min],mu' is expected.");
  EXPECT_EQ(complaint("mu\n"),
            "Line 1: the file ends behind its headings, but a measurement is "
            "expected.");
  EXPECT_NE(message_of<InputError>([] { MeasuredFriction::read("/nowhere"); }),
            "");
}
