#ifndef asperity_benchmarks_markdown_table_h
#define asperity_benchmarks_markdown_table_h

#include <functional>
#include <iostream>
#include <string>

namespace markdown_table
{
  /** A row of a Markdown table, printed as soon as it is known. */
  template <typename... Cells>
  void
  row(const Cells &...cells)
  {
    std::cout << "|";
    ((std::cout << " " << cells << " |"), ...);
    std::cout << std::endl;
  }

  /** A failed computation is a cell of the table, too. */
  inline void
  attempt(const std::function<void()> &action)
  {
    try
      {
        action();
      }
    catch (const std::exception &error)
      {
        row(std::string("failed: ") + error.what());
      }
  }
} // namespace markdown_table

#endif
