#ifndef asperity_lubricant_film_walls_h
#define asperity_lubricant_film_walls_h

#include <asperity/lubricant/reynolds_film.h>

#include <functional>

namespace asperity
{
  /** Two rigid walls with a film between them, at one instant, on cells that
   *  stand still. */
  struct FilmWalls
  {
    std::vector<double>           x;   ///< faces of the cells, increasing [m]
    std::function<double(double)> gap; ///< h(x) > 0 [m]

    double lower_speed = 0., upper_speed = 0.; ///< u_1, u_2 [m/s]

    /** Whether the last face is the first of the next period. */
    bool periodic = false;

    FilmGeometry
    geometry() const;

    /** Middles of the cells [m]. */
    std::vector<double>
    centres() const;
  };

  /** What a film does to its walls, per metre of thickness. */
  struct FilmForces
  {
    double load         = 0.; ///< int p dx, pushes the walls apart [N/m]
    double max_pressure = 0.; ///< of the cells [Pa]

    /** Of the oil on the walls by shear, in x [N/m]. */
    double lower_shear = 0., upper_shear = 0.;

    /** int p (dh/dx) dx: pressure pushes a sloping upper wall over a flat lower
     *  one by minus this in x [N/m]. */
    double wedge = 0.;

    /** Shear stress of each wall at each face [Pa]. */
    std::vector<double> lower_stress, upper_stress;

    /** Flow of oil at ambient density through each face [m^2/s]. */
    std::vector<double> flow;
  };

  /** @param states as ReynoldsFilm::solve() gives them */
  FilmForces
  film_forces(const ReynoldsFilm           &film,
              const FilmWalls              &walls,
              const std::vector<FilmState> &states);
} // namespace asperity

#endif
