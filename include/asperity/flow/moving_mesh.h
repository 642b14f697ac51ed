#ifndef asperity_flow_moving_mesh_h
#define asperity_flow_moving_mesh_h

#include <asperity/flow/fluid_space.h>
#include <asperity/time_integration/backward_difference.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <vector>

namespace asperity
{
  /**
   * The motion of the fluid mesh: x = X + d(X, t) with a nodal displacement d
   * in the geometry space, and its velocity w by the formula that the flow
   * itself is integrated with.
   *
   * Geometric conservation. The momentum balance is advective, with rates at
   * fixed X: a uniform flow has no rate of its nodal values and no gradient, so
   * it stays uniform for every w and every motion, exactly. What the advective
   * form does not conserve by itself is the volume between material walls: the
   * flux of w through the wall at the end of the step differs from the swept
   * volume by O(dt). swept_volume_defect() is that difference, by which
   * the continuity equation is corrected at material walls only.
   */
  class MovingMesh
  {
  public:
    using Vector = dealii::Vector<double>;

    explicit MovingMesh(const FluidSpace &space);

    ~MovingMesh();

    /** Current node positions [m] are reference positions plus this.
     *  @return false, and is_valid() is false, if a cell is inverted */
    bool
    set_displacement(const Vector &d);

    /** No cell is inverted. */
    bool
    is_valid() const;

    /** The formula of the rates in the next calls. */
    void
    set_rate(const BackwardDifference &rate);

    const BackwardDifference &
    rate() const;

    /** The current displacement becomes the start of the next step. */
    void
    accept();

    /** Displacements at t_n and t_{n-1}, as a restart needs. */
    void
    set_history(const Vector &old, const Vector &older);

    const Vector &
    displacement() const;
    const Vector &
    old_displacement() const;
    const Vector &
    older_displacement() const;

    /** x, nodal [m]. */
    const Vector &
    positions() const;

    /** w, nodal [m/s]. */
    Vector
    velocity() const;

    /** Current shape of the cells. */
    const dealii::Mapping<2> &
    mapping() const;

    const FluidSpace &
    space() const;

    /** Present areas [m^2] by active_cell_index(), also of cells that are off.
     */
    std::vector<double>
    cell_areas() const;

    /**
     * Adds to R, for each pressure function q of a cell at the walls, the
     * integral of q w.n over the walls at the end of the step minus the rate
     * of the volume that the walls sweep [m^2/s], weighted by q: with
     * Delta_1 = d_{n+1} - d_n, Delta_2 = d_n - d_{n-1},
     *   int_{n+1} q w.n - now int_{n+1/2} q Delta_1.n
     *     + older int_{n-1/2} q Delta_2.n.
     * In the plane n ds is affine in d, so the middle of a step is exact.
     */
    void
    add_swept_volume_defect(const BoundaryIds &walls, Vector &R) const;

    /**
     * Adds to R, for each pressure function q, what the content at the last
     * times contributes to its rate, with the density ratios r_n and r_{n-1},
     *   old int_n q r_n + older int_{n-1} q r_{n-1} - m g(q)    [m^2/s],
     *   g(q) = now int_{n+1} q + old int_n q + older int_{n-1} q
     *          - int_{n+1} q div w.
     * g is the error of the rate of the cells' own area: without it a motion of
     * the mesh would compress a fluid of the uniform ratio m.
     * @param mean_ratio m, by parts of the space
     */
    void
    add_content_history(const Vector              &r_old,
                        const Vector              &r_older,
                        const std::vector<double> &mean_ratio,
                        Vector                    &R) const;

  private:
    struct Shapes; // shape functions on the reference cell

    bool
    has_inverted_cell() const;

    /** The defect at the points of a wall's face, times JxW. */
    std::vector<double>
    flux_defect(const dealii::FEFaceValues<2> &face) const;

    const FluidSpace                   &space_;
    const std::unique_ptr<const Shapes> shapes;
    dealii::MappingQCache<2>            mapping_;
    Vector                              reference; ///< X, nodal [m]
    Vector                              x;         ///< now
    Vector                              now, old, older;
    BackwardDifference                  rate_;
    bool                                valid = true;
  };
} // namespace asperity

#endif
