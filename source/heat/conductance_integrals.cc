#include <asperity/base/errors.h>
#include <asperity/base/neighbours.h>
#include <asperity/base/vector_widths.h>
#include <asperity/heat/conductance_integrals.h>
#include <asperity/isogeometric/element_view.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    using neighbours::at;
    using neighbours::Pack;
    using neighbours::width;

    inline double
    sum(const Pack &x)
    {
      return (x[0] + x[1]) + (x[2] + x[3]);
    }



    /** J F^{-T} of F, and J. */
    template <int dim>
    double
    cofactors(const double (&F)[dim][dim], double (&C)[dim][dim])
    {
      if constexpr (dim == 2)
        {
          C[0][0] = F[1][1];
          C[0][1] = -F[1][0];
          C[1][0] = -F[0][1];
          C[1][1] = F[0][0];
        }
      else
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            {
              const unsigned int k = (i + 1) % 3, l = (i + 2) % 3,
                                 m = (j + 1) % 3, n = (j + 2) % 3;
              C[i][j] = F[k][m] * F[l][n] - F[k][n] * F[l][m];
            }
      double J = 0.;
      for (unsigned int j = 0; j < dim; ++j)
        J += F[0][j] * C[0][j];
      return J;
    }



    /**
     * Adds the points of an element.
     *
     * @param gradients all components at each point, rows of length stride
     * @param u rows of all components of the displacement
     * @param flux dim rows to work in, J C^{-1} Grad N_b
     * @return whether J > 0 everywhere
     */
    template <int dim>
    bool
    integrate_points(const unsigned int n_points,
                     const unsigned int n,
                     const unsigned int stride,
                     const double      *gradients,
                     const double      *weights,
                     const double      *u,
                     double            *flux,
                     double            *block)
    {
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const double *const G           = gradients + dim * q * stride;
          Pack                H[dim][dim] = {};
          for (unsigned int k = 0; k < stride; k += width)
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int d = 0; d < dim; ++d)
                H[i][d] += at(u + i * stride + k) * at(G + d * stride + k);
          double F[dim][dim], C[dim][dim];
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int d = 0; d < dim; ++d)
              F[i][d] = (i == d ? 1. : 0.) + sum(H[i][d]);
          const double J = cofactors<dim>(F, C);
          if (!(J > 0.))
            return false;
          // J C^{-1} = (J F^{-1}) (J F^{-T})/J
          const double w = weights[q] / J;
          double       K[dim][dim];
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int e = 0; e < dim; ++e)
              {
                double product = 0.;
                for (unsigned int i = dim; i-- > 0;)
                  product += C[i][d] * C[i][e];
                K[d][e] = w * product;
              }
          for (unsigned int k = 0; k < stride; k += width)
            for (unsigned int d = 0; d < dim; ++d)
              {
                Pack component = K[d][0] * at(G + k);
                for (unsigned int e = 1; e < dim; ++e)
                  component += K[d][e] * at(G + e * stride + k);
                at(flux + d * stride + k) = component;
              }
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int k = 0; k < stride; k += width)
              {
                Pack product = G[a] * at(flux + k);
                for (unsigned int d = 1; d < dim; ++d)
                  product += G[d * stride + a] * at(flux + d * stride + k);
                at(block + a * stride + k) += product;
              }
        }
      return true;
    }



    ASPERITY_ALL_VECTOR_WIDTHS ASPERITY_INLINE_ALL bool
    integrate_points(const unsigned int dim,
                     const unsigned int n_points,
                     const unsigned int n,
                     const unsigned int stride,
                     const double      *gradients,
                     const double      *weights,
                     const double      *u,
                     double            *flux,
                     double            *block)
    {
      return dim == 2 ?
               integrate_points<2>(
                 n_points, n, stride, gradients, weights, u, flux, block) :
               integrate_points<3>(
                 n_points, n, stride, gradients, weights, u, flux, block);
    }
  } // namespace



  template <int dim>
  ConductanceIntegrals<dim>::ConductanceIntegrals(const BasisTable<dim> &cells,
                                                  const GradientRows    &rows)
    : cells(cells)
    , rows(rows)
  {
    if (rows)
      return;
    for (unsigned int e = 0; e < cells.elements.size(); ++e)
      {
        const ElementView<dim> element(cells, cells.elements[e]);
        const unsigned int     n_columns = stride(e);
        first.push_back(gradients.size());
        gradients.resize(gradients.size() +
                         dim * cells.points_per_element * n_columns);
        double *row = gradients.data() + first.back();
        for (unsigned int q = 0; q < cells.points_per_element; ++q)
          for (unsigned int c = 0; c < dim; ++c, row += n_columns)
            for (unsigned int a = 0; a < element.n_functions(); ++a)
              row[a] = element.gradient(q, a)[c];
      }
  }



  template <int dim>
  const double *
  ConductanceIntegrals<dim>::gradient_rows(const unsigned int element) const
  {
    return rows ? rows(element) : gradients.data() + first[element];
  }



  template <int dim>
  unsigned int
  ConductanceIntegrals<dim>::stride(const unsigned int element) const
  {
    return neighbours::padded(cells.elements[element].functions.size());
  }



  template <int dim>
  const double *
  ConductanceIntegrals<dim>::integrate(const unsigned int            element,
                                       const dealii::Vector<double> &u)
  {
    const ElementView<dim> view(cells, cells.elements[element]);
    const unsigned int     n = view.n_functions(), n_columns = stride(element);
    work.assign(2 * dim * n_columns, 0.);
    block.assign(n * n_columns, 0.);
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int c = 0; c < dim; ++c)
        work[c * n_columns + a] = u(view.dof(a, c));
    if (!integrate_points(dim,
                          cells.points_per_element,
                          n,
                          n_columns,
                          gradient_rows(element),
                          &cells.JxW[cells.elements[element].first_point],
                          work.data(),
                          work.data() + dim * n_columns,
                          block.data()))
      throw ComputationError("An element of the chip is folded, where no heat "
                             "can be conducted.");
    return block.data();
  }



  template class ConductanceIntegrals<2>;
  template class ConductanceIntegrals<3>;
} // namespace asperity
