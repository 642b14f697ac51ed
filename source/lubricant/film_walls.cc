#include <asperity/lubricant/film_walls.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace asperity
{
  std::vector<double>
  FilmWalls::centres() const
  {
    std::vector<double> result(x.size() - 1);
    for (unsigned int i = 0; i < result.size(); ++i)
      result[i] = 0.5 * (x[i] + x[i + 1]);
    return result;
  }



  FilmGeometry
  FilmWalls::geometry() const
  {
    const unsigned int      n = x.size() - 1;
    const dealii::QGauss<1> gauss(5);
    const auto              centre = centres();
    FilmGeometry            result;
    result.volume.resize(n, 0.);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int q = 0; q < gauss.size(); ++q)
        {
          const double dx = x[i + 1] - x[i];
          result.volume[i] +=
            gauss.weight(q) * dx * gap(x[i] + gauss.point(q)[0] * dx);
        }
    for (unsigned int f = 0; f <= (periodic ? n - 1 : n); ++f)
      {
        double left = f > 0 ? centre[f - 1] : x[0];
        if (f == 0 && periodic)
          left = centre[n - 1] - (x[n] - x[0]);
        const double right = f < n ? centre[f] : x[n];
        result.faces.push_back({gap(x[f]),
                                0.5 * (lower_speed + upper_speed),
                                upper_speed - lower_speed,
                                right - left});
      }
    return result;
  }



  FilmForces
  film_forces(const ReynoldsFilm           &film,
              const FilmWalls              &walls,
              const std::vector<FilmState> &states)
  {
    const FilmGeometry geometry = walls.geometry();
    FilmLinearization  linearization;
    film.linearize(states, geometry, 1., linearization);
    FilmForces result;
    for (unsigned int i = 0; i < film.n_cells(); ++i)
      {
        const double p = states[i].pressure;
        result.load += p * (walls.x[i + 1] - walls.x[i]);
        result.wedge += p * (walls.gap(walls.x[i + 1]) - walls.gap(walls.x[i]));
        result.max_pressure = std::max(result.max_pressure, p);
      }
    for (unsigned int f = 0; f < film.n_faces(); ++f)
      {
        const FilmFluxes &fluxes = linearization.fluxes[f];
        const double      d      = geometry.faces[f].distance;
        result.lower_shear += fluxes.lower_shear.value;
        result.upper_shear -= fluxes.upper_shear.value;
        result.lower_stress.push_back(fluxes.lower_shear.value / d);
        result.upper_stress.push_back(-fluxes.upper_shear.value / d);
        result.flow.push_back(fluxes.flow.value);
      }
    return result;
  }
} // namespace asperity
