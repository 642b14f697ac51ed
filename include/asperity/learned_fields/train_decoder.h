#ifndef asperity_learned_fields_train_decoder_h
#define asperity_learned_fields_train_decoder_h

#include <asperity/learned_fields/field_data.h>
#include <asperity/learned_fields/field_decoder.h>
#include <asperity/learned_fields/manifold_decoder.h>

#include <memory>
#include <string>
#include <vector>

namespace asperity
{
  /** Which decoder is trained. */
  struct DecoderOptions
  {
    std::string  name     = "manifold"; ///< or "pod", "network"
    unsigned int n_codes  = 4;
    unsigned int n_epochs = 600; ///< of networks
  };

  /** @throws InputError if there is no such decoder, or the latent size is too
   *  small for it */
  void
  check_decoder(const DecoderOptions &options);

  /** A decoder and what its training has found. */
  struct TrainedDecoder
  {
    std::shared_ptr<const FieldDecoder> decoder;

    /** The best ones of all runs, in the order of the data. */
    std::vector<std::vector<double>> codes;

    /** Of the deviations of the runs, each field scaled to the same variance;
     *  none of networks. */
    std::vector<double> singular_values;
  };

  /** Trains it on the runs that are not held out.
   *  @throws InputError if the latent size is too large for them */
  TrainedDecoder
  train_decoder(const FieldData &data, const DecoderOptions &options);

  /** The network of a ManifoldDecoder.
   *  @param coefficients of the modes, of the fields to learn from
   *  @param n_codes less than there are modes */
  std::shared_ptr<const ManifoldDecoder>
  train_manifold(const PodDecoder                       &modes,
                 const std::vector<std::vector<double>> &coefficients,
                 const unsigned int                      n_codes,
                 const unsigned int                      n_epochs);
} // namespace asperity

#endif
