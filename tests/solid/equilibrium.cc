#include <asperity/base/errors.h>

#include <gtest/gtest.h>

#include "../files.h"
#include "loaded_solid.h"

using namespace loaded_solid;

TEST(Equilibrium, refuses_components_that_are_constrained_by_others)
{
  Body body(
    make_space(1, {0., 1.}, {0., 1.}),
    [](const Point<2> &xi) { return xi; },
    MaterialParameters().make_law());
  body.clamp(Edge::bottom);
  body.constraints.add_line(5);
  body.constraints.add_entry(5, 7, 1.); // the top moves as one
  EXPECT_EQ(message_of<ComputationError>([&]() { body.equilibrium(); }),
            "Component 5 of a displacement is constrained by others, but a "
            "force balance takes prescribed components only.");
}
