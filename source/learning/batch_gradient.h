#ifndef source_learning_batch_gradient_h
#define source_learning_batch_gradient_h

#include <asperity/learning/decoder.h>
#include <asperity/learning/loss.h>

#include <vector>

namespace asperity
{
  /** Points of some samples, as a network sees them. */
  struct PointBatch
  {
    std::vector<unsigned int> sample; ///< of each point, its place in the batch
    std::vector<float>        positions, values;

    std::size_t
    size() const
    {
      return sample.size();
    }

    /** Adds a point of a sample. @param x,y its position and values */
    void
    add(const unsigned int place,
        const float       *x,
        const unsigned int n_position,
        const float       *y,
        const unsigned int n_outputs);
  };

  /** The loss of a batch and its gradient. */
  class BatchGradient
  {
  public:
    BatchGradient(const Decoder<float> &decoder, const Loss &loss);

    /**
     * Sum over the points begin ... end - 1, block by block, so that equal
     * calls give equal bits.
     * @param codes of the samples of the batch, one after the other
     * @param factor of the gradients, which are added
     * @param d_parameters may be null; d_codes as the codes
     * @return loss, without the factor
     */
    double
    add(const PointBatch &batch,
        const std::size_t begin,
        const std::size_t end,
        const float      *codes,
        const float       factor,
        float            *d_parameters,
        float            *d_codes);

  private:
    const Decoder<float>     &decoder;
    Loss                      loss;
    Decoder<float>::Workspace workspace;
    std::vector<float>        d_outputs, d_inputs;
  };
} // namespace asperity

#endif
