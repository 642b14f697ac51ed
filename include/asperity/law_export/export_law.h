#ifndef asperity_law_export_export_law_h
#define asperity_law_export_export_law_h

#include <asperity/law_export/friction_grid.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  struct ExportOptions
  {
    /** SI values of the inputs beside p, v and T, by name or symbol. */
    std::map<std::string, double> fixed;

    /** Units of the solver tables, and how fine they are. The user subroutines
     *  always start with mm, t, s, MPa, degC. */
    FrictionGridOptions grid;

    /** Up to this number of runs the generated source carries the triangular
     *  factor (n^2/2 numbers), and with it deviation and `trusted`. */
    std::size_t largest_factor_size = 200;

    /** At which Abaqus's TAUMAX is taken [K]; empty: the middle of the range.
     */
    std::optional<double> limit_temperature;
  };

  struct ExportedFile
  {
    std::string name; ///< inside of the directory
    std::string sentence;

    /** Largest relative error of linear interpolation that was measured; 0 for
     *  files that carry the law itself. */
    double interpolation_error = 0.;
  };

  struct ExportReport
  {
    std::vector<ExportedFile> files;
    std::vector<std::string>  warnings;

    double      table_error   = 0.;    ///< largest of the interpolation errors
    std::size_t table_entries = 0;     ///< of the table over p, v and T
    bool        has_deviation = false; ///< the source knows `trusted`
  };

  /**
   * Writes a law of mu as source code (C99, Fortran 77), user subroutines,
   * tables for Abaqus, LS-DYNA and DEFORM, a long CSV table and a README.txt
   * that explains them. Each file is replaced as a whole; what else is in the
   * directory stays.
   *
   * @throws InputError if the law is not one of mu, or an input beside p, v and
   *   T has no value; ComputationError if a file cannot be written
   */
  ExportReport
  export_law(const FrictionLaw   &law,
             const std::string   &directory,
             const ExportOptions &options = {});
} // namespace asperity

#endif
