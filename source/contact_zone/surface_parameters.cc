#include <asperity/base/errors.h>
#include <asperity/contact_zone/scene_parameters.h>

#include <cmath>

namespace asperity
{
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
        "phi_k); `measured`, a profile of the height map named in the "
        "subsection Topography.");
    parameters.list("Wave numbers",
                    wave_numbers,
                    "1",
                    Range::at_least(1.),
                    "Harmonics: the numbers k of waves in a period.");
    parameters.list("Amplitudes",
                    amplitudes,
                    "um",
                    Range::any(),
                    "Harmonics: a_k, one for each wave number.");
    parameters.list("Phases",
                    phases,
                    "rad",
                    Range::any(),
                    "Harmonics: phi_k, one for each wave number.");
    parameters.integer("Spline degree",
                       degree,
                       Range::between(3, 5),
                       "Degree of the periodic spline; at least 3, so that the "
                       "curvature of the surface is continuous.");
    parameters.integer(
      "Spline spans",
      spans,
      Range::between(8, 20000),
      "Spans of the periodic spline over a period. "
      "`automatic`: 40 for each period of the shortest "
      "harmonic, one for each 2 points of a measured profile.");
    const auto in_topography = parameters.subsection("Topography");
    topography.declare(parameters);
  }



  void
  SurfaceParameters::check(const ParameterDeclarator &parameters,
                           const std::string         &section) const
  {
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
  }
} // namespace asperity
