#ifndef asperity_topography_report_words_h
#define asperity_topography_report_words_h

#include <asperity/base/quantity.h>

#include <cstdio>
#include <string>

namespace asperity
{
  /** Numbers as the sentences of a report of topography have them. */
  inline std::string
  micrometres(const double length)
  {
    return format_quantity(length, "um", 5);
  }

  inline std::string
  percent(const double fraction)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%.3g %%", 100. * fraction);
    return text;
  }
} // namespace asperity

#endif
