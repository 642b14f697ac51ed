#ifndef asperity_base_csv_h
#define asperity_base_csv_h

#include <string>
#include <vector>

namespace asperity
{
  /**
   * The cells of a line of comma-separated values; those in quotes may hold
   * commas, and a quote as two.
   * @throws InputError with a half sentence if a quote is not closed
   */
  std::vector<std::string>
  csv_cells(const std::string &line);
} // namespace asperity

#endif
