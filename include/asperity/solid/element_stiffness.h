#ifndef asperity_solid_element_stiffness_h
#define asperity_solid_element_stiffness_h

#include <asperity/solid/element_gradients.h>

#include <array>
#include <vector>

namespace asperity
{
  /**
   * Stiffness of one element, K_aibl = integral of dN_a/dX_J dP_iJ/dF_lM
   * dN_b/dX_M [N/m^2 per metre of thickness; N/m if axisymmetric].
   */
  class ElementStiffness
  {
  public:
    /** @param weights of the points [m^2, m^3 if axisymmetric] */
    void
    integrate(const ElementGradients &gradients,
              const double           *weights,
              const MaterialResponse *responses);

    /** Number of functions. */
    unsigned int
    size() const
    {
      return n;
    }

    /** K_ai, one number for each [2 b + l]. */
    const double *
    row(const unsigned int a, const unsigned int i) const
    {
      return &blocks[i][a * stride];
    }

  private:
    unsigned int n      = 0;
    unsigned int stride = 0; ///< 2 n, padded

    /** Of a group of points: [i][(point, J), 2 b + l], derivatives of P_iJ
     *  times weight by displacement component l of function b. */
    std::array<std::vector<double>, 2> columns;

    std::array<std::vector<double>, 2> blocks; ///< [i][a stride + 2 b + l]
  };
} // namespace asperity

#endif
