#include <asperity/solvers/matrix_entries.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
  using namespace asperity;
  using Matrix = dealii::SparseMatrix<double>;

  dealii::SparsityPattern
  band(const unsigned int n, const unsigned int width)
  {
    dealii::DynamicSparsityPattern couplings(n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = i - std::min(i, width); j < std::min(n, i + width);
           ++j)
        couplings.add(i, j);
    dealii::SparsityPattern result;
    result.copy_from(couplings);
    return result;
  }
} // namespace



TEST(MatrixEntries, adds_in_each_pass_where_the_matrix_would)
{
  const auto    narrow = band(9, 2), wide = band(9, 4);
  MatrixEntries entries;
  for (const auto *pattern : {&narrow, &narrow, &wide, &narrow})
    {
      Matrix matrix(*pattern), expected(*pattern);
      for (const double phase : {0., 1.})
        {
          entries.begin(matrix);
          for (unsigned int k = 0; k < 40; ++k)
            {
              const unsigned int row    = (7 * k) % 9,
                                 column = std::min(8u, row + k % 2);
              const double value        = std::sin(k + phase);
              entries.add(row, column, value);
              expected.add(row, column, value);
            }
          const std::vector<unsigned int> columns = {4, 3, 5};
          const std::vector<double>       numbers = {1.5, -2., phase};
          entries.add(4, columns, numbers.data());
          for (unsigned int i = 0; i < 3; ++i)
            expected.add(4, columns[i], numbers[i]);
        }
      for (const auto &entry : expected)
        EXPECT_EQ(matrix.el(entry.row(), entry.column()), entry.value());
    }
}
