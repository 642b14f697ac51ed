#ifndef asperity_solid_stiffness_scatter_h
#define asperity_solid_stiffness_scatter_h

#include <asperity/solid/element_stiffness.h>

#include <deal.II/lac/sparse_matrix.h>

#include <vector>

namespace asperity
{
  /**
   * Adds element stiffnesses to a matrix. Where their entries stand is looked
   * up once for all elements, not at every assembly: the search would cost a
   * tenth of a run.
   */
  template <int dim>
  class StiffnessScatter
  {
  public:
    /** Finds the entries of all elements, unless corners of the stiffnesses
     *  stand where they were found last: then the pattern is the same. In the
     *  place and of the size of the last one, the first element decides.
     *  @param dofs unknowns of each element, [dim a + component], those of a
     *   function one after the other and in rising order; none where an element
     *   is not added */
    void
    find(const dealii::SparsityPattern                &pattern,
         const std::vector<std::vector<unsigned int>> &dofs);

    void
    add(const unsigned int            element,
        const ElementStiffness<dim>  &K,
        dealii::SparseMatrix<double> &matrix) const;

  private:
    bool
    fits(const dealii::SparsityPattern                &pattern,
         const std::vector<std::vector<unsigned int>> &dofs,
         const std::size_t                             n_elements) const;

    /** Of each element, for each of its rows [dim a + i], among all entries:
     *  where those of b = 0, 1, ... begin, of which the others follow the
     *  first; for b = a, where the diagonal is elsewhere, all. */
    std::vector<std::vector<unsigned int>> entries;

    const dealii::SparsityPattern *last      = nullptr; ///< only to compare
    std::size_t                    last_size = 0;
  };
} // namespace asperity

#endif
