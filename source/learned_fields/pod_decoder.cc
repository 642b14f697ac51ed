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
    : n(n_codes)
    , mean(decomposition.mean())
    , weights(weights)
  {
    if (n_codes < 1 || n_codes > decomposition.n_modes())
      throw InputError("A latent size of " + std::to_string(n_codes) +
                       " is asked for, where the runs have " +
                       std::to_string(decomposition.n_modes()) +
                       " modes; expected 1 to as many.");
    for (unsigned int k = 0; k < n; ++k)
      modes.insert(modes.end(),
                   decomposition.mode(k),
                   decomposition.mode(k) + mean.size());
  }



  PodDecoder::PodDecoder(const Hdf5Content &content,
                         const std::size_t  size,
                         const std::string &origin)
    : mean(content.table("pod mean", 1, origin).values)
    , weights(content.table("pod weights", 1, origin).values)
  {
    const Hdf5Table &table = content.table("pod modes", size, origin);
    n                      = table.n_rows;
    modes                  = table.values;
    if (n == 0 || mean.size() != size || weights.size() != size)
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
    return n;
  }



  std::vector<double>
  PodDecoder::decode(const std::vector<double> &code) const
  {
    std::vector<double> values = mean;
    for (unsigned int k = 0; k < n; ++k)
      {
        const double *mode = &modes[k * mean.size()];
        for (std::size_t i = 0; i < mean.size(); ++i)
          values[i] += code[k] * mode[i];
      }
    return values;
  }



  std::vector<double>
  PodDecoder::encode(const std::vector<double> &values) const
  {
    std::vector<double> code(n, 0.);
    for (unsigned int k = 0; k < n; ++k)
      {
        const double *mode = &modes[k * mean.size()];
        for (std::size_t i = 0; i < mean.size(); ++i)
          code[k] += weights[i] * (values[i] - mean[i]) * mode[i];
      }
    return code;
  }



  void
  PodDecoder::save(Hdf5Content &content) const
  {
    content.texts["decoder"]      = decoder_name;
    content.tables["pod mean"]    = {mean.size(), 1, mean};
    content.tables["pod weights"] = {weights.size(), 1, weights};
    content.tables["pod modes"]   = {n, mean.size(), modes};
  }
} // namespace asperity
