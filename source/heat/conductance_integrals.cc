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



    /**
     * Adds the points of an element.
     *
     * @param gradients both components at each point, rows of length stride
     * @param u rows of both components of the displacement
     * @param flux two rows to work in, J C^{-1} Grad N_b
     * @return whether J > 0 everywhere
     */
    ASPERITY_ALL_VECTOR_WIDTHS ASPERITY_INLINE_ALL bool
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
          const double *const G_0  = gradients + 2 * q * stride,
                              *G_1 = G_0 + stride;
          Pack F_00{}, F_01{}, F_10{}, F_11{};
          for (unsigned int k = 0; k < stride; k += width)
            {
              F_00 += at(u + k) * at(G_0 + k);
              F_01 += at(u + k) * at(G_1 + k);
              F_10 += at(u + stride + k) * at(G_0 + k);
              F_11 += at(u + stride + k) * at(G_1 + k);
            }
          const double F[2][2] = {{1. + sum(F_00), sum(F_01)},
                                  {sum(F_10), 1. + sum(F_11)}};
          const double J       = F[0][0] * F[1][1] - F[0][1] * F[1][0];
          if (!(J > 0.))
            return false;
          // J C^{-1} = adj(C) / J
          const double w    = weights[q] / J;
          const double K_00 = w * (F[0][1] * F[0][1] + F[1][1] * F[1][1]),
                       K_11 = w * (F[0][0] * F[0][0] + F[1][0] * F[1][0]),
                       K_01 = -w * (F[0][0] * F[0][1] + F[1][0] * F[1][1]);
          for (unsigned int k = 0; k < stride; k += width)
            {
              at(flux + k)          = K_00 * at(G_0 + k) + K_01 * at(G_1 + k);
              at(flux + stride + k) = K_01 * at(G_0 + k) + K_11 * at(G_1 + k);
            }
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int k = 0; k < stride; k += width)
              at(block + a * stride + k) +=
                G_0[a] * at(flux + k) + G_1[a] * at(flux + stride + k);
        }
      return true;
    }
  } // namespace



  ConductanceIntegrals::ConductanceIntegrals(const BasisTable<2> &cells)
    : cells(cells)
  {
    for (unsigned int e = 0; e < cells.elements.size(); ++e)
      {
        const ElementView<2> element(cells, cells.elements[e]);
        const unsigned int   n_columns = stride(e);
        first.push_back(gradients.size());
        gradients.resize(gradients.size() +
                         2 * cells.points_per_element * n_columns);
        double *row = &gradients[first.back()];
        for (unsigned int q = 0; q < cells.points_per_element; ++q)
          for (unsigned int c = 0; c < 2; ++c, row += n_columns)
            for (unsigned int a = 0; a < element.n_functions(); ++a)
              row[a] = element.gradient(q, a)[c];
      }
  }



  unsigned int
  ConductanceIntegrals::stride(const unsigned int element) const
  {
    return neighbours::padded(cells.elements[element].functions.size());
  }



  const double *
  ConductanceIntegrals::integrate(const unsigned int            element,
                                  const dealii::Vector<double> &u)
  {
    const ElementView<2> view(cells, cells.elements[element]);
    const unsigned int   n = view.n_functions(), n_columns = stride(element);
    work.assign(4 * n_columns, 0.);
    block.assign(n * n_columns, 0.);
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int c = 0; c < 2; ++c)
        work[c * n_columns + a] = u(view.dof(a, c));
    if (!integrate_points(cells.points_per_element,
                          n,
                          n_columns,
                          &gradients[first[element]],
                          &cells.JxW[cells.elements[element].first_point],
                          work.data(),
                          work.data() + 2 * n_columns,
                          block.data()))
      throw ComputationError("An element of the chip is folded, where no heat "
                             "can be conducted.");
    return block.data();
  }
} // namespace asperity
