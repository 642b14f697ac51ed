#ifndef asperity_learning_decoder_parameters_h
#define asperity_learning_decoder_parameters_h

#include <asperity/learning/decoder.h>

#include <string>

namespace asperity
{
  class ParameterDeclarator;

  /** Declares "Latent dimension", "Layers" and "Width" in the subsection that
   * is open. @param what the code describes, for the reference: "a shape" */
  void
  declare_size(ParameterDeclarator &parameters,
               DecoderShape        &network,
               const std::string   &what);
} // namespace asperity

#endif
