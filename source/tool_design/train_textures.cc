#include <asperity/base/progress.h>
#include <asperity/tool_design/texture_space.h>
#include <asperity/tool_design/train_textures.h>

#include <cmath>

namespace asperity
{
  TextureTraining::TextureTraining()
  {
    network.n_code     = 8;
    network.n_layers   = 4;
    network.width      = 64;
    network.activation = Activation::softplus;
    network.output     = Activation::identity;

    options.n_epochs            = 400;
    options.samples_per_batch   = 16;
    options.points_per_sample   = 128;
    options.loss.kind           = Loss::Kind::squared;
    options.code_regularization = 1e-4;
    options.initial_code_length = 0.5;
    options.weights             = {3e-3, 0.5, 80};
    options.codes               = {1e-2, 0.5, 80};
  }



  namespace
  {
    FieldSample
    sample_of(const ToolTexture &texture, const std::vector<double> &positions)
    {
      return {texture.kind, positions, texture.heights};
    }

    /** Root mean square of the difference of two lists of heights. */
    double
    distance(const std::vector<double> &a, const std::vector<double> &b)
    {
      double sum = 0.;
      for (std::size_t i = 0; i < a.size(); ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
      return std::sqrt(sum / a.size());
    }
  } // namespace



  AutoDecoder
  train_textures(const std::vector<ToolTexture> &textures,
                 const TextureFamily            &family,
                 const TextureTraining          &training,
                 const std::string              &checkpoint,
                 ProgressLine                   &progress)
  {
    const auto positions = texture_positions(family.n_places, family.n_waves());
    std::vector<FieldSample> samples;
    for (const ToolTexture &texture : textures)
      samples.push_back(sample_of(texture, positions));
    DecoderShape network = training.network;
    network.n_position   = n_texture_coordinates(family.n_waves());
    AutoDecoderTraining trainer(network,
                                training.options,
                                samples,
                                Scaling(network.n_position),
                                Scaling(1));
    trainer.run(checkpoint, progress);
    AutoDecoder model = trainer.model();
    model.description = "network of " + std::to_string(network.n_layers) +
                        " x " + std::to_string(network.width) + ", " +
                        std::to_string(network.n_code) + " numbers, " +
                        std::to_string(textures.size()) + " textures, " +
                        std::to_string(training.options.n_epochs) + " epochs";
    return model;
  }



  std::vector<TextureErrors>
  judge_textures(const AutoDecoder              &network,
                 const std::vector<ToolTexture> &trained,
                 const std::vector<ToolTexture> &held_out,
                 const TextureFamily            &family)
  {
    const unsigned int  n = network.decoder().shape().n_code;
    const ModalTextures modal(trained, n);
    const auto positions = texture_positions(family.n_places, family.n_waves());
    Loss       loss;
    loss.kind = Loss::Kind::squared;
    CodeSearch search;
    search.points_per_step = 128;
    std::vector<TextureErrors> result;
    TextureErrors              all{"all", 0, 0., 0.};
    for (const ToolTexture &texture : held_out)
      {
        const auto code =
          infer_code(network, sample_of(texture, positions), loss, search);
        const double by_network =
          distance(network.evaluate(code, positions), texture.heights);
        const double by_modes =
          distance(modal.modes().reconstruct(
                     modal.modes().project(texture.heights, n)),
                   texture.heights);
        if (result.empty() || result.back().kind != texture.kind)
          result.push_back({texture.kind, 0, 0., 0.});
        for (TextureErrors *const errors : {&result.back(), &all})
          {
            ++errors->n;
            errors->network += by_network;
            errors->modes += by_modes;
          }
      }
    result.push_back(all);
    for (TextureErrors &errors : result)
      if (errors.n > 0)
        {
          errors.network /= errors.n;
          errors.modes /= errors.n;
        }
    return result;
  }
} // namespace asperity
