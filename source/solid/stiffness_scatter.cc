#include <asperity/solid/stiffness_scatter.h>

namespace asperity
{
  namespace
  {
    /** Both components of a function. */
    using Pair = double
      __attribute__((vector_size(16), aligned(alignof(double)), may_alias));
  } // namespace



  void
  StiffnessScatter::find(const dealii::SparsityPattern                &pattern,
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
            if (column % 2 == 0 || column / 2 == row / 2)
              entries[e].push_back(pattern(dofs[e][row], dofs[e][column]));
      }
  }



  bool
  StiffnessScatter::fits(const dealii::SparsityPattern                &pattern,
                         const std::vector<std::vector<unsigned int>> &dofs,
                         const std::size_t n_elements) const
  {
    if (entries.size() != dofs.size())
      return false;
    for (std::size_t e = 0; e < n_elements; ++e)
      {
        // First row, last function; last row, first function.
        const std::size_t n = dofs[e].size() / 2;
        if (pattern(dofs[e].front(), dofs[e][n > 1 ? 2 * n - 2 : 1]) !=
              entries[e][n] ||
            pattern(dofs[e].back(), dofs[e].front()) !=
              entries[e][(2 * n - 1) * (n + 1)])
          return false;
      }
    return true;
  }



  void
  StiffnessScatter::add(const unsigned int            element,
                        const ElementStiffness       &K,
                        dealii::SparseMatrix<double> &matrix) const
  {
    // The diagonal comes first in each row of a square matrix: that of the
    // first row is where its values start.
    double *const       values   = &matrix.diag_element(0);
    const unsigned int *entry    = entries[element].data();
    const auto          add_pair = [&](const double *pair) {
      Pair &at = *(Pair *)(values + *entry++);
      at += *(const Pair *)pair;
    };
    for (unsigned int a = 0; a < K.size(); ++a)
      for (unsigned int i = 0; i < 2; ++i)
        {
          const double *const row = K.row(a, i);
          for (unsigned int b = 0; b < a; ++b)
            add_pair(row + 2 * b);
          values[*entry++] += row[2 * a];
          values[*entry++] += row[2 * a + 1];
          for (unsigned int b = a + 1; b < K.size(); ++b)
            add_pair(row + 2 * b);
        }
  }
} // namespace asperity
