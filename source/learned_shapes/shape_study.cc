#include <asperity/base/errors.h>
#include <asperity/base/progress.h>
#include <asperity/base/random_numbers.h>
#include <asperity/learned_shapes/chamfer_distance.h>
#include <asperity/learned_shapes/shape_study.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    constexpr double half_box = 1.1;

    bool
    are_equal(const ShapeDeformation &a, const ShapeDeformation &b)
    {
      return a.shrink_x == b.shrink_x &&
             a.translate_top_x == b.translate_top_x &&
             a.translate_top_y == b.translate_top_y &&
             a.expand_middle == b.expand_middle &&
             a.expand_top == b.expand_top && a.rotate_top == b.rotate_top;
    }
  } // namespace



  template <int dim>
  ShapeStudy<dim>::ShapeStudy(const ShapeParameters &parameters,
                              const Ranks           &ranks)
    : parameters(parameters)
    , ranks(ranks)
    , recipes_(shape_recipes(parameters.n_per_base,
                             parameters.n_magnitudes,
                             parameters.amplitude,
                             parameters.training.seed))
    , n_trained_(recipes_.size())
  {
    // Random combinations follow all shapes with a single deformation.
    const unsigned int n_single = 1 + 12 * parameters.n_magnitudes;
    const unsigned int n        = n_single + parameters.n_held_out;
    const auto         others   = shape_recipes(n,
                                      parameters.n_magnitudes,
                                      parameters.amplitude,
                                      parameters.training.seed + 1);
    for (std::size_t i = 0; i < others.size(); ++i)
      if (i % n >= n_single)
        recipes_.push_back(others[i]);
    codes.resize(recipes_.size());
  }



  template <int dim>
  FieldSample
  ShapeStudy<dim>::sample(const std::size_t recipe) const
  {
    RandomNumbers random(parameters.training.seed + 1000003 * (recipe + 1));
    return sample_distances(make_shape<dim>(recipes_[recipe],
                                            parameters.n_pieces),
                            recipes_[recipe].name,
                            parameters.sampling,
                            random);
  }



  template <int dim>
  double
  ShapeStudy<dim>::flops() const
  {
    return parameters.network.flops(true) * n_trained_ *
           parameters.training.points_per_sample * parameters.training.n_epochs;
  }



  template <int dim>
  double
  ShapeStudy<dim>::train(const std::string &checkpoint, ProgressLine &progress)
  {
    std::vector<FieldSample> samples;
    for (std::size_t i = 0; i < n_trained_; ++i)
      samples.push_back(sample(i));
    AutoDecoderTraining training(parameters.network,
                                 parameters.training,
                                 samples,
                                 Scaling(dim),
                                 Scaling(1),
                                 ranks);
    const double        loss = training.run(checkpoint, progress);
    model_                   = training.model();
    for (std::size_t i = 0; i < n_trained_; ++i)
      codes[i] = model_->code(i);
    return loss;
  }



  template <int dim>
  std::optional<BoundaryMesh<dim>>
  ShapeStudy<dim>::surface(const std::vector<float> &code) const
  {
    try
      {
        return isosurface<dim>(
          [&](const std::vector<double> &x) {
            return model_->evaluate(code, x);
          },
          half_box,
          parameters.n_cells);
      }
    catch (const InputError &)
      {
        return std::nullopt;
      }
  }



  template <int dim>
  Reconstruction
  ShapeStudy<dim>::compare(const std::vector<float> &code,
                           const ShapeRecipe        *truth) const
  {
    Reconstruction result;
    const auto     body = surface(code);
    result.empty        = !body;
    if (!body)
      return result;
    result.measure = body->measure();
    result.euler   = body->euler_number();
    result.closed  = body->is_closed();
    if (truth == nullptr)
      return result;
    const auto exact       = make_shape<dim>(*truth, parameters.n_pieces);
    const auto distance    = chamfer_distance<dim>(*body, exact, 2000);
    result.chamfer         = distance.mean;
    result.chamfer_squared = distance.squared;
    result.largest         = distance.largest;
    result.true_measure    = exact.measure();
    return result;
  }



  template <int dim>
  std::vector<Reconstruction>
  ShapeStudy<dim>::reconstruct()
  {
    const std::size_t           n      = recipes_.size();
    const unsigned int          n_code = parameters.network.n_code;
    std::vector<Reconstruction> result(n);
    std::vector<unsigned int>   owner(n);
    std::vector<float>          all_codes(n * n_code);
    for (std::size_t i = 0; i < n; ++i)
      {
        owner[i] = i % ranks.size();
        if (owner[i] != ranks.rank())
          continue;
        if (i >= n_trained_)
          codes[i] = infer_code(*model_, sample(i), parameters.training.loss);
        std::copy(codes[i].begin(),
                  codes[i].end(),
                  all_codes.begin() + i * n_code);
        result[i] = compare(codes[i], &recipes_[i]);
      }
    ranks.share(owner, result);
    ranks.share(owner, all_codes);
    for (std::size_t i = 0; i < n; ++i)
      codes[i].assign(all_codes.begin() + i * n_code,
                      all_codes.begin() + (i + 1) * n_code);
    return result;
  }



  template <int dim>
  std::vector<InterpolatedShape>
  ShapeStudy<dim>::interpolate() const
  {
    constexpr unsigned int         n_parts = 20; // as Lee (2025)
    RandomNumbers                  random(parameters.training.seed);
    std::vector<InterpolatedShape> result;
    for (unsigned int pair = 0; pair < parameters.n_interpolated; ++pair)
      {
        // from an undeformed shape to any other one
        const std::size_t first  = parameters.n_per_base * (pair % 4);
        std::size_t       second = first;
        while (second == first)
          second = random.below(n_trained_);
        for (unsigned int k = 0; k <= n_parts; ++k)
          {
            InterpolatedShape shape{first, second, double(k) / n_parts, {}, {}};
            for (unsigned int i = 0; i < parameters.network.n_code; ++i)
              shape.code.push_back(codes[first][i] +
                                   static_cast<float>(shape.part) *
                                     (codes[second][i] - codes[first][i]));
            result.push_back(shape);
          }
      }
    std::vector<unsigned int>   owner(result.size());
    std::vector<Reconstruction> shapes(result.size());
    for (std::size_t i = 0; i < result.size(); ++i)
      {
        owner[i] = i % ranks.size();
        if (owner[i] == ranks.rank())
          shapes[i] = compare(result[i].code, nullptr);
      }
    ranks.share(owner, shapes);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i].shape = shapes[i];
    return result;
  }



  /** The trained recipe, or their number if there is none. */
  template <int dim>
  std::size_t
  ShapeStudy<dim>::find(const BaseShape         base,
                        const ShapeDeformation &deformation) const
  {
    for (std::size_t i = 0; i < n_trained_; ++i)
      if (recipes_[i].base == base &&
          are_equal(recipes_[i].deformation, deformation))
        return i;
    return n_trained_;
  }



  template <int dim>
  std::vector<ShapeArithmetic>
  ShapeStudy<dim>::calculate() const
  {
    // from squares to hexagons and discs
    std::vector<ShapeArithmetic> result;
    const std::size_t            square = find(BaseShape::square, {});
    for (std::size_t i = 0; i < n_trained_; ++i)
      for (const BaseShape base : {BaseShape::hexagon, BaseShape::disc})
        if (recipes_[i].base == BaseShape::square && i != square)
          {
            const std::size_t to       = find(base, {});
            const std::size_t expected = find(base, recipes_[i].deformation);
            if (expected < n_trained_)
              result.push_back({square, i, to, expected, {}});
          }
    std::vector<unsigned int>   owner(result.size());
    std::vector<Reconstruction> shapes(result.size());
    for (std::size_t i = 0; i < result.size(); ++i)
      {
        owner[i] = i % ranks.size();
        if (owner[i] != ranks.rank())
          continue;
        const ShapeArithmetic &a    = result[i];
        std::vector<float>     code = codes[a.deformed];
        for (unsigned int c = 0; c < code.size(); ++c)
          code[c] += codes[a.to][c] - codes[a.from][c];
        shapes[i] = compare(code, &recipes_[a.expected]);
      }
    ranks.share(owner, shapes);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i].shape = shapes[i];
    return result;
  }



  template class ShapeStudy<2>;
  template class ShapeStudy<3>;
} // namespace asperity
