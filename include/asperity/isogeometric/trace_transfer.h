#ifndef asperity_isogeometric_trace_transfer_h
#define asperity_isogeometric_trace_transfer_h

#include <asperity/isogeometric/basis_table.h>
#include <asperity/isogeometric/space_transfer.h>
#include <asperity/isogeometric/spline_hierarchy.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>

#include <vector>

namespace asperity
{
  /**
   * Takes splines on an edge (face), which are traces of functions of a space,
   * to another space on the same level-0 knots: by the L2 projection in the
   * parameters of the edge, integrated exactly on the common refinement of both
   * meshes. Splines that are in the new space, too, stay the same to round-off,
   * and the integral of all others is kept.
   */
  template <int dim>
  class TraceTransfer
  {
  public:
    TraceTransfer(const SplineHierarchy<dim> &from,
                  const SplineHierarchy<dim> &to,
                  const Edge                  edge);

    /** Coefficients, one a function whose trace does not vanish, in the order
     *  of SplineSpace::edge_functions(), from old to new. */
    std::vector<double>
    apply(const std::vector<double> &coefficients) const;

  private:
    /** Products of new with new and old functions on a part of the edge. */
    struct Products
    {
      std::vector<unsigned int>  rows, columns;
      dealii::FullMatrix<double> with_new, with_old;
    };

    void
    build_matrix();

    unsigned int                 n_old = 0, n_new = 0;
    std::vector<Products>        products;
    dealii::SparsityPattern      pattern;
    dealii::SparseMatrix<double> matrix;
  };

  /**
   * transfer_history() for values at the points of the cells along an edge,
   * in the order of edge_cells(), within the range of all old values.
   * @param quadrature on the unit cell of the edge
   */
  template <int dim>
  std::vector<double>
  transfer_edge_history(const SplineHierarchy<dim>        &from,
                        const SplineHierarchy<dim>        &to,
                        const Edge                         edge,
                        const dealii::Quadrature<dim - 1> &quadrature,
                        const std::vector<double>         &values,
                        const unsigned int                 n_components);
} // namespace asperity

#endif
