#include <asperity/learned_fields/network_decoder.h>
#include <asperity/learned_fields/train_decoder.h>

#include "../files.h"
#include "field_family.h"

using namespace asperity;

// The auto-decoder of fields, trained on a family of two inputs.

namespace
{
  TrainedDecoder
  train(const FieldData &data, const unsigned int n_epochs)
  {
    DecoderOptions options;
    options.name     = NetworkDecoder::decoder_name;
    options.n_codes  = 5;
    options.n_epochs = n_epochs;
    return train_decoder(data, options);
  }

  double
  squared_distance(const FieldLayout  &layout,
                   std::vector<double> a,
                   const FieldRun     &run,
                   const std::size_t   field)
  {
    for (std::size_t i = 0; i < a.size(); ++i)
      a[i] -= run.values[i];
    return layout.squared_norm(a, field);
  }

  /** Squared error of the contact pressure of the runs that are held out, with
   *  their best codes, over that of the mean of the others. */
  double
  error_of_pressure(const FieldData &data, const TrainedDecoder &trained)
  {
    const FieldLayout  &layout = data.layout;
    const std::size_t   f = layout.about().find(field_names::contact_pressure);
    std::vector<double> mean(layout.size(), 0.);
    for (const FieldRun &run : data.runs)
      for (std::size_t i = 0; i < mean.size() && !run.held; ++i)
        mean[i] += run.values[i] / data.n_runs(false);
    double of_decoder = 0., of_mean = 0.;
    for (std::size_t r = 0; r < data.runs.size(); ++r)
      if (const FieldRun &run = data.runs[r]; run.held)
        {
          of_decoder += squared_distance(
            layout, trained.decoder->decode(trained.codes[r]), run, f);
          of_mean += squared_distance(layout, mean, run, f);
        }
    return of_decoder / of_mean;
  }
} // namespace

// Of period 2 with Gauss points at 0.5 and 1.5, whose cosines vanish but for
// rounding; at the nodes they are 1 and -1.
TEST(NetworkPart, leaves_waves_as_they_are)
{
  const FieldLayout layout(two_cells());
  const NetworkPart chip(layout, false);
  const FieldSample sample =
    chip.sample("run", layout.pack(two_cells(), "run"));
  const Scaling      scaling = chip.position_scaling({sample});
  const auto         nodes   = chip.positions(PlaceKind::nodes);
  const unsigned int n       = chip.n_coordinates();
  ASSERT_EQ(scaling.scale.size(), n);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (const unsigned int c = i % n; c < n - 3) // then time, height and depth
      {
        EXPECT_NEAR((nodes[i] - scaling.centre[c]) / scaling.scale[c],
                    nodes[i],
                    1e-15);
      }
  // The share of the time, 0.5 and 1, is scaled to -1 and 1.
  EXPECT_NEAR(scaling.centre[n - 3], 0.75, 1e-15);
  EXPECT_NEAR(scaling.scale[n - 3], 0.25, 1e-15);
}

// Waves that vanish at all places of the training but for rounding do not grow
// beyond all bounds elsewhere, as at the nodes of this family.
TEST(TrainNetwork, says_nothing_absurd_between_its_places)
{
  const FieldData      data    = read_family();
  const TrainedDecoder trained = train(data, 2);
  const FieldRun      &run     = data.runs.front();
  const std::size_t    u = data.layout.about().find(field_names::displacement);
  for (std::size_t r = 0; r < data.runs.size(); ++r)
    EXPECT_LT(squared_distance(
                data.layout, trained.decoder->decode(trained.codes[r]), run, u),
              10.); // whose square is up to 0.1^2 over an area of 2, twice
}

TEST(TrainNetwork, gives_each_run_a_code_of_the_size_that_is_asked_for)
{
  const FieldData      data    = read_family();
  const TrainedDecoder trained = train(data, 2), again = train(data, 2);
  EXPECT_EQ(trained.decoder->name(), NetworkDecoder::decoder_name);
  EXPECT_EQ(trained.decoder->n_codes(), 5u);
  EXPECT_EQ(trained.decoder->modes(), nullptr);
  EXPECT_TRUE(trained.singular_values.empty());
  ASSERT_EQ(trained.codes.size(), data.runs.size());
  const auto &network  = dynamic_cast<const NetworkDecoder &>(*trained.decoder);
  std::size_t n_learnt = 0;
  for (std::size_t r = 0; r < data.runs.size(); ++r)
    {
      EXPECT_EQ(trained.codes[r].size(), 5u);
      // Codes of the training belong to the runs in their order.
      EXPECT_EQ(trained.codes[r],
                data.runs[r].held ? network.encode(data.runs[r].values) :
                                    network.code_of(n_learnt++));
    }
  EXPECT_EQ(n_learnt, data.n_runs(false));
  EXPECT_EQ(trained.codes, again.codes); // of the same seed, to the bit
}

TEST(TrainNetwork, errs_less_the_longer_it_lasts)
{
  const FieldData data      = read_family();
  const double    short_one = error_of_pressure(data, train(data, 3)),
               long_one     = error_of_pressure(data, train(data, 30));
  EXPECT_LT(long_one, 0.1);
  EXPECT_LT(long_one, 0.5 * short_one);
}
