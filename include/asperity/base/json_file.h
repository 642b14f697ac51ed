#ifndef asperity_base_json_file_h
#define asperity_base_json_file_h

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace asperity
{
  /**
   * Reads a JSON document that may come from anybody: of at most 64 MB, 32
   * levels and 20000 keys, so that it can exhaust neither memory, stack nor
   * patience.
   * @param expected what the file should be, for messages: "a friction law"
   * @throws InputError naming the file, and line and column of what is not
   *   JSON, if it is missing, no such document or beyond these bounds
   */
  nlohmann::ordered_json
  read_json(const std::string &path, const std::string &expected);
} // namespace asperity

#endif
