#include <asperity/surrogate/friction_law.h>

#include <algorithm>
#include <sstream>

#include "../law_export/javascript.h"
#include "program.h"

using namespace asperity;
using asperity_test::browser;
using asperity_test::LawKind;

// tools/report as its users call it, and its page of a law in a real browser.

namespace
{
  const std::string hostile = "<script>alert(1)</script>";

  /** A scene that is computed in a moment. */
  const std::string scene =
    "subsection Mesh\n set Spans = 32\n set Refinement levels = 1\nend\n"
    "subsection Protocol\n set Ramp steps = 4\n set Slide steps = 8\n"
    " set Inertia = quasi-static\nend\n";

  class Report : public Program
  {
  protected:
    void
    SetUp() override
    {
      Program::SetUp();
      if (std::system("/usr/bin/python3 -c 'import matplotlib, numpy' "
                      "2>/dev/null") != 0)
        GTEST_SKIP() << "matplotlib was not found";
    }

    /** Exit status and message of the tool. */
    Result
    report(const std::string &arguments) const
    {
      const std::filesystem::path program = ASPERITY_PROGRAM;
      const std::string           command =
        "cd '" + folder.string() + "' && ASPERITY_FRICTION_LIBRARY='" +
        (program.parent_path() / "libasperity_friction.so").string() +
        "' '" ASPERITY_SOURCE_DIR "/tools/report' --program '" +
        program.string() + "' " + arguments + " >output.txt 2>errors.txt";
      const int status = std::system(command.c_str());
      return {WEXITSTATUS(status), read("output.txt"), read("errors.txt")};
    }

    /** The page of a folder, which has to stand alone. */
    std::string
    page_of(const std::string &name) const
    {
      const Result result = report(name);
      EXPECT_EQ(result.status, 0) << result.errors;
      EXPECT_EQ(result.output, name + "/report.html\n");
      const std::string page = read(name + "/report.html");
      for (const char *const word :
           {"src=\"http", "href=\"http", "<link", "@import", "url(", "src=\"/"})
        EXPECT_EQ(page.find(word), std::string::npos) << word;
      EXPECT_EQ(page.find(hostile), std::string::npos);
      return page;
    }

    void
    make(const std::string &name) const
    {
      std::filesystem::create_directories(folder / name);
    }

    /** What a script leaves in the element "probe" of a page in the browser. */
    std::string
    probe(const std::string &page, const std::string &script) const
    {
      write("probed.html",
            page.substr(0, page.rfind("</body>")) +
              "<pre id=\"probe\"></pre><script>" + script +
              "</script></body></html>");
      const std::string command = "cd '" + folder.string() + "' && " +
                                  browser() +
                                  " --dump-dom probed.html >dom.html 2>log.txt";
      EXPECT_EQ(std::system(command.c_str()), 0) << read("log.txt");
      const std::string dom = read("dom.html"), mark = "<pre id=\"probe\">";
      const std::size_t begin = dom.find(mark) + mark.size();
      return dom.substr(begin, dom.find("</pre>", begin) - begin);
    }

    /** Every occurrence of a word becomes another one. */
    static std::string
    replaced(std::string text, const std::string &word, const std::string &by)
    {
      for (std::size_t at = text.find(word); at != std::string::npos;
           at             = text.find(word, at + by.size()))
        text.replace(at, word.size(), by);
      return text;
    }

    static unsigned int
    count(const std::string &text, const std::string &word)
    {
      unsigned int n = 0;
      for (std::size_t at = text.find(word); at != std::string::npos;
           at             = text.find(word, at + 1))
        ++n;
      return n;
    }

    static bool
    holds(const std::string &text, const std::string &word)
    {
      return text.find(word) != std::string::npos;
    }
  };

  /** Moves all sliders to shares of their ways, and tells a line of what the
   * page then shows for each row of shares. */
  const char *const move_sliders = R"(
document.getElementById("probe").textContent = shares.map((row) => {
  const shown = row.map((share, i) => {
    const slider = document.getElementById(`law-input-${i}`);
    slider.value = 1000 * share;
    slider.dispatchEvent(new Event("input"));
    return document.getElementById(`law-value-${i}`).textContent;
  });
  const text = (name) => document.getElementById(`law-${name}`).textContent;
  return [...shown, text("mu"), text("run"), text("surface"), text("trust")]
    .join(";");
}).join("\n");
)";

  std::vector<std::string>
  split(const std::string &text, const char at)
  {
    std::vector<std::string> parts;
    std::istringstream       in(text);
    for (std::string part; std::getline(in, part, at);)
      parts.push_back(part);
    return parts;
  }

  /** The numbers of a text, "0.1 to 0.2". */
  std::vector<double>
  numbers(const std::string &text)
  {
    std::vector<double> result;
    for (const std::string &word : split(text, ' '))
      {
        char        *end   = nullptr;
        const double value = std::strtod(word.c_str(), &end);
        if (end != word.c_str())
          result.push_back(value);
      }
    return result;
  }

  void
  expect_numbers(const std::string &text, const std::vector<double> &expected)
  {
    const std::vector<double> found = numbers(text);
    ASSERT_EQ(found.size(), expected.size()) << text;
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 1e-4 * std::abs(expected[i])) << text;
  }
} // namespace



// The page rounds the inputs that it shows to five digits, as `predict` does
// mu.
TEST_F(Report, sliders_of_a_law_show_what_predict_says)
{
  if (browser().empty())
    GTEST_SKIP() << "chromium was not found";
  LawKind strained;
  strained.has_strain = strained.over_k = true;
  make("law");
  asperity_test::train(strained, 60).save((folder / "law/friction_law.json"));
  std::string script = "const shares = [";
  for (std::size_t j = 0; j < 12; ++j)
    {
      script += "[";
      for (const double u : asperity_test::evenly_spread_point(j, 4))
        script += std::to_string(j < 6 ? 0.25 + 0.5 * u : u) + ",";
      script += "],";
    }
  const auto lines =
    split(probe(page_of("law"), script + "];\n" + move_sliders), '\n');
  ASSERT_EQ(lines.size(), 12u);
  unsigned int trusted = 0;
  for (std::size_t j = 0; j < lines.size(); ++j)
    {
      SCOPED_TRACE(lines[j]);
      const auto shown =
        split(replaced(replaced(lines[j], "\u2212", "-"), "\u00b0C", "degC"),
              ';');
      ASSERT_EQ(shown.size(), 8u);
      const Result said = run("predict law/friction_law.json -p '" + shown[0] +
                              "' -v '" + shown[1] + "' -T '" + shown[2] +
                              "' --plastic-strain '" + shown[3] + "'");
      ASSERT_EQ(said.status, 0) << said.errors;
      const auto answer = split(said.output, '\n');
      // "mu = 0.1, 95 % interval 0.09 to 0.11"
      const auto of_run = numbers(replaced(answer[0], ",", " "));
      expect_numbers(shown[4], {of_run[0]});
      expect_numbers(shown[5], {of_run[2], of_run[3]});
      // "whole surface: 95 % interval 0.08 to 0.12, from 3 profiles"
      const auto of_surface = numbers(replaced(answer[3], ",", " "));
      expect_numbers(shown[6], {of_surface[1], of_surface[2]});
      EXPECT_EQ(shown[7], answer[1].substr(0, answer[1].find(':')));
      trusted += shown[7] == "trusted";
    }
  EXPECT_GE(trusted, 4u);
  EXPECT_LE(trusted, 11u);
}

// The picture follows the sliders and the choice of its axis, and the line of
// errors has those of the choices in it.
TEST_F(Report, the_page_of_a_law_follows_its_reader)
{
  if (browser().empty())
    GTEST_SKIP() << "chromium was not found";
  make("law");
  LawKind wet;
  wet.has_wetting = true;
  asperity_test::train(wet, 60).save((folder / "law/friction_law.json"));
  write("law/choices.json",
        "{\"mu\": 0.2, \"spread\": {\"preparation\": {\"below\": 0.25, "
        "\"above\": 0.5}}, \"variations\": []}");
  const Result result =
    report("law --to page.html --sensitivity law/choices.json");
  ASSERT_EQ(result.status, 0) << result.errors;
  const auto lines = split(probe(read("page.html"), R"(
const plot = document.getElementById("law-plot");
const picture = () => plot.querySelector(".beyond").getAttribute("d");
const line = () => document.getElementById("law-line").textContent;
const slider = document.getElementById("law-input-1");
const over = document.getElementById("law-over");
const pictures = [picture()];
const first = line();
slider.value = 900;
slider.dispatchEvent(new Event("input"));
pictures.push(picture());
over.value = 1;
over.dispatchEvent(new Event("change"));
pictures.push(picture());
document.getElementById("probe").textContent =
  [new Set(pictures).size, /NaN/.test(plot.innerHTML), first, line()].join("\n");
)"),
                           '\n');
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0], "3");
  EXPECT_EQ(lines[1], "false");
  EXPECT_NE(lines[2], lines[3]);
  EXPECT_TRUE(holds(lines[2], "(preparation)"));
  EXPECT_TRUE(holds(lines[2], "(profile for surface)"));
}

TEST_F(Report, a_run_says_its_errors_and_why)
{
  write("scene.prm",
        scene + "subsection Accuracy\n set Control = estimate\nend\n"
                "subsection Output\n set Output directory = run\nend\n");
  ASSERT_EQ(run("scene.prm").status, 0);
  const std::string page = page_of("run");
  EXPECT_EQ(count(page, "data:image/png;base64,"), 2u);
  for (const char *const text : {"(numerics)",
                                 "(spread over time)",
                                 "penalty of the contact",
                                 "left if µ is corrected",
                                 "below about 4 asperities are jumped over",
                                 "asperity run/parameters.prm",
                                 "set Refinement levels = 1"})
    EXPECT_TRUE(holds(page, text)) << text;
}

TEST_F(Report, a_campaign_shows_its_pictures_and_goes_on_from_its_file)
{
  write("scene.prm", scene);
  write("campaign.prm",
        "subsection Campaign\n set Base scene = scene.prm\n"
        " set Output directory = law\n subsection Input 1\n"
        "  set Entry = Load/Pressure\n  set From = 300 MPa\n"
        "  set To = 1300 MPa\n end\n subsection Input 2\n"
        "  set Entry = Load/Temperature\n  set From = 25 degC\n"
        "  set To = 700 degC\n end\n subsection Design\n"
        "  set Initial runs = 6\n  set Batch = 0\n  set Test runs = 2\n"
        " end\nend\n");
  ASSERT_EQ(run("characterize campaign.prm").status, 0);
  const std::string page = page_of("law");
  EXPECT_EQ(count(page, "data:image/png;base64,"), 5u);
  for (const char *const text : {"asperity characterize law/campaign.prm",
                                 "set Initial runs = 6",
                                 "const friction_law = (function (model)",
                                 "one: how far others differ is not known"})
    EXPECT_TRUE(holds(page, text)) << text;
  const Result again = run("characterize law/campaign.prm");
  EXPECT_EQ(again.status, 0) << again.errors;
  EXPECT_TRUE(holds(again.output, "8 of 8 runs are in ")) << again.output;
}

TEST_F(Report, a_run_without_pictures_and_with_hostile_names)
{
  make("run");
  write("run/friction.csv", "step [-],time [s],mu [-]\n");
  write("run/summary.json",
        "{\"friction\": {\"mu\": 0.25, \"valid\": false, \"status\": \"" +
          hostile + "\"}, \"load\": {\"pressure\": 3e8}, \"audit\": {\"" +
          hostile + "\": 0.5, \"slope\": {\"value\": null, \"meaning\": \"" +
          hostile + "\"}}, \"warnings\": [\"" + hostile +
          "\"], \"mechanisms\": [\"" + hostile + "\"]}");
  write("run/parameters.prm", "# </pre>" + hostile + "\n");
  const std::string page = page_of("run");
  for (const char *const text : {"\u00b5 = 0.25",
                                 "300 MPa",
                                 "was not estimated",
                                 "Not all pictures could be drawn",
                                 "&lt;script&gt;alert(1)&lt;/script&gt;"})
    EXPECT_TRUE(holds(page, text)) << text;
}

TEST_F(Report, a_sensitivity_is_a_table_with_its_interval)
{
  write("sensitivity.json",
        "{\"mu\": 0.2, \"spread\": {\"profile\": {\"below\": 0.25, \"above\": "
        "0.25}, \"scene\": {\"below\": 0.1, \"above\": 0.5}}, \"variations\": ["
        "{\"entry\": \"Tool/Position\", \"value\": \"" +
          hostile +
          "\", \"kind\": \"profile\", \"mu\": 0.25}, {\"entry\": \"Load/X\", "
          "\"value\": \"2\", \"kind\": \"scene\", \"reason\": \"no step\"}]}");
  EXPECT_EQ(report("sensitivity.json").output, "./report.html\n");
  const std::string page = read("report.html");
  EXPECT_EQ(page.find(hostile), std::string::npos);
  for (const char *const text : {"\u00b1 0.05 <small>(profile for surface)",
                                 "+0.1 \u22120.02 <small>(scene)",
                                 "+25.0 %",
                                 "no step"})
    EXPECT_TRUE(holds(page, text)) << text;
}

TEST_F(Report, charts_are_shown_in_their_order)
{
  make("charts/10_last");
  make("charts/2_first");
  write("charts/2_first/README.md",
        "# Cost over error\n\nDegree 2 **wins**, see `a.csv` and [it](../x.md)."
        "\n\n" +
          hostile + "\n");
  write("charts/2_first/a.csv",
        "# machine: " + hostile + "\nx,y\n1," + hostile);
  write("charts/2_first/a.png", "picture");
  write("charts/2_first/a.svg", "<svg/>");
  const std::string page = page_of("charts");
  EXPECT_LT(page.find("<h2>Cost over error</h2>"),
            page.find("<h2>10 last</h2>"));
  EXPECT_TRUE(holds(page, "<strong>wins</strong>"));
  EXPECT_EQ(count(page, "data:image/"), 1u) << "the SVG is that of the PNG";
  EXPECT_TRUE(holds(page, "The folder has no picture yet."));
}

TEST_F(Report, what_is_no_result_ends_with_one_sentence)
{
  const auto complaint = [&](const std::string &arguments) {
    const Result result = report(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.output, "");
    EXPECT_EQ(result.errors.substr(0, 8), "report: ");
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1)
      << result.errors;
    return result.errors;
  };
  EXPECT_TRUE(holds(complaint("nothing"), "nothing is no folder and no file"));
  make("empty");
  EXPECT_TRUE(holds(complaint("empty"), "is no output directory of a run"));
  make("campaign");
  write("campaign/plan.json", "{}");
  EXPECT_TRUE(holds(complaint("campaign"), "without a law yet"));
  write("campaign/friction_law.json", "{\"inputs\": ");
  EXPECT_TRUE(holds(complaint("campaign"), "friction_law.json is not JSON"));
  write("campaign/friction_law.json", "{}");
  EXPECT_TRUE(holds(complaint("campaign"), "is no friction law"));
  asperity_test::train(LawKind()).save((folder / "law.json"));
  write("campaign/friction_law.json",
        replaced(read("law.json"), "\"MPa\"", "\"GPa\""));
  EXPECT_TRUE(holds(complaint("campaign"), "cannot be exported: Error: "));
  write("other.json", "{\"mu\": 0.2}");
  EXPECT_TRUE(holds(complaint("other.json"), "a result of 'asperity sens"));
  write("other.json", "[1]");
  EXPECT_TRUE(holds(complaint("other.json"), "holds no object"));
  make("run");
  write("run/friction.csv", "");
  write("run/summary.json", "\xff\xfe");
  EXPECT_TRUE(holds(complaint("run"), "cannot be read"));
}
