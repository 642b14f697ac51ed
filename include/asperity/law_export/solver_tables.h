#ifndef asperity_law_export_solver_tables_h
#define asperity_law_export_solver_tables_h

#include <asperity/law_export/friction_grid.h>

#include <string>

namespace asperity
{
  /**
   * A law as tables that chip-formation programs read without any user code.
   * Each text says in its comments the units, the measured error of linear
   * interpolation, the provenance of the law and a permissive licence, and that
   * it has not been run in the program. Beyond the table these programs hold
   * the last value, as far as they document it, where the law itself goes on.
   */

  /**
   * Abaqus: `*FRICTION` with mu over slip rate, pressure and average
   * temperature, and TAUMAX, which is one number there.
   * @param temperature at which TAUMAX = k(T) is taken [K]
   */
  std::string
  abaqus_table(const ContactPointLaw &law,
               const FrictionGrid    &grid,
               const double           temperature);

  /** LS-DYNA: for each temperature of the grid, which LS-DYNA cannot
   *  interpolate, a table of curves mu(v), one a pressure. */
  std::string
  lsdyna_table(const ContactPointLaw &law, const FrictionGrid &grid);

  /** DEFORM: FRCFAC with mu over pressure and temperature at one velocity of
   *  the grid, which DEFORM cannot interpolate. */
  std::string
  deform_table(const ContactPointLaw &law,
               const FrictionGrid    &grid,
               const std::size_t      velocity);

  /**
   * Long table with a row for each node: p_Pa, v_m_per_s, T_K, mu, sigma_mu,
   * tau_Pa, k_Pa, trusted (1 or 0), under lines that start with #. What is
   * unknown is nan.
   * @param grid in SI units
   */
  std::string
  friction_table_csv(const ContactPointLaw &law, const FrictionGrid &grid);

  /** "LS-DYNA cannot interpolate in T", the error there: the largest one on the
   *  planes of the nodes of a coordinate. */
  double
  error_on_planes(const FrictionGrid &grid, const unsigned int coordinate);
} // namespace asperity

#endif
