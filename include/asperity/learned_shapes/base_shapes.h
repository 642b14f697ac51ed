#ifndef asperity_learned_shapes_base_shapes_h
#define asperity_learned_shapes_base_shapes_h

#include <asperity/learned_shapes/boundary_mesh.h>
#include <asperity/learned_shapes/free_form_deformation.h>

#include <cstdint>
#include <string>
#include <vector>

namespace asperity
{
  /** What training sets of shapes begin with (paper of section 3.1 of Lee 2025,
   *  figure 5); in space prisms on it. */
  enum class BaseShape
  {
    triangle,
    square,
    hexagon,
    disc
  };

  std::string
  name_of(const BaseShape shape);

  /** A base shape and what is done to it. */
  struct ShapeRecipe
  {
    BaseShape        base = BaseShape::square;
    ShapeDeformation deformation;
    std::string      name;
  };

  /**
   * The deformed shape, put in the middle of its bounding box and scaled so
   * that it fits into the unit sphere with 3 % to spare (as the program of Park
   * et al. 2019 does); undeformed and as it is, the corners of the section lie
   * on the unit circle, and a prism reaches from -1 to 1.
   * @param n_pieces into which the section's outline is cut, at least 3; its
   *   edges remain edges
   * @param normalised whether it is moved and scaled
   */
  template <int dim>
  BoundaryMesh<dim>
  make_shape(const ShapeRecipe &recipe,
             const unsigned int n_pieces,
             const bool         normalised = true);

  /**
   * Recipes of a training set: of each base shape itself, every deformation
   * alone with `n_magnitudes` positive and as many negative magnitudes, and
   * random combinations until there are `n_per_base`.
   * @param amplitude of all deformations, the share by which something widens
   */
  std::vector<ShapeRecipe>
  shape_recipes(const unsigned int  n_per_base,
                const unsigned int  n_magnitudes,
                const double        amplitude,
                const std::uint64_t seed);
} // namespace asperity

#endif
