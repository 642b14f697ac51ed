#ifndef asperity_learning_training_h
#define asperity_learning_training_h

#include <asperity/base/ranks.h>
#include <asperity/learning/adam.h>
#include <asperity/learning/auto_decoder.h>
#include <asperity/learning/loss.h>

#include <cstdint>
#include <string>
#include <vector>

namespace asperity
{
  class ProgressLine;

  /** How an auto-decoder is trained; rates and regularisation as Park et al.
   *  (2019) and Lee (2025). */
  struct TrainingOptions
  {
    unsigned int n_epochs          = 300;
    unsigned int samples_per_batch = 16;
    unsigned int points_per_sample = 512; ///< drawn anew in every epoch

    LearningRate weights{5e-4, 0.5, 500};
    LearningRate codes{1e-3, 0.5, 500};
    Loss         loss;

    /** Factor of the mean length of codes that is added to the loss, and the
     *  epochs over which it grows to that. */
    double       code_regularization = 1e-4;
    unsigned int regularization_ramp = 100;

    /** Deviation of the codes before training times the root of their length,
     *  so that codes have about this length. */
    double initial_code_length = 1.;

    /** Parts of a batch, whose gradients are added in their order: as many
     *  ranks have work. The last bits of the weights depend on it, but not on
     *  the number of ranks. */
    unsigned int n_parts = 4;

    std::uint64_t seed = 1;

    /** @throws InputError that says what cannot be */
    void
    check() const;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &samples_per_batch &points_per_sample &weights &codes &loss;
      archive &code_regularization &regularization_ramp &initial_code_length;
      archive &n_parts                                  &seed;
    }
  };

  /**
   * Trains weights and codes together: minimises over both
   *
   *   mean over samples i and points x of l(f(z_i, x), y_i(x)) + r |z_i|
   *
   * by Adam on batches of points. Ranks share each batch, and all hold the same
   * weights, which are to the bit those of one rank alone. The random numbers
   * of an epoch follow from the seed and its number, so that a training that is
   * resumed ends with the same bits, too.
   */
  class AutoDecoderTraining
  {
  public:
    /** @throws InputError if the shape, the options or the samples cannot be */
    AutoDecoderTraining(const DecoderShape             &shape,
                        const TrainingOptions          &options,
                        const std::vector<FieldSample> &samples,
                        const Scaling                  &position_scaling,
                        const Scaling                  &value_scaling,
                        const Ranks                    &ranks = Ranks());

    /** Collective: one pass over all samples.
     *  @return mean loss of its points, without regularisation */
    double
    run_epoch();

    /**
     * Collective: the epochs that are left.
     * @param checkpoint file that is written once a minute and at the end, and
     *   that the training goes on from if it exists; none if empty
     * @param progress says epoch, loss and time left
     * @return loss of the last epoch
     * @throws InputError if the checkpoint is damaged or another training's,
     *   ComputationError if the loss is no number any more
     */
    double
    run(const std::string &checkpoint, ProgressLine &progress);

    unsigned int
    epoch() const
    {
      return epoch_;
    }

    /** What has been trained so far. */
    AutoDecoder
    model() const;

    /** Of an epoch, on all ranks together; see DecoderShape::flops(). */
    double
    flops_per_epoch() const;

    void
    write_checkpoint(const std::string &path) const;

    /** @throws InputError as run() */
    void
    read_checkpoint(const std::string &path);

  private:
    struct Batch;

    Batch
    draw(const std::vector<std::size_t> &samples, RandomNumbers &random) const;

    double
    step(const Batch &batch);

    void
    add_regularization(const Batch &batch);

    template <typename Archive>
    void
    serialize_state(Archive &archive);

    TrainingOptions options;
    Ranks           ranks;
    Decoder<float>  decoder;
    Scaling         position_scaling, value_scaling;

    std::vector<std::string>        names;
    std::vector<std::vector<float>> positions,
      values; ///< scaled, a sample each

    std::vector<float> codes;
    Adam<float>        weight_steps, code_steps;
    unsigned int       epoch_    = 0;
    double             last_loss = 0.;

    std::string        inputs; ///< check sum of all that training depends on
    std::vector<float> part_gradients, gradient, code_gradient;
  };

  /** How the code of an unseen sample is found (Park et al. 2019, section 4.3):
   *  from the best of zero and the codes of the training. */
  struct CodeSearch
  {
    unsigned int  n_steps         = 800;
    unsigned int  points_per_step = 1024;
    double        rate            = 5e-3; ///< a tenth of it in the second half
    double        regularization  = 1e-4; ///< of the code's length
    std::uint64_t seed            = 1;
  };

  /** The code with which a model says what a sample says, its weights as they
   *  are. @throws InputError if the sample does not fit the model */
  std::vector<float>
  infer_code(const AutoDecoder &model,
             const FieldSample &sample,
             const Loss        &loss,
             const CodeSearch  &search = CodeSearch());
} // namespace asperity

#endif
