#include <asperity/topography/length_unit.h>

#include <map>

namespace asperity
{
  double
  metres_per(const std::string &unit)
  {
    // Fields of fixed length carry trailing blanks and NULs.
    const std::string blank(" \t\r\n\0", 5);
    const auto        first = unit.find_first_not_of(blank);
    if (first == std::string::npos)
      return 0.;
    const auto last = unit.find_last_not_of(blank);

    static const std::map<std::string, double> table = {
      {"m", 1.},
      {"metre", 1.},
      {"meter", 1.},
      {"cm", 1e-2},
      {"mm", 1e-3},
      {"um", 1e-6},
      {"\xc2\xb5m", 1e-6}, // micro sign, UTF-8
      {"\xce\xbcm", 1e-6}, // Greek mu, UTF-8
      {"\xb5m", 1e-6},     // micro sign, Latin-1
      {"micron", 1e-6},
      {"microns", 1e-6},
      {"nm", 1e-9},
      {"A", 1e-10},
      {"\xc3\x85", 1e-10}, // A with ring, UTF-8
      {"pm", 1e-12}};
    const auto entry = table.find(unit.substr(first, last - first + 1));
    return entry == table.end() ? 0. : entry->second;
  }
} // namespace asperity
