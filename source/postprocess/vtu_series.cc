#include <asperity/base/atomic_file.h>
#include <asperity/postprocess/vtu_series.h>

#include <deal.II/base/data_out_base.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

namespace asperity
{
  namespace
  {
    /** The step in the name of a file of the series, if it is one. */
    std::optional<int>
    step_of_file(const std::string &file, const std::string &name)
    {
      const std::string prefix = name + "_", suffix = ".vtu";
      if (file.size() <= prefix.size() + suffix.size() ||
          file.compare(0, prefix.size(), prefix) != 0 ||
          file.compare(file.size() - suffix.size(), suffix.size(), suffix) != 0)
        return std::nullopt;
      const std::string digits =
        file.substr(prefix.size(), file.size() - prefix.size() - suffix.size());
      if (digits.size() > 9 ||
          digits.find_first_not_of("0123456789") != std::string::npos)
        return std::nullopt;
      return std::stoi(digits);
    }

    /** The value of an attribute in a line of XML; empty if it has none. */
    std::string
    attribute(const std::string &line, const std::string &key)
    {
      const std::string start    = " " + key + "=\"";
      const std::size_t position = line.find(start);
      if (position == std::string::npos)
        return "";
      const std::size_t begin = position + start.size();
      const std::size_t end   = line.find('"', begin);
      return end == std::string::npos ? "" : line.substr(begin, end - begin);
    }
  } // namespace



  VtuSeries::VtuSeries(const std::string &directory,
                       const std::string &name,
                       const int          keep_until_step)
    : directory(directory)
    , name(name)
  {
    if (keep_until_step > keep_nothing)
      read_record(keep_until_step);
    write_record();
    remove_files(keep_until_step);
  }



  std::string
  VtuSeries::file_name(const unsigned int step) const
  {
    char number[16];
    std::snprintf(number, sizeof(number), "%06u", step);
    return name + "_" + number + ".vtu";
  }



  std::string
  VtuSeries::path(const unsigned int step) const
  {
    return directory + "/" + file_name(step);
  }



  void
  VtuSeries::write(const unsigned int                         step,
                   const double                               time,
                   const std::function<void(std::ostream &)> &write)
  {
    write_atomically(path(step), write);
    record.emplace_back(time, file_name(step));
    write_record();
  }



  void
  VtuSeries::read_record(const int keep_until_step)
  {
    std::ifstream in(directory + "/" + name + ".pvd");
    std::string   line;
    while (std::getline(in, line))
      {
        const std::string time = attribute(line, "timestep");
        const std::string file = attribute(line, "file");
        const auto        step = step_of_file(file, name);
        if (!time.empty() && step && *step <= keep_until_step &&
            std::filesystem::exists(directory + "/" + file))
          record.emplace_back(std::strtod(time.c_str(), nullptr), file);
      }
  }



  void
  VtuSeries::remove_files(const int keep_until_step) const
  {
    std::error_code error;
    for (const auto &file :
         std::filesystem::directory_iterator(directory, error))
      {
        const auto step = step_of_file(file.path().filename().string(), name);
        if (step && *step > keep_until_step)
          {
            std::error_code ignored;
            std::filesystem::remove(file.path(), ignored);
          }
      }
  }



  void
  VtuSeries::write_record() const
  {
    write_atomically(directory + "/" + name + ".pvd", [&](std::ostream &out) {
      dealii::DataOutBase::write_pvd_record(out, record);
    });
  }
} // namespace asperity
