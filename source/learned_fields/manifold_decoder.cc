#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/learned_fields/manifold_decoder.h>
#include <asperity/postprocess/hdf5_file.h>

#include "network_tables.h"

namespace asperity
{
  namespace
  {
    const char *const part = "manifold";

    /** The latent size that the file states. */
    unsigned int
    latent_size(const Hdf5Content &content, const std::string &origin)
    {
      const std::vector<double> &number =
        content.table("manifold latent size", 1, origin).values;
      return number.size() == 1 && number[0] >= 1. && number[0] <= 4096. ?
               static_cast<unsigned int>(number[0]) :
               0;
    }
  } // namespace



  ManifoldDecoder::ManifoldDecoder(const PodDecoder  &modes,
                                   const AutoDecoder &network)
    : linear(modes)
    , network(network)
  {
    check("the training");
  }



  ManifoldDecoder::ManifoldDecoder(const Hdf5Content &content,
                                   const std::size_t  size,
                                   const std::string &origin)
    : linear(content, size, origin)
    , network(load_network(content,
                           part,
                           latent_size(content, origin),
                           linear.n_codes() - latent_size(content, origin),
                           origin))
  {
    check(quoted_name(origin));
  }



  void
  ManifoldDecoder::check(const std::string &origin) const
  {
    const DecoderShape &shape = network.decoder().shape();
    if (shape.n_code != 0 ||
        shape.n_position + shape.n_outputs != linear.n_codes())
      throw InputError("The network of the manifold in " + origin +
                       " does not fit its " + std::to_string(linear.n_codes()) +
                       " modes.");
  }



  std::string
  ManifoldDecoder::name() const
  {
    return decoder_name;
  }



  unsigned int
  ManifoldDecoder::n_codes() const
  {
    return network.decoder().shape().n_position;
  }



  std::vector<double>
  ManifoldDecoder::decode(const std::vector<double> &code) const
  {
    return linear.decode(coefficients(code));
  }



  std::vector<double>
  ManifoldDecoder::encode(const std::vector<double> &values) const
  {
    std::vector<double> code = linear.encode(values);
    code.resize(n_codes());
    return code;
  }



  const FieldModes *
  ManifoldDecoder::modes() const
  {
    return linear.modes();
  }



  std::vector<double>
  ManifoldDecoder::coefficients(const std::vector<double> &code) const
  {
    std::vector<double>       all  = code;
    const std::vector<double> rest = network.evaluate({}, code);
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
  }



  void
  ManifoldDecoder::save(Hdf5Content &content) const
  {
    linear.save(content);
    save_network(network, part, content);
    content.tables["manifold latent size"] = {1, 1, {1. * n_codes()}};
    content.texts["decoder"]               = decoder_name;
  }
} // namespace asperity
