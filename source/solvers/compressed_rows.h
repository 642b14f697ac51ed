#ifndef asperity_source_solvers_compressed_rows_h
#define asperity_source_solvers_compressed_rows_h

#include <deal.II/lac/sparse_matrix.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace asperity
{
  /**
   * A deal.II matrix as compressed rows with sorted columns, which
   * SuiteSparse reads as the compressed columns of the transpose. deal.II
   * stores the diagonal first, so the slots are found once a pattern.
   */
  class CompressedRows
  {
  public:
    void
    reset()
    {
      row_start.clear();
    }

    /** @return true if the pattern was built anew. */
    bool
    update(const dealii::SparseMatrix<double> &matrix)
    {
      const bool is_new = row_start.empty();
      if (is_new)
        build_pattern(matrix);
      std::size_t k    = 0;
      double      zero = 0.;
      for (const auto &entry : matrix)
        {
          values[slot[k++]] = entry.value();
          zero += 0. * entry.value();
        }
      is_finite = (zero == 0.);
      return is_new;
    }

    int
    n() const
    {
      return static_cast<int>(row_start.size()) - 1;
    }

    std::vector<int>    row_start, column;
    std::vector<double> values;
    bool                is_finite = true; ///< the values of the last update

  private:
    void
    build_pattern(const dealii::SparseMatrix<double> &matrix)
    {
      row_start.assign(1, 0);
      column.clear();
      slot.clear();
      std::vector<std::pair<int, int>> row; // column, position in the row
      for (unsigned int r = 0; r < matrix.m(); ++r)
        {
          row.clear();
          for (auto entry = matrix.begin(r); entry != matrix.end(r); ++entry)
            row.emplace_back(entry->column(), row.size());
          std::sort(row.begin(), row.end());
          slot.resize(slot.size() + row.size());
          for (unsigned int i = 0; i < row.size(); ++i)
            {
              slot[row_start.back() + row[i].second] = row_start.back() + i;
              column.push_back(row[i].first);
            }
          row_start.push_back(column.size());
        }
      values.resize(column.size());
    }

    std::vector<int> slot; ///< deal.II's k-th entry -> index into values
  };
} // namespace asperity

#endif
