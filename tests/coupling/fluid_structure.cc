#include <asperity/base/archive.h>
#include <asperity/base/errors.h>

#include <gtest/gtest.h>

#include "lined_channel.h"

using namespace lined_channel;

namespace
{
  /** A channel of few cells, after some steps. */
  struct ChannelRun
  {
    explicit ChannelRun(const unsigned int degree = 2,
                        const unsigned int cells  = 10)
    {
      LinedChannel data;
      data.cells                    = cells;
      FluidStructureOptions options = data.options();
      options.fluid.degree = options.fluid.geometry_degree = degree;
      problem = data.problem(mesh, options);
    }

    Tensor<1, 2>
    advance(const unsigned int n_steps)
    {
      for (unsigned int i = 0; i < n_steps; ++i)
        EXPECT_TRUE(problem->advance(1e-3).converged);
      return problem->displacement({0.25, 0.});
    }

    dealii::Triangulation<2>        mesh;
    std::unique_ptr<FluidStructure> problem;
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
  load(*rest.problem, state_of(*whole.problem));
  EXPECT_EQ(whole.advance(4), rest.advance(4));
}



TEST(FluidStructure, refuses_a_checkpoint_of_another_run)
{
  ChannelRun whole, coarse(2, 8);
  whole.advance(1);
  const std::string state = state_of(*whole.problem);
  EXPECT_NE(message_of(*coarse.problem, state).find("unknowns of a"),
            std::string::npos);
  EXPECT_EQ(message_of(*whole.problem, state.substr(0, state.size() / 2)),
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
  fine.problem->continue_from(*coarse.problem);
  EXPECT_EQ(fine.problem->flow().time(), coarse.problem->flow().time());
  EXPECT_EQ(fine.problem->displacement({0.25, 0.}),
            coarse.problem->displacement({0.25, 0.}));
  const Tensor<1, 2> d = coarse.advance(2), d_fine = fine.advance(2);
  EXPECT_LT((d - d_fine).norm(), 0.05 * d.norm());
}



TEST(FluidStructure, refuses_to_continue_from_another_body)
{
  ChannelRun a(2, 8), b(2, 10);
  a.advance(1);
  try
    {
      b.problem->continue_from(*a.problem);
      FAIL();
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("body to continue from"),
                std::string::npos);
    }
}
