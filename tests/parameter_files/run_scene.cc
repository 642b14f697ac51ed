// Runs a scene and prints what must hold for it, whatever the mesh, the steps
// that were cut, or the machine: so the expected outputs are not the program's.

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace
{
  /** One step of friction.csv, SI units. */
  struct Row
  {
    double time, distance, T_x, T_y, mu;
  };

  std::vector<Row>
  read_rows(const std::string &file)
  {
    std::ifstream    in(file);
    std::string      line;
    std::vector<Row> rows;
    std::getline(in, line); // headings
    while (std::getline(in, line))
      {
        std::istringstream  fields(line);
        std::string         field;
        std::vector<double> values;
        while (std::getline(fields, field, ','))
          values.push_back(std::stod(field));
        rows.push_back({values[1], values[2], values[3], values[4], values[5]});
      }
    return rows;
  }

  // What all of these scenes have in common.
  constexpr double pressure = 300e6;      // [Pa]
  constexpr double velocity = 200. / 60.; // [m/s]
  constexpr double period   = 10e-6;      // [m]
  constexpr double end_time = 2.5e-7;     // [s]
  constexpr double ramp     = 0.2 * end_time;

  double
  load(const double time)
  {
    return pressure * period / 2. *
           (1. - std::cos(M_PI * std::min(time, ramp) / ramp));
  }
} // namespace

int
main(int argc, char **argv)
{
  if (argc != 2)
    return 2;
  const std::string command =
    std::string("'") + ASPERITY_PROGRAM + "' '" + argv[1] + "' >program.txt";
  if (std::system(command.c_str()) != 0)
    return 1;
  const std::vector<Row> rows = read_rows("run/friction.csv");
  if (rows.empty())
    return 1;

  double imbalance = 0, slip = 0, ratio = 0;
  for (const Row &row : rows)
    {
      imbalance =
        std::max(imbalance, std::abs(std::abs(row.T_y) / load(row.time) - 1.));
      slip =
        std::max(slip, std::abs(row.distance / (velocity * row.time) - 1.));
      ratio = std::max(ratio, std::abs(row.T_x / row.T_y - row.mu));
    }
  const auto answer = [](const bool holds) { return holds ? "yes" : "no"; };
  std::cout << "T_y is the load at every step: " << answer(imbalance < 1e-4)
            << "\nsliding distance is v t: " << answer(slip < 1e-9)
            << "\nmu is T_x/T_y: " << answer(ratio < 1e-9)
            << "\nlast time over end time: " << rows.back().time / end_time
            << std::endl;
  return 0;
}
