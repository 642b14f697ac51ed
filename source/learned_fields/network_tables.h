#ifndef asperity_learned_fields_network_tables_h
#define asperity_learned_fields_network_tables_h

#include <asperity/learning/auto_decoder.h>
#include <asperity/postprocess/hdf5_file.h>

#include <string>

namespace asperity
{
  /** Adds a network to a file. @param part begins the names of its tables */
  void
  save_network(const AutoDecoder &network,
               const std::string &part,
               Hdf5Content       &content);

  /** @throws InputError if it is missing, or has other numbers of coordinates
   *  and outputs */
  AutoDecoder
  load_network(const Hdf5Content &content,
               const std::string &part,
               const unsigned int n_coordinates,
               const unsigned int n_outputs,
               const std::string &origin);
} // namespace asperity

#endif
