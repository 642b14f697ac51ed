#include <asperity/learned_fields/network_decoder.h>
#include <asperity/learning/training.h>
#include <asperity/postprocess/hdf5_file.h>

#include "network_tables.h"

namespace asperity
{
  namespace
  {
    const char *const names_of_parts[] = {"chip", "edge"};
  } // namespace



  NetworkDecoder::NetworkDecoder(const FieldLayout &layout,
                                 const AutoDecoder &chip,
                                 const AutoDecoder &edge)
    : layout(layout)
    , chip(chip)
    , edge(edge)
  {}



  NetworkDecoder::NetworkDecoder(const FieldLayout &layout,
                                 const Hdf5Content &content,
                                 const std::string &origin)
    : layout(layout)
    , chip(load_network(content,
                        names_of_parts[0],
                        NetworkPart(layout, false).n_coordinates(),
                        NetworkPart(layout, false).n_outputs(),
                        origin))
    , edge(load_network(content,
                        names_of_parts[1],
                        NetworkPart(layout, true).n_coordinates(),
                        NetworkPart(layout, true).n_outputs(),
                        origin))
  {}



  std::string
  NetworkDecoder::name() const
  {
    return decoder_name;
  }



  unsigned int
  NetworkDecoder::n_codes() const
  {
    return chip.decoder().shape().n_code + edge.decoder().shape().n_code;
  }



  std::vector<double>
  NetworkDecoder::decode(const std::vector<double> &code) const
  {
    std::vector<double> values(layout.size(), 0.);
    const auto          middle = code.begin() + chip.decoder().shape().n_code;
    NetworkPart(layout, false).fill(chip, {code.begin(), middle}, values);
    NetworkPart(layout, true).fill(edge, {middle, code.end()}, values);
    return values;
  }



  std::vector<double>
  NetworkDecoder::encode(const std::vector<double> &values) const
  {
    Loss loss;
    loss.kind = Loss::Kind::squared;
    CodeSearch search;
    search.n_steps         = 300;
    search.points_per_step = 256;
    search.rate            = 2e-2;
    search.regularization  = 0.;
    std::vector<double> code;
    for (const bool is_edge : {false, true})
      {
        const std::vector<float> part =
          infer_code(is_edge ? edge : chip,
                     NetworkPart(layout, is_edge).sample("run", values),
                     loss,
                     search);
        code.insert(code.end(), part.begin(), part.end());
      }
    return code;
  }



  std::vector<double>
  NetworkDecoder::code_of(const std::size_t run) const
  {
    const std::vector<float> first = chip.code(run), second = edge.code(run);
    std::vector<double>      code(first.begin(), first.end());
    code.insert(code.end(), second.begin(), second.end());
    return code;
  }



  void
  NetworkDecoder::save(Hdf5Content &content) const
  {
    content.texts["decoder"] = decoder_name;
    save_network(chip, names_of_parts[0], content);
    save_network(edge, names_of_parts[1], content);
  }
} // namespace asperity
