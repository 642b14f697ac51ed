#ifndef asperity_postprocess_summary_h
#define asperity_postprocess_summary_h

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace asperity
{
  /**
   * Writes a JSON document, indented, in the order in which its keys were set,
   * atomically.
   *
   * @throws ComputationError naming the key (as a JSON pointer) of a number
   * that is not finite, which JSON could only write as null
   */
  void
  write_summary(const std::string &path, const nlohmann::ordered_json &summary);

  /** Reads a JSON document. @throws InputError if the file is missing or is not
   *  JSON. */
  nlohmann::ordered_json
  read_summary(const std::string &path);
} // namespace asperity

#endif
