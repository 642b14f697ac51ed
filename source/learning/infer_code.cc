#include <asperity/base/random_numbers.h>
#include <asperity/learning/training.h>

#include <limits>

#include "batch_gradient.h"
#include "scaled_sample.h"

namespace asperity
{
  namespace
  {
    PointBatch
    draw(const ScaledSample &sample,
         const DecoderShape &shape,
         const std::size_t   n,
         RandomNumbers      &random)
    {
      PointBatch        result;
      const std::size_t n_points = sample.positions.size() / shape.n_position;
      for (std::size_t i = 0; i < n; ++i)
        {
          // all points once if they are few
          const std::size_t point = n < n_points ? random.below(n_points) : i;
          if (point == n_points)
            break;
          result.add(0,
                     sample.positions.data() + point * shape.n_position,
                     shape.n_position,
                     sample.values.data() + point * shape.n_outputs,
                     shape.n_outputs);
        }
      return result;
    }
  } // namespace



  std::vector<float>
  infer_code(const AutoDecoder &model,
             const FieldSample &sample,
             const Loss        &loss,
             const CodeSearch  &search)
  {
    const DecoderShape &shape = model.decoder().shape();
    const ScaledSample  scaled(sample,
                              shape,
                              model.position_scaling(),
                              model.value_scaling());
    RandomNumbers       random(search.seed);
    BatchGradient       batch_gradient(model.decoder(), loss);

    std::vector<float> gradient(shape.n_code);
    std::vector<float> best(shape.n_code, 0.f);
    const PointBatch   first =
      draw(scaled, shape, search.points_per_step, random);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i <= model.n_codes(); ++i)
      {
        const std::vector<float> z =
          i == 0 ? std::vector<float>(shape.n_code, 0.f) : model.code(i - 1);
        const double sum = batch_gradient.add(
          first, 0, first.size(), z.data(), 0.f, nullptr, gradient.data());
        if (sum < least)
          {
            least = sum;
            best  = z;
          }
      }

    Adam<float> steps(shape.n_code);
    for (unsigned int i = 0; i < search.n_steps; ++i)
      {
        const PointBatch batch =
          draw(scaled, shape, search.points_per_step, random);
        gradient.assign(shape.n_code, 0.f);
        batch_gradient.add(batch,
                           0,
                           batch.size(),
                           best.data(),
                           1.f / (batch.size() * shape.n_outputs),
                           nullptr,
                           gradient.data());
        add_length_gradient(shape.n_code,
                            search.regularization,
                            best.data(),
                            gradient.data());
        steps.step(gradient,
                   i < search.n_steps / 2 ? search.rate : 0.1 * search.rate,
                   best);
      }
    return best;
  }
} // namespace asperity
