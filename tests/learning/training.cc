#include <asperity/base/errors.h>
#include <asperity/base/mpi_session.h>
#include <asperity/base/progress.h>
#include <asperity/learning/training.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

#include "../files.h"

using namespace asperity;

namespace
{
  /** A wave whose phase is what a code has to say, on [0, 2]. */
  double
  wave(const double phase, const double x)
  {
    return 3. + 0.5 * std::sin(2. * x + phase);
  }

  FieldSample
  sample(const double phase)
  {
    FieldSample result;
    result.name = "phase " + std::to_string(phase);
    for (unsigned int i = 0; i <= 40; ++i)
      {
        result.positions.push_back(0.05 * i);
        result.values.push_back(wave(phase, 0.05 * i));
      }
    return result;
  }

  struct WaveExample
  {
    WaveExample()
    {
      shape.n_code     = 2;
      shape.n_position = 1;
      shape.n_layers   = 2;
      shape.width      = 16;
      shape.skip_layer = 1;
      shape.activation = Activation::tanh;
      shape.output     = Activation::identity;

      options.loss.kind           = Loss::Kind::squared;
      options.samples_per_batch   = 4;
      options.points_per_sample   = 16;
      options.weights             = {5e-3, 0.5, 100};
      options.codes               = {1e-2, 0.5, 100};
      options.initial_code_length = 0.1;
      options.n_epochs            = 8;
      for (unsigned int i = 0; i < 9; ++i)
        samples.push_back(sample(0.1 * i));
    }

    AutoDecoderTraining
    training(const Ranks &ranks = Ranks()) const
    {
      return {shape,
              options,
              samples,
              scaling_of_positions(samples, 1),
              scaling_of_values(samples, 1),
              ranks};
    }

    DecoderShape             shape;
    TrainingOptions          options;
    std::vector<FieldSample> samples;
  };

  double
  finish(AutoDecoderTraining &training, const std::string &checkpoint = "")
  {
    std::ostringstream out;
    ProgressLine       progress(out, ProgressLine::Mode::silent);
    return training.run(checkpoint, progress);
  }

  /** Weights and codes, to be compared to the bit. */
  std::vector<float>
  bits(const AutoDecoderTraining &training)
  {
    const AutoDecoder  model  = training.model();
    std::vector<float> result = model.decoder().parameters();
    for (std::size_t i = 0; i < model.n_codes(); ++i)
      for (const float z : model.code(i))
        result.push_back(z);
    return result;
  }

  double
  largest_error(const AutoDecoder        &model,
                const std::vector<float> &code,
                const double              phase)
  {
    double     largest = 0.;
    const auto s       = sample(phase);
    const auto y       = model.evaluate(code, s.positions);
    for (std::size_t i = 0; i < y.size(); ++i)
      largest = std::max(largest, std::abs(y[i] - s.values[i]));
    return largest;
  }
} // namespace



TEST(AutoDecoderTraining, learns_waves_and_recognises_one_it_has_not_seen)
{
  WaveExample example;
  example.options.n_epochs         = 2000;
  example.options.weights.interval = example.options.codes.interval = 300;
  auto training = example.training();
  finish(training);
  const AutoDecoder model = training.model();
  // of an amplitude of 0.5
  EXPECT_LT(largest_error(model, model.code(2), 0.2), 0.02);
  EXPECT_LT(largest_error(model, model.code(7), 0.7), 0.02);

  const double             unseen = 0.45;
  CodeSearch               search;
  const std::vector<float> code =
    infer_code(model, sample(unseen), example.options.loss, search);
  EXPECT_LT(largest_error(model, code, unseen), 0.02);
  EXPECT_GT(largest_error(model, model.code(0), unseen), 0.1);

  // slopes in the units of the samples: cos(2 x + phase)
  std::vector<double> slopes;
  model.evaluate(code, {0.5, 1., 1.5}, &slopes);
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_NEAR(slopes[i], std::cos(1. + i + unseen), 0.08);
}



TEST(AutoDecoderTraining, is_resumed_to_the_same_bits)
{
  const std::string checkpoint = test_folder() + "/checkpoint";
  WaveExample       example;
  example.options.n_epochs = 80; // more steps than a checkpoint has bytes left
  auto whole               = example.training();
  finish(whole);

  example.options.n_epochs = 70;
  auto first               = example.training();
  finish(first, checkpoint);
  example.options.n_epochs = 80;
  auto second              = example.training();
  finish(second, checkpoint);
  EXPECT_EQ(second.epoch(), 80u);
  EXPECT_EQ(bits(second), bits(whole));
  EXPECT_NE(bits(first), bits(whole));
}



TEST(AutoDecoderTraining, follows_its_seed)
{
  WaveExample example;
  auto        one = example.training(), same = example.training();
  finish(one);
  finish(same);
  EXPECT_EQ(bits(one), bits(same));
  example.options.seed = 2;
  auto other           = example.training();
  finish(other);
  EXPECT_NE(bits(one), bits(other));
}



TEST(AutoDecoderTraining, adds_up_the_same_gradient_from_any_number_of_parts)
{
  WaveExample example;
  example.options.n_epochs = 1;
  example.options.n_parts  = 1;
  auto one                 = example.training();
  example.options.n_parts  = 7;
  auto         seven       = example.training();
  const double loss        = finish(one);
  EXPECT_NEAR(loss, finish(seven), 1e-5 * loss);
  const auto a = bits(one), b = bits(seven);
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i], b[i], 1e-4);
}



TEST(AutoDecoderTraining, pulls_codes_to_zero_by_its_regularisation)
{
  WaveExample example;
  example.options.n_epochs            = 50;
  example.options.code_regularization = 100.;
  example.options.regularization_ramp = 0;
  auto training                       = example.training();
  finish(training);
  for (std::size_t i = 0; i < example.samples.size(); ++i)
    for (const float z : training.model().code(i))
      EXPECT_NEAR(z, 0., 0.05);
}



TEST(AutoDecoderTraining, gives_the_bits_of_one_rank_on_two)
{
  if (MpiSession::n_ranks() == 1)
    {
      // Open MPI refuses root, and more ranks than cores, without these.
      for (const char *variable : {"OMPI_ALLOW_RUN_AS_ROOT",
                                   "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM",
                                   "OMPI_MCA_rmaps_base_oversubscribe"})
        setenv(variable, "1", 1);
      const auto program = std::filesystem::read_symlink("/proc/self/exe");
      const std::string command =
        "mpirun -np 2 " + program.string() +
        " --gtest_filter=AutoDecoderTraining.gives_the_bits_of_one_rank_on_two"
        " > " +
        test_folder() + "/output 2>&1";
      EXPECT_EQ(std::system(command.c_str()), 0);
      return;
    }
  const WaveExample example;
  auto              alone = example.training();
  finish(alone);
  auto together = example.training(Ranks::together());
  finish(together);
  EXPECT_EQ(bits(together), bits(alone));
}



TEST(AutoDecoderTraining, refuses_a_checkpoint_of_other_settings)
{
  const std::string checkpoint = test_folder() + "/checkpoint";
  WaveExample       example;
  auto              first = example.training();
  finish(first, checkpoint);
  example.options.seed = 5;
  auto second          = example.training();
  EXPECT_EQ(message_of<InputError>([&]() { finish(second, checkpoint); }),
            "The checkpoint '" + checkpoint +
              "' is that of a training with other samples or settings; "
              "remove it to begin anew.");
}



TEST(AutoDecoderTraining, tells_that_it_has_run_away)
{
  WaveExample example;
  example.options.weights.initial = 1e30;
  auto training                   = example.training();
  EXPECT_NE(message_of<ComputationError>([&]() {
              finish(training);
            }).find("its loss is no number any more"),
            std::string::npos);
}



TEST(AutoDecoderTraining, refuses_samples_that_do_not_fit)
{
  WaveExample example;
  example.samples[3].values.pop_back();
  const auto refuse = [&]() {
    AutoDecoderTraining training(
      example.shape, example.options, example.samples, Scaling(1), Scaling(1));
  };
  EXPECT_EQ(message_of<InputError>(refuse),
            "The sample 'phase 0.300000' has 41 coordinates and 40 values, "
            "which are not points of 1 with 1.");
  example.samples[3].values.push_back(NAN);
  EXPECT_EQ(message_of<InputError>(refuse),
            "The sample 'phase 0.300000' has a position or value that is no "
            "number.");
}



TEST(AutoDecoder, is_read_as_it_was_written_and_refused_if_damaged)
{
  const std::string path = test_folder() + "/model";
  const WaveExample example;
  auto              training = example.training();
  finish(training);
  AutoDecoder model = training.model();
  model.description = "waves";
  model.write(path);
  const AutoDecoder read = AutoDecoder::read(path);
  EXPECT_EQ(read.names(), model.names());
  EXPECT_EQ(read.description, "waves");
  const std::vector<double> x = {0.1, 1.7};
  EXPECT_EQ(read.evaluate(read.code(4), x), model.evaluate(model.code(4), x));

  const std::string whole   = content(path);
  const std::string quoted  = "'" + path + "'";
  std::string       damaged = whole;
  damaged[whole.size() / 2] ^= 1;
  overwrite(path, damaged);
  const auto        refuse = [&]() { AutoDecoder::read(path); };
  const std::string is_damaged =
    "The learned model " + quoted +
    " is damaged: its content has another check sum than it had when it was "
    "written.";
  EXPECT_EQ(message_of<InputError>(refuse), is_damaged);
  overwrite(path, whole.substr(0, whole.size() - 1));
  EXPECT_EQ(message_of<InputError>(refuse), is_damaged);
  overwrite(path, "something else");
  EXPECT_EQ(message_of<InputError>(refuse),
            "The file " + quoted +
              " is no learned model of this version of Asperity.");
  std::filesystem::remove(path);
  EXPECT_EQ(message_of<InputError>(refuse),
            "The learned model " + quoted + " cannot be read.");
}



TEST(Scaling, maps_positions_to_a_box_and_values_to_deviation_one)
{
  FieldSample a, b;
  a.positions  = {0., 10., 4., 20.};
  b.positions  = {-2., 16.};
  a.values     = {1., 7., 3., 7.};
  b.values     = {5., 7.};
  const auto x = scaling_of_positions({a, b}, 2);
  EXPECT_EQ(x.centre, std::vector<double>({1., 15.}));
  EXPECT_EQ(x.scale, std::vector<double>({3., 5.}));
  // 1, 3, 5 has the mean 3 and the variance 8/3; a constant keeps its unit
  const auto y = scaling_of_values({a, b}, 2);
  EXPECT_EQ(y.centre, std::vector<double>({3., 7.}));
  EXPECT_NEAR(y.scale[0], std::sqrt(8. / 3.), 1e-15);
  EXPECT_EQ(y.scale[1], 1.);
}
