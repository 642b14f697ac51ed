#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/base/md5.h>
#include <asperity/base/progress.h>
#include <asperity/base/random_numbers.h>
#include <asperity/base/text.h>
#include <asperity/learning/training.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <utility>

#include "batch_gradient.h"
#include "checked_file.h"
#include "scaled_sample.h"

namespace asperity
{
  namespace
  {
    const char *const kind = "checkpoint of a training";

    /** Of an epoch, so that a resumed training needs no state of random
     *  numbers; epoch 0 is the beginning. */
    RandomNumbers
    random_numbers(const std::uint64_t seed, const unsigned int epoch)
    {
      // the odd number next to 2^64 over the golden ratio keeps seeds apart
      return RandomNumbers(seed + epoch * 0x9E3779B97F4A7C15ull);
    }

    std::string
    with_digits(const double x)
    {
      std::ostringstream out;
      out.precision(3);
      out << x;
      return out.str();
    }
  } // namespace



  struct AutoDecoderTraining::Batch
  {
    std::vector<std::size_t> samples;
    PointBatch               points;
  };



  void
  TrainingOptions::check() const
  {
    const auto require = [](const bool holds, const std::string &sentence) {
      if (!holds)
        throw InputError(sentence);
    };
    require(samples_per_batch > 0 && points_per_sample > 0,
            "A batch of a training needs at least one sample and one point.");
    require(n_parts > 0 && n_parts <= 1024,
            "A batch of a training is cut into 1 to 1024 parts.");
    for (const LearningRate &rate : {weights, codes})
      require(rate.initial > 0. && rate.factor > 0. && rate.interval > 0,
              "Learning rates, their factors and intervals must be positive.");
    require(loss.clamp > 0., "The clamp of distances must be positive.");
    require(code_regularization >= 0. && initial_code_length >= 0.,
            "Regularisation and initial length of codes cannot be negative.");
  }



  AutoDecoderTraining::AutoDecoderTraining(
    const DecoderShape             &shape,
    const TrainingOptions          &options,
    const std::vector<FieldSample> &samples,
    const Scaling                  &position_scaling,
    const Scaling                  &value_scaling,
    const Ranks                    &ranks)
    : options(options)
    , ranks(ranks)
    , decoder(shape)
    , position_scaling(position_scaling)
    , value_scaling(value_scaling)
    , codes(samples.size() * shape.n_code)
    , weight_steps(shape.n_parameters())
    , code_steps(codes.size())
    , gradient(shape.n_parameters())
    , code_gradient(codes.size())
  {
    options.check();
    if (samples.empty())
      throw InputError("A training needs at least one sample.");
    for (const FieldSample &sample : samples)
      {
        names.push_back(sample.name);
        ScaledSample scaled(sample, shape, position_scaling, value_scaling);
        positions.push_back(std::move(scaled.positions));
        values.push_back(std::move(scaled.values));
      }
    RandomNumbers random = random_numbers(options.seed, 0);
    decoder.initialize(random);
    const double deviation =
      options.initial_code_length / std::sqrt(std::max(1u, shape.n_code));
    for (float &z : codes)
      z = static_cast<float>(deviation * random.normal());

    inputs = md5(to_bytes([&](OutputArchive &archive) {
      archive << shape << options << positions << values;
    }));
  }



  AutoDecoderTraining::Batch
  AutoDecoderTraining::draw(const std::vector<std::size_t> &samples,
                            RandomNumbers                  &random) const
  {
    const unsigned int dim   = decoder.shape().n_position;
    const unsigned int n_out = decoder.shape().n_outputs;
    Batch              result;
    result.samples = samples;
    for (unsigned int i = 0; i < samples.size(); ++i)
      for (unsigned int p = 0; p < options.points_per_sample; ++p)
        {
          const auto       &x     = positions[samples[i]];
          const std::size_t point = random.below(x.size() / dim);
          result.points.add(i,
                            x.data() + point * dim,
                            dim,
                            values[samples[i]].data() + point * n_out,
                            n_out);
        }
    return result;
  }



  double
  AutoDecoderTraining::run_epoch()
  {
    ++epoch_;
    RandomNumbers     random = random_numbers(options.seed, epoch_);
    const auto        order  = random.permutation(names.size());
    const std::size_t most   = options.samples_per_batch;
    double            loss   = 0.;
    for (std::size_t begin = 0; begin < order.size(); begin += most)
      {
        const std::size_t n     = std::min(most, order.size() - begin);
        const auto        first = order.begin() + begin;
        loss += n * step(draw({first, first + n}, random));
      }
    last_loss = loss / order.size();
    return last_loss;
  }



  /** Adam's step for a batch. @return mean loss of its points */
  double
  AutoDecoderTraining::step(const Batch &batch)
  {
    const unsigned int n_code       = decoder.shape().n_code;
    const unsigned int n_parts      = options.n_parts;
    const std::size_t  n            = batch.points.size();
    const std::size_t  n_parameters = gradient.size();
    const std::size_t  n_batch      = batch.samples.size() * n_code;
    const std::size_t  length       = n_parameters + n_batch;
    const double       n_values     = double(n) * decoder.shape().n_outputs;

    std::vector<float> batch_codes(n_batch);
    for (std::size_t i = 0; i < batch.samples.size(); ++i)
      std::copy_n(codes.data() + batch.samples[i] * n_code,
                  n_code,
                  batch_codes.data() + i * n_code);

    std::vector<unsigned int> owner(n_parts);
    std::vector<double>       losses(n_parts, 0.);
    part_gradients.assign(n_parts * length, 0.f);
    BatchGradient batch_gradient(decoder, options.loss);
    for (unsigned int part = 0; part < n_parts; ++part)
      {
        owner[part] = part % ranks.size();
        if (owner[part] != ranks.rank())
          continue;
        float *const g = part_gradients.data() + part * length;
        losses[part]   = batch_gradient.add(batch.points,
                                          n * part / n_parts,
                                          n * (part + 1) / n_parts,
                                          batch_codes.data(),
                                          static_cast<float>(1. / n_values),
                                          g,
                                          g + n_parameters);
      }
    ranks.share(owner, part_gradients);
    ranks.share(owner, losses);

    std::fill(gradient.begin(), gradient.end(), 0.f);
    std::fill(code_gradient.begin(), code_gradient.end(), 0.f);
    double loss = 0.;
    for (unsigned int part = 0; part < n_parts; ++part)
      {
        const float *const g = part_gradients.data() + part * length;
        loss += losses[part] / n_values;
        for (std::size_t i = 0; i < n_parameters; ++i)
          gradient[i] += g[i];
        for (std::size_t i = 0; i < n_batch; ++i)
          code_gradient[batch.samples[i / n_code] * n_code + i % n_code] +=
            g[n_parameters + i];
      }
    add_regularization(batch);
    weight_steps.step(gradient,
                      options.weights.at(epoch_ - 1),
                      decoder.parameters());
    code_steps.step(code_gradient, options.codes.at(epoch_ - 1), codes);
    return loss;
  }



  void
  AutoDecoderTraining::add_regularization(const Batch &batch)
  {
    const double ramp =
      options.regularization_ramp == 0 ?
        1. :
        std::min(1., double(epoch_ - 1) / options.regularization_ramp);
    const double factor =
      options.code_regularization * ramp / batch.samples.size();
    for (const std::size_t sample : batch.samples)
      add_length_gradient(decoder.shape().n_code,
                          factor,
                          codes.data() + sample * decoder.shape().n_code,
                          code_gradient.data() +
                            sample * decoder.shape().n_code);
  }



  double
  AutoDecoderTraining::run(const std::string &checkpoint,
                           ProgressLine      &progress)
  {
    using Clock                         = std::chrono::steady_clock;
    const std::chrono::seconds interval = std::chrono::seconds(60);
    const bool                 writes = !checkpoint.empty() && ranks.is_first();
    const bool                 exists =
      !checkpoint.empty() && std::filesystem::exists(checkpoint);
    // every rank reads the file before the first one may write it
    if (exists)
      read_checkpoint(checkpoint);
    ranks.meet();
    const unsigned int begin   = epoch_;
    auto               written = Clock::now();
    while (epoch_ < options.n_epochs)
      {
        run_epoch();
        if (!std::isfinite(last_loss))
          throw SharedError("The training has failed in epoch " +
                            std::to_string(epoch_) +
                            ": its loss is no number any more; smaller "
                            "learning rates may help.");
        progress.update(double(epoch_ - begin) / (options.n_epochs - begin),
                        "epoch " + std::to_string(epoch_) + "/" +
                          std::to_string(options.n_epochs) +
                          "  loss = " + with_digits(last_loss));
        const bool is_last = epoch_ == options.n_epochs;
        if (writes && (is_last || Clock::now() - written > interval))
          {
            write_checkpoint(checkpoint);
            written = Clock::now();
          }
      }
    return last_loss;
  }



  AutoDecoder
  AutoDecoderTraining::model() const
  {
    return {decoder, codes, names, position_scaling, value_scaling};
  }



  double
  AutoDecoderTraining::flops_per_epoch() const
  {
    return decoder.shape().flops(true) * options.points_per_sample *
           names.size();
  }



  template <typename Archive>
  void
  AutoDecoderTraining::serialize_state(Archive &archive)
  {
    archive &epoch_       &last_loss;
    archive               &fixed_length(decoder.parameters(), "weights");
    archive               &fixed_length(codes, "numbers of codes");
    archive &weight_steps &code_steps;
  }



  void
  AutoDecoderTraining::write_checkpoint(const std::string &path) const
  {
    AutoDecoderTraining copy = *this;
    write_checked_file(path, kind, to_bytes([&](OutputArchive &archive) {
                         archive << copy.inputs;
                         copy.serialize_state(archive);
                       }));
  }



  void
  AutoDecoderTraining::read_checkpoint(const std::string &path)
  {
    const std::string bytes = read_checked_file(path, kind);
    from_bytes(bytes,
               std::string("The ") + kind + " " + quoted_name(path),
               [&](InputArchive &archive) {
                 std::string found;
                 archive    &found;
                 if (found != inputs)
                   throw InputError(
                     "The checkpoint " + quoted_name(path) +
                     " is that of a training with other samples or settings; "
                     "remove it to begin anew.");
                 serialize_state(archive);
               });
  }
} // namespace asperity
