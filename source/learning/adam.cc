#include <asperity/learning/adam.h>

#include <cmath>

namespace asperity
{
  double
  LearningRate::at(const unsigned int epoch) const
  {
    return initial * std::pow(factor, static_cast<double>(epoch / interval));
  }



  template <typename Number>
  Adam<Number>::Adam(const std::size_t n)
    : mean(n)
    , square(n)
  {}



  template <typename Number>
  void
  Adam<Number>::step(const std::vector<Number> &gradient,
                     const double               rate,
                     std::vector<Number>       &x)
  {
    ++n_steps;
    const double t  = static_cast<double>(n_steps);
    const Number b1 = static_cast<Number>(beta_1);
    const Number b2 = static_cast<Number>(beta_2);
    const Number factor =
      static_cast<Number>(rate / (1. - std::pow(beta_1, t)));
    const Number root =
      static_cast<Number>(1. / std::sqrt(1. - std::pow(beta_2, t)));
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        const Number g = gradient[i];
        mean[i]        = b1 * mean[i] + (Number(1) - b1) * g;
        square[i]      = b2 * square[i] + (Number(1) - b2) * g * g;
        x[i] -= factor * mean[i] /
                (std::sqrt(square[i]) * root + static_cast<Number>(epsilon));
      }
  }



  template class Adam<float>;
  template class Adam<double>;
} // namespace asperity
