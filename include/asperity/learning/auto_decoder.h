#ifndef asperity_learning_auto_decoder_h
#define asperity_learning_auto_decoder_h

#include <asperity/learning/decoder.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace asperity
{
  /** A continuous function that is known at points: a shape by its signed
   *  distances, a field by its values. */
  struct FieldSample
  {
    std::string         name;
    std::vector<double> positions; ///< coordinates of point after point
    std::vector<double> values;    ///< components of point after point
  };

  /** What a network sees of numbers: (x - centre) / scale, a component each. */
  struct Scaling
  {
    std::vector<double> centre, scale;

    Scaling() = default;

    /** Changes nothing. */
    explicit Scaling(const unsigned int n_components)
      : centre(n_components, 0.)
      , scale(n_components, 1.)
    {}

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &centre &scale;
    }
  };

  /** To [-1, 1] over all positions of the samples.
   *  @throws InputError if one of them has no points or not whole ones */
  Scaling
  scaling_of_positions(const std::vector<FieldSample> &samples,
                       const unsigned int              n_coordinates);

  /** To mean 0 and deviation 1 of each component, but for one that is constant,
   *  whose scale stays 1. @throws InputError as above */
  Scaling
  scaling_of_values(const std::vector<FieldSample> &samples,
                    const unsigned int              n_components);

  /**
   * A trained network with the latent codes of the samples that it was trained
   * with.
   */
  class AutoDecoder
  {
  public:
    AutoDecoder() = default;

    AutoDecoder(const Decoder<float>           &decoder,
                const std::vector<float>       &codes,
                const std::vector<std::string> &names,
                const Scaling                  &position_scaling,
                const Scaling                  &value_scaling);

    const Decoder<float> &
    decoder() const
    {
      return decoder_;
    }

    std::size_t
    n_codes() const
    {
      return names_.size();
    }

    /** Of a sample of the training. */
    std::vector<float>
    code(const std::size_t sample) const;

    /** Of the samples. */
    const std::vector<std::string> &
    names() const
    {
      return names_;
    }

    const Scaling &
    position_scaling() const
    {
      return position_scaling_;
    }

    const Scaling &
    value_scaling() const
    {
      return value_scaling_;
    }

    /**
     * The function of a code.
     * @param positions coordinates of point after point
     * @param derivatives if given: of the values,
     * [point][coordinate][component] with the component running fastest
     * @return values, components of point after point
     * @throws InputError if the code or the positions have the wrong length
     */
    std::vector<double>
    evaluate(const std::vector<float>  &code,
             const std::vector<double> &positions,
             std::vector<double>       *derivatives = nullptr) const;

    /** Words of whoever trained the model, e.g. its parameter file. */
    std::string description;

    /** @throws ComputationError if the file cannot be written */
    void
    write(const std::string &path) const;

    /** @throws InputError with one sentence if the file is missing, something
     *   else, damaged or contradicts itself */
    static AutoDecoder
    read(const std::string &path);

  private:
    template <typename Archive>
    void
    serialize(Archive &archive);

    void
    check() const;

    Decoder<float>           decoder_{DecoderShape()};
    std::vector<float>       codes_; ///< code after code
    std::vector<std::string> names_;
    Scaling                  position_scaling_, value_scaling_;
  };
} // namespace asperity

#endif
