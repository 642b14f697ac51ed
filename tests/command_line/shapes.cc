#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

#include "program.h"

// Shapes that are learned by a tiny network for a moment: that tables and
// pictures have what they say, and that the model is the same bits on two ranks
// and after a resumption.

using namespace asperity;

namespace
{
  class LearnShapes : public Program
  {
  protected:
    std::string
    study(const std::string &directory, const unsigned int epochs) const
    {
      return "subsection Shapes\n set Shapes of each kind = 3\n"
             " set Magnitudes = 1\n set Held out of each kind = 1\n"
             " set Points = 200\nend\n"
             "subsection Network\n set Latent dimension = 2\n"
             " set Layers = 2\n set Width = 8\n set Fed again at = 1\nend\n"
             "subsection Training\n set Points of a batch = 50\n"
             " set Epochs = " +
             std::to_string(epochs) +
             "\nend\nsubsection Output\n set Cells = 12\n"
             " set Interpolated pairs = 1\n set Perplexity = 2\n"
             " set Output directory = " +
             directory + "\nend\n";
    }

    void
    learn(const std::string &directory,
          const unsigned int epochs,
          const std::string &launcher = "") const
    {
      write("study.prm", study(directory, epochs));
      const Result result = run("shapes study.prm", launcher);
      EXPECT_EQ(result.status, 0) << result.errors;
      EXPECT_EQ(result.errors, "");
    }

    std::string
    refused(const std::string &text) const
    {
      write("study.prm", text);
      const Result result = run("shapes study.prm");
      EXPECT_EQ(result.status, 2);
      return result.errors;
    }
  };

  unsigned int
  n_lines(const std::string &text)
  {
    return std::count(text.begin(), text.end(), '\n');
  }
} // namespace



TEST_F(LearnShapes, gives_the_same_model_on_two_ranks_and_after_a_resumption)
{
  learn("whole", 6);
  const std::string model = read("whole/model.asperity");
  EXPECT_GT(model.size(), 1000u);
  learn("two", 6, "mpirun -np 2");
  EXPECT_EQ(read("two/model.asperity"), model);
  EXPECT_EQ(read("two/shapes.csv"), read("whole/shapes.csv"));
  learn("resumed", 2);
  EXPECT_NE(read("resumed/model.asperity"), model);
  learn("resumed", 6);
  EXPECT_EQ(read("resumed/model.asperity"), model);

  // four kinds of three and one, a header; 21 places on the way
  EXPECT_EQ(n_lines(read("whole/shapes.csv")), 1 + 4 * 3 + 4 * 1u);
  EXPECT_EQ(n_lines(read("whole/interpolation.csv")), 1 + 21u);
  // a square's two deformations, for hexagon and disc
  EXPECT_EQ(n_lines(read("whole/arithmetic.csv")), 1 + 4u);
  const auto summary = nlohmann::json::parse(read("whole/summary.json"));
  EXPECT_EQ(summary["trained"]["shapes"], 12);
  EXPECT_EQ(summary["held out"]["shapes"], 4);
  EXPECT_NE(read("whole/shapes.vtu").find("NumberOfCells"), std::string::npos);
}



TEST_F(LearnShapes, refuses_what_contradicts_itself)
{
  EXPECT_EQ(refused("subsection Network\n set Fed again at = 5\nend\n"),
            "Error: study.prm, line 2, entry 'Network/Fed again at': found 5; "
            "expected at most the number of layers, 4.\n");
  EXPECT_EQ(refused("subsection Shapes\n set Shapes of each kind = 10\nend\n"),
            "Error: entry 'Output/Perplexity': expected less than a third of "
            "the number of shapes, 40.\n");
}
