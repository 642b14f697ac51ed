#ifndef asperity_lubricant_film_flux_h
#define asperity_lubricant_film_flux_h

#include <asperity/constitutive/lubricant_parameters.h>

#include <array>

namespace asperity
{
  /** The oil in a cell of a film: either p = 0 or theta = 1. */
  struct FilmState
  {
    double pressure = 0.; ///< p, above ambient [Pa]
    double fraction = 1.; ///< theta, share of the gap that holds oil [-]
  };

  /** A face between two cells of a film, or at its end. */
  struct FilmFace
  {
    double gap = 0.; ///< h [m]

    /** Mean of both walls' horizontal velocities relative to the face, c =
     *  (u_1 + u_2)/2 - w [m/s]. */
    double couette_speed = 0.;

    /** Upper minus lower wall, s = u_2 - u_1 [m/s]. */
    double sliding_speed = 0.;

    /** Between the two points where the pressures are, d [m]. */
    double distance = 0.;
  };

  /** What a face's fluxes depend on, the order of their derivatives. */
  enum FilmVariable : unsigned int
  {
    left_pressure,
    right_pressure,
    left_fraction,
    right_fraction,
    face_gap,
    couette_speed,
    sliding_speed,
    face_distance,
    n_film_variables
  };

  struct FilmFaceValue
  {
    double                               value = 0.;
    std::array<double, n_film_variables> derivative{};
  };

  /** Fluxes at a face, per metre of thickness. */
  struct FilmFluxes
  {
    /** Volume of oil at ambient density that passes to the right [m^2/s]. */
    FilmFaceValue flow;

    /** Force of the oil on the lower wall in x by shear, over the length
     *  `distance` around the face [N/m]; on the upper wall with the opposite
     *  sign. */
    FilmFaceValue lower_shear, upper_shear;

    /** The viscosity law was left, see ViscosityValue::solid. */
    bool solid = false;
  };

  /**
   * The lubricant in a thin film: what flows and what shears at a face.
   *
   *   F = theta r c h - r h^3/(12 eta) dp/dx,     r = rho(p)/rho_0,
   *   T_1 = theta eta s d/h - (h/2) dp,  T_2 = theta eta s d/h + (h/2) dp
   *
   * with dp the difference of the two pressures, rho and eta at their mean, eta
   * at the mean shear rate |s|/h. The fraction that is carried along comes from
   * upstream, so that oil never leaves an empty cell; where the film is full
   * the flux is central, hence of second order. Streamers of oil shear in
   * proportion to the fraction they cover.
   */
  class FilmLubricant
  {
  public:
    /** @throws InputError as LubricantParameters::check() */
    explicit FilmLubricant(const LubricantParameters &parameters);

    FilmFluxes
    fluxes(const FilmState &left,
           const FilmState &right,
           const FilmFace  &face) const;

    /** rho/rho_0 and its derivative; linear for p < 0, which iterates only
     *  reach. */
    double
    density_ratio(const double pressure) const;

    double
    density_derivative(const double pressure) const;

    const LubricantViscosity &
    viscosity() const;

    bool
    is_incompressible() const;

  private:
    LubricantDensity   density;
    LubricantViscosity viscosity_;
  };
} // namespace asperity

#endif
