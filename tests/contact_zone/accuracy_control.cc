#include <asperity/contact_zone/accuracy_control.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

#include "scene_examples.h"

using namespace asperity;

namespace
{
  const auto anything = [](const Fineness &) { return true; };

  AccuracyRound
  round_with(const ErrorEstimate &error)
  {
    return {{-1, -1, -1}, coarse_scene(), {0.1, 700, 300}, error};
  }
} // namespace

TEST(AccuracyControl, refines_what_dominates_only)
{
  // 0.8 of an error is uncertain, and 0.8 of the wanted one is the aim: 4 by a
  // halving of the elements, 2 by one of steps or penalty.
  EXPECT_EQ(*next_fineness(round_with({0.0399, 0., 0.}), 0.01, anything),
            (Fineness{0, -1, -1}));
  EXPECT_EQ(*next_fineness(round_with({0., -0.0399, 0.}), 0.01, anything),
            (Fineness{-1, 1, -1}));
  EXPECT_EQ(*next_fineness(round_with({0., 0., 0.0401}), 0.01, anything),
            (Fineness{-1, -1, 2}));
}

TEST(AccuracyControl, takes_the_cheapest_of_settings_that_do)
{
  const AccuracyRound           last = round_with({0.012, 0.012, -0.004});
  const std::optional<Fineness> best = next_fineness(last, 0.005, anything);
  ASSERT_TRUE(best);
  const Fineness more{best->mesh + 1, best->step + 1, best->penalty + 1};
  EXPECT_LE(last.error.after(more).uncertainty(), 0.8 * 0.005);
  // Every single halving less is too little.
  for (const Fineness &less :
       {Fineness{more.mesh - 1, more.step, more.penalty},
        Fineness{more.mesh, more.step - 1, more.penalty},
        Fineness{more.mesh, more.step, more.penalty - 1}})
    if (less.mesh >= 0 && less.step >= 0 && less.penalty >= 0)
      {
        EXPECT_GT(last.error.after(less).uncertainty(), 0.8 * 0.005);
      }
}

TEST(AccuracyControl, halves_what_dominates_where_estimates_do_not_reach)
{
  EXPECT_EQ(*next_fineness(round_with({0.5, 0.01, 0.01}), 1e-4, anything),
            (Fineness{0, -1, -1}));
  EXPECT_EQ(*next_fineness(round_with({0.01, 0.01, 0.5}), 1e-4, anything),
            (Fineness{-1, -1, 0}));
}

TEST(AccuracyControl, gives_up_where_the_mesh_may_not_be_refined)
{
  const auto coarse_only = [](const Fineness &f) { return f.mesh <= -1; };
  EXPECT_FALSE(next_fineness(round_with({0.5, 0., 0.}), 1e-4, coarse_only));
  EXPECT_TRUE(next_fineness(round_with({0., 0.5, 0.}), 1e-4, coarse_only));
}

TEST(AccuracyControl, is_met_by_mu_that_is_corrected)
{
  EXPECT_TRUE(is_met({0.0124, 0., 0.}, 0.01));
  EXPECT_FALSE(is_met({0.0126, 0., 0.}, 0.01));
  // Sources that cancel are no less uncertain.
  EXPECT_FALSE(is_met({0.01, -0.01, 0.}, 0.01));
}

TEST(AccuracyControl, says_which_mu_keeps_the_wanted_error)
{
  AccuracyReport report;
  report.error  = ErrorEstimate{0.01, 0.008, 0.005};
  report.wanted = 0.02;
  // 2.3 % in all; of the root of their squares 0.8.
  nlohmann::ordered_json json = to_json(report, 0.2);
  EXPECT_NEAR(json.at("corrected_mu"), 0.1954, 1e-15);
  EXPECT_NEAR(json.at("uncertainty"), 0.8 * std::sqrt(1.89e-4), 1e-15);
  EXPECT_EQ(json.at("met_by"), nlohmann::ordered_json({"corrected_mu"}));
  report.wanted = 0.025;
  json          = to_json(report, 0.2);
  EXPECT_EQ(json.at("met_by"), nlohmann::ordered_json({"mu", "corrected_mu"}));
  report.wanted = 0.01;
  EXPECT_TRUE(to_json(report, 0.2).at("met_by").empty());
}

TEST(AccuracyControl, begins_with_coarse_entries)
{
  SceneParameters parameters; // 160 spans: 80, 40, 20, 10 are there
  // Elements go with the root of the wanted error.
  for (const auto &[error, mesh] : {std::pair(0.5, -2),
                                    std::pair(0.02, -2),
                                    std::pair(0.007, -1),
                                    std::pair(0.002, 0),
                                    std::pair(0., 0)})
    {
      parameters.accuracy.error = error;
      EXPECT_EQ(cheapest(parameters), (Fineness{mesh, -1, -1})) << error;
    }
  parameters.accuracy.error  = 0.02;
  parameters.mesh.spans      = 80;
  parameters.mesh.refinement = 2; // 40, 20, 10
  EXPECT_EQ(cheapest(parameters), (Fineness{-1, -1, -1}));
  EXPECT_EQ(cheapest(coarse_scene()), (Fineness{0, -1, -1}));
}

TEST(AccuracyControl, writes_entries_that_make_the_run)
{
  SceneParameters parameters;
  parameters.contact.penalty = 2e18;
  const Fineness fineness{1, -1, 2};
  std::string    text;
  for (const auto &[path, value] : entries_of(parameters, fineness))
    {
      const std::size_t slash = path.find('/');
      text += "subsection " + path.substr(0, slash) + "\n set " +
              path.substr(slash + 1) + " = " + value + "\nend\n";
    }
  dealii::ParameterHandler handler;
  ParameterDeclarator      declarator(handler);
  SceneParameters          read;
  read.declare(declarator);
  declarator.read_text(text, "entries");
  read.resolve();
  const SceneParameters expected = with_fineness(parameters, fineness);
  EXPECT_EQ(read.mesh.spans, expected.mesh.spans);
  EXPECT_EQ(read.mesh.refinement, expected.mesh.refinement);
  EXPECT_EQ(read.protocol.ramp_steps, expected.protocol.ramp_steps);
  EXPECT_EQ(read.protocol.slide_steps, expected.protocol.slide_steps);
  EXPECT_DOUBLE_EQ(read.protocol.steady_step, expected.protocol.steady_step);
  EXPECT_DOUBLE_EQ(read.contact.penalty_factor,
                   expected.contact.penalty_factor);
  EXPECT_DOUBLE_EQ(*read.contact.penalty, 8e18);
}
