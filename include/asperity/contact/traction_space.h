#ifndef asperity_contact_traction_space_h
#define asperity_contact_traction_space_h

#include <asperity/isogeometric/cell_partition.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <vector>

namespace asperity
{
  template <int dim>
  class SplineSpace;

  enum class ContactFormulation
  {
    mortar,     ///< knot to surface: one traction a control point
    gauss_point ///< Gauss point to surface: one traction a quadrature point
  };

  /**
   * The space of tractions on the reference edge (face): t(X) = sum_a psi_a(X)
   * t_a. With the mortar the psi_a are the functions N_a of the edge, at Gauss
   * points each is 1 at its point and 0 at the others. What the kinematics say
   * at the points of the table reaches a traction through the mean
   * <v>_a = int psi_a v / W_a, W_a = int psi_a.
   *
   * On several ranks tractions and means are complete on each of them, but a
   * tangent is that of the tractions and points that are this process's own.
   */
  template <int dim>
  class TractionSpace
  {
  public:
    using Vectors = std::vector<dealii::Tensor<1, dim>>;

    /** @param table of the edge, which must outlive this object
     *  @param share which cells are this process's own */
    TractionSpace(const SplineSpace<dim>  &space,
                  const BasisTable<dim>   &table,
                  const Edge               edge,
                  const ContactFormulation formulation,
                  const CellShare         &share = CellShare());

    /** Number of tractions. */
    unsigned int
    size() const;

    ContactFormulation
    formulation() const;

    /** Whether an element of the table is this process's own. */
    bool
    is_own(const unsigned int element) const
    {
      return own_elements[element];
    }

    /** <v>_a of values at the points. */
    std::vector<double>
    means(const std::vector<double> &at_points) const;

    /** t at the points. */
    std::vector<double>
    at_points(const std::vector<double> &tractions) const;

    /** Per point, whether all tractions that reach it are positive. */
    std::vector<bool>
    inside(const std::vector<double> &tractions) const;

    /** The couplings that the tangents below have. */
    void
    add_couplings(dealii::DynamicSparsityPattern &pattern) const;

    /**
     * The tangent of forces int N_b psi_a v t_a whose t_a follows the mean of
     * w . dx: K_bc += sum_a f_a/W_a (int N_b psi_a v) (x) (int N_c psi_a w).
     * @param factors f_a = dt_a/d<w . x>_a [Pa/m]; those that are 0 cost
     *   nothing
     * @param v, w at the points
     */
    void
    add_stiffness(const std::vector<double>    &factors,
                  const Vectors                &v,
                  const Vectors                &w,
                  dealii::SparseMatrix<double> &tangent) const;

    /** The tangent of forces that follow the displacement point by point,
     *  K_bc += int N_b N_c f v (x) w. */
    void
    add_pointwise(const std::vector<double>    &factors,
                  const Vectors                &v,
                  const Vectors                &w,
                  dealii::SparseMatrix<double> &tangent) const;

  private:
    /** f_a/W_a (int N_b psi_a v), [a][slot of b]; empty where f_a = 0, and
     *  where a is another rank's. */
    std::vector<Vectors>
    moments(const std::vector<double> &factors, const Vectors &v) const;

    void
    add_mortar_stiffness(const std::vector<double>    &factors,
                         const Vectors                &v,
                         const Vectors                &w,
                         dealii::SparseMatrix<double> &tangent) const;

    /** The part of an element, added as one block: entries are too dear to be
     *  looked up for each point. */
    void
    add_pointwise_of(const unsigned int            element,
                     const std::vector<double>    &factors,
                     const Vectors                &v,
                     const Vectors                &w,
                     dealii::SparseMatrix<double> &tangent) const;

    /** Calls action(point, a, psi_a) for each value that is not 0. */
    template <typename Action>
    void
    for_each_value(const Action &action) const;

    ContactFormulation     formulation_;
    const BasisTable<dim> &table;

    std::vector<unsigned int> edge_functions; ///< edge index -> function
    std::vector<std::vector<unsigned int>> element_functions; ///< edge indices
    std::vector<std::vector<unsigned int>> element_columns; ///< into table rows
    std::vector<std::vector<unsigned int>> neighbours; ///< overlapping supports

    std::vector<bool> own_elements;
    std::vector<bool> own_functions; ///< by edge index: of the first element

    std::vector<double> weight; ///< W_a [m^(dim - 1)]
  };
} // namespace asperity

#endif
