#include <asperity/flow/shape_table.h>

namespace asperity
{
  ShapeTable::ShapeTable(const dealii::FiniteElement<2>      &fe,
                         const std::vector<dealii::Point<2>> &points,
                         const bool with_second_derivatives)
    : n(fe.n_dofs_per_cell())
  {
    for (const auto &xi : points)
      for (unsigned int a = 0; a < n; ++a)
        {
          values_.push_back(fe.shape_value(a, xi));
          gradients_.push_back(fe.shape_grad(a, xi));
          if (with_second_derivatives)
            second_derivatives_.push_back(fe.shape_grad_grad(a, xi));
        }
  }



  CellUnknowns::CellUnknowns(const dealii::FiniteElement<2> &fe)
    : dofs_(fe.n_dofs_per_cell())
    , functions_(fe.n_components())
  {
    for (unsigned int c = 0; c < functions_.size(); ++c)
      for (unsigned int a = 0; a < fe.get_sub_fe(c, 1).n_dofs_per_cell(); ++a)
        functions_[c].push_back(fe.component_to_system_index(c, a));
  }



  void
  CellUnknowns::reinit(const FluidSpace::Cell &cell)
  {
    cell->get_dof_indices(dofs_);
  }



  void
  CellUnknowns::extract(const dealii::Vector<double> &field,
                        NodalVectors                 &nodal) const
  {
    nodal.resize(functions_[0].size());
    for (unsigned int a = 0; a < nodal.size(); ++a)
      for (unsigned int i = 0; i < 2; ++i)
        nodal[a][i] = field(dofs_[functions_[i][a]]);
  }



  void
  CellUnknowns::extract(const dealii::Vector<double> &field,
                        const unsigned int            component,
                        std::vector<double>          &nodal) const
  {
    nodal.resize(functions_[component].size());
    for (unsigned int k = 0; k < nodal.size(); ++k)
      nodal[k] = field(dofs_[functions_[component][k]]);
  }
} // namespace asperity
