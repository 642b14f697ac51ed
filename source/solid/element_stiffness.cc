#include <asperity/base/vector_widths.h>
#include <asperity/solid/element_stiffness.h>

namespace asperity
{
  namespace
  {
    /** Neighbours in a row, which become one instruction. */
    using Pack = double
      __attribute__((vector_size(32), aligned(alignof(double)), may_alias));

    /** Rows are padded to a multiple of this. */
    constexpr unsigned int padding = sizeof(Pack) / sizeof(double);

    // Row and column of the components of P in plane kinematics, and the hoop.
    constexpr unsigned int row_of[]    = {0, 0, 1, 1, 2};
    constexpr unsigned int column_of[] = {0, 1, 0, 1, 2};



    /** y = a x_1 + b x_2 */
    ASPERITY_ALL_VECTOR_WIDTHS
    void
    combine(const unsigned int n,
            const double       a,
            const double      *x_1,
            const double       b,
            const double      *x_2,
            double            *y)
    {
      for (unsigned int k = 0; k < n; k += padding)
        *(Pack *)(y + k) =
          a * *(const Pack *)(x_1 + k) + b * *(const Pack *)(x_2 + k);
    }



    /** K_ab += u_a x_b + v_a y_b for a < n, b < stride. */
    ASPERITY_ALL_VECTOR_WIDTHS
    void
    add_products(const unsigned int n,
                 const unsigned int stride,
                 const double      *u,
                 const double      *x,
                 const double      *v,
                 const double      *y,
                 double            *K)
    {
      for (unsigned int b = 0; b < stride; b += padding)
        {
          const Pack x_b = *(const Pack *)(x + b), y_b = *(const Pack *)(y + b);
          for (unsigned int a = 0; a < n; ++a)
            *(Pack *)(K + a * stride + b) += u[a] * x_b + v[a] * y_b;
        }
    }
  } // namespace



  void
  ElementStiffness::start(const unsigned int n_functions,
                          const bool         is_axisymmetric)
  {
    n            = n_functions;
    stride       = (n + padding - 1) / padding * padding;
    axisymmetric = is_axisymmetric;
    for (auto *values : {&gradients_.x, &gradients_.y, &gradients_.hoop, &zero})
      values->assign(stride, 0.);
    for (auto &column : columns)
      column.resize(stride);
    for (auto &block : blocks)
      block.assign(n * stride, 0.);
  }



  ElementStiffness::Gradients &
  ElementStiffness::gradients()
  {
    return gradients_;
  }



  void
  ElementStiffness::add(const dealii::Tensor<4, 3> &dP_dF, const double weight)
  {
    const double *const x = gradients_.x.data(), *const y = gradients_.y.data(),
                        *const hoop = gradients_.hoop.data();
    for (unsigned int c = 0; c < (axisymmetric ? 5u : 4u); ++c)
      for (unsigned int l = 0; l < 2; ++l)
        {
          const dealii::Tensor<2, 3> &by_F   = dP_dF[row_of[c]][column_of[c]];
          std::vector<double>        &column = columns[2 * c + l];
          const double a_x = weight * by_F[l][0], a_y = weight * by_F[l][1];
          combine(stride, a_x, x, a_y, y, &column[0]);
          if (axisymmetric && l == 0)
            combine(
              stride, weight * by_F[2][2], hoop, 1., &column[0], &column[0]);
        }
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int l = 0; l < 2; ++l)
        {
          const double *const        P_ix  = columns[4 * i + l].data(),
                              *const P_iy  = columns[4 * i + 2 + l].data();
          double *const              block = blocks[2 * i + l].data();
          add_products(n, stride, x, P_ix, y, P_iy, block);
          if (axisymmetric && i == 0)
            add_products(
              n, stride, hoop, columns[8 + l].data(), zero.data(), x, block);
        }
  }



  void
  StiffnessScatter::find(const dealii::SparsityPattern                &pattern,
                         const std::vector<std::vector<unsigned int>> &dofs)
  {
    if (fits(pattern, dofs))
      return;
    entries.resize(dofs.size());
    for (std::size_t e = 0; e < dofs.size(); ++e)
      {
        entries[e].clear();
        for (const unsigned int row : dofs[e])
          for (const unsigned int column : dofs[e])
            entries[e].push_back(pattern(row, column));
      }
  }



  bool
  StiffnessScatter::fits(
    const dealii::SparsityPattern                &pattern,
    const std::vector<std::vector<unsigned int>> &dofs) const
  {
    if (entries.size() != dofs.size())
      return false;
    for (std::size_t e = 0; e < dofs.size(); ++e)
      if (pattern(dofs[e].front(), dofs[e].back()) !=
            entries[e][dofs[e].size() - 1] ||
          pattern(dofs[e].back(), dofs[e].front()) !=
            entries[e][entries[e].size() - dofs[e].size()])
        return false;
    return true;
  }



  void
  StiffnessScatter::add(const unsigned int            element,
                        const ElementStiffness       &K,
                        dealii::SparseMatrix<double> &matrix) const
  {
    // The diagonal comes first in each row of a square matrix: that of the
    // first row is where its values start.
    double *const       values = &matrix.diag_element(0);
    const unsigned int *entry  = entries[element].data();
    for (unsigned int a = 0; a < K.size(); ++a)
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int b = 0; b < K.size(); ++b)
          for (unsigned int l = 0; l < 2; ++l)
            values[*entry++] += K(a, i, b, l);
  }
} // namespace asperity
