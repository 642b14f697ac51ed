#include <asperity/base/errors.h>
#include <asperity/learned_fields/manifold_decoder.h>
#include <asperity/learned_fields/train_decoder.h>
#include <asperity/postprocess/hdf5_file.h>

#include <cmath>

#include "../files.h"
#include "field_family.h"

using namespace asperity;

namespace
{
  /** Snapshots (1, 0, 0), (-1, 0, 0), (0, 0.5, 0), (0, -0.5, 0): modes along
   * the first two axes. */
  PodDecoder
  two_modes()
  {
    const std::vector<double> weights(3, 1.);
    return PodDecoder(OrthogonalDecomposition(
                        {1., 0., 0., -1., 0., 0., 0., 0.5, 0., 0., -0.5, 0.},
                        4,
                        weights),
                      weights,
                      2);
  }

  /** f(z) = max(z, 0). */
  AutoDecoder
  ramp_network()
  {
    DecoderShape shape;
    shape.n_code     = 0;
    shape.n_position = 1;
    shape.n_outputs  = 1;
    shape.n_layers   = 1;
    shape.width      = 1;
    shape.skip_layer = 0;
    shape.activation = Activation::relu;
    shape.output     = Activation::identity;
    Decoder<float> decoder(shape);
    decoder.parameters() = {1.f, 0.f, 1.f, 0.f};
    return AutoDecoder(decoder, {}, {"ramp"}, Scaling(1), Scaling(1));
  }
} // namespace

TEST(ManifoldDecoder, bends_the_plane_of_its_modes)
{
  const ManifoldDecoder decoder(two_modes(), ramp_network());
  EXPECT_EQ(decoder.n_codes(), 1u);
  for (const double z : {-0.5, 0.25, 2.})
    {
      const std::vector<double> values = decoder.decode({z});
      EXPECT_NEAR(std::abs(values[0]), std::abs(z), 1e-12);
      EXPECT_NEAR(std::abs(values[1]), std::max(z, 0.), 1e-6);
      EXPECT_NEAR(values[2], 0., 1e-12);
      EXPECT_NEAR(decoder.encode(values)[0], z, 1e-12);
    }
}

TEST(ManifoldDecoder, is_read_as_it_was_written_or_refused)
{
  const ManifoldDecoder decoder(two_modes(), ramp_network());
  Hdf5Content           content;
  decoder.save(content);
  EXPECT_EQ(ManifoldDecoder(content, 3, "x.h5").decode({0.7}),
            decoder.decode({0.7}));
  content.tables["manifold latent size"].values[0] = 2.;
  EXPECT_NE(message_of<InputError>([&]() {
              ManifoldDecoder(content, 3, "x.h5");
            }).find("does not fit"),
            std::string::npos);
}

// Five functions of two inputs, which two coefficients determine.
TEST(ManifoldDecoder, errs_less_than_as_many_modes)
{
  const std::string folder = test_folder();
  write_family(folder);
  const FieldData data = read_fields(folder);
  DecoderOptions  options;
  options.n_codes  = 2;
  options.n_epochs = 60;
  const auto error = [&](const std::string &name) {
    options.name                 = name;
    const TrainedDecoder trained = train_decoder(data, options);
    const std::size_t    f   = data.layout.about().find(field_names::traction);
    double               sum = 0.;
    for (std::size_t r = 0; r < data.runs.size(); ++r)
      {
        std::vector<double> values = trained.decoder->decode(trained.codes[r]);
        for (std::size_t i = 0; i < values.size(); ++i)
          values[i] -= data.runs[r].values[i];
        sum += data.layout.squared_norm(values, f);
      }
    return std::sqrt(sum);
  };
  EXPECT_LT(error("manifold"), 0.5 * error("pod"));
  options.n_codes = 12;
  EXPECT_NE(message_of<InputError>([&]() {
              error("manifold");
            }).find("less than 12 is expected"),
            std::string::npos);
}
