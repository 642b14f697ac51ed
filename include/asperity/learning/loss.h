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
      /** |c(f) - c(y)|, c(s) = min(d, max(-d, s)) with the clamp d: signed
       *  distances, of which those near the boundary matter (Park et al. 2019,
       *  equation 4). */
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
