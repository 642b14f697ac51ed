#include <asperity/base/csv.h>
#include <asperity/base/errors.h>

namespace asperity
{
  std::vector<std::string>
  csv_cells(const std::string &line)
  {
    std::vector<std::string> result(1);
    bool                     in_quotes = false;
    for (std::size_t i = 0; i < line.size(); ++i)
      if (line[i] == '"' && in_quotes && line[i + 1] == '"')
        result.back() += line[i++];
      else if (line[i] == '"')
        in_quotes = !in_quotes;
      else if (line[i] == ',' && !in_quotes)
        result.emplace_back();
      else
        result.back() += line[i];
    if (in_quotes)
      throw InputError("a quote is opened, but not closed");
    return result;
  }
} // namespace asperity
