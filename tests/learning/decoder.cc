#include <asperity/base/errors.h>
#include <asperity/base/random_numbers.h>
#include <asperity/learning/decoder.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../files.h"

using namespace asperity;

namespace
{
  DecoderShape
  small_shape(const Activation activation, const unsigned int skip_layer)
  {
    DecoderShape shape;
    shape.n_code     = 3;
    shape.n_position = 2;
    shape.n_outputs  = 2;
    shape.n_layers   = 3;
    shape.width      = 7;
    shape.skip_layer = skip_layer;
    shape.activation = activation;
    shape.output = skip_layer == 1 ? Activation::identity : Activation::tanh;
    return shape;
  }

  std::vector<double>
  random_vector(const std::size_t n, RandomNumbers &random)
  {
    std::vector<double> result(n);
    for (double &x : result)
      x = 2. * random.uniform() - 1.;
    return result;
  }

  /** A network with random parameters, at random points. */
  struct DecoderExample
  {
    explicit DecoderExample(const DecoderShape &shape)
      : decoder(shape)
    {
      RandomNumbers random(5);
      decoder.initialize(random);
      // offsets, too
      for (double &w : decoder.parameters())
        w += 0.1 * (random.uniform() - 0.5);
      inputs  = random_vector(n * shape.n_inputs(), random);
      factors = random_vector(n * shape.n_outputs, random);
    }

    std::vector<double>
    outputs()
    {
      std::copy(inputs.begin(), inputs.end(), decoder.inputs(n, workspace));
      const double *y = decoder.evaluate(n, workspace);
      return {y, y + n * decoder.shape().n_outputs};
    }

    /** The function whose gradient is tested. */
    double
    function()
    {
      double     sum = 0.;
      const auto y   = outputs();
      for (std::size_t i = 0; i < y.size(); ++i)
        sum += factors[i] * y[i];
      return sum;
    }

    /** Its derivative by one of its numbers, from central differences. */
    double
    difference(double &x)
    {
      const double h = 1e-6, old = x;
      x                 = old + h;
      const double up   = function();
      x                 = old - h;
      const double down = function();
      x                 = old;
      return (up - down) / (2. * h);
    }

    const std::size_t          n = 5;
    Decoder<double>            decoder;
    Decoder<double>::Workspace workspace;
    std::vector<double>        inputs, factors;
  };

  class EachDecoder
    : public testing::TestWithParam<std::tuple<Activation, unsigned int>>
  {
  protected:
    DecoderShape
    shape() const
    {
      return small_shape(std::get<0>(GetParam()), std::get<1>(GetParam()));
    }
  };
} // namespace



TEST_P(EachDecoder, has_the_gradients_of_differences)
{
  DecoderExample      example(shape());
  std::vector<double> parameters(shape().n_parameters());
  std::vector<double> inputs(example.inputs.size());
  ASSERT_EQ(parameters.size(), example.decoder.parameters().size());
  example.outputs();
  example.decoder.add_gradient(example.n,
                               example.factors.data(),
                               example.workspace,
                               parameters.data(),
                               inputs.data());
  double largest = 0.;
  for (const double g : parameters)
    largest = std::max(largest, std::abs(g));
  ASSERT_GT(largest, 0.1);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    EXPECT_NEAR(parameters[i],
                example.difference(example.decoder.parameters()[i]),
                1e-8 * largest)
      << "parameter " << i;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    EXPECT_NEAR(inputs[i],
                example.difference(example.inputs[i]),
                1e-8 * largest)
      << "input " << i;
}



TEST_P(EachDecoder, has_the_position_derivatives_of_differences)
{
  DecoderExample     example(shape());
  const DecoderShape s = shape();
  example.outputs();
  std::vector<double> derivatives(example.n * s.n_position * s.n_outputs);
  example.decoder.position_derivatives(example.n,
                                       example.workspace,
                                       derivatives.data());
  const double h = 1e-6;
  for (unsigned int d = 0; d < s.n_position; ++d)
    {
      const auto move = [&](const double step) {
        for (std::size_t j = 0; j < example.n; ++j)
          example.inputs[j * s.n_inputs() + s.n_code + d] += step;
        return example.outputs();
      };
      const auto up   = move(h);
      const auto down = move(-2. * h);
      move(h);
      for (std::size_t j = 0; j < example.n; ++j)
        for (unsigned int k = 0; k < s.n_outputs; ++k)
          EXPECT_NEAR(derivatives[(j * s.n_position + d) * s.n_outputs + k],
                      (up[j * s.n_outputs + k] - down[j * s.n_outputs + k]) /
                        (2. * h),
                      1e-8);
    }
}



// without the inputs fed in again, then at the first layer, the last hidden one
// and the output layer
INSTANTIATE_TEST_SUITE_P(Shapes,
                         EachDecoder,
                         testing::Combine(testing::Values(Activation::relu,
                                                          Activation::tanh,
                                                          Activation::softplus,
                                                          Activation::sine),
                                          testing::Values(0u, 1u, 2u, 3u)),
                         [](const auto &parameters) {
                           return name_of(std::get<0>(parameters.param)) +
                                  "_fed_again_at_" +
                                  std::to_string(std::get<1>(parameters.param));
                         });



TEST(Activation, is_its_formula_for_large_and_small_sums)
{
  for (const double x : {-100., -30., -2., -1e-3, 0.25, 3., 40., 100.})
    {
      const auto value = [x](const Activation activation) {
        double y = x;
        activate(activation, 1, 1, 1, &y, static_cast<double *>(nullptr));
        return y;
      };
      EXPECT_EQ(value(Activation::identity), x);
      EXPECT_EQ(value(Activation::relu), std::max(x, 0.));
      EXPECT_NEAR(value(Activation::tanh), std::tanh(x), 1e-15);
      EXPECT_NEAR(value(Activation::softplus),
                  x > 0. ? x + std::log1p(std::exp(-x)) :
                           std::log1p(std::exp(x)),
                  1e-15 * std::max(1., x));
      EXPECT_NEAR(value(Activation::sine), std::sin(x), 1e-15);
    }
}



TEST(Decoder, of_one_neuron_is_a_formula)
{
  // y = tanh(w_1 max(w_z z + w_x x + b_0, 0) + b_1), the inputs fed in again
  // at the output
  DecoderShape shape;
  shape.n_code = shape.n_position = shape.n_layers = shape.width = 1;
  shape.skip_layer                                               = 1;
  Decoder<double> decoder(shape);
  decoder.parameters() = {0.5, -2., 0.3, /* output: */ 0.7, 0.2, -0.4, 0.1};
  Decoder<double>::Workspace workspace;
  double *const              inputs = decoder.inputs(1, workspace);
  inputs[0]                         = 0.8;
  inputs[1]                         = -0.6;
  // 0.4 + 1.2 + 0.3 = 1.9; 1.33 + 0.16 + 0.24 + 0.1 = 1.83
  EXPECT_NEAR(*decoder.evaluate(1, workspace), std::tanh(1.83), 1e-15);
}



TEST(Decoder, says_the_same_in_float_and_double_but_for_round_off)
{
  DecoderShape    shape;
  Decoder<double> exact(shape);
  Decoder<float>  decoder(shape);
  RandomNumbers   random(2), same(2);
  exact.initialize(random);
  decoder.initialize(same);
  Decoder<double>::Workspace exact_workspace;
  Decoder<float>::Workspace  workspace;
  const std::size_t          n  = 600;
  double *const              in = exact.inputs(n, exact_workspace);
  for (std::size_t i = 0; i < n * shape.n_inputs(); ++i)
    in[i] = 2. * random.uniform() - 1.;
  std::copy_n(in, n * shape.n_inputs(), decoder.inputs(n, workspace));
  const double *y = exact.evaluate(n, exact_workspace);
  const float  *f = decoder.evaluate(n, workspace);
  for (std::size_t i = 0; i < n; ++i)
    EXPECT_NEAR(y[i], f[i], 1e-5);
}



TEST(DecoderShape, counts_operations_and_parameters)
{
  // 4 x 64 with (8 + 2) inputs, fed in again at layer 2, and 1 output
  const DecoderShape shape;
  const double       products = 10 * 64 + 64 * 64 + 74 * 64 + 64 * 64 + 64;
  EXPECT_EQ(shape.n_parameters(), products + 4 * 64 + 1);
  EXPECT_EQ(shape.flops(false), 2. * products);
  EXPECT_EQ(shape.flops(true), 6. * products);
}



TEST(DecoderShape, refuses_what_cannot_be)
{
  DecoderShape shape;
  shape.skip_layer = 5;
  EXPECT_EQ(message_of<InputError>([&]() { Decoder<float> decoder(shape); }),
            "A network with inputs fed in again at layer 5 of 4 is not "
            "possible.");
  shape            = {};
  shape.n_position = 0;
  EXPECT_EQ(message_of<InputError>([&]() { shape.check(); }),
            "A network with 0 coordinates (1 to 16) is not possible.");
}
