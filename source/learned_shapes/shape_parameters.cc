#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/learned_shapes/shape_parameters.h>
#include <asperity/learning/decoder_parameters.h>

namespace asperity
{
  ShapeParameters::ShapeParameters()
  {
    // Small networks that are trained for minutes want other settings than
    // those of Park et al. (2019): with small steps, large batches and codes
    // that begin far apart the distance that remains is four times as large
    // after as many operations.
    training.n_epochs            = 1200;
    training.points_per_sample   = 100;
    training.weights             = {5e-3, 0.5, 200};
    training.codes               = {5e-3, 0.5, 200};
    training.initial_code_length = 0.05;
    network.width                = 64;
  }



  void
  ShapeParameters::declare_shapes(ParameterDeclarator &parameters)
  {
    const auto section = parameters.subsection("Shapes");
    parameters.integer("Dimension",
                       dimension,
                       Range::between(2, 3),
                       "2 for shapes in the plane, 3 for prisms in space.");
    parameters.integer("Shapes of each kind",
                       n_per_base,
                       Range::between(1, 10000),
                       "Triangles, squares, hexagons and discs each: the shape "
                       "itself, each deformation alone, and random "
                       "combinations of them.");
    parameters.integer("Magnitudes",
                       n_magnitudes,
                       Range::between(1, 100),
                       "With how many magnitudes of either sign a deformation "
                       "is applied alone.");
    parameters.integer("Held out of each kind",
                       n_held_out,
                       Range::between(0, 1000),
                       "Further shapes that are not trained with, by which "
                       "the network is judged.");
    parameters.number("Amplitude",
                      amplitude,
                      Range::between(0.01, 0.6),
                      "Largest magnitude of the deformations: the share by "
                      "which a shape widens, half of the box that its top "
                      "moves by, and the angle in radians that it turns.");
    parameters.integer("Outline pieces",
                       n_pieces,
                       Range::between(12, 10000),
                       "Into how many pieces the outline of a section is cut "
                       "before it is deformed.");
    parameters.integer("Points",
                       sampling.n_points,
                       Range::between(10, 1000000),
                       "At how many points the distances of a shape are "
                       "taken.");
    parameters.number("Share near the surface",
                      sampling.share_near,
                      Range::between(0., 1.),
                      "Share of these points that lie near the surface.");
    parameters.integer("Seed",
                       seed,
                       Range::between(0, 1000000000),
                       "Of all random numbers of shapes and training.");
  }



  void
  ShapeParameters::declare_network(ParameterDeclarator &parameters)
  {
    const auto section = parameters.subsection("Network");
    declare_size(parameters, network, "a shape");
    parameters.integer("Fed again at",
                       network.skip_layer,
                       Range::between(0, 64),
                       "Hidden layer, from 0, that is given code and position "
                       "again; 0 for none.");
    parameters.choice("Activation",
                      network.activation,
                      {{"ReLU", Activation::relu},
                       {"tanh", Activation::tanh},
                       {"softplus", Activation::softplus},
                       {"sine", Activation::sine}},
                      "What neurons make of the sum of their inputs: "
                      "max(x, 0), tanh x, log(1 + exp x) or sin x.");
  }



  void
  ShapeParameters::declare_training(ParameterDeclarator &parameters)
  {
    const auto section = parameters.subsection("Training");
    parameters.integer("Epochs",
                       training.n_epochs,
                       Range::between(1, 1000000),
                       "Passes over all shapes.");
    parameters.integer("Shapes of a batch",
                       training.samples_per_batch,
                       Range::between(1, 10000),
                       "Shapes between two steps of the weights.");
    parameters.integer("Points of a batch",
                       training.points_per_sample,
                       Range::between(1, 1000000),
                       "Points of each of them, drawn anew.");
    parameters.number("Rate of weights",
                      training.weights.initial,
                      Range::positive(),
                      "First learning rate of the weights.");
    parameters.number("Rate of codes",
                      training.codes.initial,
                      Range::positive(),
                      "First learning rate of the codes.");
    parameters.integer("Epochs of a rate",
                       training.weights.interval,
                       Range::between(1, 1000000),
                       "After how many epochs both rates are halved.");
    parameters.number("Clamp",
                      training.loss.clamp,
                      Range::positive(),
                      "Distance beyond which it does not matter, the radius "
                      "of shapes being 1.");
    parameters.number("Code regularisation",
                      training.code_regularization,
                      Range::non_negative(),
                      "Factor of the mean length of codes in the loss.");
    parameters.number("Initial code length",
                      training.initial_code_length,
                      Range::positive(),
                      "About how long the random codes are that training "
                      "begins with.");
    parameters.integer("Parts of a batch",
                       training.n_parts,
                       Range::between(1, 1024),
                       "As many ranks can share the work. The last bits of "
                       "the weights depend on this number, but not on that of "
                       "the ranks.");
  }



  void
  ShapeParameters::declare(ParameterDeclarator &parameters)
  {
    declare_shapes(parameters);
    declare_network(parameters);
    declare_training(parameters);
    const auto section = parameters.subsection("Output");
    parameters.text("Output directory",
                    directory,
                    "Folder of model, tables and pictures.");
    parameters.integer("Cells",
                       n_cells,
                       Range::between(4, 1024),
                       "Cells along an edge of the cube in which surfaces are "
                       "found.");
    parameters.integer("Interpolated pairs",
                       n_interpolated,
                       Range::between(0, 1000),
                       "Pairs of shapes between whose codes it is "
                       "interpolated.");
    parameters.number("Perplexity",
                      embedding.perplexity,
                      Range::between(1., 1000.),
                      "Neighbours of a code in its picture (t-SNE).");
  }



  void
  ShapeParameters::check(const ParameterDeclarator &parameters)
  {
    if (network.skip_layer > network.n_layers)
      throw InputError(parameters.where("Network/Fed again at") + ": found " +
                       std::to_string(network.skip_layer) +
                       "; expected at most the number of layers, " +
                       std::to_string(network.n_layers) + ".");
    if (embedding.perplexity * 3. >= 4. * n_per_base)
      throw InputError(parameters.where("Output/Perplexity") +
                       ": expected less than a third of the number of "
                       "shapes, " +
                       std::to_string(4 * n_per_base) + ".");
    network.n_position      = dimension;
    training.codes.interval = training.weights.interval;
    training.seed           = seed;
    embedding.seed          = seed;
  }
} // namespace asperity
