#ifndef asperity_lubricant_film_term_h
#define asperity_lubricant_film_term_h

#include <asperity/lubricant/film_edge.h>
#include <asperity/lubricant/lubricant.h>
#include <asperity/lubricant/reynolds_film.h>
#include <asperity/solvers/matrix_entries.h>

namespace asperity
{
  struct FilmTermOptions
  {
    LubricantParameters oil;

    /** w: share of the gap that holds oil at the start. */
    double wetting = 1.;

    /** Volume of the oil at p = 0 over the period, at most the mean gap [m],
     *  instead of w times the gap. */
    std::optional<double> oil_film;

    /** The film that stays where the surfaces touch. */
    FilmGap gap;

    /** Cells of the film a span of the chip's edge. */
    unsigned int cells_per_span = 1;

    /** Typical pressure p_s [Pa] and film h_s [m], for scaling only. */
    double pressure_scale = 1e8;
    double gap_scale      = 1e-7;
  };

  /**
   * A Reynolds film between the top edge of a periodic chip and a rigid tool
   * above, solved together with the chip.
   *
   * The cells of the film are material intervals of the deformed edge, so that
   * x-graph and parameter of the chip are one: faces move with the particles of
   * the chip, w = u_1 = (x_f - x_f^old)/dt, and relative to a face the mean of
   * the walls' velocities is c = s/2, s = u_2 - u_1. Volumes and gaps are
   * vertical (see FilmEdge), so the normal motion of both walls is in V - V_old
   * and flat walls that slide squeeze nothing.
   *
   * Unknowns beyond those of the chip: for each cell i
   *   u[first_unknown + 2 i]     = p_i h_s/p_s  [m],
   *   u[first_unknown + 2 i + 1] = theta_i h_s  [m],
   * with the residuals, in N/m like those of the chip,
   *   (p_s/h_s) R_i   (see ReynoldsFilm),   p_s dX_i phi_i.
   * Thus R times unknown is pressure times volume, an energy, and entries of
   * the tangent are of the order of those of the chip. It is not symmetric:
   * Newton's method needs NewtonMerit::residual_norm.
   *
   * On the chip act the pressure on the deformed edge, constant in a cell, and
   * the shear T_1 of each face, in x, as the balance of the oil has it (slopes
   * squared are neglected in both):
   *   R_a = sum_i p_i int N_a n ds - e_x sum_f N_a(x_f) T_1f.
   */
  class FilmTerm : public Lubricant
  {
  public:
    /** @param first_unknown length of the chip's displacement vector, or more
     *  if others have appended unknowns
     *  @throws InputError if a parameter has no physical meaning */
    FilmTerm(const SplineSpace<2>   &space,
             const PatchGeometry<2> &geometry,
             const SplineCurve      &tool,
             const FilmTermOptions  &options,
             const unsigned int      first_unknown);

    /** How many unknowns there are beyond first_unknown. */
    unsigned int
    n_unknowns() const;

    /**
     * The chip starts with the displacement in u: the oil, w times the void
     * without displacement, is spread evenly over the void that is there then.
     * Writes the unknowns of the start into u: no pressure, and the fraction
     * that the oil fills, at most 1. Without this call the start is at u = 0.
     * @throws InputError if there is no film at u
     */
    void
    initialize(dealii::Vector<double> &u);

    /** Translation of the tool at the end of the step [m]. */
    void
    set_tool_offset(const dealii::Tensor<1, 2> &offset);

    void
    add_couplings(dealii::DynamicSparsityPattern &pattern) const override;

    bool
    add(const dealii::Vector<double> &u,
        dealii::Vector<double>       &residual,
        dealii::SparseMatrix<double> *tangent) override;

    void
    set_oil(const LubricantParameters &oil) override;

    void
    begin_step(const dealii::Vector<double> &u,
               const unsigned int            step,
               const double                  time,
               const double                  dt) override;

    std::string
    reason() const override;

    /** ReynoldsFilm::coarseness() at the last evaluation. */
    std::string
    coarseness() const
    {
      return film.coarseness(film_geometry, states);
    }

    /** The oil goes on from the fluxes of the step: none is lost, whatever the
     *  tolerance of the solution. */
    void
    accept(const dealii::Vector<double> &u) override;

    LubricantState
    state() const override;

    double
    pressure(const dealii::Point<2> &parameter) const override;

    /** theta of the cell. */
    double
    coverage(const dealii::Point<2> &parameter) const override;

    /** Pressure and fraction of each cell at the last evaluation. */
    const std::vector<FilmState> &
    film_states() const;

    const FilmEdge &
    edge() const;

    void
    save(OutputArchive &archive) const override;

    void
    load(InputArchive &archive) override;

  private:
    /** The cell that holds a parameter of the edge. */
    unsigned int
    cell_at(const double parameter) const;

    /** Takes positions from u. @throws InputError if there is no film */
    void
    start(const dealii::Vector<double> &u);

    /** Geometry, states and linearization at u; false if there is none. */
    bool
    evaluate(const dealii::Vector<double> &u);

    unsigned int
    pressure_unknown(const unsigned int cell) const;

    unsigned int
    fraction_unknown(const unsigned int cell) const;

    /** Derivative of a number at a face by all unknowns. */
    SparseGradient
    face_gradient(const unsigned int face, const FilmFaceValue &value) const;

    void
    add_cell_tangent(const unsigned int cell);

    void
    add_face_tangent(const unsigned int face);

    FilmTermOptions options;
    unsigned int    first_unknown;
    FilmEdge        edge_;
    ReynoldsFilm    film;

    double               void_volume = 0.; ///< without displacement [m^2]
    dealii::Tensor<1, 2> tool_offset;

    // At the last accepted step:
    FilmStep             step;         ///< and the length of the next one
    std::vector<double>  old_position; ///< of the faces [m]
    dealii::Tensor<1, 2> old_tool_offset;

    // At the last evaluation:
    std::vector<FilmState> states;
    FilmGeometry           film_geometry;
    FilmLinearization      linearization;
    MatrixEntries          tangent; ///< which add() fills
    std::string            failure;
  };
} // namespace asperity

#endif
