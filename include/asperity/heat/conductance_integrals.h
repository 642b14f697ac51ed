#ifndef asperity_heat_conductance_integrals_h
#define asperity_heat_conductance_integrals_h

#include <asperity/isogeometric/basis_table.h>

#include <deal.II/lac/vector.h>

#include <functional>
#include <vector>

namespace asperity
{
  /** Gradients of an element's functions [1/m], kept elsewhere: component d at
   *  point q from (dim q + d) n on, n the number of functions, padded by zeros
   *  to full vectors. @return of an element of the table */
  using GradientRows = std::function<const double *(const unsigned int)>;

  /**
   * What the elements of a deforming body give to the matrix of its heat
   * conduction,
   *
   *   int J C^{-1} Grad N_a . Grad N_b dV,   C = F^T F,
   *
   * conduction in the current frame written in the reference. The gradients
   * lie in rows, since a body that deforms is integrated at every step.
   */
  template <int dim>
  class ConductanceIntegrals
  {
  public:
    /** @param cells of the body; must outlive this object
     *  @param rows of their gradients, which must outlive it, too; empty: a
     *    copy of those in the table */
    explicit ConductanceIntegrals(const BasisTable<dim> &cells,
                                  const GradientRows    &rows = {});

    /**
     * @param element number of it in the table
     * @param u displacement, numbered by displacement_dof() [m]; must not fold
     *   the element
     * @return the integral for functions a and b at [a * stride(element) + b]
     *   [m^(dim - 2)], until the next call
     * @throws ComputationError if the element is folded
     */
    const double *
    integrate(const unsigned int element, const dealii::Vector<double> &u);

    unsigned int
    stride(const unsigned int element) const;

  private:
    /** Those of an element. */
    const double *
    gradient_rows(const unsigned int element) const;

    const BasisTable<dim>   &cells;
    GradientRows             rows;
    std::vector<std::size_t> first;     ///< by element, in gradients
    std::vector<double>      gradients; ///< unless there are rows
    std::vector<double>      work, block;
  };
} // namespace asperity

#endif
