#ifndef asperity_surrogate_law_checksum_h
#define asperity_surrogate_law_checksum_h

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace asperity
{
  /**
   * CRC-64 (ECMA-182, as in XZ) of all that a law's document says but its own
   * entry `checksum`, in hexadecimal digits. Neither the order of keys nor the
   * layout of the text counts, so that a law survives other JSON programs; any
   * other number or text does.
   */
  std::string
  law_checksum(const nlohmann::ordered_json &law);
} // namespace asperity

#endif
