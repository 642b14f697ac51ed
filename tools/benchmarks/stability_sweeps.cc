// Evaluates cells of the sweeps of tools/stability. Reads a cell a line,
//   C18 rate=1e6 celsius=675 increment=0.01
// and answers each at once with a line of JSON: {"values": {...}}, {"reported":
// "sentence"} where the program would end with that sentence, or {"failed":
// "..."} for an exception that it does not know.

#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/mpi_session.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <sstream>

#include "stability/sweeps.h"

namespace
{
  using namespace stability;

  nlohmann::json
  answer(const Sweeps &sweeps, const std::string &line)
  {
    std::istringstream words(line);
    std::string        mode, word;
    words >> mode;
    std::map<std::string, std::string> settings;
    while (words >> word)
      settings[word.substr(0, word.find('='))] =
        word.substr(word.find('=') + 1);
    try
      {
        const Answer found = sweeps.at(mode)(Cell(settings));
        // Numbers that are not finite become null.
        return {{"values", found.values}, {"warning", found.warning}};
      }
    catch (const Reported &error)
      {
        return {{"reported", error.what()}};
      }
    catch (const asperity::InputError &error)
      {
        return {{"reported", error.what()}};
      }
    catch (const asperity::ComputationError &error)
      {
        return {{"reported", error.what()}};
      }
    catch (const std::exception &error)
      {
        return {{"failed", error.what()}};
      }
  }
} // namespace



namespace stability
{
  Cell::Cell(std::map<std::string, std::string> settings)
    : settings(std::move(settings))
  {}



  const std::string &
  Cell::text(const std::string &name) const
  {
    const auto found = settings.find(name);
    if (found == settings.end())
      throw std::invalid_argument("the cell has no setting " + name);
    return found->second;
  }



  double
  Cell::number(const std::string &name) const
  {
    return std::stod(text(name));
  }



  unsigned int
  Cell::count(const std::string &name) const
  {
    return std::stoul(text(name));
  }
} // namespace stability



int
main(int argc, char **argv)
{
  asperity::use_one_thread_per_rank();
  const asperity::MpiSession mpi(argc, argv);
  Sweeps                     sweeps;
  for (const Sweeps &some :
       {contact_sweeps(), point_sweeps(), flow_sweeps(), solid_sweeps()})
    sweeps.insert(some.begin(), some.end());
  for (std::string line; std::getline(std::cin, line);)
    std::cout << answer(sweeps, line).dump() << std::endl;
}
