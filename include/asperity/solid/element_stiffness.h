#ifndef asperity_solid_element_stiffness_h
#define asperity_solid_element_stiffness_h

#include <deal.II/base/tensor.h>
#include <deal.II/lac/sparse_matrix.h>

#include <array>
#include <vector>

namespace asperity
{
  /**
   * Stiffness of one element, K_aibl = integral of dN_a/dX_J dP_iJ/dF_lM
   * dN_b/dX_M [N/m^2 per metre of thickness; N/m if axisymmetric], summed point
   * by point.
   *
   * The functions' index runs fastest and is padded, so that the innermost
   * loops are vector instructions of the widest kind that the processor has.
   */
  class ElementStiffness
  {
  public:
    /** Derivatives of the functions at one point, padded by zeros; hoop: N_a
     *  over the radius. */
    struct Gradients
    {
      std::vector<double> x, y, hoop;
    };

    /** A new element, of zero stiffness. */
    void
    start(const unsigned int n_functions, const bool axisymmetric);

    /** Derivatives at a point that the caller fills, one entry a function. */
    Gradients &
    gradients();

    /** K += weight dP/dF : (Grad N_a, Grad N_b) at gradients(). */
    void
    add(const dealii::Tensor<4, 3> &dP_dF, const double weight);

    /** Number of functions. */
    unsigned int
    size() const
    {
      return n;
    }

    double
    operator()(const unsigned int a,
               const unsigned int i,
               const unsigned int b,
               const unsigned int l) const
    {
      return blocks[2 * i + l][a * stride + b];
    }

  private:
    unsigned int n            = 0;
    unsigned int stride       = 0; ///< n, padded
    bool         axisymmetric = false;
    Gradients    gradients_;

    std::vector<double> zero;

    /** [2 * component of P + l][b]: derivative of that component times weight
     *  with respect to displacement component l of function b. */
    std::array<std::vector<double>, 10> columns;

    /** [2 i + l][a * stride + b] */
    std::array<std::vector<double>, 4> blocks;
  };



  /**
   * Adds element stiffnesses to a matrix. Where their entries stand is looked
   * up once for all elements, not at every assembly: the search would cost a
   * tenth of a run.
   */
  class StiffnessScatter
  {
  public:
    /** Finds the entries of all elements, unless corners of the stiffnesses
     *  stand where they were found last: then the pattern is the same.
     *  @param dofs unknowns of each element, [2 a + component] */
    void
    find(const dealii::SparsityPattern                &pattern,
         const std::vector<std::vector<unsigned int>> &dofs);

    void
    add(const unsigned int            element,
        const ElementStiffness       &K,
        dealii::SparseMatrix<double> &matrix) const;

  private:
    bool
    fits(const dealii::SparsityPattern                &pattern,
         const std::vector<std::vector<unsigned int>> &dofs) const;

    /** Of each element: [(2 a + i) 2 n + 2 b + l], among all entries. */
    std::vector<std::vector<unsigned int>> entries;
  };
} // namespace asperity

#endif
