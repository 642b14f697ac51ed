#include <asperity/base/errors.h>
#include <asperity/learned_fields/field_errors.h>
#include <asperity/learned_fields/pod_decoder.h>
#include <asperity/learned_fields/train_decoder.h>
#include <asperity/postprocess/hdf5_file.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "../files.h"
#include "field_family.h"

using namespace asperity;

namespace
{
  FieldModel
  train(const FieldData &data, const unsigned int n_codes)
  {
    DecoderOptions options;
    options.name                 = "pod";
    options.n_codes              = n_codes;
    const TrainedDecoder trained = train_decoder(data, options);
    return FieldModel(data, trained.decoder, trained.codes);
  }

  /** That of five codes is trained once. */
  const FieldModel &
  model_of_family()
  {
    static const FieldModel model = train(read_family(), 5);
    return model;
  }

  /** With the codes that are nearest. */
  FieldErrors
  errors_on(const FieldModel &model, const FieldData &data)
  {
    std::vector<std::vector<double>> codes;
    for (const FieldRun &run : data.runs)
      codes.push_back(model.decoder().encode(run.values));
    return errors_of(model, data, codes);
  }
} // namespace

TEST(ReadFields, takes_test_runs_out_or_the_share_that_is_asked_for)
{
  const std::string folder = test_folder();
  write_family(folder);
  const FieldData data = read_fields(folder);
  EXPECT_EQ(data.n_runs(false), 25u);
  EXPECT_EQ(data.n_runs(true), 4u);
  EXPECT_EQ(data.times.size(), 2u);
  EXPECT_NEAR(data.times[0].pressure, 1., 1e-12); // over Load/Pressure
  EXPECT_NEAR(data.times[1].share, 1., 0.);
  EXPECT_EQ(read_fields(folder, 0.5).n_runs(true), 15u);
}

TEST(ReadFields, refuses_folders_without_runs_or_fields)
{
  const std::string folder = test_folder();
  EXPECT_EQ(message_of<InputError>([&]() { read_fields(folder); }),
            "The folder '" + folder +
              "' has no runs.csv; the output directory of a campaign is "
              "expected, as 'asperity characterize' makes it.");
  write_family(folder, false);
  EXPECT_EQ(message_of<InputError>([&]() { read_fields(folder); }),
            "None of the 29 runs in '" + folder +
              "' has kept its fields; expected a campaign whose base scene has "
              "Output/Field times.");
  family_fields(p_low, T_low).write(folder + "/runs/0001.h5");
  EXPECT_NE(message_of<InputError>([&]() { read_fields(folder); })
              .find("Of 1 runs with fields 0 are held out; expected at least "
                    "one, and 4 others to learn from."),
            std::string::npos);
}

// A family of rank five is its first five modes; fewer err by what the
// singular values say.
TEST(PodDecoder, reconstructs_fields_of_its_rank)
{
  const FieldData data = read_family();
  DecoderOptions  options;
  options.name                 = "pod";
  options.n_codes              = 5;
  const TrainedDecoder trained = train_decoder(data, options);
  EXPECT_LT(trained.singular_values[5], 1e-12 * trained.singular_values[0]);
  for (const FieldRun &run : data.runs)
    {
      const std::vector<double> again =
        trained.decoder->decode(trained.decoder->encode(run.values));
      for (std::size_t f = 0; f < data.layout.n_fields(); ++f)
        {
          std::vector<double> error = again;
          for (std::size_t i = 0; i < error.size(); ++i)
            error[i] -= run.values[i];
          EXPECT_LE(std::sqrt(data.layout.squared_norm(error, f)),
                    1e-8 * (1. + std::sqrt(
                                   data.layout.squared_norm(run.values, f))));
        }
    }
  options.n_codes = 50;
  EXPECT_EQ(message_of<InputError>([&]() { train_decoder(data, options); }),
            "A latent size of 50 is asked for, where the runs have 25 modes; "
            "expected 1 to as many.");
}

TEST(FieldModel, finds_mu_and_fields_between_its_runs)
{
  const FieldData   data  = read_family();
  const FieldModel &model = model_of_family();
  for (const FieldRun &run : data.runs)
    {
      const FieldPrediction at = model.predict(run.x);
      for (unsigned int i = 0; i < 2; ++i)
        {
          EXPECT_NEAR(at.moments[i].mu / family_mu(run.x[0], run.x[1], i),
                      1.,
                      1e-2);
          EXPECT_LT(at.moments[i].load_residual, 1e-2);
          EXPECT_LT(at.moments[i].stress_residual, 1e-10);
          EXPECT_GT(at.moments[i].mu_deviation, 0.);
        }
    }
  const FieldErrors errors = errors_on(model, data);
  ASSERT_EQ(errors.rows.size(), data.layout.n_fields() + 2);
  for (const FieldErrorRow &row : errors.rows)
    {
      EXPECT_LT(row.best.largest, 1e-8) << row.quantity;
      EXPECT_LT(row.predicted.largest, 2e-2) << row.quantity;
    }
  EXPECT_NEAR(errors.share_trusted, 1., 1e-12);
}

// What a decoder leaves out counts in the deviation of mu.
TEST(FieldModel, knows_more_with_more_codes)
{
  const FieldData   data = read_family();
  const FieldModel  few  = train(data, 1);
  const FieldModel &many = model_of_family();
  EXPECT_LT(errors_on(many, data).rows.back().predicted.mean,
            errors_on(few, data).rows.back().predicted.mean);
  EXPECT_LT(many.limits().mu, few.limits().mu);
  EXPECT_LT(many.predict({800e6, 700.}).moments[1].mu_deviation,
            few.predict({800e6, 700.}).moments[1].mu_deviation);
}

TEST(FieldModel, trusts_no_fields_outside_of_its_box)
{
  const FieldModel &model = model_of_family();
  EXPECT_LE(model.predict({800e6, 700.}).trust.score(), 1.);
  const FieldTrust hot = model.predict({800e6, 1500.}).trust;
  EXPECT_NEAR(hot.box, 1.5, 1e-12); // half of the width beyond it
  EXPECT_GT(hot.score(), 1.);
  // Far away the balances alone would say so.
  const FieldTrust far = model.predict({5000e6, 700.}).trust;
  EXPECT_GT(far.load, 1.);
  EXPECT_GT(far.codes, 1.);
}

TEST(FieldModel, is_read_as_it_was_written)
{
  const FieldModel &model = model_of_family();
  const std::string path  = test_folder() + "/model.h5";
  model.save(path);
  const FieldModel      read     = FieldModel::load(path);
  const FieldPrediction a        = model.predict({500e6, 800.}),
                        b        = read.predict({500e6, 800.});
  const std::vector<double> of_a = model.decoder().decode(a.code),
                            of_b = read.decoder().decode(b.code);
  ASSERT_EQ(of_a.size(), of_b.size());
  for (std::size_t i = 0; i < of_a.size(); ++i)
    EXPECT_NEAR(of_a[i], of_b[i], 1e-9 * (1. + std::abs(of_a[i])));
  EXPECT_NEAR(a.trust.score(), b.trust.score(), 1e-9);
  EXPECT_NEAR(a.moments[1].mu_deviation, b.moments[1].mu_deviation, 1e-9);
}

TEST(FieldModel, refuses_files_that_are_none_of_its_own)
{
  model_of_family(); // which has a folder of its own
  const std::string path    = test_folder() + "/model.h5";
  const auto        message = [&]() {
    return message_of<InputError>([&]() { FieldModel::load(path); });
  };
  EXPECT_NE(message().find("could not be opened"), std::string::npos);
  two_cells().write(path);
  EXPECT_NE(message().find("has the format 'asperity fields, version 1'"),
            std::string::npos)
    << message();
  model_of_family().save(path);
  Hdf5Content content      = Hdf5Content::read(path, "a model");
  content.texts["decoder"] = "tea leaves";
  content.write(path);
  EXPECT_NE(message().find("has the decoder 'tea leaves', which this program "
                           "does not know"),
            std::string::npos);
  content.texts["decoder"]       = "pod";
  content.texts["law of code 2"] = "{";
  content.write(path);
  EXPECT_NE(message().find("has a law of code 2 that is damaged"),
            std::string::npos)
    << message();
  content.tables["spread"] = {1, 1, {1.}};
  content.write(path);
  EXPECT_NE(message().find("has tables that do not fit each other"),
            std::string::npos);
}

// A pressure p1 that is not there, where the held-out runs have p1 and 0 at one
// temperature each and p2 at two: it errs by p1 over the root of the mean
// square.
TEST(FieldErrors, of_what_vanishes_are_over_what_other_runs_have)
{
  FieldData    data   = read_family();
  const double p1     = p_low + 0.22 * (p_high - p_low),
               p2     = p_low + 0.61 * (p_high - p_low);
  const std::size_t f = data.layout.about().find(field_names::contact_pressure);
  FieldRun         &run = data.runs[25];
  ASSERT_TRUE(run.held);
  ASSERT_NEAR(run.x[0], p1, 1.);
  for (unsigned int time = 0; time < 2; ++time)
    std::fill_n(run.values.begin() + data.layout.offset(time, f),
                data.layout.length(f),
                0.);
  const FieldErrors errors = errors_on(model_of_family(), data);
  EXPECT_NEAR(errors.rows[f].predicted.largest,
              p1 / std::sqrt((p1 * p1 + 2. * p2 * p2) / 4.),
              1e-2);
}

TEST(FieldErrors, are_a_table_with_a_row_for_each_quantity)
{
  FieldErrors errors;
  errors.rows.push_back({"contact pressure [Pa]", {0.01, 0.02}, {0.03, 0.04}});
  std::ostringstream table;
  write_errors(table, errors);
  EXPECT_EQ(table.str(),
            "quantity,mean error with the best code [-],largest,"
            "mean error with the code of the inputs [-],largest\n"
            "contact pressure [Pa],0.01,0.02,0.03,0.04\n");
}
