#ifndef asperity_solid_element_stiffness_h
#define asperity_solid_element_stiffness_h

#include <asperity/solid/element_gradients.h>

#include <array>
#include <vector>

namespace asperity
{
  /**
   * Stiffness of one element, K_aibl = integral of dN_a/dX_J dP_iJ/dF_lM
   * dN_b/dX_M [N/m^2 per metre of thickness; N/m if axisymmetric or in three
   * dimensions].
   */
  template <int dim>
  class ElementStiffness
  {
  public:
    /** @param weights of the points [m^2, m^3 if axisymmetric or in three
     *  dimensions] */
    void
    integrate(const ElementGradients<dim> &gradients,
              const double                *weights,
              const MaterialResponse      *responses);

    /** Number of functions. */
    unsigned int
    size() const
    {
      return n;
    }

    /** K_ai, one number for each unknown of the element, in the order of
     *  ElementGradients. */
    const double *
    row(const unsigned int a, const unsigned int i) const
    {
      return &blocks[i][a * stride];
    }

    /** Distance between the components of one function in a row. */
    unsigned int
    component_stride() const
    {
      return dim == 2 ? 1 : stride / dim;
    }

    /** Distance between functions in a row. */
    static constexpr unsigned int
    function_stride()
    {
      return dim == 2 ? 2 : 1;
    }

  private:
    unsigned int n      = 0;
    unsigned int stride = 0; ///< unknowns, padded

    /** Of a group of points: [i][(point, J), unknown], derivatives of P_iJ
     *  times weight by the unknowns. */
    std::array<std::vector<double>, dim> columns;

    std::array<std::vector<double>, dim> blocks; ///< [i][a stride + unknown]
  };
} // namespace asperity

#endif
