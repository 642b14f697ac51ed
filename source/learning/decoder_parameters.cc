#include <asperity/base/parameters.h>
#include <asperity/learning/decoder_parameters.h>

namespace asperity
{
  void
  declare_size(ParameterDeclarator &parameters,
               DecoderShape        &network,
               const std::string   &what)
  {
    parameters.integer("Latent dimension",
                       network.n_code,
                       Range::between(1, 256),
                       "Numbers that describe " + what + ".");
    parameters.integer("Layers",
                       network.n_layers,
                       Range::between(1, 64),
                       "Hidden layers.");
    parameters.integer("Width",
                       network.width,
                       Range::between(1, 1024),
                       "Neurons of a hidden layer.");
  }
} // namespace asperity
