#ifndef asperity_tool_design_texture_family_h
#define asperity_tool_design_texture_family_h

#include <asperity/tool_design/texture.h>

#include <cstdint>
#include <vector>

namespace asperity
{
  struct SceneParameters;
  struct SurfaceParameters;

  /** Textures of which a network learns what tools look like. */
  struct TextureFamily
  {
    unsigned int n_per_kind = 60; ///< grooves, dimples, ridges, waves each
    unsigned int n_measured = 120;
    unsigned int n_held_out = 10; ///< of each kind, besides

    unsigned int most_repeats  = 4;   ///< grooves, dimples, ... of a period
    unsigned int n_places      = 256; ///< of a period
    double       shortest_wave = 0.;  ///< nesting index over the period

    std::uint64_t seed = 1;

    /** Waves that remain: shorter ones pass the filter by less than 1/500. */
    unsigned int
    n_waves() const;
  };

  /** A groove, dimple, ridge or wave that repeats over the period. */
  struct AnalyticTexture
  {
    enum class Kind
    {
      grooves, ///< a flat floor and two flanks in a plateau
      dimples, ///< parabolas in a plateau
      ridges,  ///< grooves upside down
      waves    ///< cosines
    };

    Kind         kind      = Kind::grooves;
    unsigned int n_repeats = 1;

    /** Share of the repeat that is no plateau; of waves nothing. */
    double width = 0.5;

    /** Flank of a groove over its width, at most 1/2. */
    double flank = 0.25;

    /** In (-1, 1): the first flank is 1 + skew, the other 1 - skew times as
     *  long; the lowest point of a dimple and the crest of a wave move
     * alike. */
    double skew = 0.;

    /** @param x in a period of 1 */
    double
    height(const double x) const;
  };

  /** As in tables: "grooves". */
  std::string
  name_of(const AnalyticTexture::Kind kind);

  /** Heights of a function that is filtered as a measured profile. */
  ToolTexture
  make_texture(const AnalyticTexture &texture, const TextureFamily &family);

  /** Nesting index of the filter that a tool has gone through [m]: its S-filter
   *  or, of harmonics, their shortest wave.
   *  @param period of the tool [m]
   *  @throws InputError if a measured tool has not been filtered */
  double
  filter_of(const SurfaceParameters &tool, const double period);

  /** The tool of a scene: its heights out of the tool [m] at n places.
   *  @throws InputError if it cannot be made, is flat, or a patch */
  std::vector<double>
  tool_heights(const SceneParameters &scene, const std::size_t n);

  /**
   * Random grooves, dimples, ridges and waves, and, if the tool of the scene is
   * measured, pieces of its map as long as its profile, which are spread over
   * the map and made periodic as that.
   * @return those to learn, kind after kind, and those that are held out
   * @throws InputError if the map cannot be used
   */
  std::pair<std::vector<ToolTexture>, std::vector<ToolTexture>>
  make_textures(const TextureFamily &family, const SceneParameters &scene);
} // namespace asperity

#endif
