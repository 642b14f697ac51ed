#ifndef asperity_lubricant_sheet_void_h
#define asperity_lubricant_sheet_void_h

#include <asperity/isogeometric/basis_table.h>
#include <asperity/isogeometric/spline_space.h>
#include <asperity/lubricant/sheet_integral.h>
#include <asperity/splines/spline_sheet.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace asperity
{
  /**
   * The volume between the deformed top face of a periodic chip,
   * (x, y, z)(s, t), and the sheet Z(x, y) of the tool above: for a set of
   * elements of the face
   *
   *   V = oint P dy - int z (x_s y_t - x_t y_s) ds dt,   P = int_0^x Z dx,
   *
   * with its first and second derivatives with respect to the displacement: in
   * three dimensions what VoidVolume is in two. The first integral is along the
   * boundary of the set (Green's theorem), so that elements between which there
   * is no boundary know nothing of the tool: over the whole face it is the mean
   * height of the tool times L W, whatever the displacement. The second one is
   * exact by Gauss' rule. Derivatives are those of the rules. Where the
   * surfaces overlap the volume counts as negative.
   *
   * Elements are a grid: (i, j) has the number i + j n_x. They are those of the
   * face unless a number of them is given, with which each is in one of those.
   */
  class SheetVoid
  {
  public:
    /** @param tool sheet with the periods of the space [m]
     *  @param size of the grid; zeros: that of the face, which is a grid */
    SheetVoid(const SplineSpace<3>              &space,
              const PatchGeometry<3>            &geometry,
              const SplineSheet                 &tool,
              const std::array<unsigned int, 2> &size = {{0, 0}});

    /** Elements along x and y. */
    const std::array<unsigned int, 2> &
    size() const;

    unsigned int
    n_elements() const;

    unsigned int
    n_dofs() const;

    /** The element at a parameter of the face, in [0, L) x [0, W). */
    unsigned int
    element_at(const dealii::Point<2> &parameter) const;

    /** Takes the positions of the face from a displacement. */
    void
    measure(const dealii::Vector<double> &u);

    /** Vertical distance of the tool over the start of an element [m]. */
    double
    gap(const unsigned int element) const;

    /** V of each of n regions [m^3].
     *  @param region of each element, less than n */
    std::vector<double>
    volumes(const std::vector<unsigned int> &region,
            const unsigned int               n) const;

    /** g += factor dV/du of one of the regions. */
    void
    add_gradient(const std::vector<unsigned int> &region,
                 const unsigned int               of,
                 const double                     factor,
                 dealii::Vector<double>          &g) const;

    /** K += sum factor d^2V/du^2.
     *  @param factors of the regions; where they are zero nothing is added */
    void
    add_hessian(const std::vector<unsigned int> &region,
                const std::vector<double>       &factors,
                dealii::SparseMatrix<double>    &K) const;

    void
    add_couplings(dealii::DynamicSparsityPattern &pattern) const;

  private:
    /** The nodes of the elements of a grid that is finer than the face. */
    void
    tabulate(const SplineSpace<3> &space, const PatchGeometry<3> &geometry);

    /** Gauss' rule on [0, 1], and the Lagrange polynomials of the nodes of an
     *  element and their derivatives at its points, [q][k]. */
    struct Rule
    {
      Rule(const unsigned int n_nodes, const unsigned int n_points);

      std::vector<double>              weight;
      std::vector<std::vector<double>> value, derivative;
    };

    /** A volume as a function of the nodes of an element, component c of node k
     *  at 3 k + c. */
    struct Part
    {
      double                     value = 0.;
      dealii::Vector<double>     gradient;
      dealii::FullMatrix<double> hessian;
    };

    /** int z (x_s y_t - x_t y_s) ds dt of an element. */
    Part
    below_chip(const unsigned int element, const bool with_hessian) const;

    /** int P dy along the first edge of an element: 0, at which it begins in x,
     *  towards larger y, or 1, at which it begins in y, towards larger x.
     *  @param of_period of P(x + L, y) - P(x, y) instead of P */
    Part
    along_edge(const unsigned int element,
               const unsigned int edge,
               const bool         of_period,
               const bool         with_hessian) const;

    /** What the first edges of an element count by in the sum over regions:
     *  [0] along y, [1] along x, [2] that along y of a period.
     *  @param factors of the regions */
    std::array<double, 3>
    weights_of_edges(const unsigned int               element,
                     const std::vector<unsigned int> &region,
                     const std::vector<double>       &factors) const;

    /** Calls add(part, weight, element) for all that the sum of volumes times
     *  factors has beside the whole period of the tool. */
    template <typename Add>
    void
    for_all_parts(const std::vector<unsigned int> &region,
                  const std::vector<double>       &factors,
                  const bool                       with_hessian,
                  const Add                       &add) const;

    SplineSheet   tool;
    SheetIntegral integral;
    double        whole_tool; ///< mean height times L W [m^3]
    unsigned int  n_dofs_;

    std::array<unsigned int, 2>   size_;
    std::array<double, 2>         width{};  ///< of an element [m]
    BasisTable<3>                 table;    ///< its points are nodes
    std::vector<unsigned int>     entry;    ///< of an element, in the table
    unsigned int                  n_nodes;  ///< of an element in a direction
    std::vector<dealii::Point<3>> position; ///< of nodes, present

    Rule face_rule, edge_rule;
  };
} // namespace asperity

#endif
