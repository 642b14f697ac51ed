#include <asperity/base/archive.h>
#include <asperity/base/errors.h>

#include <gtest/gtest.h>

#include "problems.h"

using namespace asperity;

namespace
{
  /** A channel of few cells, after some steps. */
  struct ChannelRun
  {
    explicit ChannelRun(const unsigned int degree = 2,
                        const unsigned int cells  = 10)
      : problem(make_problem(read_problem(
          "lined_channel",
          "subsection Fluid\n set Degree = " + std::to_string(degree) +
            "\n set Cells along = " + std::to_string(cells) + "\nend\n")))
    {}

    FluidStructure &
    system()
    {
      return *problem->system;
    }

    dealii::Tensor<1, 2>
    advance(const unsigned int n_steps)
    {
      for (unsigned int i = 0; i < n_steps; ++i)
        EXPECT_TRUE(system().advance(1e-3).converged);
      return problem->displacement();
    }

    std::unique_ptr<FluidStructureProblem> problem;
  };

  std::string
  state_of(FluidStructure &problem)
  {
    return to_bytes([&](OutputArchive &archive) { problem.save(archive); });
  }

  void
  load(FluidStructure &problem, const std::string &bytes)
  {
    from_bytes(bytes, "The checkpoint", [&](InputArchive &archive) {
      problem.load(archive);
    });
  }

  std::string
  message_of(FluidStructure &problem, const std::string &bytes)
  {
    try
      {
        load(problem, bytes);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace



TEST(FluidStructure, a_run_that_is_continued_repeats_the_other)
{
  ChannelRun whole, rest;
  whole.advance(4);
  load(rest.system(), state_of(whole.system()));
  EXPECT_EQ(whole.advance(4), rest.advance(4));
}



TEST(FluidStructure, refuses_a_checkpoint_of_another_run)
{
  ChannelRun whole, coarse(2, 8);
  whole.advance(1);
  const std::string state = state_of(whole.system());
  EXPECT_NE(message_of(coarse.system(), state).find("unknowns of a"),
            std::string::npos);
  EXPECT_EQ(message_of(whole.system(), state.substr(0, state.size() / 2)),
            "The checkpoint is damaged: it does not hold what is expected of "
            "it.");
}



TEST(FluidStructure, continues_on_another_mesh)
{
  // The space of degree 3 holds that of degree 2, so the same body and flow go
  // on, with the difference between the two discretizations; the pressure of
  // the first step is disturbed, see interpolate_to_mesh().
  ChannelRun coarse(2), fine(3);
  coarse.advance(4);
  fine.system().continue_from(coarse.system());
  EXPECT_EQ(fine.system().flow().time(), coarse.system().flow().time());
  EXPECT_EQ(fine.problem->displacement(), coarse.problem->displacement());
  const dealii::Tensor<1, 2> d = coarse.advance(2), d_fine = fine.advance(2);
  EXPECT_LT((d - d_fine).norm(), 0.05 * d.norm());
}



TEST(FluidStructure, refuses_to_continue_from_another_body)
{
  ChannelRun a(2, 8), b(2, 10);
  a.advance(1);
  try
    {
      b.system().continue_from(a.system());
      FAIL();
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("body to continue from"),
                std::string::npos);
    }
}
