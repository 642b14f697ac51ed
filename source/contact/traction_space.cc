#include <asperity/contact/traction_space.h>
#include <asperity/isogeometric/element_view.h>
#include <asperity/isogeometric/spline_space.h>

#include <algorithm>
#include <set>

namespace asperity
{
  using dealii::Tensor;
  using Matrix = dealii::SparseMatrix<double>;

  template <int dim>
  TractionSpace<dim>::TractionSpace(const SplineSpace<dim>  &space,
                                    const BasisTable<dim>   &table,
                                    const Edge               edge,
                                    const ContactFormulation formulation,
                                    const CellShare         &share)
    : formulation_(formulation)
    , table(table)
    , edge_functions(space.edge_functions(edge))
    , neighbours(edge_functions.size())
    , own_functions(edge_functions.size(), false)
  {
    std::vector<std::set<unsigned int>> overlap(edge_functions.size());
    for (const auto &entry : table.elements)
      {
        const ElementView<dim>    element(table, entry);
        std::vector<unsigned int> functions, columns;
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          {
            const auto found = std::lower_bound(edge_functions.begin(),
                                                edge_functions.end(),
                                                element.function(a));
            if (found == edge_functions.end() || *found != element.function(a))
              continue;
            functions.push_back(found - edge_functions.begin());
            columns.push_back(a);
          }
        own_elements.push_back(share.is_own(entry.cell));
        for (const unsigned int a : functions)
          {
            if (overlap[a].empty())
              own_functions[a] = own_elements.back();
            overlap[a].insert(functions.begin(), functions.end());
          }
        element_functions.push_back(functions);
        element_columns.push_back(columns);
      }
    for (unsigned int a = 0; a < overlap.size(); ++a)
      neighbours[a].assign(overlap[a].begin(), overlap[a].end());
    weight.assign(size(), 0.);
    for_each_value([&](const unsigned int q, const unsigned int a, double psi) {
      weight[a] += psi * table.JxW[q];
    });
  }



  template <int dim>
  unsigned int
  TractionSpace<dim>::size() const
  {
    return formulation_ == ContactFormulation::mortar ? edge_functions.size() :
                                                        table.JxW.size();
  }



  template <int dim>
  ContactFormulation
  TractionSpace<dim>::formulation() const
  {
    return formulation_;
  }



  template <int dim>
  template <typename Action>
  void
  TractionSpace<dim>::for_each_value(const Action &action) const
  {
    if (formulation_ == ContactFormulation::gauss_point)
      {
        for (unsigned int q = 0; q < table.JxW.size(); ++q)
          action(q, q, 1.);
        return;
      }
    for (unsigned int e = 0; e < table.elements.size(); ++e)
      {
        const ElementView<dim> element(table, table.elements[e]);
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          for (unsigned int i = 0; i < element_functions[e].size(); ++i)
            action(element.point(q),
                   element_functions[e][i],
                   element.N(q, element_columns[e][i]));
      }
  }



  template <int dim>
  std::vector<double>
  TractionSpace<dim>::means(const std::vector<double> &at_points) const
  {
    std::vector<double> mean(size(), 0.);
    for_each_value([&](const unsigned int q, const unsigned int a, double psi) {
      mean[a] += psi * at_points[q] * table.JxW[q];
    });
    for (unsigned int a = 0; a < mean.size(); ++a)
      mean[a] /= weight[a];
    return mean;
  }



  template <int dim>
  std::vector<double>
  TractionSpace<dim>::at_points(const std::vector<double> &tractions) const
  {
    std::vector<double> values(table.JxW.size(), 0.);
    for_each_value([&](const unsigned int q, const unsigned int a, double psi) {
      values[q] += psi * tractions[a];
    });
    return values;
  }



  template <int dim>
  std::vector<bool>
  TractionSpace<dim>::inside(const std::vector<double> &tractions) const
  {
    std::vector<bool> result(table.JxW.size(), true);
    for_each_value([&](const unsigned int q, const unsigned int a, double) {
      if (tractions[a] <= 0.)
        result[q] = false;
    });
    return result;
  }



  template <int dim>
  void
  TractionSpace<dim>::add_couplings(
    dealii::DynamicSparsityPattern &pattern) const
  {
    const auto couple = [&](const std::vector<unsigned int> &indices) {
      for (const unsigned int a : indices)
        for (const unsigned int b : indices)
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              pattern.add(displacement_dof<dim>(edge_functions[a], i),
                          displacement_dof<dim>(edge_functions[b], j));
    };
    if (formulation_ == ContactFormulation::mortar)
      for (unsigned int a = 0; a < neighbours.size(); ++a)
        if (own_functions[a])
          couple(neighbours[a]);
    for (unsigned int e = 0; e < element_functions.size(); ++e)
      if (own_elements[e])
        couple(element_functions[e]);
  }



  template <int dim>
  void
  TractionSpace<dim>::add_stiffness(const std::vector<double> &factors,
                                    const Vectors             &v,
                                    const Vectors             &w,
                                    Matrix                    &tangent) const
  {
    if (formulation_ == ContactFormulation::mortar)
      add_mortar_stiffness(factors, v, w, tangent);
    else
      add_pointwise(factors, v, w, tangent);
  }



  template <int dim>
  std::vector<typename TractionSpace<dim>::Vectors>
  TractionSpace<dim>::moments(const std::vector<double> &factors,
                              const Vectors             &v) const
  {
    std::vector<Vectors> h(edge_functions.size());
    for (unsigned int a = 0; a < h.size(); ++a)
      if (factors[a] != 0. && own_functions[a])
        h[a].resize(neighbours[a].size());
    for (unsigned int e = 0; e < table.elements.size(); ++e)
      {
        const ElementView<dim> element(table, table.elements[e]);
        const auto            &functions = element_functions[e];
        const auto            &columns   = element_columns[e];
        for (unsigned int i = 0; i < functions.size(); ++i)
          {
            const unsigned int a = functions[i];
            if (h[a].empty())
              continue;
            for (unsigned int j = 0; j < functions.size(); ++j)
              {
                const unsigned int slot =
                  std::lower_bound(neighbours[a].begin(),
                                   neighbours[a].end(),
                                   functions[j]) -
                  neighbours[a].begin();
                for (unsigned int q = 0; q < table.points_per_element; ++q)
                  h[a][slot] += element.N(q, columns[i]) *
                                element.N(q, columns[j]) * element.JxW(q) *
                                v[element.point(q)];
              }
          }
      }
    return h;
  }



  template <int dim>
  void
  TractionSpace<dim>::add_mortar_stiffness(const std::vector<double> &factors,
                                           const Vectors             &v,
                                           const Vectors             &w,
                                           Matrix &tangent) const
  {
    const std::vector<Vectors> of_v = moments(factors, v);
    const bool                 same = (&v == &w);
    const std::vector<Vectors> other =
      same ? std::vector<Vectors>() : moments(factors, w);
    const std::vector<Vectors> &of_w = same ? of_v : other;
    std::vector<unsigned int>   dofs;
    std::vector<double>         row;
    for (unsigned int a = 0; a < of_v.size(); ++a)
      {
        const unsigned int n = of_v[a].size();
        dofs.resize(dim * n);
        row.resize(dim * n);
        for (unsigned int m = 0; m < dim * n; ++m)
          dofs[m] =
            displacement_dof<dim>(edge_functions[neighbours[a][m / dim]],
                                  m % dim);
        for (unsigned int k = 0; k < dim * n; ++k)
          {
            const double of_row =
              factors[a] / weight[a] * of_v[a][k / dim][k % dim];
            for (unsigned int l = 0; l < dim * n; ++l)
              row[l] = of_row * of_w[a][l / dim][l % dim];
            tangent.add(dofs[k], dim * n, dofs.data(), row.data());
          }
      }
  }



  template <int dim>
  void
  TractionSpace<dim>::add_pointwise(const std::vector<double> &factors,
                                    const Vectors             &v,
                                    const Vectors             &w,
                                    Matrix                    &tangent) const
  {
    for (unsigned int e = 0; e < table.elements.size(); ++e)
      if (own_elements[e])
        add_pointwise_of(e, factors, v, w, tangent);
  }



  template <int dim>
  void
  TractionSpace<dim>::add_pointwise_of(const unsigned int         e,
                                       const std::vector<double> &factors,
                                       const Vectors             &v,
                                       const Vectors             &w,
                                       Matrix                    &tangent) const
  {
    const ElementView<dim> element(table, table.elements[e]);
    const auto            &columns = element_columns[e];
    const unsigned int     n       = dim * columns.size();
    std::vector<double>    block;
    for (unsigned int q = 0; q < table.points_per_element; ++q)
      {
        const unsigned int point  = element.point(q);
        const double       factor = factors[point] * element.JxW(q);
        if (factor == 0.)
          continue;
        block.resize(n * n, 0.);
        for (unsigned int row = 0; row < n; ++row)
          {
            const double of_row =
              factor * element.N(q, columns[row / dim]) * v[point][row % dim];
            for (unsigned int column = 0; column < n; ++column)
              block[n * row + column] += of_row *
                                         element.N(q, columns[column / dim]) *
                                         w[point][column % dim];
          }
      }
    if (block.empty())
      return;
    std::vector<unsigned int> dofs;
    for (const unsigned int a : columns)
      for (unsigned int i = 0; i < dim; ++i)
        dofs.push_back(element.dof(a, i));
    for (unsigned int row = 0; row < n; ++row)
      tangent.add(dofs[row], n, dofs.data(), &block[n * row]);
  }



  template class TractionSpace<2>;
  template class TractionSpace<3>;
} // namespace asperity
