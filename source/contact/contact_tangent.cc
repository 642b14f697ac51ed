#include <asperity/contact/contact_assembler.h>
#include <asperity/isogeometric/element_view.h>

#include <algorithm>

namespace asperity
{
  using dealii::Tensor;
  using Matrix = dealii::SparseMatrix<double>;

  namespace
  {
    /** K_ab += factor N_a N_b v (x) v at point q of an element, for the
     *  functions in the given columns of the table. */
    void
    add_dyad(const ElementView               &element,
             const std::vector<unsigned int> &columns,
             const unsigned int               q,
             const double                     factor,
             const Tensor<1, 2>              &v,
             Matrix                          &tangent)
    {
      for (const unsigned int a : columns)
        for (const unsigned int b : columns)
          for (unsigned int i = 0; i < 2; ++i)
            for (unsigned int j = 0; j < 2; ++j)
              tangent.add(element.dof(a, i),
                          element.dof(b, j),
                          factor * element.N(q, a) * element.N(q, b) * v[i] *
                            v[j]);
    }
  } // namespace



  void
  ContactAssembler::add_curvature(Matrix &tangent) const
  {
    // Hessian of the distance: curvature / (1 + curvature gap) t (x) t. Beyond
    // the centre of curvature of a valley the closest point jumps; the bound
    // keeps the term finite there, where gaps are large and pressures zero.
    for (unsigned int e = 0; e < table_.elements.size(); ++e)
      for (unsigned int q = 0; q < table_.points_per_element; ++q)
        {
          const ElementView  element(table_, table_.elements[e]);
          const unsigned int point = element.point(q);
          if (point_pressure[point] == 0.)
            continue;
          const GapPoint &g = gap[point];
          const double    hessian =
            g.curvature / std::max(0.1, 1. + g.curvature * g.gap);
          Tensor<1, 2> tangential;
          tangential[0] = -g.normal[1];
          tangential[1] = g.normal[0];
          add_dyad(element,
                   element_columns[e],
                   q,
                   -point_pressure[point] * hessian * element.JxW(q),
                   tangential,
                   tangent);
        }
  }



  void
  ContactAssembler::add_mortar_stiffness(Matrix &tangent) const
  {
    // h[c][b] = int N_c N_b n for the active functions c.
    std::vector<std::vector<Tensor<1, 2>>> h(edge_functions.size());
    for (unsigned int c = 0; c < h.size(); ++c)
      if (slope[c] != 0.)
        h[c].resize(neighbours[c].size());
    for (unsigned int e = 0; e < table_.elements.size(); ++e)
      {
        const ElementView element(table_, table_.elements[e]);
        const auto       &functions = element_functions[e];
        const auto       &columns   = element_columns[e];
        for (unsigned int i = 0; i < functions.size(); ++i)
          {
            const unsigned int c = functions[i];
            if (h[c].empty())
              continue;
            for (unsigned int j = 0; j < functions.size(); ++j)
              {
                const unsigned int slot =
                  std::lower_bound(neighbours[c].begin(),
                                   neighbours[c].end(),
                                   functions[j]) -
                  neighbours[c].begin();
                for (unsigned int q = 0; q < table_.points_per_element; ++q)
                  h[c][slot] += element.N(q, columns[i]) *
                                element.N(q, columns[j]) * element.JxW(q) *
                                gap[element.point(q)].normal;
              }
          }
      }
    for (unsigned int c = 0; c < h.size(); ++c)
      for (unsigned int k = 0; k < h[c].size(); ++k)
        for (unsigned int l = 0; l < h[c].size(); ++l)
          for (unsigned int i = 0; i < 2; ++i)
            for (unsigned int j = 0; j < 2; ++j)
              tangent.add(displacement_dof(edge_functions[neighbours[c][k]], i),
                          displacement_dof(edge_functions[neighbours[c][l]], j),
                          -slope[c] / weight[c] * h[c][k][i] * h[c][l][j]);
  }



  void
  ContactAssembler::add_point_stiffness(Matrix &tangent) const
  {
    for (unsigned int e = 0; e < table_.elements.size(); ++e)
      for (unsigned int q = 0; q < table_.points_per_element; ++q)
        {
          const ElementView  element(table_, table_.elements[e]);
          const unsigned int point = element.point(q);
          if (slope[point] != 0.)
            add_dyad(element,
                     element_columns[e],
                     q,
                     -slope[point] * element.JxW(q),
                     gap[point].normal,
                     tangent);
        }
  }
} // namespace asperity
