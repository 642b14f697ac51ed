#ifndef asperity_isogeometric_space_transfer_h
#define asperity_isogeometric_space_transfer_h

#include <asperity/isogeometric/basis_table.h>
#include <asperity/isogeometric/spline_hierarchy.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <utility>
#include <vector>

namespace asperity
{
  template <int dim>
  class L2Projection;

  /**
   * Takes splines from one space to another on the same level-0 knots:
   *
   *     const auto before = space.hierarchy();
   *     space.execute_refinement();
   *     const SpaceTransfer<dim> transfer(*before, *space.hierarchy());
   *     u = transfer.apply(u, dim);
   *
   * If the old space is part of the new one (no cell was coarsened) the spline
   * stays the same: each coefficient is read off one cell with the dual
   * functional of SplineHierarchy::function_home(). Otherwise the new spline
   * is the L2 projection in the parameters, integrated exactly on the common
   * refinement of both meshes.
   */
  template <int dim>
  class SpaceTransfer
  {
  public:
    SpaceTransfer(const SplineHierarchy<dim> &from,
                  const SplineHierarchy<dim> &to);

    ~SpaceTransfer();

    /** Whether every spline of the old space is one of the new space. */
    bool
    is_exact() const;

    /** Coefficients [function * n_components + component], from old to new. */
    std::vector<double>
    apply(const std::vector<double> &coefficients,
          const unsigned int         n_components = 1) const;

    /** The geometry in the new space. */
    PatchGeometry<dim>
    apply(const PatchGeometry<dim> &geometry) const;

  private:
    /** Products of new and old functions on one cell. */
    struct Products
    {
      std::vector<unsigned int>  rows;
      std::vector<unsigned int>  columns;
      dealii::FullMatrix<double> values;
    };

    void
    build_exact(const SplineHierarchy<dim> &from,
                const SplineHierarchy<dim> &to);

    void
    build_projection(const SplineHierarchy<dim> &from,
                     const SplineHierarchy<dim> &to);

    bool         exact           = false;
    unsigned int n_old_functions = 0;
    unsigned int n_new_functions = 0;

    /** Exact transfer: old function and weight for each new function. */
    std::vector<std::vector<std::pair<unsigned int, double>>> weights;

    std::vector<Products>              products;
    std::unique_ptr<L2Projection<dim>> projection;
  };

  /** Whether every cell of `coarse` exists in `fine`, refined or not. */
  template <int dim>
  bool
  is_refinement(const SplineHierarchy<dim> &coarse,
                const SplineHierarchy<dim> &fine);

  /** What the values of transfer_history() do not leave. */
  enum class HistoryRange
  {
    cell, ///< the range of the old values in the cell of the fit
    body, ///< the range of all old values
    none
  };

  /**
   * Takes values at the quadrature points of the cells from one mesh to another
   * on the same level-0 knots. Cells in both meshes keep their values bit by
   * bit. Elsewhere, on each cell of the coarser of both meshes, a polynomial is
   * fitted to the old values by weighted least squares and evaluated at the new
   * points. It is then drawn towards its mean, as little as needed, until no
   * value leaves a range (the limiter of X. Zhang, C.-W. Shu, J. Comput. Phys.
   * 229 (2010) 3091-3120). So, for each component and with a Gauss quadrature,
   * the integral in the parameters is conserved, and bounds (a plastic strain
   * that is not negative) are kept. The new points of a finer cell lie outside
   * the old ones: in the range of their cell values are first-order accurate,
   * in a wider one second-order.
   *
   * Components are treated one by one: a relation between components that is
   * not linear, like det F = 1, must be restored by their owner.
   *
   * @param quadrature that of both meshes on the unit cell
   * @param values [(cell * n_q + q) * n_components + component]
   * @param fit_degree of the polynomial in each direction; less where the
   *   quadrature has too few points. Histories have kinks: a high degree would
   *   oscillate, and the limiter then flattens more.
   */
  template <int dim>
  std::vector<double>
  transfer_history(const SplineHierarchy<dim>    &from,
                   const SplineHierarchy<dim>    &to,
                   const dealii::Quadrature<dim> &quadrature,
                   const std::vector<double>     &values,
                   const unsigned int             n_components,
                   const unsigned int             fit_degree = 2,
                   const HistoryRange             range = HistoryRange::cell);

  /**
   * What values at quadrature points would lose if cells were coarsened by one
   * level: root mean square over the parent of what the fit of
   * transfer_history() leaves.
   * @param values [cell * n_q + q]
   * @return one a cell; zero if its parent has other parts than active cells
   */
  template <int dim>
  std::vector<double>
  coarsening_loss(const SplineHierarchy<dim>    &hierarchy,
                  const dealii::Quadrature<dim> &quadrature,
                  const std::vector<double>     &values,
                  const unsigned int             fit_degree = 2);
} // namespace asperity

#endif
