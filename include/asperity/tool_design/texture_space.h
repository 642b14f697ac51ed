#ifndef asperity_tool_design_texture_space_h
#define asperity_tool_design_texture_space_h

#include <asperity/learning/auto_decoder.h>
#include <asperity/learning/orthogonal_decomposition.h>
#include <asperity/optimization/evaluation_record.h>
#include <asperity/splines/knot_vector.h>
#include <asperity/tool_design/texture.h>

#include <memory>
#include <string>
#include <vector>

namespace asperity
{
  /** Textures that a few variables describe, for a search. */
  class TextureSpace
  {
  public:
    virtual ~TextureSpace() = default;

    /** The variables, and in which box they are searched. */
    virtual SearchBox
    box() const = 0;

    /** Heights as of a ToolTexture. */
    virtual std::vector<double>
    heights(const std::vector<double> &variables) const = 0;

    /** All that the heights depend on besides the variables, for people. */
    virtual std::string
    description() const = 0;
  };

  /**
   * What a network sees of a place x in a period of 1: cos(2 pi m x) and
   * sin(2 pi m x) with m = 1, 2, 4, ... up to half the number of waves (Tancik
   * et al. 2020), so that its textures are periodic.
   * @return for each of n places one after the other
   */
  std::vector<double>
  texture_positions(const std::size_t n, const unsigned int n_waves);

  /** Length of a position. */
  unsigned int
  n_texture_coordinates(const unsigned int n_waves);

  /** Latent codes of a network that has learnt h = f(z, x). A network of the
   *  height and not of the signed distance, since a profile has one height at
   *  each place, whatever the network says. */
  class LatentTextures : public TextureSpace
  {
  public:
    /** The box is that of the codes of the training. */
    LatentTextures(const AutoDecoder &network,
                   const std::size_t  n_places,
                   const unsigned int n_waves);

    SearchBox
    box() const override;

    std::vector<double>
    heights(const std::vector<double> &code) const override;

    std::string
    description() const override;

  private:
    AutoDecoder         network;
    std::vector<double> positions;
  };

  /** Coefficients of the modes of a proper orthogonal decomposition: the linear
   *  yardstick. */
  class ModalTextures : public TextureSpace
  {
  public:
    /** @param textures at least n + 1; the box is that of their coefficients */
    ModalTextures(const std::vector<ToolTexture> &textures,
                  const unsigned int              n);

    SearchBox
    box() const override;

    std::vector<double>
    heights(const std::vector<double> &coefficients) const override;

    std::string
    description() const override;

    const OrthogonalDecomposition &
    modes() const
    {
      return modes_;
    }

  private:
    OrthogonalDecomposition modes_;
    unsigned int            n;
    SearchBox               box_;
  };

  /**
   * Free-form deformation (Sederberg and Parry 1986) of a base profile: two
   * rows of n control points around it, periodic along x, which move up and
   * down,
   *
   *   h -> h + sum over j of N_j(x) ((1 - s) b_j + s t_j),
   *
   * with the periodic cubic B-splines N_j, the place s of h between the lowest
   * (0) and the highest point (1) of the base profile, and the moves b_j and
   * t_j of lower and upper control points as variables.
   */
  class FreeFormTextures : public TextureSpace
  {
  public:
    /** @param base heights as of a ToolTexture @param n_columns at least 4
     *  @param largest_move in multiples of the root mean square height */
    FreeFormTextures(const std::vector<double> &base,
                     const unsigned int         n_columns,
                     const double               largest_move);

    SearchBox
    box() const override;

    std::vector<double>
    heights(const std::vector<double> &moves) const override;

    std::string
    description() const override;

  private:
    std::vector<double> base;
    KnotVector          columns;
    double              largest_move;
  };
} // namespace asperity

#endif
