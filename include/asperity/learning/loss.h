#ifndef asperity_learning_loss_h
#define asperity_learning_loss_h

#include <cstddef>

namespace asperity
{
  /** What a network's output costs. */
  struct Loss
  {
    enum class Kind
    {
      /** |f - c(y)|, c(y) = min(d, max(-d, y)) with the clamp d, or zero where
       *  f and y lie beyond d on the same side: signed distances, of which
       * those near the boundary matter. Park et al. (2019), equation 4, clamp
       * f, too, but then an output beyond d does not learn that it is on the
       * wrong side. */
      clamped_distance,

      squared ///< (f - y)^2, fields
    };

    Kind   kind  = Kind::clamped_distance;
    double clamp = 0.1;

    /**
     * The sum over n numbers.
     * @param factor of the gradient
     * @param gradient factor times the derivatives by the outputs
     */
    double
    evaluate(const std::size_t n,
             const float      *outputs,
             const float      *targets,
             const float       factor,
             float            *gradient) const;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &kind &clamp;
    }
  };
} // namespace asperity

#endif
