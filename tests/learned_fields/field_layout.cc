#include <asperity/base/errors.h>
#include <asperity/learned_fields/field_layout.h>

#include <cmath>

#include "../files.h"
#include "field_family.h"

using namespace asperity;

TEST(FieldLayout, unpacks_what_it_has_packed)
{
  const FieldSnapshots      run = two_cells();
  const FieldLayout         layout(run);
  const std::vector<double> values = layout.pack(run, "run");
  EXPECT_EQ(values.size(), layout.size());
  for (unsigned int i = 0; i < 2; ++i)
    EXPECT_EQ(layout.unpack(values, i), run.snapshots[i].values);
  EXPECT_TRUE(layout.about().snapshots.empty());
}

// The contact pressure is 7 over a length of 2 at one time, 14 at the other.
TEST(FieldLayout, has_norms_that_are_integrals)
{
  const FieldSnapshots      run = two_cells();
  const FieldLayout         layout(run);
  const std::vector<double> values = layout.pack(run, "run");
  const std::size_t         f      = run.find(field_names::contact_pressure);
  EXPECT_NEAR(layout.squared_norm(values, f), 2. * (49. + 196.), 1e-12);
  // With weights over the squared norms the product is the number of fields.
  std::vector<double> variance;
  for (std::size_t g = 0; g < layout.n_fields(); ++g)
    variance.push_back(layout.squared_norm(values, g));
  const std::vector<double> weights = layout.weights(variance);
  double                    sum     = 0.;
  for (std::size_t i = 0; i < values.size(); ++i)
    sum += weights[i] * values[i] * values[i];
  EXPECT_NEAR(sum, layout.n_fields(), 1e-12);
}

TEST(FieldLayout, refuses_runs_that_are_not_alike)
{
  const FieldSnapshots run = two_cells();
  const FieldLayout    layout(run);
  const auto           message = [&](const FieldSnapshots &other) {
    return message_of<InputError>([&]() { layout.pack(other, "x.h5"); });
  };
  FieldSnapshots other = run;
  other.snapshots.pop_back();
  EXPECT_EQ(message(other),
            "The file 'x.h5' has 1 of 2 times; the fields of one campaign have "
            "all times.");
  other           = run;
  other.shares[0] = 0.4;
  EXPECT_NE(message(other).find("has other times"), std::string::npos);
  other = run;
  other.places.nodes[0] += 0.1;
  EXPECT_NE(message(other).find("is of another mesh"), std::string::npos);
  other                = run;
  other.fields[1].name = "strain [-]";
  EXPECT_NE(message(other).find("has other fields"), std::string::npos);
}
