#include <asperity/base/errors.h>
#include <asperity/learned_fields/field_layout.h>
#include <asperity/learned_fields/pod_decoder.h>
#include <asperity/postprocess/hdf5_file.h>

#include <algorithm>

namespace asperity
{
  PodDecoder::PodDecoder(const OrthogonalDecomposition &decomposition,
                         const std::vector<double>     &weights,
                         const unsigned int             n_codes)
    : weights(weights)
  {
    if (n_codes < 1 || n_codes > decomposition.n_modes())
      throw InputError("A latent size of " + std::to_string(n_codes) +
                       " is asked for, where the runs have " +
                       std::to_string(decomposition.n_modes()) +
                       " modes; expected 1 to as many.");
    modes_.mean = decomposition.mean();
    for (unsigned int k = 0; k < n_codes; ++k)
      modes_.modes.insert(modes_.modes.end(),
                          decomposition.mode(k),
                          decomposition.mode(k) + modes_.mean.size());
  }



  PodDecoder::PodDecoder(const Hdf5Content &content,
                         const std::size_t  size,
                         const std::string &origin)
    : modes_{content.table("pod mean", 1, origin).values,
             content.table("pod modes", size, origin).values}
    , weights(content.table("pod weights", 1, origin).values)
  {
    if (modes_.modes.empty() || modes_.mean.size() != size ||
        weights.size() != size)
      throw InputError("The modes of " + origin +
                       " do not fit its places; expected the file as it was "
                       "written.");
  }



  std::string
  PodDecoder::name() const
  {
    return decoder_name;
  }



  unsigned int
  PodDecoder::n_codes() const
  {
    return modes_.n_modes();
  }



  std::vector<double>
  PodDecoder::decode(const std::vector<double> &code) const
  {
    return modes_.combine(code);
  }



  std::vector<double>
  PodDecoder::encode(const std::vector<double> &values) const
  {
    const std::vector<double> &mean = modes_.mean;
    std::vector<double>        code(n_codes(), 0.);
    for (unsigned int k = 0; k < code.size(); ++k)
      {
        const double *mode = modes_.mode(k);
        for (std::size_t i = 0; i < mean.size(); ++i)
          code[k] += weights[i] * (values[i] - mean[i]) * mode[i];
      }
    return code;
  }



  const FieldModes *
  PodDecoder::modes() const
  {
    return &modes_;
  }



  std::vector<double>
  PodDecoder::coefficients(const std::vector<double> &code) const
  {
    return code;
  }



  void
  PodDecoder::save(Hdf5Content &content) const
  {
    content.texts["decoder"]      = decoder_name;
    content.tables["pod mean"]    = {modes_.mean.size(), 1, modes_.mean};
    content.tables["pod weights"] = {weights.size(), 1, weights};
    content.tables["pod modes"] = {n_codes(), modes_.mean.size(), modes_.modes};
  }
} // namespace asperity
