#ifndef source_learning_scaled_sample_h
#define source_learning_scaled_sample_h

#include <asperity/learning/auto_decoder.h>

#include <vector>

namespace asperity
{
  /** A sample as a network sees it. */
  struct ScaledSample
  {
    /** @throws InputError if positions, values and shape do not fit together,
     *   or one of them is no number */
    ScaledSample(const FieldSample  &sample,
                 const DecoderShape &shape,
                 const Scaling      &position_scaling,
                 const Scaling      &value_scaling);

    std::vector<float> positions, values;
  };

  /** Adds the gradient of factor |z|, which is zero where it does not exist. */
  void
  add_length_gradient(const unsigned int n,
                      const double       factor,
                      const float       *z,
                      float             *gradient);
} // namespace asperity

#endif
