#include <asperity/isogeometric/space_transfer.h>
#include <asperity/solid/state_transfer.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    using Symmetric = dealii::SymmetricTensor<2, 3>;

    /** f(lambda) in place of the eigenvalues. */
    template <typename Function>
    Symmetric
    of_eigenvalues(const Symmetric &tensor, const Function &f)
    {
      Symmetric result;
      for (const auto &[value, direction] :
           eigenvectors(tensor,
                        dealii::SymmetricTensorEigenvectorMethod::jacobi))
        result += f(value) * symmetrize(outer_product(direction, direction));
      return result;
    }

    constexpr unsigned int n_components = 5;

    void
    append(const MaterialState &state, std::vector<double> &values)
    {
      const Symmetric log =
        of_eigenvalues(state.Cp_inverse,
                       [](const double x) { return std::log(x); });
      values.insert(values.end(),
                    {log[0][0],
                     log[1][1],
                     log[0][1],
                     state.plastic_strain,
                     state.temperature});
    }

    MaterialState
    state_of(const double *values)
    {
      Symmetric log;
      log[0][0] = values[0];
      log[1][1] = values[1];
      log[0][1] = values[2];
      log[2][2] = -values[0] - values[1]; // the determinant stays one
      MaterialState state;
      state.Cp_inverse =
        of_eigenvalues(log, [](const double x) { return std::exp(x); });
      state.plastic_strain = values[3];
      state.temperature    = values[4];
      return state;
    }
  } // namespace



  std::vector<MaterialState>
  transfer_states(const SplineHierarchy<2>         &from,
                  const SplineHierarchy<2>         &to,
                  const dealii::Quadrature<2>      &quadrature,
                  const std::vector<MaterialState> &states)
  {
    std::vector<double> old_values;
    old_values.reserve(n_components * states.size());
    for (const MaterialState &state : states)
      append(state, old_values);
    const std::vector<double> values =
      transfer_history(from, to, quadrature, old_values, n_components);

    const unsigned int         n_q = quadrature.size();
    std::vector<MaterialState> result;
    result.reserve(to.n_cells() * n_q);
    for (unsigned int cell = 0; cell < to.n_cells(); ++cell)
      {
        // A logarithm and back would change the last digit.
        const CellIndex<2> &index = to.cell_index(cell);
        const int           old   = from.nodes()[from.find_node(index)].cell;
        const bool          kept  = old >= 0 && from.cell_index(old) == index;
        for (unsigned int q = 0; q < n_q; ++q)
          result.push_back(
            kept ? states[old * n_q + q] :
                   state_of(&values[(cell * n_q + q) * n_components]));
      }
    return result;
  }
} // namespace asperity
