#include <asperity/base/errors.h>
#include <asperity/base/progress.h>
#include <asperity/base/text.h>
#include <asperity/learned_fields/manifold_decoder.h>
#include <asperity/learned_fields/network_decoder.h>
#include <asperity/learned_fields/pod_decoder.h>
#include <asperity/learned_fields/train_decoder.h>
#include <asperity/learning/training.h>

#include <algorithm>
#include <iostream>

namespace asperity
{
  namespace
  {
    /** The runs to learn from, one after the other. */
    std::vector<double>
    matrix_of(const FieldData &data)
    {
      std::vector<double> matrix;
      matrix.reserve(data.n_runs(false) * data.layout.size());
      for (const FieldRun &run : data.runs)
        if (!run.held)
          matrix.insert(matrix.end(), run.values.begin(), run.values.end());
      return matrix;
    }

    /** Of each field, the mean squared norm of its deviations from its mean. A
     *  field that is the same in all runs is no part of what is learnt: it
     *  counts by its mean, or, if it vanishes, by 1. */
    std::vector<double>
    variances_of(const FieldData &data)
    {
      const double        n = data.n_runs(false);
      std::vector<double> mean(data.layout.size(), 0.);
      for (const FieldRun &run : data.runs)
        for (std::size_t i = 0; i < mean.size() && !run.held; ++i)
          mean[i] += run.values[i] / n;
      std::vector<double> result(data.layout.n_fields(), 0.);
      for (const FieldRun &run : data.runs)
        {
          if (run.held)
            continue;
          std::vector<double> deviation = run.values;
          for (std::size_t i = 0; i < mean.size(); ++i)
            deviation[i] -= mean[i];
          for (std::size_t f = 0; f < result.size(); ++f)
            result[f] += data.layout.squared_norm(deviation, f) / n;
        }
      constexpr double rounding = 1e-24; // squared
      for (std::size_t f = 0; f < result.size(); ++f)
        if (const double of_mean = data.layout.squared_norm(mean, f);
            result[f] <= rounding * of_mean)
          result[f] = of_mean > 0. ? of_mean : 1.;
      return result;
    }
  } // namespace



  void
  check_decoder(const DecoderOptions &options)
  {
    const bool is_network = options.name == NetworkDecoder::decoder_name;
    if (!is_network && options.name != PodDecoder::decoder_name &&
        options.name != ManifoldDecoder::decoder_name)
      throw InputError("The option '--decoder' is " +
                       quoted_text(options.name) +
                       "; 'pod', 'manifold' or 'network' is expected.");
    if (is_network && options.n_codes < 2)
      throw InputError("The option '--latent' is 1 with '--decoder network', "
                       "which has a code of the chip and one of its edge; at "
                       "least 2 is expected.");
  }



  namespace
  {
    /** Of the chip or of its edge. */
    AutoDecoder
    train_network(const FieldData      &data,
                  const bool            is_edge,
                  const unsigned int    n_codes,
                  const DecoderOptions &options)
    {
      const NetworkPart        part(data.layout, is_edge);
      std::vector<FieldSample> samples;
      for (const FieldRun &run : data.runs)
        if (!run.held)
          samples.push_back(
            part.sample("run " + std::to_string(run.id), run.values));
      DecoderShape shape;
      shape.n_code     = n_codes;
      shape.n_position = part.n_coordinates();
      shape.n_outputs  = part.n_outputs();
      shape.activation = Activation::softplus;
      shape.output     = Activation::identity;
      TrainingOptions training;
      training.n_epochs          = options.n_epochs;
      training.samples_per_batch = 4;
      training.points_per_sample = 256;
      training.loss.kind         = Loss::Kind::squared;
      // halved five times in all
      training.weights = {2e-3, 0.5, std::max(1u, options.n_epochs / 6)};
      training.codes   = {1e-2, 0.5, std::max(1u, options.n_epochs / 6)};
      training.code_regularization = 1e-5;
      AutoDecoderTraining trainer(shape,
                                  training,
                                  samples,
                                  part.position_scaling(samples),
                                  scaling_of_values(samples, shape.n_outputs));
      ProgressLine        progress(std::cout);
      progress.note(is_edge ? "Network of the edge" : "Network of the chip");
      trainer.run("", progress);
      return trainer.model();
    }

    TrainedDecoder
    train_networks(const FieldData &data, const DecoderOptions &options)
    {
      const unsigned int n_edge = options.n_codes / 2;
      const AutoDecoder  chip =
        train_network(data, false, options.n_codes - n_edge, options);
      const AutoDecoder edge = train_network(data, true, n_edge, options);
      const auto        decoder =
        std::make_shared<NetworkDecoder>(data.layout, chip, edge);
      TrainedDecoder result{decoder, {}, {}};
      std::size_t    n_learnt = 0;
      for (const FieldRun &run : data.runs)
        result.codes.push_back(run.held ? decoder->encode(run.values) :
                                          decoder->code_of(n_learnt++));
      return result;
    }
  } // namespace



  std::shared_ptr<const ManifoldDecoder>
  train_manifold(const PodDecoder                       &modes,
                 const std::vector<std::vector<double>> &coefficients,
                 const unsigned int                      n_codes,
                 const unsigned int                      n_epochs)
  {
    FieldSample sample;
    sample.name = "coefficients";
    for (const std::vector<double> &c : coefficients)
      {
        const auto middle = c.begin() + n_codes;
        sample.positions.insert(sample.positions.end(), c.begin(), middle);
        sample.values.insert(sample.values.end(), middle, c.end());
      }
    DecoderShape shape;
    shape.n_code     = 0;
    shape.n_position = n_codes;
    shape.n_outputs  = modes.n_codes() - n_codes;
    shape.n_layers   = 2;
    shape.width      = 32;
    shape.skip_layer = 0;
    shape.activation = Activation::softplus;
    shape.output     = Activation::identity;
    TrainingOptions training;
    training.n_epochs          = n_epochs;
    training.samples_per_batch = 1;
    training.points_per_sample = 128;
    training.n_parts           = 1;
    training.loss.kind         = Loss::Kind::squared;
    training.weights = {5e-3, 0.5, std::max(1u, training.n_epochs / 8)};
    // Modes count by their variance, not each alike.
    Scaling scaling = scaling_of_values({sample}, shape.n_outputs);
    std::fill(scaling.scale.begin(),
              scaling.scale.end(),
              *std::max_element(scaling.scale.begin(), scaling.scale.end()));
    AutoDecoderTraining trainer(shape,
                                training,
                                {sample},
                                scaling_of_positions({sample},
                                                     shape.n_position),
                                scaling);
    ProgressLine        progress(std::cout);
    trainer.run("", progress);
    progress.note("");
    return std::make_shared<ManifoldDecoder>(modes, trainer.model());
  }



  namespace
  {
    std::shared_ptr<const FieldDecoder>
    train_manifold(const FieldData               &data,
                   const OrthogonalDecomposition &decomposition,
                   const std::vector<double>     &weights,
                   const DecoderOptions          &options)
    {
      constexpr std::size_t most_modes = 40;
      const std::size_t     n_modes =
        std::min(most_modes, decomposition.n_modes() / 2);
      if (n_modes <= options.n_codes)
        throw InputError("A latent size of " + std::to_string(options.n_codes) +
                         " leaves no modes to the network of '--decoder "
                         "manifold'; less than " +
                         std::to_string(n_modes) + " is expected.");
      const PodDecoder                 modes(decomposition, weights, n_modes);
      std::vector<std::vector<double>> coefficients;
      for (const FieldRun &run : data.runs)
        if (!run.held)
          coefficients.push_back(modes.encode(run.values));
      return train_manifold(modes,
                            coefficients,
                            options.n_codes,
                            20 * options.n_epochs);
    }
  } // namespace



  TrainedDecoder
  train_decoder(const FieldData &data, const DecoderOptions &options)
  {
    check_decoder(options);
    if (options.name == NetworkDecoder::decoder_name)
      return train_networks(data, options);
    const std::vector<double> weights = data.layout.weights(variances_of(data));
    const OrthogonalDecomposition       decomposition(matrix_of(data),
                                                data.n_runs(false),
                                                weights);
    std::shared_ptr<const FieldDecoder> decoder =
      std::make_shared<PodDecoder>(decomposition, weights, options.n_codes);
    if (options.name == ManifoldDecoder::decoder_name)
      decoder = train_manifold(data, decomposition, weights, options);
    TrainedDecoder result{decoder, {}, decomposition.singular_values()};
    for (const FieldRun &run : data.runs)
      result.codes.push_back(decoder->encode(run.values));
    return result;
  }
} // namespace asperity
