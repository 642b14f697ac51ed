#include <asperity/base/errors.h>
#include <asperity/contact_zone/scene_parameters.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** Cubic interpolation misses a cosine by (2 pi/n)^4/384 of its amplitude,
     *  0.1 % with n = 8 spans a wave. */
    constexpr unsigned int spans_per_wave = 8;
  } // namespace



  void
  SurfaceParameters::declare(ParameterDeclarator &parameters,
                             const std::string   &section,
                             const std::string   &whose)
  {
    const auto in_section = parameters.subsection(section);
    parameters.choice(
      "Kind",
      kind,
      {{"flat", SurfaceKind::flat},
       {"harmonics", SurfaceKind::harmonics},
       {"measured", SurfaceKind::measured}},
      "Where the heights of the " + whose +
        " come from: `flat`; `harmonics`, the sum of a_k cos(2 pi k x/L + "
        "phi_k); `measured`, a profile (of a patch a window) of the height map "
        "named in the subsection Topography.");
    parameters.list("Wave numbers",
                    wave_numbers,
                    "1",
                    Range::between(1., 2000.),
                    "Harmonics: the numbers k of waves in a period.");
    parameters.list("Wave numbers across",
                    across,
                    "1",
                    Range::between(-2000., 2000.),
                    "Harmonics of a patch (Geometry/Dimension = 3): the "
                    "numbers j of waves along y, one for each wave number; the "
                    "surface is the sum of a_k cos(2 pi (k x/L + j y/W) + "
                    "phi_k). Empty: all 0, ridges along y.");
    parameters.list("Amplitudes",
                    amplitudes,
                    "um",
                    Range::between(-1e-3, 1e-3),
                    "Harmonics: a_k, one for each wave number.");
    parameters.list("Phases",
                    phases,
                    "rad",
                    Range::between(-1000., 1000.),
                    "Harmonics: phi_k, one for each wave number.");
    parameters.integer("Spline degree",
                       degree,
                       Range::between(3, 5),
                       "Degree of the periodic spline; at least 3, so that the "
                       "curvature of the surface is continuous.");
    parameters.integer("Spline spans",
                       spans,
                       Range::between(8, 20000),
                       "Spans of the periodic spline over a period. "
                       "`automatic`: 40 for each period of the shortest "
                       "harmonic, one for each 2 points of a measured profile. "
                       "Along y a patch always has 40 for each wave.");
    parameters.choice("Spline fit",
                      fit,
                      {{"least squares", SurfaceFit::least_squares},
                       {"interpolation", SurfaceFit::interpolation}},
                      "How the spline of a measured profile follows its "
                      "points: by `least squares` on fewer spans, or through "
                      "each of them (`interpolation`), noise included.");
    const auto in_topography = parameters.subsection("Topography");
    topography.declare(parameters);
  }



  void
  SurfaceParameters::check(const ParameterDeclarator &parameters,
                           const std::string         &section) const
  {
    if (kind == SurfaceKind::measured)
      check_fit(parameters, section);
    if (kind != SurfaceKind::harmonics)
      return;
    if (wave_numbers.empty())
      throw InputError(parameters.where(section + "/Wave numbers") +
                       ": the list is empty; harmonics need at least one wave "
                       "number.");
    const auto same_length = [&](const std::vector<double> &list,
                                 const std::string         &key) {
      if (list.size() != wave_numbers.size())
        throw InputError(parameters.where(section + "/" + key) + ": found " +
                         std::to_string(list.size()) + " values; expected " +
                         std::to_string(wave_numbers.size()) +
                         ", one for each wave number.");
    };
    same_length(amplitudes, "Amplitudes");
    same_length(phases, "Phases");
    for (const double k : wave_numbers)
      if (k != std::floor(k))
        throw InputError(parameters.where(section + "/Wave numbers") +
                         ": found " + format_number(k) +
                         "; expected whole numbers, so that the surface is "
                         "periodic.");
    if (n_spans_of_harmonics() < spans_per_wave * highest_wave_number())
      throw InputError(parameters.where(section + "/Spline spans") +
                       ": found " + std::to_string(n_spans_of_harmonics()) +
                       " for up to " + std::to_string(highest_wave_number()) +
                       " waves in a period; expected at least " +
                       std::to_string(spans_per_wave * highest_wave_number()) +
                       ", so that the spline follows them.");
  }



  void
  SurfaceParameters::check_fit(const ParameterDeclarator &parameters,
                               const std::string         &section) const
  {
    if (fit != SurfaceFit::interpolation)
      return;
    if (spans)
      throw InputError(parameters.where(section + "/Spline spans") +
                       ": found " + std::to_string(*spans) +
                       " with the Spline fit interpolation, which has one for "
                       "each point; expected automatic.");
    if (degree % 2 == 0)
      throw InputError(parameters.where(section + "/Spline degree") +
                       ": found " + std::to_string(degree) +
                       " with the Spline fit interpolation; expected an odd "
                       "degree, for which the points determine the spline.");
  }



  unsigned int
  SurfaceParameters::n_spans_of_harmonics() const
  {
    return spans.value_or(40 * highest_wave_number());
  }



  unsigned int
  SurfaceParameters::highest_wave_number() const
  {
    return static_cast<unsigned int>(
      *std::max_element(wave_numbers.begin(), wave_numbers.end()));
  }
} // namespace asperity
