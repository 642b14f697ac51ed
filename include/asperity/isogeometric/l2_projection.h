#ifndef asperity_isogeometric_l2_projection_h
#define asperity_isogeometric_l2_projection_h

#include <asperity/isogeometric/basis_table.h>
#include <asperity/isogeometric/spline_hierarchy.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace asperity
{
  /** Bernstein polynomials of the unit cell that do not vanish on one of its
   *  edges, in order along it (the first direction fastest). */
  template <int dim>
  std::vector<unsigned int>
  edge_bernstein(const unsigned int degree, const Edge edge);

  /** Rows of cell_extraction(cell) of functions that do not vanish on an edge
   *  of the cell. */
  template <int dim>
  std::vector<unsigned int>
  trace_rows(const SplineHierarchy<dim> &hierarchy,
             const unsigned int          cell,
             const Edge                  edge);

  /** Active cells with a face on an edge of the parameter box, sorted by
   *  their first corners along it, in three dimensions row by row. */
  template <int dim>
  std::vector<unsigned int>
  edge_cells(const SplineHierarchy<dim> &hierarchy, const Edge edge);

  /** The edges that bound the domain: those of the directions that are not
   *  periodic. */
  template <int dim>
  std::vector<Edge>
  boundary_edges(const SplineHierarchy<dim> &hierarchy);

  /** Integrals of products of Bernstein polynomials over [0, 1]:
   *  G(a, b) = C(p, a) C(p, b) / (C(2 p, a + b) (2 p + 1)). */
  dealii::FullMatrix<double>
  bernstein_gramian(const unsigned int degree);

  /**
   * The L2 projection in the parameters. An edge term, the cell's width normal
   * to the edge times the L2 product on the edge, may be added.
   *
   * In two dimensions the matrix is factorised once. In three, where a factor
   * fills, conjugate gradients solve with it: scaled by its diagonal it is as
   * well conditioned on any mesh as on the coarsest.
   */
  template <int dim>
  class L2Projection
  {
  public:
    L2Projection(const SplineHierarchy<dim> &hierarchy,
                 const double                edge_weight = 0.);

    /** The matrix of products, without factorisation; small spaces only. */
    static dealii::FullMatrix<double>
    gramian(const SplineHierarchy<dim> &hierarchy);

    /** From the products of functions with the function to be projected to its
     *  coefficients. */
    void
    solve(dealii::Vector<double> &right_hand_side) const;

  private:
    dealii::SparsityPattern      pattern;
    dealii::SparseMatrix<double> matrix; ///< in three dimensions
    dealii::SparseDirectUMFPACK  factorization;
  };
} // namespace asperity

#endif
