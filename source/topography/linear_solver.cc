#include <asperity/base/errors.h>
#include <asperity/topography/linear_solver.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  SkylineMatrix::SkylineMatrix(const std::vector<unsigned int> &first)
    : first(first)
  {
    for (unsigned int i = 0; i < first.size(); ++i)
      rows.emplace_back(i + 1 - first[i], 0.);
  }

  void
  SkylineMatrix::add(const unsigned int i,
                     const unsigned int j,
                     const double       value)
  {
    const unsigned int row    = std::max(i, j);
    const unsigned int column = std::min(i, j);
    rows[row].at(column - first[row]) += value;
  }

  std::vector<double>
  SkylineMatrix::factorize_and_solve(std::vector<double> b)
  {
    const unsigned int n = rows.size();
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = first[i]; j <= i; ++j)
        {
          double             value = rows[i][j - first[i]];
          const unsigned int begin = std::max(first[i], first[j]);
          for (unsigned int k = begin; k < j; ++k)
            value -= rows[i][k - first[i]] * rows[j][k - first[j]];
          if (j < i)
            rows[i][j - first[i]] = value / rows[j].back();
          else if (value > 1e-15 * rows[i].back())
            rows[i].back() = std::sqrt(value);
          else
            throw ComputationError("Least squares: the normal equations are "
                                   "singular in unknown " +
                                   std::to_string(i) + ".");
        }
    for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int k = first[i]; k < i; ++k)
          b[i] -= rows[i][k - first[i]] * b[k];
        b[i] /= rows[i].back();
      }
    for (unsigned int i = n; i-- > 0;)
      {
        b[i] /= rows[i].back();
        for (unsigned int k = first[i]; k < i; ++k)
          b[k] -= rows[i][k - first[i]] * b[i];
      }
    return b;
  }
} // namespace asperity
