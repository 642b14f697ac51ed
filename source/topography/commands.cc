#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/base/text.h>
#include <asperity/topography/commands.h>
#include <asperity/topography/file_content.h>
#include <asperity/topography/read_height_map.h>
#include <asperity/topography/report_output.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <sstream>

namespace asperity
{
  namespace
  {
    void
    write_file(const std::filesystem::path &path, const std::string &content)
    {
      write_atomically(path.string(),
                       [&content](std::ostream &out) { out << content; });
    }

    /** Whether a text has a line of a parameter file. */
    bool
    has_parameter_line(const std::string &text)
    {
      std::istringstream lines(text);
      for (std::string line; std::getline(lines, line);)
        {
          const std::string word =
            line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
          const bool assigns = line.find('=') != std::string::npos;
          if (word.compare(0, 11, "subsection ") == 0 ||
              word.compare(0, 8, "include ") == 0 ||
              (word.compare(0, 4, "set ") == 0 && assigns))
            return true;
        }
      return false;
    }

    /** A text named .prm is a parameter file, whatever is wrong with it. */
    bool
    is_height_map(const std::string &file)
    {
      const std::filesystem::path path(file);
      const bool                  is_prm = path.extension() == ".prm";
      if (is_prm && !std::filesystem::is_regular_file(path))
        return false;
      const FileContent content(file);
      return has_height_map_signature(content) ||
             !(is_prm || has_parameter_line(content.bytes()));
    }

    /**
     * The defaults for a map that comes without a parameter file, but for the
     * crop: where more is missing than a profile may have, it is taken from the
     * largest rectangle without holes. Returns a sentence on that, or nothing.
     */
    std::string
    choose_parameters(const std::string &file, TopographyParameters &parameters)
    {
      parameters.file      = file;
      const double missing = read_height_map(file).missing_fraction();
      if (missing <= parameters.largest_missing_fraction)
        return "";
      parameters.crop = CropChoice::hole_free;
      return "Crop = hole-free was chosen, since " +
             std::to_string(std::lround(100. * missing)) +
             " % of the points are missing.";
    }

    void
    read_parameters(const std::string    &prm_file,
                    std::string          &directory,
                    TopographyParameters &parameters)
    {
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
      if (directory.empty())
        throw InputError(declarator.where("Output directory") +
                         ": found nothing; expected a folder, such as '.' for "
                         "the current one.");
    }
  } // namespace

  int
  topography_report(const std::string &file)
  {
    std::string          directory = "output/topography";
    TopographyParameters parameters;
    std::string          choice;
    if (is_height_map(file))
      {
        directory += "/" + std::filesystem::path(file).stem().string();
        choice = choose_parameters(file, parameters);
      }
    else
      read_parameters(file, directory, parameters);

    TopographyReport report;
    make_profile(parameters, report);
    if (!choice.empty())
      report.steps.insert(report.steps.begin(), choice);
    print_report(report, std::cout);

    const std::filesystem::path folder(directory);
    std::error_code             error;
    std::filesystem::create_directories(folder, error);
    if (error)
      throw InputError("The output directory " + quoted_name(directory) +
                       " cannot be created: " + error.message() + ".");
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
