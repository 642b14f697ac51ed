#include "law_checksum.h"

#include <asperity/base/quantity.h>

#include <boost/crc.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace asperity
{
  namespace
  {
    using Json = nlohmann::ordered_json;
    using Crc  = boost::crc_optimal<64,
                                   0x42F0E1EBA9EA3693ULL,
                                   0xFFFFFFFFFFFFFFFFULL,
                                   0xFFFFFFFFFFFFFFFFULL,
                                   true,
                                   true>;

    /** With the length in front, so that neighbours cannot be mistaken. */
    void
    add(Crc &crc, const std::string &text)
    {
      const std::string framed = std::to_string(text.size()) + ":" + text;
      crc.process_bytes(framed.data(), framed.size());
    }

    void
    add(Crc &crc, const Json &value, const std::string &left_out = "")
    {
      if (value.is_object())
        {
          std::vector<std::string> keys;
          for (const auto &[key, entry] : value.items())
            if (key != left_out)
              keys.push_back(key);
          std::sort(keys.begin(), keys.end());
          add(crc, "object " + std::to_string(keys.size()));
          for (const std::string &key : keys)
            {
              add(crc, key);
              add(crc, value.at(key));
            }
        }
      else if (value.is_array())
        {
          add(crc, "list " + std::to_string(value.size()));
          for (const Json &entry : value)
            add(crc, entry);
        }
      else if (value.is_number())
        add(crc, "number " + format_number(value.get<double>()));
      else if (value.is_string())
        add(crc, "text " + value.get<std::string>());
      else
        add(crc, value.dump());
    }
  } // namespace



  std::string
  law_checksum(const nlohmann::ordered_json &law)
  {
    Crc crc;
    add(crc, law, "checksum");
    char digits[17];
    std::snprintf(digits,
                  sizeof(digits),
                  "%016llx",
                  static_cast<unsigned long long>(crc.checksum()));
    return digits;
  }
} // namespace asperity
