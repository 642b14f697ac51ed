#ifndef asperity_learning_activation_h
#define asperity_learning_activation_h

#include <cstddef>
#include <string>

namespace asperity
{
  /** What a neuron makes of the sum of its inputs. */
  enum class Activation
  {
    identity,
    relu,     ///< max(x, 0), of distances (Park et al. 2019)
    tanh,     ///< smooth and bounded
    softplus, ///< log(1 + exp x), smooth
    sine      ///< sin x, of fields (Sitzmann et al. 2020)
  };

  /** "ReLU", "tanh" and so on. */
  std::string
  name_of(const Activation activation);

  /**
   * Replaces sums by what their neurons make of them.
   * @param rows,columns,stride of the matrix of sums, stored by columns that
   *   begin `stride` numbers after each other
   * @param values sums, replaced
   * @param derivatives rows x columns without gaps, of the values with respect
   *   to the sums; none are written if null
   */
  template <typename Number>
  void
  activate(const Activation  activation,
           const std::size_t rows,
           const std::size_t columns,
           const std::size_t stride,
           Number           *values,
           Number           *derivatives);
} // namespace asperity

#endif
