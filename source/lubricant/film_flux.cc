#include <asperity/lubricant/film_flux.h>

#include <cmath>

namespace asperity
{
  namespace
  {
    using Gradient = std::array<double, n_film_variables>;

    /** Derivatives of the viscosity by the film variables. */
    Gradient
    viscosity_gradient(const ViscosityValue &eta,
                       const FilmFace       &face,
                       const double          rate)
    {
      Gradient result{};
      result[left_pressure] = result[right_pressure] = 0.5 * eta.d_pressure;
      result[sliding_speed] =
        (face.sliding_speed < 0. ? -1. : 1.) * eta.d_rate / face.gap;
      result[face_gap] = -eta.d_rate * rate / face.gap;
      return result;
    }
  } // namespace



  FilmLubricant::FilmLubricant(const LubricantParameters &parameters)
    : density(parameters.compressibility)
    , viscosity_(parameters.viscosity)
  {
    parameters.check();
  }



  double
  FilmLubricant::density_ratio(const double pressure) const
  {
    return pressure < 0. ?
             density.ratio(0.) + density.derivative(0.) * pressure :
             density.ratio(pressure);
  }



  double
  FilmLubricant::density_derivative(const double pressure) const
  {
    return density.derivative(pressure < 0. ? 0. : pressure);
  }



  const LubricantViscosity &
  FilmLubricant::viscosity() const
  {
    return viscosity_;
  }



  bool
  FilmLubricant::is_incompressible() const
  {
    return density.law == DensityLaw::incompressible;
  }



  FilmFluxes
  FilmLubricant::fluxes(const FilmState &left,
                        const FilmState &right,
                        const FilmFace  &face) const
  {
    const auto [h, c, s, d] = face;
    const double p          = 0.5 * (left.pressure + right.pressure);
    const double dp         = right.pressure - left.pressure;
    const double rate       = std::fabs(s) / h;

    const ViscosityValue law   = viscosity_.evaluate(rate, p);
    const double         eta   = law.value;
    const Gradient       d_eta = viscosity_gradient(law, face, rate);

    FilmFluxes result;
    result.solid = law.solid;

    // flow = r (couette - k dp)
    const FilmVariable upstream = c >= 0. ? left_fraction : right_fraction;
    const double       theta    = c >= 0. ? left.fraction : right.fraction;
    const double       couette  = theta * c * h;
    const double       k        = h * h * h / (12. * eta * d);
    const double       r        = density_ratio(p);
    const double       dr       = density_derivative(p);
    Gradient          &d_flow   = result.flow.derivative;
    result.flow.value           = r * (couette - k * dp);
    for (unsigned int i = 0; i < n_film_variables; ++i)
      d_flow[i] = r * k * dp * d_eta[i] / eta;
    d_flow[left_pressure] += 0.5 * dr * (couette - k * dp) + r * k;
    d_flow[right_pressure] += 0.5 * dr * (couette - k * dp) - r * k;
    d_flow[upstream] += r * c * h;
    d_flow[face_gap] += r * (theta * c - 3. * k * dp / h);
    d_flow[couette_speed] += r * theta * h;
    d_flow[face_distance] += r * k * dp / d;

    // shear = drag -+ h dp/2, drag = theta_mean eta s d/h
    const double theta_mean = 0.5 * (left.fraction + right.fraction);
    const double drag       = theta_mean * eta * s * d / h;
    Gradient     d_drag;
    for (unsigned int i = 0; i < n_film_variables; ++i)
      d_drag[i] = drag * d_eta[i] / eta;
    d_drag[left_fraction] += 0.5 * eta * s * d / h;
    d_drag[right_fraction] += 0.5 * eta * s * d / h;
    d_drag[face_gap] -= drag / h;
    d_drag[sliding_speed] += theta_mean * eta * d / h;
    d_drag[face_distance] += theta_mean * eta * s / h;
    const auto wall = [&](const double sign) {
      FilmFaceValue shear{drag + sign * 0.5 * h * dp, d_drag};
      shear.derivative[left_pressure] -= sign * 0.5 * h;
      shear.derivative[right_pressure] += sign * 0.5 * h;
      shear.derivative[face_gap] += sign * 0.5 * dp;
      return shear;
    };
    result.lower_shear = wall(-1.);
    result.upper_shear = wall(1.);
    return result;
  }
} // namespace asperity
