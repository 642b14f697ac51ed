#include <asperity/isogeometric/space_transfer.h>
#include <asperity/solid/state_transfer.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity
{
  namespace
  {
    using dealii::Tensor;
    using Symmetric = dealii::SymmetricTensor<2, 3>;

    constexpr unsigned int n_scalars = 2;

    /** Components of a strain that do not vanish, in the order in which they go
     *  over: those of plane and axisymmetric kinematics come first. */
    constexpr std::pair<unsigned int, unsigned int> components[] =
      {{0, 0}, {1, 1}, {0, 1}, {2, 2}, {0, 2}, {1, 2}};

    constexpr unsigned int
    n_strains(const unsigned int dim)
    {
      return dim == 2 ? 4 : 6;
    }

    /** Below it a change of F is rounding. */
    constexpr double smallest_change = 1e-12;

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

    /** A C A^T */
    Symmetric
    push_forward(const Tensor<2, 3> &A, const Symmetric &C)
    {
      return symmetrize(A * Tensor<2, 3>(C) * transpose(A));
    }

    bool
    has_yielded(const MaterialState &state)
    {
      return state.Cp_inverse != dealii::unit_symmetric_tensor<3>();
    }

    /** Of a point that is in both meshes: under another F it keeps its elastic
     *  strain, which follows F until it yields. */
    MaterialState
    kept_state(const MaterialState &old,
               const Tensor<2, 3>  &F_before,
               const Tensor<2, 3>  &F_after)
    {
      MaterialState      state = old;
      const Tensor<2, 3> A     = invert(F_after) * F_before;
      if (has_yielded(old) &&
          (A - Tensor<2, 3>(dealii::unit_symmetric_tensor<3>())).norm() >
            smallest_change)
        state.Cp_inverse = push_forward(A, old.Cp_inverse);
      return state;
    }

    /** Plastic strain and temperature of each point. */
    std::vector<double>
    scalars_of(const std::vector<MaterialState> &states)
    {
      std::vector<double> scalars;
      scalars.reserve(n_scalars * states.size());
      for (const MaterialState &state : states)
        scalars.insert(scalars.end(),
                       {state.plastic_strain, state.temperature});
      return scalars;
    }

    /** Twice the logarithmic elastic strain of each point. */
    std::vector<double>
    elastic_strains(const std::vector<MaterialState> &states,
                    const std::vector<Tensor<2, 3>>  &F,
                    const unsigned int                n)
    {
      std::vector<double> strains;
      strains.reserve(n * states.size());
      for (std::size_t q = 0; q < states.size(); ++q)
        {
          const Symmetric log =
            of_eigenvalues(push_forward(F[q], states[q].Cp_inverse),
                           [](const double b) { return std::log(b); });
          for (unsigned int k = 0; k < n; ++k)
            strains.push_back(log[components[k].first][components[k].second]);
        }
      return strains;
    }

    /** C_p^{-1} of a point from its elastic strain, as above, and its F. */
    Symmetric
    Cp_inverse(const double       *strain,
               const unsigned int  n,
               const Tensor<2, 3> &F)
    {
      Symmetric log;
      for (unsigned int k = 0; k < n; ++k)
        log[components[k].first][components[k].second] = strain[k];
      return push_forward(invert(F), of_eigenvalues(log, [](const double x) {
                            return std::exp(x);
                          }));
    }
  } // namespace



  template <int dim>
  std::vector<MaterialState>
  transfer_states(const SplineHierarchy<dim>       &from,
                  const SplineHierarchy<dim>       &to,
                  const dealii::Quadrature<dim>    &quadrature,
                  const std::vector<MaterialState> &states,
                  const std::vector<Tensor<2, 3>>  &F_before,
                  const std::vector<Tensor<2, 3>>  &F_after)
  {
    const unsigned int     n_q = quadrature.size();
    constexpr unsigned int n   = n_strains(dim);
    AssertDimension(F_before.size(), states.size());
    AssertDimension(F_after.size(), to.n_cells() * n_q);
    const auto transferred = [&](const std::vector<double> &values,
                                 const unsigned int         n_components,
                                 const HistoryRange         range) {
      return transfer_history(
        from, to, quadrature, values, n_components, 2, range);
    };
    const std::vector<double> scalars =
      transferred(scalars_of(states), n_scalars, HistoryRange::body);
    const std::vector<double> strains =
      transferred(elastic_strains(states, F_before, n), n, HistoryRange::none);
    // Where nothing has yielded the elastic strain is that of F.
    std::vector<double> yielded;
    for (const MaterialState &state : states)
      yielded.push_back(has_yielded(state) ? 1. : 0.);
    yielded = transferred(yielded, 1, HistoryRange::cell);

    std::vector<MaterialState> result(F_after.size());
    for (std::size_t q = 0; q < result.size(); ++q)
      {
        const CellIndex<dim> &index = to.cell_index(q / n_q);
        const int             old   = from.nodes()[from.find_node(index)].cell;
        if (old >= 0 && from.cell_index(old) == index)
          {
            const std::size_t same = old * n_q + q % n_q;
            result[q] = kept_state(states[same], F_before[same], F_after[q]);
            continue;
          }
        result[q].plastic_strain = scalars[n_scalars * q];
        result[q].temperature    = scalars[n_scalars * q + 1];
        if (yielded[q] > 0.)
          result[q].Cp_inverse = Cp_inverse(&strains[n * q], n, F_after[q]);
      }
    return result;
  }



  template std::vector<MaterialState>
  transfer_states(const SplineHierarchy<2> &,
                  const SplineHierarchy<2> &,
                  const dealii::Quadrature<2> &,
                  const std::vector<MaterialState> &,
                  const std::vector<Tensor<2, 3>> &,
                  const std::vector<Tensor<2, 3>> &);
  template std::vector<MaterialState>
  transfer_states(const SplineHierarchy<3> &,
                  const SplineHierarchy<3> &,
                  const dealii::Quadrature<3> &,
                  const std::vector<MaterialState> &,
                  const std::vector<Tensor<2, 3>> &,
                  const std::vector<Tensor<2, 3>> &);
} // namespace asperity
