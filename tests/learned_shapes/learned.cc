#include <asperity/base/progress.h>
#include <asperity/base/random_numbers.h>
#include <asperity/learned_shapes/base_shapes.h>
#include <asperity/learned_shapes/chamfer_distance.h>
#include <asperity/learned_shapes/distance_samples.h>
#include <asperity/learned_shapes/isosurface.h>
#include <asperity/learned_shapes/spline_shape.h>
#include <asperity/learning/training.h>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

using namespace asperity;



TEST(LearnedShapes, are_a_disc_and_a_square_to_a_thousandth_of_their_size)
{
  // exact ones: a rational spline, and a polygon
  const double      radius = 1. / 1.03, side = std::sqrt(2.) / 1.03;
  const SplineShape disc(circle({}, radius));
  const auto        square = make_shape<2>({BaseShape::square, {}, ""}, 4);

  RandomNumbers    random(1);
  DistanceSampling sampling;
  sampling.n_points                      = 4000;
  const std::vector<FieldSample> samples = {
    sample_distances<2>(disc, "disc", sampling, random),
    sample_distances<2>(square, "square", sampling, random)};

  // 4 x 64, 7.7e5 points of 8e4 operations: 3 s at 20 Gflop/s
  DecoderShape shape;
  shape.n_code = 4;
  TrainingOptions options;
  options.n_epochs          = 1500;
  options.points_per_sample = 256;
  options.weights           = {5e-3, 0.5, 200};
  options.codes             = {2e-3, 0.5, 200};
  AutoDecoderTraining training(shape, options, samples, Scaling(2), Scaling(1));
  std::ostringstream  out;
  ProgressLine        progress(out, ProgressLine::Mode::silent);
  training.run("", progress);
  const AutoDecoder model = training.model();

  const auto learned = [&model](const std::size_t sample) {
    return isosurface<2>(
      [&](const std::vector<double> &x) {
        return model.evaluate(model.code(sample), x);
      },
      1.1,
      128);
  };
  const auto learned_disc = learned(0), learned_square = learned(1);
  EXPECT_LT(chamfer_distance<2>(learned_disc, disc).mean, 1e-3 * 2. * radius);
  EXPECT_LT(chamfer_distance<2>(learned_square, square).mean, 1e-3 * side);
  for (const auto *body : {&learned_disc, &learned_square})
    {
      EXPECT_TRUE(body->is_closed());
      EXPECT_EQ(body->euler_number(), 1);
    }
  EXPECT_NEAR(learned_disc.measure(), M_PI * radius * radius, 5e-3);
  EXPECT_NEAR(learned_square.measure(), side * side, 5e-3);
}
