#ifndef asperity_learned_shapes_shape_study_h
#define asperity_learned_shapes_shape_study_h

#include <asperity/base/ranks.h>
#include <asperity/learned_shapes/base_shapes.h>
#include <asperity/learned_shapes/isosurface.h>
#include <asperity/learned_shapes/shape_parameters.h>

#include <array>
#include <optional>
#include <vector>

namespace asperity
{
  class ProgressLine;

  /** How a code's shape compares with the true one; all numbers, so that ranks
   *  can share them. */
  struct Reconstruction
  {
    double chamfer = 0., chamfer_squared = 0., largest = 0.;
    double measure = 0., true_measure = 0.; ///< area or volume
    double euler  = 0.;                     ///< of the body, 1 for a whole one
    double closed = 0.;                     ///< 1 if water-tight
    double empty  = 0.; ///< 1 if there is no surface; else nothing counts

    bool
    is_whole() const
    {
      return empty == 0. && closed == 1. && euler == 1.;
    }
  };

  /** A place on the way between the codes of two shapes. */
  struct InterpolatedShape
  {
    std::size_t        first = 0, second = 0; ///< recipes
    double             part = 0.;
    std::vector<float> code;
    Reconstruction     shape; ///< without a true one to compare with
  };

  /** A deformation that one shape has learned, applied to another one by its
   *  difference of codes: z_a' - z_a + z_b, compared with b'. */
  struct ShapeArithmetic
  {
    std::size_t    from = 0, deformed = 0, to = 0, expected = 0; ///< recipes
    Reconstruction shape;
  };

  /**
   * Learns a training set of shapes and judges what has been learned. All
   * members but recipes() and model() are collective.
   */
  template <int dim>
  class ShapeStudy
  {
  public:
    ShapeStudy(const ShapeParameters &parameters, const Ranks &ranks);

    /** Trained ones, then held-out ones. */
    const std::vector<ShapeRecipe> &
    recipes() const
    {
      return recipes_;
    }

    std::size_t
    n_trained() const
    {
      return n_trained_;
    }

    /** Operations of the training. */
    double
    flops() const;

    /** @param checkpoint as AutoDecoderTraining::run()
     *  @return loss of the last epoch */
    double
    train(const std::string &checkpoint, ProgressLine &progress);

    /** Finds the codes of held-out shapes, and compares all shapes. */
    std::vector<Reconstruction>
    reconstruct();

    /** Pairs of undeformed and deformed shapes, of different kinds, too. */
    std::vector<InterpolatedShape>
    interpolate() const;

    std::vector<ShapeArithmetic>
    calculate() const;

    const AutoDecoder &
    model() const
    {
      return *model_;
    }

    /** Of any recipe; of held-out ones after reconstruct(). */
    const std::vector<float> &
    code(const std::size_t recipe) const
    {
      return codes[recipe];
    }

    /** The surface of a code; nothing if it has none. */
    std::optional<BoundaryMesh<dim>>
    surface(const std::vector<float> &code) const;

  private:
    Reconstruction
    compare(const std::vector<float> &code, const ShapeRecipe *truth) const;

    FieldSample
    sample(const std::size_t recipe) const;

    std::size_t
    find(const BaseShape base, const ShapeDeformation &deformation) const;

    ShapeParameters                 parameters;
    Ranks                           ranks;
    std::vector<ShapeRecipe>        recipes_;
    std::size_t                     n_trained_;
    std::vector<std::vector<float>> codes;
    std::optional<AutoDecoder>      model_;
  };
} // namespace asperity

#endif
