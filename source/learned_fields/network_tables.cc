#include "network_tables.h"

#include <asperity/base/errors.h>
#include <asperity/base/text.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    /** Numbers of a DecoderShape in the order of the table. */
    constexpr unsigned int n_shape = 9;

    template <typename Number>
    Hdf5Table
    column(const std::vector<Number> &values)
    {
      return {values.size(), 1, {values.begin(), values.end()}};
    }
  } // namespace



  void
  save_network(const AutoDecoder &network,
               const std::string &part,
               Hdf5Content       &content)
  {
    const DecoderShape &shape       = network.decoder().shape();
    content.tables[part + " shape"] = {1,
                                       n_shape,
                                       {1. * shape.n_code,
                                        1. * shape.n_position,
                                        1. * shape.n_outputs,
                                        1. * shape.n_layers,
                                        1. * shape.width,
                                        1. * shape.skip_layer,
                                        1. * static_cast<int>(shape.activation),
                                        1. * static_cast<int>(shape.output),
                                        shape.frequency}};
    content.tables[part + " parameters"] =
      column(network.decoder().parameters());
    std::vector<float> codes;
    for (std::size_t i = 0; i < network.n_codes(); ++i)
      {
        const std::vector<float> code = network.code(i);
        codes.insert(codes.end(), code.begin(), code.end());
      }
    content.tables[part + " codes"] = column(codes);
    const auto add = [&](const std::string &what, const Scaling &scaling) {
      content.tables[part + " centre of " + what] = column(scaling.centre);
      content.tables[part + " scale of " + what]  = column(scaling.scale);
    };
    add("positions", network.position_scaling());
    add("values", network.value_scaling());
  }



  AutoDecoder
  load_network(const Hdf5Content &content,
               const std::string &part,
               const unsigned int n_coordinates,
               const unsigned int n_outputs,
               const std::string &origin)
  {
    const auto numbers = [&](const std::string &name) {
      return content.table(part + " " + name, 1, origin).values;
    };
    const std::vector<double> &s =
      content.table(part + " shape", n_shape, origin).values;
    const bool in_range =
      s.size() == n_shape && std::all_of(s.begin(), s.end(), [](double x) {
        return x >= 0. && x <= 4096.;
      });
    DecoderShape shape;
    if (in_range)
      {
        shape.n_code     = s[0];
        shape.n_position = s[1];
        shape.n_outputs  = s[2];
        shape.n_layers   = s[3];
        shape.width      = s[4];
        shape.skip_layer = s[5];
        shape.activation = static_cast<Activation>(static_cast<int>(s[6]));
        shape.output     = static_cast<Activation>(static_cast<int>(s[7]));
        shape.frequency  = s[8];
      }
    constexpr double most_activations = static_cast<int>(Activation::sine);
    if (!in_range || s[6] > most_activations || s[7] > most_activations ||
        shape.n_outputs != n_outputs || shape.n_position != n_coordinates)
      throw InputError("The network of the " + part + " in " +
                       quoted_name(origin) +
                       " does not fit the fields; expected the file as it "
                       "was written.");
    Decoder<float>            decoder(shape);
    const std::vector<double> parameters = numbers("parameters"),
                              codes      = numbers("codes");
    decoder.parameters().assign(parameters.begin(), parameters.end());
    Scaling positions, values;
    positions.centre    = numbers("centre of positions");
    positions.scale     = numbers("scale of positions");
    values.centre       = numbers("centre of values");
    values.scale        = numbers("scale of values");
    const std::size_t n = shape.n_code > 0 ? codes.size() / shape.n_code : 0;
    return AutoDecoder(decoder,
                       {codes.begin(), codes.end()},
                       std::vector<std::string>(n, "run"),
                       positions,
                       values);
  }
} // namespace asperity
