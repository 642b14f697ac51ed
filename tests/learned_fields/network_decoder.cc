#include <asperity/base/errors.h>
#include <asperity/learned_fields/network_decoder.h>
#include <asperity/learned_fields/train_decoder.h>
#include <asperity/learning/training.h>
#include <asperity/postprocess/hdf5_file.h>

#include <cmath>

#include "../files.h"
#include "field_family.h"

using namespace asperity;

namespace
{
  /** A network whose outputs are the linear function of its code z (one number)
   *  offset + z, in units of the fields, at every position. */
  AutoDecoder
  constant_network(const NetworkPart &part, const std::vector<double> &offset)
  {
    DecoderShape shape;
    shape.n_code     = 1;
    shape.n_position = part.n_coordinates();
    shape.n_outputs  = part.n_outputs();
    shape.n_layers   = 1;
    shape.width      = 1;
    shape.skip_layer = 0;
    shape.activation = Activation::relu; // of z + 10, which is positive
    shape.output     = Activation::identity;
    Decoder<float> decoder(shape);
    // A matrix by columns and offsets of the neuron, the same of the outputs.
    const std::size_t outputs = shape.n_position + 2;

    decoder.parameters()[0]           = 1.f;
    decoder.parameters()[outputs - 1] = 10.f;
    for (unsigned int i = 0; i < shape.n_outputs; ++i)
      {
        decoder.parameters()[outputs + i]                   = 1.f;
        decoder.parameters()[outputs + shape.n_outputs + i] = -10.f;
      }
    Scaling values(shape.n_outputs);
    values.centre = offset;
    return AutoDecoder(decoder,
                       {0.f, 1.f},
                       {"first", "second"},
                       Scaling(shape.n_position),
                       values);
  }

  std::vector<double>
  ramp(const unsigned int n)
  {
    std::vector<double> values;
    for (unsigned int i = 0; i < n; ++i)
      values.push_back(10. * i);
    return values;
  }

  NetworkDecoder
  constant_decoder(const FieldLayout &layout)
  {
    const NetworkPart chip(layout, false), edge(layout, true);
    return {layout,
            constant_network(chip, ramp(chip.n_outputs())),
            constant_network(edge, ramp(edge.n_outputs()))};
  }
} // namespace

TEST(NetworkPart, sees_a_period_as_one_and_depth_on_a_logarithm)
{
  const FieldLayout layout(two_cells());
  const NetworkPart edge(layout, true), chip(layout, false);
  EXPECT_EQ(edge.n_outputs(), 2u + 1u + 2u + 2u);
  EXPECT_EQ(chip.n_outputs(), 2u + 4u + 2u + 1u + 1u);
  const auto x = edge.positions(PlaceKind::edge);
  ASSERT_EQ(x.size(), 2u * 4u * edge.n_coordinates());
  // the first point is at 0.25 of a period of 2: an eighth
  EXPECT_NEAR(x[0], std::cos(M_PI / 4.), 1e-14);
  EXPECT_NEAR(x[1], std::sin(M_PI / 4.), 1e-14);
  EXPECT_NEAR(x[2], std::cos(M_PI / 2.), 1e-14);
  EXPECT_EQ(x[10], 0.5); // share of the time
  const auto at_nodes = chip.positions(PlaceKind::nodes);
  EXPECT_NEAR(at_nodes[12], std::log(1.01), 1e-12); // on the bottom
  EXPECT_NEAR(at_nodes[2 * 13 + 12], std::log(0.01), 1e-12);
}

// Nodes of bilinear cells: in their middle they are the mean of the corners.
TEST(NetworkPart, interpolates_fields_of_nodes_at_the_gauss_points)
{
  const FieldSnapshots      run = two_cells();
  const FieldLayout         layout(run);
  const std::vector<double> values = layout.pack(run, "run");
  const FieldSample sample = NetworkPart(layout, false).sample("run", values);
  EXPECT_NEAR(sample.values[0], 0.1 * 0.5, 1e-14); // u = 0.1 Y
  EXPECT_NEAR(sample.values[5], 2., 1e-14);        // shear stress
  EXPECT_NEAR(sample.values[9], 300., 1e-12);
}

TEST(NetworkDecoder, fills_all_fields_from_two_codes)
{
  const FieldSnapshots      run = two_cells();
  const FieldLayout         layout(run);
  const NetworkDecoder      decoder = constant_decoder(layout);
  const std::vector<double> values  = decoder.decode({0.5, 2.});
  EXPECT_EQ(decoder.n_codes(), 2u);
  for (unsigned int i = 0; i < 2; ++i)
    {
      const auto fields = layout.unpack(values, i);
      EXPECT_NEAR(fields[0][15], 10. + 0.5, 1e-5); // u_y of the last node
      EXPECT_NEAR(fields[4][1], 90. + 0.5, 1e-4);  // temperature
      EXPECT_NEAR(fields[6][3], 20. + 2., 1e-5);   // contact pressure
      EXPECT_NEAR(fields[8][1], 60. + 2., 1e-4);   // further force
    }
  EXPECT_EQ(decoder.code_of(1), std::vector<double>({1., 1.}));
  // and finds the codes again
  const std::vector<double> code = decoder.encode(values);
  EXPECT_NEAR(code[0], 0.5, 1e-2);
  EXPECT_NEAR(code[1], 2., 1e-2);
}

TEST(NetworkDecoder, is_read_as_it_was_written_or_refused)
{
  const FieldLayout    layout(two_cells());
  const NetworkDecoder decoder = constant_decoder(layout);
  Hdf5Content          content;
  decoder.save(content);
  EXPECT_EQ(NetworkDecoder(layout, content, "x.h5").decode({0.5, 2.}),
            decoder.decode({0.5, 2.}));
  content.tables["edge shape"].values[2] = 3.;
  EXPECT_EQ(message_of<InputError>(
              [&]() { NetworkDecoder(layout, content, "x.h5"); }),
            "The network of the edge in 'x.h5' does not fit the fields; "
            "expected the file as it was written.");
}

TEST(TrainDecoder, refuses_decoders_that_there_are_not)
{
  DecoderOptions options;
  const auto     message = [&]() {
    return message_of<InputError>([&]() { check_decoder(options); });
  };
  options.name = "tea leaves";
  EXPECT_EQ(
    message(),
    "The option '--decoder' is 'tea leaves'; 'pod', 'manifold' or 'network' is "
    "expected.");
  options.name    = "network";
  options.n_codes = 1;
  EXPECT_NE(message().find("at least 2 is expected"), std::string::npos);
}
