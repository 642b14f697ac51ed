#ifndef asperity_learning_decoder_h
#define asperity_learning_decoder_h

#include <asperity/learning/activation.h>

#include <cstddef>
#include <vector>

namespace asperity
{
  class RandomNumbers;

  /** Sizes and functions of a Decoder. */
  struct DecoderShape
  {
    unsigned int n_code     = 8; ///< length of a latent code, may be 0
    unsigned int n_position = 2; ///< dimension of space (and time)
    unsigned int n_outputs  = 1;
    unsigned int n_layers   = 4; ///< hidden ones
    unsigned int width      = 64;

    /** The hidden layer, counted from 0, or the output layer (n_layers), that
     *  is given the inputs again beside what the layer before it says; 0 for
     *  none. */
    unsigned int skip_layer = 2;

    Activation activation = Activation::relu;
    Activation output     = Activation::tanh; ///< or identity

    /** Sine: its number of half waves, roughly, over [-1, 1] before training
     *  (the omega_0 of Sitzmann et al. 2020 over pi). */
    double frequency = 3.;

    unsigned int
    n_inputs() const
    {
      return n_code + n_position;
    }

    /** Inputs of layer 0 .. n_layers. */
    unsigned int
    inputs_of(const unsigned int layer) const;

    unsigned int
    outputs_of(const unsigned int layer) const
    {
      return layer == n_layers ? n_outputs : width;
    }

    /** Of weights and offsets. */
    std::size_t
    n_parameters() const;

    /** Operations for a point: its value, and the gradient with respect to all
     *  weights and inputs, which costs twice as much again. Activations are not
     *  counted. */
    double
    flops(const bool with_gradient) const;

    /** @throws InputError that says which number cannot be. */
    void
    check() const;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &n_code &n_position &n_outputs &n_layers &width &skip_layer
        &activation &output &frequency;
    }
  };

  /**
   * A fully connected network y = f(z, x) of a latent code z and a position x
   * (the auto-decoder of Park et al. 2019, without its weight normalisation and
   * dropout, which serve networks a hundred times as large):
   *
   *   a_0 = (z, x),  a_{l+1} = s(W_l a_l + b_l),  y = s_out(W_L a_L + b_L),
   *
   * where a_k of the skip layer k has (z, x) appended. Derivatives are exact.
   * Many points at once are columns of matrices, which BLAS multiplies. The
   * values of a point do not depend on how many stand beside it but for
   * round-off; those of equal calls are equal to the bit.
   *
   * @tparam Number float for training, double where derivatives are tested
   */
  template <typename Number>
  class Decoder
  {
  public:
    /** What a pass forward leaves for those backward. Is resized as needed. */
    struct Workspace
    {
      /** Inputs of each layer, a column a point; [0] is for the caller to fill,
       *  code before position. The last are the outputs. */
      std::vector<std::vector<Number>> values;
      std::vector<std::vector<Number>> derivatives; ///< of the activations
      std::vector<Number>              delta, above;
    };

    /** All parameters zero. @throws InputError as DecoderShape::check() */
    explicit Decoder(const DecoderShape &shape);

    const DecoderShape &
    shape() const
    {
      return shape_;
    }

    /** Layer after layer the matrix by columns, then the offsets. */
    std::vector<Number> &
    parameters()
    {
      return parameters_;
    }

    const std::vector<Number> &
    parameters() const
    {
      return parameters_;
    }

    /** Uniform weights that keep the size of signals: of variance 2/n for ReLU
     *  (He et al. 2015) and sine (Sitzmann et al. 2020), 2/(n + m) otherwise
     *  (Glorot and Bengio 2010), n inputs and m outputs of a layer; offsets are
     *  zero. */
    void
    initialize(RandomNumbers &random);

    /** Makes room for n points, n >= 1. @return n_inputs() x n numbers to fill
     */
    Number *
    inputs(const std::size_t n, Workspace &workspace) const;

    /** Values at the inputs of the workspace.
     *  @return n_outputs x n, a column a point, in the workspace */
    const Number *
    evaluate(const std::size_t n, Workspace &workspace) const;

    /**
     * Backward, after evaluate() of the same points.
     * @param d_outputs of some function, with respect to the values
     * @param d_parameters its gradient is added to; null if none is wanted
     * @param d_inputs n_inputs() x n, its gradient is written to; may be null
     */
    void
    add_gradient(const std::size_t n,
                 const Number     *d_outputs,
                 Workspace        &workspace,
                 Number           *d_parameters,
                 Number           *d_inputs) const;

    /** Forward, after evaluate() of the same points: dy/dx.
     *  @param derivatives n_outputs x n_position x n numbers, the output
     *   running fastest */
    void
    position_derivatives(const std::size_t n,
                         Workspace        &workspace,
                         Number           *derivatives) const;

  private:
    const Number *
    matrix(const unsigned int layer) const
    {
      return parameters_.data() + first[layer];
    }

    void
    add_layer_gradient(const unsigned int layer,
                       const std::size_t  n,
                       const Workspace   &workspace,
                       Number            *gradient) const;

    DecoderShape             shape_;
    std::vector<std::size_t> first; ///< parameter of each layer
    std::vector<Number>      parameters_;
  };
} // namespace asperity

#endif
