#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/topography/commands.h>
#include <asperity/topography/read_height_map.h>
#include <asperity/topography/report_output.h>

#include <deal.II/base/parameter_handler.h>

#include <filesystem>
#include <fstream>
#include <iostream>

namespace asperity
{
  namespace
  {
    void
    write_file(const std::filesystem::path &path, const std::string &content)
    {
      std::ofstream out(path, std::ios::binary);
      out << content;
      if (!out.flush())
        throw InputError("The file '" + path.string() + "' cannot be written.");
    }
  } // namespace

  int
  topography_report(const std::string &prm_file)
  {
    std::string              directory = "output/topography";
    TopographyParameters     parameters;
    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator(handler);
    declarator.text("Output directory",
                    directory,
                    "Where the report is written, relative to where the "
                    "program is started.");
    {
      const auto section = declarator.subsection("Topography");
      parameters.declare(declarator);
    }
    declarator.read_file(prm_file);

    TopographyReport report;
    make_profile(parameters, report);
    print_report(report, std::cout);

    const std::filesystem::path folder(directory);
    std::error_code             error;
    std::filesystem::create_directories(folder, error);
    if (error)
      throw InputError("The output directory '" + directory +
                       "' cannot be created: " + error.message() + ".");
    write_file(folder / "report.json", report_json(report));
    write_file(folder / "topography.svg", report_svg(report));
    write_file(folder / "profile.csv",
               profile_csv(report.profile,
                           "one period of the finished profile"));
    write_file(folder / "measured_profile.csv",
               profile_csv(report.measured, "measured profile"));
    write_x3p(report.map, (folder / "surface.x3p").string());
    std::cout << "Written to " << directory
              << ": topography.svg, report.json, profile.csv, "
                 "measured_profile.csv, surface.x3p\n";
    return 0;
  }
} // namespace asperity
