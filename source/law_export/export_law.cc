#include <asperity/base/atomic_file.h>
#include <asperity/base/quantity.h>
#include <asperity/law_export/export_law.h>
#include <asperity/law_export/generated_source.h>
#include <asperity/law_export/solver_tables.h>
#include <asperity/law_export/solver_templates.h>

#include <algorithm>
#include <ostream>

#include "export_text.h"

namespace asperity
{
  namespace
  {
    /** Writes the files and keeps the report on them. */
    class Exporter
    {
    public:
      Exporter(const ContactPointLaw &law,
               const std::string     &directory,
               const ExportOptions   &options)
        : law(law)
        , directory(directory)
        , options(options)
      {}

      ExportReport
      run()
      {
        write_sources();
        write_templates();
        write_tables();
        write_long_table();
        write_readme();
        return report;
      }

    private:
      void
      write(const std::string &name,
            const std::string &content,
            const std::string &sentence,
            const double       error = 0.)
      {
        write_atomically(directory + "/" + name,
                         [&](std::ostream &out) { out << content; });
        report.files.push_back({name, sentence, error});
        report.table_error = std::max(report.table_error, error);
      }

      void
      write_sources()
      {
        report.has_deviation =
          law.law().fitted() != nullptr ||
          law.law().data().y.size() <= options.largest_factor_size;
        if (!report.has_deviation)
          report.warnings.push_back(
            "The law has more than " +
            std::to_string(options.largest_factor_size) +
            " runs: the generated source does not know the deviation, and calls "
            "every point in the box trusted.");
        write("tribmu.h", c_header(law), "C99: what to call");
        write("tribmu.c",
              c_source(law, report.has_deviation),
              "C99: the law, to be compiled into any program");
        write("tribmu.f",
              fortran_source(law, report.has_deviation),
              "Fortran 77: the law, to be compiled into any program");
        write("friction_law.js",
              js_source(law, report.has_deviation),
              "JavaScript: the law with its intervals, for pages and Node.js");
      }

      void
      write_templates()
      {
        write("abaqus_fric_coef.f",
              abaqus_fric_coef(law),
              "Abaqus/Standard: user subroutine FRIC_COEF");
        write("abaqus_vfriction.f",
              abaqus_vfriction(law),
              "Abaqus/Explicit: user subroutine VFRICTION");
        write("deform_usr_bcc.f",
              deform_usr_bcc(law),
              "DEFORM: user routine USRBCC");
      }

      double
      limit_temperature() const
      {
        if (options.limit_temperature)
          return *options.limit_temperature;
        const LawInput *const T = law.input(2);
        return T == nullptr ? 293.15 : 0.5 * (T->lower + T->upper);
      }

      void
      write_tables()
      {
        const FrictionGrid grid(law, options.grid);
        report.table_entries = grid.n_nodes();
        if (!grid.tolerance_is_reached())
          report.warnings.push_back(
            "The tolerance of the tables, " + percent(options.grid.tolerance) +
            ", is not reached with " + std::to_string(options.grid.max_nodes) +
            " entries; the error is " + percent(grid.interpolation_error()) +
            ".");
        write("abaqus_friction.inp",
              abaqus_table(law, grid, limit_temperature()),
              "Abaqus: *FRICTION with TAUMAX",
              grid.interpolation_error());
        write("lsdyna_friction.k",
              lsdyna_table(law, grid),
              "LS-DYNA: a table mu(v, p) for each temperature",
              error_on_planes(grid, 2));
        for (std::size_t j = 0; j < grid.nodes(1).size(); ++j)
          {
            const std::string v = format_quantity(grid.nodes(1)[j], "1", 6);
            write("deform_frcfac_" + std::to_string(j + 1) + ".key",
                  deform_table(law, grid, j),
                  "DEFORM: FRCFAC over p and T at " + v + " " +
                    options.grid.units[1],
                  grid.interpolation_error(1, j));
          }
      }

      void
      write_long_table()
      {
        FrictionGridOptions in_si = options.grid;
        in_si.units               = {{"Pa", "m/s", "K"}};
        const FrictionGrid grid(law, in_si);
        write("friction_table.csv",
              friction_table_csv(law, grid),
              "any program: mu, sigma, tau, k and trusted, row by row, in SI",
              grid.interpolation_error());
      }

      void
      write_readme()
      {
        std::string text =
          "A friction law of tool and chip for chip-formation programs\n"
          "===========================================================\n\n";
        for (const std::string &line : law_lines(law))
          text += line + "\n";
        text += "\nFiles\n-----\n\n";
        for (const ExportedFile &file : report.files)
          text +=
            file.name + "\n    " + file.sentence +
            (file.interpolation_error > 0. ?
               "; interpolates within " + percent(file.interpolation_error) :
               "") +
            "\n";
        text += "\nNotes\n-----\n\n";
        for (
          const char *const paragraph :
          {"In the sticking zone the shear stress is the shear limit k of "
           "the chip and not mu p (Zorev): tau = min(mu p, k). The source and "
           "the user subroutines do that with k(T); Abaqus's table has one "
           "TAUMAX; the other tables do not limit tau.",
           "Outside of the ranges above the law is not to be trusted. The "
           "source still answers, with finite numbers that far away tend to a "
           "constant; tables hold their last value.",
           "Nothing here has been run in Abaqus, LS-DYNA or DEFORM. The "
           "source and the user subroutines were compiled and compared with "
           "the law by the tests of Asperity.",
           "For programs that can call a library, asperity_friction.h and "
           "tools/asperity_friction.py of Asperity read the law's own file."})
          {
            for (const std::string &line : wrapped(paragraph, 72))
              text += line + "\n";
            text += "\n";
          }
        for (const std::string &warning : report.warnings)
          for (const std::string &line : wrapped("Warning: " + warning, 72))
            text += line + "\n";
        text += (report.warnings.empty() ? "" : "\n");
        text += "Licence of these files\n----------------------\n\n";
        for (const std::string &line : licence_lines())
          text += line + "\n";
        write("README.txt", text, "this text");
      }

      const ContactPointLaw &law;
      const std::string      directory;
      const ExportOptions   &options;
      ExportReport           report;
    };
  } // namespace



  ExportReport
  export_law(const FrictionLaw   &law,
             const std::string   &directory,
             const ExportOptions &options)
  {
    const ContactPointLaw contact_point_law(law, options.fixed);
    return Exporter(contact_point_law, directory, options).run();
  }
} // namespace asperity
