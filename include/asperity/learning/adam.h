#ifndef asperity_learning_adam_h
#define asperity_learning_adam_h

#include <boost/serialization/vector.hpp>

#include <cstddef>
#include <vector>

namespace asperity
{
  /** A rate that is multiplied by a factor after every so many epochs (Park et
   *  al. 2019; equation 3 of the paper in section 3.1 of Lee 2025). */
  struct LearningRate
  {
    double       initial  = 5e-4;
    double       factor   = 0.5;
    unsigned int interval = 500; ///< epochs, at least 1

    double
    at(const unsigned int epoch) const;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &initial &factor &interval;
    }
  };

  /**
   * The steps of Adam (Kingma and Ba 2015, algorithm 1): with gradient g,
   *
   *   m = beta_1 m + (1 - beta_1) g,  v = beta_2 v + (1 - beta_2) g^2,
   *   x -= rate m / (1 - beta_1^t) / (sqrt(v / (1 - beta_2^t)) + epsilon).
   */
  template <typename Number>
  class Adam
  {
  public:
    explicit Adam(const std::size_t n);

    /** @param gradient,x as many numbers as there are */
    void
    step(const std::vector<Number> &gradient,
         const double               rate,
         std::vector<Number>       &x);

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &n_steps &mean &square;
    }

    static constexpr double beta_1  = 0.9;
    static constexpr double beta_2  = 0.999;
    static constexpr double epsilon = 1e-8;

  private:
    // not as long as a length, which an archive holds against its own
    unsigned int        n_steps = 0;
    std::vector<Number> mean, square;
  };
} // namespace asperity

#endif
