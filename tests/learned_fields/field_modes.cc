#include <asperity/contact_zone/friction_result.h>
#include <asperity/learned_fields/field_model.h>
#include <asperity/learned_fields/train_decoder.h>

#include <cmath>

#include "../files.h"
#include "field_family.h"

using namespace asperity;

namespace
{
  FieldModel
  train(const FieldData &data, const std::string &decoder)
  {
    DecoderOptions options;
    options.name                 = decoder;
    options.n_codes              = 2;
    options.n_epochs             = 10;
    const TrainedDecoder trained = train_decoder(data, options);
    return FieldModel(data, trained.decoder, trained.codes);
  }

  /** From decoded fields; the family slides along +x. */
  double
  mu_of(const FieldModel          &model,
        const std::vector<double> &code,
        const unsigned int         time)
  {
    const FieldLayout &layout = model.layout();
    const auto         force =
      force_of_tractions(layout.about(),
                         layout.unpack(model.decoder().decode(code), time));
    return -force[0] / std::abs(force[1]);
  }

  /** sqrt(sum (mu(z + sigma_k e_k) - mu(z))^2 + sigma^2) with decoded fields.
   */
  double
  deviation_of(const FieldModel      &model,
               const FieldPrediction &at,
               const unsigned int     time)
  {
    double variance = std::pow(model.limits().mu, 2);
    for (std::size_t k = 0; k < at.code.size(); ++k)
      {
        std::vector<double> moved = at.code;
        moved[k] += at.deviation[k];
        variance +=
          std::pow(mu_of(model, moved, time) - mu_of(model, at.code, time), 2);
      }
    return std::sqrt(variance);
  }

  /** Without sense, and far from any balance. */
  FieldModes
  any_modes(const std::size_t size, const unsigned int n_modes)
  {
    FieldModes modes;
    for (std::size_t i = 0; i < size; ++i)
      modes.mean.push_back(std::cos(1. + i));
    for (std::size_t i = 0; i < n_modes * size; ++i)
      modes.modes.push_back(std::sin(2. + i * i));
    return modes;
  }
} // namespace

TEST(FieldModes, add_up_whatever_their_length)
{
  for (const std::size_t size : {1u, 3u, 2500u})
    {
      const std::vector<double> values = any_modes(size, 2).combine({0.5, -3.});
      ASSERT_EQ(values.size(), size);
      for (std::size_t i = 0; i < size; ++i)
        EXPECT_NEAR(values[i],
                    std::cos(1. + i) + 0.5 * std::sin(2. + i * i) -
                      3. * std::sin(2. + (size + i) * (size + i)),
                    1e-14);
    }
  const FieldModes none{{1., 2.}, {}};
  EXPECT_EQ(none.combine({}), none.mean);
}

TEST(ForcesOfModes, are_those_of_the_fields)
{
  const FieldLayout         layout(two_cells());
  const FieldModes          modes = any_modes(layout.size(), 3);
  const std::vector<double> coefficients{0.5, -3., 20.};
  const auto a = ForcesOfModes(layout, modes).combine(coefficients);
  const auto b = forces_of(layout, modes.combine(coefficients));
  ASSERT_EQ(a.size(), 2u);
  ASSERT_EQ(b.size(), 2u);
  for (unsigned int time = 0; time < 2; ++time)
    for (unsigned int i = 0; i < 2; ++i)
      {
        EXPECT_GT(std::abs(b[time].traction[i]), 1e-3);
        EXPECT_GT(std::abs(b[time].imbalance[i]), 1e-3);
        EXPECT_NEAR(a[time].traction[i] / b[time].traction[i], 1., 1e-10);
        EXPECT_NEAR(a[time].imbalance[i] / b[time].imbalance[i], 1., 1e-10);
      }
}

// Whether a decoder has modes or not, mu, its deviation and the balances are
// those of the fields that it decodes.
TEST(FieldModel, says_of_a_code_what_its_fields_say)
{
  const std::string folder = test_folder();
  write_family(folder);
  const FieldData data = read_fields(folder);
  for (const std::string decoder : {"pod", "manifold", "network"})
    {
      const FieldModel model = train(data, decoder);
      EXPECT_EQ(model.decoder().modes() == nullptr, decoder == "network");
      const FieldLayout &layout = model.layout();
      for (const double p : {500e6, 1900e6})
        {
          const FieldPrediction     at     = model.predict({p, 800.});
          const std::vector<double> values = model.decoder().decode(at.code);
          for (unsigned int time = 0; time < 2; ++time)
            {
              const FieldMomentPrediction &moment = at.moments[time];
              const auto                   fields = layout.unpack(values, time);
              const auto   force = force_of_tractions(layout.about(), fields);
              const auto   rest  = imbalance_of_stress(layout.about(), fields);
              const double load  = p * layout.about().places.period;
              EXPECT_NEAR(moment.T_x / force[0], 1., 1e-10) << decoder;
              EXPECT_NEAR(moment.T_y / force[1], 1., 1e-10) << decoder;
              EXPECT_NEAR(moment.mu / mu_of(model, at.code, time), 1., 1e-10)
                << decoder;
              EXPECT_NEAR(moment.load_residual,
                          std::abs(force[1] + load) / load,
                          1e-10)
                << decoder;
              EXPECT_NEAR(moment.stress_residual,
                          std::hypot(rest[0], rest[1]) / load,
                          1e-10)
                << decoder;
              EXPECT_NEAR(moment.mu_deviation / deviation_of(model, at, time),
                          1.,
                          1e-10)
                << decoder;
            }
        }
    }
}
