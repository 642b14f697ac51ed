#ifndef asperity_lubricant_reynolds_film_h
#define asperity_lubricant_reynolds_film_h

#include <asperity/base/convergence_report.h>
#include <asperity/lubricant/film_flux.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  /** The cells of a film between two surfaces: n cells, n + 1 faces from left
   *  to right, or n faces if periodic, where face 0 is also the last one. */
  struct FilmGeometry
  {
    std::vector<double>   volume; ///< of the gap over a cell [m^2]
    std::vector<FilmFace> faces;

    /** Oil added to a cell, at ambient density [m^2/s]; empty for none. Minus
     *  the rate of `volume` it is what a squeeze at this instant displaces. */
    std::vector<double> supply;
  };

  /** What is on both sides of a film. */
  struct FilmEnds
  {
    bool      periodic = true;
    FilmState left, right; ///< if not periodic
  };

  /** theta (rho/rho_0) V of a cell: its oil at ambient density. */
  struct FilmContent
  {
    double value; ///< [m^2]
    double d_pressure, d_fraction, d_volume;
  };

  /** The Fischer-Burmeister function phi(p/p_s, 1 - theta) of a cell, which
   *  vanishes where p >= 0, theta <= 1 and one of them is attained. */
  struct FilmComplementarity
  {
    double value; ///< [-]
    double d_pressure, d_fraction;
  };

  /** All that the equations of a film consist of, with derivatives. */
  struct FilmLinearization
  {
    std::vector<FilmContent>         content;         ///< a cell
    std::vector<FilmComplementarity> complementarity; ///< a cell
    std::vector<FilmFluxes>          fluxes;          ///< a face
  };

  /** The step from which a film starts. */
  struct FilmStep
  {
    /** FilmContent::value at its start [m^2]; empty for a steady film. */
    std::vector<double> old_content;
    double              dt = std::numeric_limits<double>::infinity(); ///< [s]

    bool
    is_steady() const
    {
      return old_content.empty();
    }
  };

  /**
   * A thin film between the walls y = h_1(x, t) and y = h_2(x, t), h = h_2 -
   * h_1, whose particles move with (u_i, v_i). The continuity equation,
   * integrated over the thickness with Leibniz' rule, leaves at each wall
   * rho (dh_i/dt + u_i dh_i/dx - v_i), which vanishes since no oil passes a
   * wall. So whatever the walls do,
   *
   *   d(theta rho h)/dt + dF/dx = 0,
   *   F = theta rho h (u_1 + u_2)/2 - rho h^3/(12 eta) dp/dx,
   *
   * and the squeeze v_2 - v_1 - u_2 dh_2/dx + u_1 dh_1/dx is dh/dt at fixed x.
   * Between faces that move with w, the fluxes are those relative to the face
   * and the volume is that of the moving cell.
   *
   * Cavitation conserves mass (Jakobsson, Floberg, Olsson; H. G. Elrod, J.
   * Lubr. Technol. 103 (1981) 350): p >= 0, theta <= 1, p (1 - theta) = 0. This
   * is written as a Fischer-Burmeister equation and solved together with the
   * balance by Newton's method (T. Woloszynski, P. Podsiadlo, G. W. Stachowiak,
   * Tribol. Lett. 58 (2015) 18).
   *
   * Finite volumes in x, implicit Euler in time:
   *
   *   R_i = m_i - m_i^old + dt (F_right - F_left - supply_i),
   *   m_i = theta_i r(p_i) V_i;   steady: R_i = F_right - F_left - supply_i.
   *
   * linearize() gives every number of these equations with its derivatives by
   * the state and by the geometry, so that a coupled problem whose walls deform
   * can assemble them with the chain rule; solve() does so for given walls.
   */
  class ReynoldsFilm
  {
  public:
    /** @throws InputError as LubricantParameters::check() */
    ReynoldsFilm(const LubricantParameters &lubricant,
                 const unsigned int         n_cells,
                 const FilmEnds            &ends);

    unsigned int
    n_cells() const;

    unsigned int
    n_faces() const;

    /** The cell left of a face, none beyond an end. */
    std::optional<unsigned int>
    left_cell(const unsigned int face) const;

    std::optional<unsigned int>
    right_cell(const unsigned int face) const;

    const FilmLubricant &
    lubricant() const;

    /** @param pressure_scale p_s > 0 [Pa] */
    void
    linearize(const std::vector<FilmState> &states,
              const FilmGeometry           &geometry,
              const double                  pressure_scale,
              FilmLinearization            &result) const;

    /** R_i of all cells [m^2], steady [m^2/s]. */
    std::vector<double>
    balance(const FilmLinearization &linearization,
            const FilmGeometry      &geometry,
            const FilmStep          &step) const;

    /**
     * The contents at the end of the step by the fluxes: old content minus
     * what has flown out. Those of the states differ from them by R_i; to go on
     * from these loses no oil, however accurate the solution is.
     */
    std::vector<double>
    advanced_content(const FilmLinearization &linearization,
                     const FilmGeometry      &geometry,
                     const FilmStep          &step) const;

    /** The pressure that a full film of ambient viscosity would need, a scale
     *  for linearize() [Pa]; positive. */
    double
    typical_pressure(const FilmGeometry &geometry, const FilmStep &step) const;

    /**
     * Solves for the states. On failure the report says why, and the states are
     * those of the last iteration. report.residual is the Euclidean norm of
     * balances over the largest flow and of complementarities.
     */
    ConvergenceReport
    solve(const FilmGeometry     &geometry,
          const FilmStep         &step,
          std::vector<FilmState> &states) const;

    /**
     * A sentence if the states do not deserve trust although they solve the
     * equations, else empty: the viscosity is beyond its law, or changes by
     * more than a factor e between two cells. So ends the film whose
     * piezoviscous pressure runs away, where the exact pressure is infinite.
     */
    std::string
    warning(const FilmGeometry           &geometry,
            const std::vector<FilmState> &states) const;

    /** A sentence if the viscosity changes by so much between two cells that
     *  the load is per cents off, else empty. */
    std::string
    coarseness(const FilmGeometry           &geometry,
               const std::vector<FilmState> &states) const;

    /** @throws InputError as the constructor */
    void
    set_lubricant(const LubricantParameters &lubricant);

  private:
    FilmState
    state_beside(const std::optional<unsigned int> &cell,
                 const FilmState                   &end,
                 const std::vector<FilmState>      &states) const;

    /** Why there is no solution, or not one only; else empty. */
    std::string
    contradiction(const FilmGeometry &geometry, const FilmStep &step) const;

    FilmLubricant lubricant_;
    unsigned int  n;
    FilmEnds      ends;
  };

  /** phi(a, b) = a + b - sqrt(a^2 + b^2), a = p/scale, b = 1 - theta (A.
   *  Fischer, Optimization 24 (1992) 269); at the corner the middle of its
   *  generalised derivatives. */
  FilmComplementarity
  fischer_burmeister(const FilmState &state, const double pressure_scale);
} // namespace asperity

#endif
