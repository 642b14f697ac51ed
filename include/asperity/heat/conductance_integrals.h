#ifndef asperity_heat_conductance_integrals_h
#define asperity_heat_conductance_integrals_h

#include <asperity/isogeometric/basis_table.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace asperity
{
  /**
   * What the elements of a deforming body give to the matrix of its heat
   * conduction,
   *
   *   int J C^{-1} Grad N_a . Grad N_b dV,   C = F^T F,
   *
   * conduction in the current frame written in the reference. The gradients
   * lie in rows, since a body that deforms is integrated at every step.
   */
  class ConductanceIntegrals
  {
  public:
    /** @param cells of the body; must outlive this object */
    explicit ConductanceIntegrals(const BasisTable<2> &cells);

    /**
     * @param element number of it in the table
     * @param u displacement, numbered by displacement_dof() [m]; must not fold
     *   the element
     * @return the integral for functions a and b at [a * stride(element) + b]
     *   [1, per thickness], until the next call
     * @throws ComputationError if the element is folded
     */
    const double *
    integrate(const unsigned int element, const dealii::Vector<double> &u);

    unsigned int
    stride(const unsigned int element) const;

  private:
    const BasisTable<2>     &cells;
    std::vector<std::size_t> first;     ///< by element, in gradients
    std::vector<double>      gradients; ///< by point and component, padded
    std::vector<double>      work, block;
  };
} // namespace asperity

#endif
