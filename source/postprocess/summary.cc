#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/base/json_file.h>
#include <asperity/base/text.h>
#include <asperity/postprocess/summary.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace asperity
{
  namespace
  {
    void
    require_finite(const nlohmann::ordered_json &value,
                   const std::string            &key,
                   const std::string            &path)
    {
      if (value.is_number_float() && !std::isfinite(value.get<double>()))
        throw ComputationError("The value of " + quoted_name(key) + " for " +
                               quoted_name(path) + " is not a finite number.");
      if (value.is_structured())
        for (const auto &[name, item] : value.items())
          require_finite(item, key + "/" + name, path);
    }
  } // namespace



  void
  write_summary(const std::string &path, const nlohmann::ordered_json &summary)
  {
    require_finite(summary, "", path);
    write_atomically(path, [&](std::ostream &out) {
      out << summary.dump(2,
                          ' ',
                          false,
                          nlohmann::ordered_json::error_handler_t::replace)
          << '\n';
    });
  }



  nlohmann::ordered_json
  read_summary(const std::string &path)
  {
    return read_json(path, "a JSON document");
  }
} // namespace asperity
