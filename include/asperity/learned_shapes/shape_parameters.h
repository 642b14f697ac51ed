#ifndef asperity_learned_shapes_shape_parameters_h
#define asperity_learned_shapes_shape_parameters_h

#include <asperity/learned_shapes/distance_samples.h>
#include <asperity/learning/t_sne.h>
#include <asperity/learning/training.h>

#include <string>

namespace asperity
{
  class ParameterDeclarator;

  /** A parameter file of `asperity shapes`: which shapes are learned, by which
   *  network, and how that is judged. */
  struct ShapeParameters
  {
    ShapeParameters();

    unsigned int dimension      = 2;
    unsigned int n_per_base     = 40;
    unsigned int n_magnitudes   = 2;
    unsigned int n_held_out     = 5; ///< of each base shape, not trained with
    double       amplitude      = 0.4;
    unsigned int n_pieces       = 96; ///< of an outline
    unsigned int n_interpolated = 4;  ///< pairs of shapes

    DistanceSampling sampling;
    DecoderShape     network;
    TrainingOptions  training;
    EmbeddingOptions embedding;

    unsigned int n_cells   = 96; ///< of an isosurface along an edge of its cube
    std::string  directory = "shapes";

    /** Declares all entries, in the subsections "Shapes", "Network", "Training"
     *  and "Output". */
    void
    declare(ParameterDeclarator &parameters);

    /** @throws InputError if entries contradict each other */
    void
    check(const ParameterDeclarator &parameters);

  private:
    void
    declare_shapes(ParameterDeclarator &parameters);

    void
    declare_network(ParameterDeclarator &parameters);

    void
    declare_training(ParameterDeclarator &parameters);

    unsigned int seed = 1;
  };
} // namespace asperity

#endif
