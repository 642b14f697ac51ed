// The Reynolds film against formulas and against Stokes flow.
// Usage: film_benchmarks FOLDER; writes FOLDER/film_*.csv and prints them.

#include <asperity/base/environment.h>
#include <asperity/base/mpi_session.h>
#include <asperity/lubricant/film_walls.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "flow/flow_examples.h"

using namespace asperity;

namespace
{
  constexpr double pi = dealii::numbers::PI;

  /** eta = 1, the film is full. */
  LubricantParameters
  unit_oil()
  {
    LubricantParameters oil;
    oil.compressibility.law = DensityLaw::incompressible;
    oil.viscosity.viscosity = 1.;
    return oil;
  }



  std::vector<double>
  uniform_faces(const unsigned int n, const double length)
  {
    std::vector<double> x(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
      x[i] = length * i / n;
    return x;
  }



  FilmEnds
  ends_at(const double pressure)
  {
    FilmEnds ends;
    ends.periodic      = false;
    ends.left.pressure = ends.right.pressure = pressure;
    return ends;
  }



  class Table
  {
  public:
    Table(const std::string &file_name, const std::string &header)
      : file(file_name)
    {
      if (!file)
        throw std::runtime_error("Cannot write " + file_name + ".");
      file << header << '\n';
      std::cout << '\n' << header << '\n';
    }

    template <typename... Columns>
    void
    row(const Columns &...columns)
    {
      std::ostringstream line;
      line << std::setprecision(8);
      const char *separator = "";
      ((line << separator << columns, separator = ","), ...);
      file << line.str() << '\n';
      std::cout << line.str() << std::endl;
    }

  private:
    std::ofstream file;
  };



  /** Gap 2 at the inlet, 1 at the outlet, lower wall moving. */
  FilmWalls
  slider(const unsigned int n)
  {
    FilmWalls walls;
    walls.x           = uniform_faces(n, 1.);
    walls.gap         = [](const double x) { return 2. - x; };
    walls.lower_speed = 1.;
    return walls;
  }



  void
  slider_grids(const std::string &folder)
  {
    Table        table(folder + "/film_slider.csv",
                "cells,load,moving_drag,stationary_drag,max_pressure");
    const double l = std::log(2.);
    table.row("exact", 6. * l - 4., 4. * l - 2., 2. - 2. * l, 0.25);
    for (const unsigned int n : {125, 250, 500, 1000, 2000})
      {
        const FilmWalls        walls = slider(n);
        const ReynoldsFilm     film(unit_oil(), n, ends_at(0.));
        std::vector<FilmState> states(n);
        film.solve(walls.geometry(), FilmStep(), states);
        const FilmForces f = film_forces(film, walls, states);
        table.row(n, f.load, -f.lower_shear, f.upper_shear, f.max_pressure);
      }
  }



  void
  piezoviscous_slider(const std::string &folder)
  {
    Table              table(folder + "/film_barus.csv",
                "alpha,load,max_pressure,iterations,outcome");
    const unsigned int n = 2000;
    for (const double alpha : {0., 1., 2., 3., 3.5, 3.9, 3.99, 4., 4.1, 8.})
      {
        LubricantParameters oil            = unit_oil();
        oil.viscosity.pressure_law         = PressureLaw::barus;
        oil.viscosity.pressure_coefficient = alpha;
        const FilmWalls        walls       = slider(n);
        const ReynoldsFilm     film(oil, n, ends_at(0.));
        std::vector<FilmState> states(n);
        const auto  report  = film.solve(walls.geometry(), FilmStep(), states);
        std::string outcome = report.converged ?
                                film.warning(walls.geometry(), states) :
                                report.reason;
        const FilmForces f  = film_forces(film, walls, states);
        if (outcome.empty())
          table.row(alpha, f.load, f.max_pressure, report.iterations, "solved");
        else
          table.row(alpha, "", "", report.iterations, "\"" + outcome + "\"");
      }
  }



  /** What is compared of a flow in a wavy channel, over a period. */
  struct ChannelFlow
  {
    double flow     = 0.; ///< through any section
    double pressure = 0.; ///< largest less smallest on the flat wall
    double drag     = 0.; ///< on the flat wall, which moves
  };

  /** h = 1 + 0.5 cos(2 pi x/L) over a flat wall that moves with speed 1; the
   *  largest slope is pi/L. */
  struct WavyChannel
  {
    double length;

    double
    gap(const double x) const
    {
      return 1. + 0.5 * std::cos(2. * pi * x / length);
    }

    ChannelFlow
    reynolds() const
    {
      FilmWalls walls;
      walls.x           = uniform_faces(4000, length);
      walls.gap         = [this](const double x) { return gap(x); };
      walls.lower_speed = 1.;
      // The level keeps the film full; it changes nothing else.
      const ReynoldsFilm     film(unit_oil(), 4000, ends_at(20. * length));
      std::vector<FilmState> states(4000);
      const auto report = film.solve(walls.geometry(), FilmStep(), states);
      if (!report.converged)
        throw std::runtime_error("The film has no solution: " + report.reason);
      const FilmForces forces = film_forces(film, walls, states);
      double           lowest = states[0].pressure, highest = lowest;
      for (const FilmState &state : states)
        {
          lowest  = std::min(lowest, state.pressure);
          highest = std::max(highest, state.pressure);
        }
      return {forces.flow[0], highest - lowest, -forces.lower_shear};
    }

    ChannelFlow
    stokes(const unsigned int n_x, const unsigned int n_y) const
    {
      const auto mesh =
        flow_examples::rectangle(n_x, n_y, {0., 0.}, {length, 1.});
      FluidOptions options;
      options.model.convection          = false;
      options.model.viscosity.viscosity = 1.;
      options.scheme                    = FluidTimeScheme::steady;
      options.degree                    = 3;
      options.geometry_degree           = 3;
      options.tolerance                 = 1e-12;
      NavierStokes flow(*mesh, options, {{0, 1, 0}});
      flow.set_mesh_displacement(
        flow_examples::displacement(flow, [this](const dealii::Point<2> &X) {
          return dealii::Point<2>(X[0], X[1] * gap(X[0]));
        }));
      flow.boundary().set_velocity({2}, flow_examples::constant(1., 0.));
      flow.boundary().set_velocity({3}, flow_examples::constant(0., 0.));
      flow_examples::solve(flow);

      ChannelFlow             result;
      const dealii::QGauss<1> gauss(4);
      for (unsigned int j = 0; j < n_y; ++j)
        for (unsigned int q = 0; q < gauss.size(); ++q)
          {
            const double Y = (j + gauss.point(q)[0]) / n_y;
            const double x = 0.5 * length / n_x; // inside a cell
            result.flow += gauss.weight(q) * gap(x) / n_y *
                           flow.velocity_at({x, Y * gap(x)})[0];
          }
      double lowest = flow.pressure_at({0., 0.}), highest = lowest;
      for (unsigned int i = 0; i < 4 * n_x; ++i)
        {
          const double p = flow.pressure_at({length * i / (4. * n_x), 0.});
          lowest         = std::min(lowest, p);
          highest        = std::max(highest, p);
        }
      result.pressure = highest - lowest;
      result.drag     = -flow.total_wall_force({2})[0];
      return result;
    }
  };



  void
  reynolds_against_stokes(const std::string &folder)
  {
    Table table(folder + "/film_stokes.csv",
                "slope,flow_reynolds,flow_stokes,pressure_reynolds,"
                "pressure_stokes,drag_reynolds,drag_stokes,mesh_error");
    for (const double slope :
         {0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.5, 0.7, 1.})
      {
        const WavyChannel channel{pi / slope};
        const ChannelFlow r      = channel.reynolds();
        const ChannelFlow coarse = channel.stokes(96, 6);
        const ChannelFlow s      = channel.stokes(192, 12);
        const double      error =
          std::max({std::abs(coarse.flow / s.flow - 1.),
                    std::abs(coarse.pressure / s.pressure - 1.),
                    std::abs(coarse.drag / s.drag - 1.)});
        table.row(
          slope, r.flow, s.flow, r.pressure, s.pressure, r.drag, s.drag, error);
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  if (argc != 2)
    {
      std::cerr << "Usage: film_benchmarks FOLDER\n";
      return 2;
    }
  try
    {
      const asperity::MpiSession mpi(argc, argv);
      slider_grids(argv[1]);
      piezoviscous_slider(argv[1]);
      reynolds_against_stokes(argv[1]);
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << '\n';
      return 1;
    }
  return 0;
}
