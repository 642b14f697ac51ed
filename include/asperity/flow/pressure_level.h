#ifndef asperity_flow_pressure_level_h
#define asperity_flow_pressure_level_h

#include <asperity/flow/fluid_boundary.h>

#include <string>

namespace asperity
{
  /**
   * The pressure of a part of the flow on whose whole boundary the velocity is
   * prescribed: its level is not determined, and no flow exists unless the
   * prescribed velocities conserve the volume.
   */
  class PressureLevel
  {
  public:
    using Vector = dealii::Vector<double>;

    PressureLevel(const FluidSpace    &space,
                  const MovingMesh    &mesh,
                  const FluidBoundary &boundary);

    /** Looks which parts are enclosed under the present conditions.
     *  @param is_compressible the fluid's content tells the level: no part has
     *    an undetermined one */
    void
    update(const bool is_compressible);

    bool
    is_undetermined() const;

    /** One pressure unknown a part, to be held while solving. */
    std::vector<unsigned int>
    held_dofs() const;

    /**
     * Makes the continuity equation of enclosed parts solvable: a net flux of
     * round-off or interpolation through their boundary is spread over the
     * part.
     * @param u has the prescribed velocities
     * @param source of the continuity equation (m^2/s a pressure function), is
     *   added to
     * @param tolerance net flux over the integral of |v| on the boundary
     * @return empty, or what is wrong: a larger net flux
     */
    std::string
    balance(const Vector &u, Vector &source, const double tolerance) const;

    /**
     * Sees to the areas of the parts, see NavierStokes::set_part_volumes().
     * @param volumes wanted [m^2], one a part; empty: none is
     * @param source as for balance(); its sum over a part is replaced
     */
    void
    impose_volumes(const std::vector<double> &volumes, Vector &source) const;

    /**
     * The same for a compressible fluid. Where a wall slides along a curved
     * edge of the mesh, the interpolated velocities carry no volume through it
     * but, with the density, some mass, which is taken back.
     * @param contents wanted, as volumes of the fluid at p = 0 [m^2]
     * @param u has the prescribed velocities
     * @param ratio density ratios by pressure unknowns
     * @param source with the history of the content
     */
    void
    impose_contents(const std::vector<double> &contents,
                    const Vector              &u,
                    const Vector              &ratio,
                    Vector                    &source) const;

    /** Areas of the parts on the present mesh [m^2]. */
    std::vector<double>
    volumes() const;

    /** Shifts the pressure of enclosed parts to this mean [Pa]. */
    void
    fix_mean(Vector &u, const double mean) const;

  private:
    /** Over each part, of the divergence of the first two components. */
    std::vector<double>
    integrate_divergence(const dealii::DoFHandler<2> &dofs,
                         const Vector                &field) const;

    /** |v| over the outer boundary of each part. */
    std::vector<double>
    integrate_speed(const Vector &u) const;

    /** Of the ratio times (v - w).n, over each part's boundary of prescribed
     *  velocity. */
    std::vector<double>
    integrate_slip(const Vector &u, const Vector &ratio) const;

    /** Spreads over each part what its sum of the source misses. */
    void
    impose_sums(const std::vector<double> &sums, Vector &source) const;

    /** Integrals of the pressure functions. */
    Vector
    weights() const;

    const FluidSpace    &space;
    const MovingMesh    &mesh;
    const FluidBoundary &boundary;
    std::vector<bool>    is_enclosed; ///< by part
  };
} // namespace asperity

#endif
