#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/random_numbers.h>
#include <asperity/base/text.h>
#include <asperity/contact_zone/scene_parameters.h>
#include <asperity/contact_zone/surface.h>
#include <asperity/tool_design/texture_family.h>
#include <asperity/topography/make_profile.h>
#include <asperity/topography/periodic_continuation.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace asperity
{
  namespace
  {
    constexpr AnalyticTexture::Kind all_kinds[] = {
      AnalyticTexture::Kind::grooves,
      AnalyticTexture::Kind::dimples,
      AnalyticTexture::Kind::ridges,
      AnalyticTexture::Kind::waves};
  }



  unsigned int
  TextureFamily::n_waves() const
  {
    return std::max(1u, static_cast<unsigned int>(3. / shortest_wave));
  }



  std::string
  name_of(const AnalyticTexture::Kind kind)
  {
    switch (kind)
      {
        case AnalyticTexture::Kind::grooves:
          return "grooves";
        case AnalyticTexture::Kind::dimples:
          return "dimples";
        case AnalyticTexture::Kind::ridges:
          return "ridges";
        default:
          return "waves";
      }
  }



  double
  AnalyticTexture::height(const double x) const
  {
    const double s = n_repeats * x - std::floor(n_repeats * x); // of a repeat
    if (kind == Kind::waves)
      {
        const double angle = 2. * M_PI * s;
        return std::cos(angle + skew * std::sin(angle));
      }
    const double t = (s - 0.5) / width + 0.5; // of the valley, in [0, 1]
    if (t <= 0. || t >= 1.)
      return kind == Kind::ridges ? 0. : 1.;
    if (kind == Kind::dimples)
      {
        const double lowest = 0.5 * (1. + skew);
        const double r =
          t < lowest ? 1. - t / lowest : (t - lowest) / (1. - lowest);
        return r * r;
      }
    const double depth = std::min(
      {1., t / (flank * (1. + skew)), (1. - t) / (flank * (1. - skew))});
    return kind == Kind::ridges ? depth : 1. - depth;
  }



  ToolTexture
  make_texture(const AnalyticTexture &texture, const TextureFamily &family)
  {
    const std::size_t   n_fine = 16 * family.n_places;
    std::vector<double> fine(n_fine);
    for (std::size_t i = 0; i < n_fine; ++i)
      fine[i] = texture.height(static_cast<double>(i) / n_fine);
    Harmonics waves = harmonics_of(fine, family.n_waves());
    for (std::size_t k = 0; k < waves.amplitudes.size(); ++k)
      waves.amplitudes[k] *=
        gaussian_transmission(1. / ((k + 1.) * family.shortest_wave));
    return {name_of(texture.kind), normalized(waves.heights(family.n_places))};
  }



  double
  filter_of(const SurfaceParameters &tool, const double period)
  {
    if (tool.kind == SurfaceKind::harmonics)
      return period / tool.highest_wave_number();
    if (tool.topography.s_filter > 0.)
      return tool.topography.s_filter;
    throw InputError(
      "The tool of the base scene has no S-filter; expected one, "
      "or Textures/S-filter nesting index.");
  }



  std::vector<double>
  tool_heights(const SceneParameters &scene, const std::size_t n)
  {
    if (scene.geometry.dimension != 2)
      throw InputError("The base scene is a patch (Geometry/Dimension = 3); "
                       "expected a profile (2).");
    if (scene.tool.kind == SurfaceKind::flat)
      throw InputError("The base scene has a flat tool (Tool/Kind = flat); "
                       "expected harmonics or a measured one.");
    const Surface surface = make_surface(scene.tool, scene.geometry.length);
    // Measured heights point out of the tool, those of harmonics upwards, and
    // the tool is above.
    const double sign = scene.tool.kind == SurfaceKind::measured ? 1. : -1.;
    std::vector<double> heights(n);
    for (std::size_t i = 0; i < n; ++i)
      heights[i] = sign * surface.height(surface.period * i / n);
    return heights;
  }



  namespace
  {
    AnalyticTexture
    random_texture(const AnalyticTexture::Kind kind,
                   const TextureFamily        &family,
                   RandomNumbers              &random)
    {
      AnalyticTexture texture;
      texture.kind      = kind;
      texture.n_repeats = 1 + random.below(family.most_repeats);
      texture.width     = 0.15 + 0.7 * random.uniform();
      texture.flank     = 0.1 + 0.3 * random.uniform();
      texture.skew      = 0.7 * (2. * random.uniform() - 1.);
      return texture;
    }



    /** Pieces of a map along the direction of its profile, from anywhere. */
    class MeasuredPieces
    {
    public:
      MeasuredPieces(const TopographyParameters &parameters,
                     const TextureFamily        &family)
        : parameters(parameters)
        , family(family)
      {
        TopographyReport report;
        map = treat_map(parameters, report);
        length =
          parameters.length > 0. ?
            parameters.length :
            make_profile(parameters, report).length() / parameters.scale_x;
      }

      /** @throws InputError if a piece as long as this hardly fits */
      ToolTexture
      draw(RandomNumbers &random) const
      {
        constexpr unsigned int most_trials = 1000;
        for (unsigned int trial = 0; trial < most_trials; ++trial)
          {
            const double x    = random.uniform() * map.length_x(),
                         y    = random.uniform() * map.length_y(),
                         to_x = x + length * std::cos(parameters.direction),
                         to_y = y + length * std::sin(parameters.direction);
            if (to_x < 0. || to_x > map.length_x() - map.dx || to_y < 0. ||
                to_y > map.length_y() - map.dy)
              continue;
            const Profile piece =
              extract_profile(map, {parameters.direction, x, y, 0., length});
            if (std::none_of(piece.heights.begin(),
                             piece.heights.end(),
                             [](const double z) { return std::isnan(z); }))
              return finish(piece);
          }
        throw InputError("No piece of " + format_quantity(length, "um", 4) +
                         " without missing points was found in " +
                         quoted_name(parameters.file) +
                         "; take a shorter Profile length.");
      }

    private:
      ToolTexture
      finish(Profile piece) const
      {
        piece.heights.resize(
          std::min<std::size_t>(piece.heights.size(),
                                std::lround(length / piece.spacing)));
        ContinuationReport report;
        const Profile      profile = make_periodic(piece,
                                              parameters.continuation,
                                              parameters.spline,
                                              report);
        const unsigned int n_waves =
          std::min<unsigned int>(family.n_waves(),
                                 (profile.heights.size() - 1) / 2);
        return {"measured",
                normalized(harmonics_of(profile.heights, n_waves)
                             .heights(family.n_places))};
      }

      TopographyParameters parameters;
      TextureFamily        family;
      HeightMap            map;
      double               length = 0.; ///< before scaling [m]
    };
  } // namespace



  std::pair<std::vector<ToolTexture>, std::vector<ToolTexture>>
  make_textures(const TextureFamily &family, const SceneParameters &scene)
  {
    std::pair<std::vector<ToolTexture>, std::vector<ToolTexture>> result;
    RandomNumbers random(family.seed);
    const auto    add = [&](const unsigned int                  n,
                         const std::function<ToolTexture()> &draw) {
      for (unsigned int i = 0; i < n; ++i)
        result.first.push_back(draw());
      for (unsigned int i = 0; i < (n > 0 ? family.n_held_out : 0); ++i)
        result.second.push_back(draw());
    };
    for (const AnalyticTexture::Kind kind : all_kinds)
      add(family.n_per_kind, [&]() {
        return make_texture(random_texture(kind, family, random), family);
      });
    if (scene.tool.kind == SurfaceKind::measured && family.n_measured > 0)
      {
        const MeasuredPieces pieces(scene.tool.topography, family);
        add(family.n_measured, [&]() { return pieces.draw(random); });
      }
    return result;
  }
} // namespace asperity
