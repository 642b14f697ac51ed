#ifndef asperity_tool_design_train_textures_h
#define asperity_tool_design_train_textures_h

#include <asperity/learning/auto_decoder.h>
#include <asperity/learning/training.h>
#include <asperity/tool_design/texture_family.h>

#include <string>
#include <vector>

namespace asperity
{
  class ProgressLine;

  /** A network of textures and how it is trained. */
  struct TextureTraining
  {
    TextureTraining();

    DecoderShape    network;
    TrainingOptions options;
  };

  /**
   * Trains an auto-decoder of h = f(z, x) with the textures, or goes on from,
   * or takes, what a checkpoint holds.
   * @param checkpoint file; none if empty
   * @throws InputError if the checkpoint is another training's
   */
  AutoDecoder
  train_textures(const std::vector<ToolTexture> &textures,
                 const TextureFamily            &family,
                 const TextureTraining          &training,
                 const std::string              &checkpoint,
                 ProgressLine                   &progress);

  /** How well textures of a kind are met that were not trained with. */
  struct TextureErrors
  {
    std::string  kind;
    unsigned int n = 0;

    /** Mean over them of the root mean square error over the root mean square
     *  height: of the network, and of as many modes (POD). */
    double network = 0., modes = 0.;
  };

  /** Of all kinds, in the order of the textures, and at last of all together.
   */
  std::vector<TextureErrors>
  judge_textures(const AutoDecoder              &network,
                 const std::vector<ToolTexture> &trained,
                 const std::vector<ToolTexture> &held_out,
                 const TextureFamily            &family);
} // namespace asperity

#endif
