#ifndef asperity_solvers_matrix_entries_h
#define asperity_solvers_matrix_entries_h

#include <deal.II/lac/sparse_matrix.h>

#include <vector>

namespace asperity
{
  /**
   * Adds to the entries of a matrix, the same ones in the same order in each
   * pass. Where they stand is looked up in the first pass only: the search
   * would cost several times as much as the addition.
   */
  class MatrixEntries
  {
  public:
    /** Begins a pass over a matrix. */
    void
    begin(dealii::SparseMatrix<double> &matrix)
    {
      const auto &new_pattern = matrix.get_sparsity_pattern();
      if (&new_pattern != pattern ||
          new_pattern.n_nonzero_elements() != n_entries)
        places.clear();
      pattern   = &new_pattern;
      n_entries = new_pattern.n_nonzero_elements();
      // The diagonal comes first in each row of a square matrix: that of the
      // first row is where its values start.
      values = &matrix.diag_element(0);
      next   = 0;
    }

    void
    add(const unsigned int row, const unsigned int column, const double value)
    {
      if (next == places.size())
        places.push_back((*pattern)(row, column));
      Assert(places[next] == (*pattern)(row, column),
             dealii::ExcMessage("The entries come in another order."));
      values[places[next++]] += value;
    }

    /** Of a row, as many numbers as columns. */
    void
    add(const unsigned int               row,
        const std::vector<unsigned int> &columns,
        const double                    *numbers)
    {
      if (next == places.size())
        for (const unsigned int column : columns)
          places.push_back((*pattern)(row, column));
      Assert(places[next] == (*pattern)(row, columns[0]),
             dealii::ExcMessage("The entries come in another order."));
      const unsigned int *const place = places.data() + next;
      for (unsigned int i = 0; i < columns.size(); ++i)
        values[place[i]] += numbers[i];
      next += columns.size();
    }

  private:
    const dealii::SparsityPattern *pattern   = nullptr;
    std::size_t                    n_entries = 0;
    double                        *values    = nullptr;
    std::vector<unsigned int>      places; ///< of the values
    std::size_t                    next = 0;
  };
} // namespace asperity

#endif
