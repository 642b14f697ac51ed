/*
 * Published benchmarks of the isogeometric solid over degree, mesh and step, as
 * Markdown tables:
 *
 *   solid_benchmarks csm | swing | cook | cylinder | taylor | all
 *
 * The example problems are those of the tests.
 */

#include <asperity/base/environment.h>
#include <asperity/base/mpi_session.h>

#include <deal.II/base/timer.h>

#include <solid/cook_membrane.h>
#include <solid/taylor_bar.h>
#include <solid/thick_cylinder.h>
#include <solid/turek_flag.h>

#include <functional>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "markdown_table.h"

namespace
{
  using namespace loaded_solid;
  using namespace markdown_table;

  void
  csm()
  {
    std::cout << "\nCSM1 and CSM2: tip displacement in mm, references "
                 "-7.187190, -66.099802 and -0.4690, -16.97\n\n";
    row("degree", "cells", "CSM1 x", "CSM1 y", "CSM2 x", "CSM2 y");
    row("---", "---", "---", "---", "---", "---");
    for (unsigned int degree = 1; degree <= 4; ++degree)
      for (const unsigned int n : {1, 2, 4, 8})
        {
          const auto soft = hanging_flag_tip(degree, 12 * n, n + 1, 0.5e6);
          const auto hard = hanging_flag_tip(degree, 12 * n, n + 1, 2e6);
          row(degree,
              std::to_string(12 * n) + " x " + std::to_string(n + 1),
              1e3 * soft[0],
              1e3 * soft[1],
              1e3 * hard[0],
              1e3 * hard[1]);
        }
  }

  /** "mean +- amplitude" in mm. */
  std::string
  millimetres(const Swing &swing)
  {
    std::ostringstream text;
    text << std::fixed << std::setprecision(3) << 1e3 * swing.mean << " +- "
         << 1e3 * swing.amplitude;
    return text.str();
  }

  void
  swing()
  {
    std::cout << "\nCSM3 to t = 10 s, in mm and Hz\n\n";
    row("degree",
        "cells",
        "rho",
        "dt",
        "x, last period",
        "y, last period",
        "x, mean of periods",
        "y, mean of periods",
        "frequency",
        "energy error",
        "seconds");
    row("---",
        "---",
        "---",
        "---",
        "---",
        "---",
        "---",
        "---",
        "---",
        "---",
        "---");
    const auto run = [](const unsigned int n_x,
                        const unsigned int n_y,
                        const double       rho,
                        const double       dt) {
      attempt([=]() {
        dealii::Timer timer;
        const auto    motion = swinging_flag(3, n_x, n_y, dt, 10., rho);
        row(3,
            std::to_string(n_x) + " x " + std::to_string(n_y),
            rho,
            dt,
            millimetres(last_swing(motion.tip, 0, dt)),
            millimetres(last_swing(motion.tip, 1, dt)),
            millimetres(mean_swing(motion.tip, 0, dt)),
            millimetres(mean_swing(motion.tip, 1, dt)),
            swing_frequency(motion.tip, dt),
            motion.energy_error,
            timer.cpu_time());
      });
    };
    for (const double dt : {0.02, 0.01, 0.005, 0.0025, 0.00125, 0.000625})
      run(12, 2, 1., dt);
    for (const double dt : {0.02, 0.01, 0.005, 0.0025})
      run(24, 3, 1., dt);
    run(12, 2, 0.8, 0.005);
    run(12, 2, 0.8, 0.0025);
  }

  void
  cook()
  {
    std::cout << "\nCook's membrane, J2: rise of the corner in mm (published: "
                 "6.9 to 7.4)\n\n";
    row("cells", "p = 1", "p = 2", "p = 3", "p = 4");
    row("---", "---", "---", "---", "---");
    for (const unsigned int n : {2, 4, 8, 16, 32})
      attempt([n]() {
        double rise[4];
        for (unsigned int degree = 1; degree <= 4; ++degree)
          rise[degree - 1] = 1e3 * cook_membrane(degree, n, 10);
        row(std::to_string(n) + " x " + std::to_string(n),
            rise[0],
            rise[1],
            rise[2],
            rise[3]);
      });
  }

  void
  cylinder_table(
    const std::string                                       &name,
    const std::function<double(unsigned int, unsigned int)> &pressure,
    const std::vector<unsigned int>                         &cells)
  {
    const double exact = ThickCylinder::elastic_plastic_pressure(85e-3);
    std::cout << "\nThick cylinder, " << name
              << ": error of the pressure at a = 85 mm in per cent of "
              << 1e-6 * exact << " MPa (rigid-plastic formula: "
              << 1e-6 * ThickCylinder::rigid_plastic_pressure(85e-3)
              << " MPa)\n\n";
    row("cells in the wall", "p = 1", "p = 2", "p = 3", "p = 4");
    row("---", "---", "---", "---", "---");
    for (const unsigned int n : cells)
      attempt([&]() {
        double error[4];
        for (unsigned int degree = 1; degree <= 4; ++degree)
          error[degree - 1] = 100. * (pressure(degree, n) / exact - 1.);
        row(n, error[0], error[1], error[2], error[3]);
      });
  }

  void
  cylinder()
  {
    cylinder_table("axisymmetric ring, 75 steps",
                   [](const unsigned int degree, const unsigned int n) {
                     return ThickCylinder::ring_pressure(degree, n, 75, 85e-3);
                   },
                   {2, 4, 8, 16, 32});
    cylinder_table("quarter in plane strain, n x 2 n cells, 75 steps",
                   [](const unsigned int degree, const unsigned int n) {
                     return ThickCylinder::quarter_pressure(degree,
                                                            n,
                                                            75,
                                                            85e-3);
                   },
                   {2, 4, 8});
  }

  void
  taylor_bars()
  {
    std::cout << "\nTaylor bar, 42CrMo4, 287 m/s, 80 us (DynELA 26.52 mm, "
                 "11.15 mm, 582 degC, 1.78; Abaqus 26.56, 11.16, 591, 1.81)"
                 "\n\n";
    row("degree",
        "cells",
        "steps",
        "rho",
        "length mm",
        "diameter mm",
        "T degC",
        "largest T",
        "plastic strain",
        "kinetic energy left",
        "iterations",
        "seconds");
    std::cout << "|";
    for (unsigned int column = 0; column < 12; ++column)
      std::cout << " --- |";
    std::cout << std::endl;
    const auto run = [](const unsigned int degree,
                        const unsigned int n_r,
                        const unsigned int n_z,
                        const unsigned int n_steps,
                        const double       rho) {
      attempt([=]() {
        dealii::Timer         timer;
        const TaylorBarResult bar = taylor_bar(degree, n_r, n_z, n_steps, rho);
        row(degree,
            std::to_string(n_r) + " x " + std::to_string(n_z),
            n_steps,
            rho,
            1e3 * bar.length,
            1e3 * bar.diameter,
            bar.temperature,
            bar.max_temperature,
            bar.plastic_strain,
            bar.kinetic_energy,
            bar.iterations,
            timer.cpu_time());
      });
    };
    for (const double rho : {0.5, 0.8, 1.})
      for (const unsigned int n_steps : {320, 640, 1280, 2560, 5120, 10240})
        if (rho < 1. || n_steps <= 640) // undamped, Newton's method is slow
          run(2, 8, 32, n_steps, rho);
    for (const unsigned int n : {8, 10, 12, 16})
      run(2, n, 4 * n, 640, 0.8);
    run(3, 8, 32, 640, 0.8);
    for (const unsigned int n : {4, 12, 16})
      run(2, n, 4 * n, 2560, 0.5);
  }
} // namespace



int
main(int argc, char **argv)
{
  asperity::use_one_thread_per_rank();
  const asperity::MpiSession                            mpi(argc, argv);
  const std::vector<std::pair<std::string, void (*)()>> benchmarks = {
    {"csm", csm},
    {"swing", swing},
    {"cook", cook},
    {"cylinder", cylinder},
    {"taylor", taylor_bars}};
  bool found = false;
  std::cout << std::setprecision(7);
  for (const auto &benchmark : benchmarks)
    for (int i = 1; i < argc; ++i)
      if (argv[i] == benchmark.first || argv[i] == std::string("all"))
        {
          benchmark.second();
          found = true;
        }
  if (!found)
    {
      std::cerr << "Name one or more of: csm swing cook cylinder taylor all."
                << std::endl;
      return 2;
    }
  return 0;
}
