#ifndef asperity_law_export_fortran_blocks_h
#define asperity_law_export_fortran_blocks_h

#include <string>

#include "exported_numbers.h"

namespace asperity
{
  /** The constants that a block "PARAMETERS D NQ" names. */
  std::string
  fortran_parameters(const ExportedNumbers &numbers, const std::string &block);
} // namespace asperity

#endif
