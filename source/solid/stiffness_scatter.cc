#include <asperity/solid/stiffness_scatter.h>

namespace asperity
{
  namespace
  {
    /** Both components of a function. */
    using Pair = double
      __attribute__((vector_size(16), aligned(alignof(double)), may_alias));
  } // namespace



  template <int dim>
  void
  StiffnessScatter<dim>::find(
    const dealii::SparsityPattern                &pattern,
    const std::vector<std::vector<unsigned int>> &dofs)
  {
    const bool is_last =
      &pattern == last && pattern.n_nonzero_elements() == last_size;
    last      = &pattern;
    last_size = pattern.n_nonzero_elements();
    if (fits(pattern, dofs, is_last ? 1 : dofs.size()))
      return;
    entries.resize(dofs.size());
    for (std::size_t e = 0; e < dofs.size(); ++e)
      {
        entries[e].clear();
        for (std::size_t row = 0; row < dofs[e].size(); ++row)
          for (std::size_t column = 0; column < dofs[e].size(); ++column)
            if (column % dim == 0 || column / dim == row / dim)
              entries[e].push_back(pattern(dofs[e][row], dofs[e][column]));
      }
  }



  template <int dim>
  bool
  StiffnessScatter<dim>::fits(
    const dealii::SparsityPattern                &pattern,
    const std::vector<std::vector<unsigned int>> &dofs,
    const std::size_t                             n_elements) const
  {
    if (entries.size() != dofs.size())
      return false;
    for (std::size_t e = 0, n_found = 0;
         e < dofs.size() && n_found < n_elements;
         ++e)
      {
        if (dofs[e].empty())
          continue;
        ++n_found;
        // First row, last function; last row, first function.
        const std::size_t n = dofs[e].size() / dim, per_row = n - 1 + dim;
        if (pattern(dofs[e].front(),
                    dofs[e][n > 1 ? dim * (n - 1) : dim - 1]) !=
              entries[e][per_row - 1] ||
            pattern(dofs[e].back(), dofs[e].front()) !=
              entries[e][(dim * n - 1) * per_row])
          return false;
      }
    return true;
  }



  namespace
  {
    /** Adds the block of a function other than the row's own. */
    template <int dim>
    inline void
    add_block(const ElementStiffness<dim> &K, const double *from, double *to)
    {
      if constexpr (dim == 2)
        *(Pair *)to += *(const Pair *)from;
      else
        for (unsigned int l = 0; l < dim; ++l)
          to[l] += from[l * K.component_stride()];
    }
  } // namespace



  template <int dim>
  void
  StiffnessScatter<dim>::add(const unsigned int            element,
                             const ElementStiffness<dim>  &K,
                             dealii::SparseMatrix<double> &matrix) const
  {
    // The diagonal comes first in each row of a square matrix: that of the
    // first row is where its values start.
    double *const          values   = &matrix.diag_element(0);
    const unsigned int    *entry    = entries[element].data();
    constexpr unsigned int function = ElementStiffness<dim>::function_stride();
    for (unsigned int a = 0; a < K.size(); ++a)
      for (unsigned int i = 0; i < dim; ++i)
        {
          const double *const row = K.row(a, i);
          for (unsigned int b = 0; b < a; ++b)
            add_block(K, row + function * b, values + *entry++);
          for (unsigned int l = 0; l < dim; ++l)
            values[*entry++] += row[function * a + l * K.component_stride()];
          for (unsigned int b = a + 1; b < K.size(); ++b)
            add_block(K, row + function * b, values + *entry++);
        }
  }



  template class StiffnessScatter<2>;
  template class StiffnessScatter<3>;
} // namespace asperity
