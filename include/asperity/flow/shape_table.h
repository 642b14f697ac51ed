#ifndef asperity_flow_shape_table_h
#define asperity_flow_shape_table_h

#include <asperity/flow/fluid_space.h>
#include <asperity/flow/wall_nodes.h>

#include <array>
#include <vector>

namespace asperity
{
  /**
   * The functions of a scalar element at points of the reference cell. They are
   * the same for all cells, so one table serves a whole mesh, also while it
   * moves; FEValues would evaluate and copy them for each cell anew.
   */
  class ShapeTable
  {
  public:
    ShapeTable(const dealii::FiniteElement<2>      &fe,
               const std::vector<dealii::Point<2>> &points,
               const bool with_second_derivatives = false);

    unsigned int
    n_functions() const
    {
      return n;
    }

    /** Of the functions in turn, at a point. */
    const double *
    values(const unsigned int q) const
    {
      return &values_[q * n];
    }

    /** By the coordinates of the reference cell. */
    const dealii::Tensor<1, 2> *
    gradients(const unsigned int q) const
    {
      return &gradients_[q * n];
    }

    const dealii::Tensor<2, 2> *
    second_derivatives(const unsigned int q) const
    {
      return &second_derivatives_[q * n];
    }

    /** A field at a point, from its nodal values in a cell. */
    template <typename T>
    T
    value(const unsigned int q, const std::vector<T> &nodal) const
    {
      const double *const N = values(q);
      T                   sum{};
      for (unsigned int a = 0; a < n; ++a)
        sum += N[a] * nodal[a];
      return sum;
    }

    /** [i][j] = d v_i/d xi_j */
    dealii::Tensor<2, 2>
    gradient(const unsigned int q, const NodalVectors &nodal) const
    {
      const dealii::Tensor<1, 2> *const g = gradients(q);
      dealii::Tensor<2, 2>              sum;
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int i = 0; i < 2; ++i)
          sum[i] += nodal[a][i] * g[a];
      return sum;
    }

  private:
    unsigned int                      n;
    std::vector<double>               values_;
    std::vector<dealii::Tensor<1, 2>> gradients_;
    std::vector<dealii::Tensor<2, 2>> second_derivatives_;
  };



  /** The unknowns of a cell by component: the nodal values of fields in it. */
  class CellUnknowns
  {
  public:
    explicit CellUnknowns(const dealii::FiniteElement<2> &fe);

    void
    reinit(const FluidSpace::Cell &cell);

    /** In the order of the element. */
    const std::vector<dealii::types::global_dof_index> &
    dofs() const
    {
      return dofs_;
    }

    /** Functions of the element that belong to a component, in the order of
     *  its scalar element. */
    const std::vector<unsigned int> &
    functions(const unsigned int component) const
    {
      return functions_[component];
    }

    /** Components 0 and 1 of a field. */
    void
    extract(const dealii::Vector<double> &field, NodalVectors &nodal) const;

    /** One component of a field. */
    void
    extract(const dealii::Vector<double> &field,
            const unsigned int            component,
            std::vector<double>          &nodal) const;

  private:
    std::vector<dealii::types::global_dof_index> dofs_;
    std::vector<std::vector<unsigned int>>       functions_;
  };
} // namespace asperity

#endif
