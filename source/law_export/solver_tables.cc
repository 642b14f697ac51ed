#include <asperity/base/quantity.h>
#include <asperity/law_export/solver_tables.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "export_text.h"

namespace asperity
{
  namespace
  {
    std::string
    number(const double       value,
           const unsigned int digits = FrictionGrid::n_digits)
    {
      return std::isfinite(value) ? format_quantity(value, "1", digits) :
                                    std::string("nan");
    }

    /** With a decimal point or an exponent, as keyword decks want real numbers.
     *  A coordinate that the law does not have becomes 0. */
    std::string
    real(const double value)
    {
      const std::string text =
        std::isfinite(value) ? number(value) : std::string("0");
      return text.find_first_of(".e") == std::string::npos ? text + "." : text;
    }

    /** Right-aligned in a column of a fixed format. */
    std::string
    column(const std::string &text, const std::size_t width)
    {
      return std::string(width > text.size() ? width - text.size() : 0, ' ') +
             text;
    }

    std::string
    units_line(const FrictionGrid &grid)
    {
      const SolverUnits &units = grid.options().units;
      return "Units: pressure " + units[0] + ", velocity " + units[1] +
             ", temperature " + units[2] + ".";
    }

    std::vector<std::string>
    error_lines(const double        error,
                const FrictionGrid &grid,
                const std::string  &between,
                const std::size_t   width = 66)
    {
      std::vector<std::string> lines =
        wrapped("Largest error of linear interpolation " + between + ": " +
                  percent(error, 3) + " of mu (tolerance " +
                  percent(grid.options().tolerance) +
                  "), measured against the law at " +
                  std::to_string(grid.n_checked()) + " points.",
                width);
      if (!grid.tolerance_is_reached())
        for (const std::string &line :
             wrapped("The tolerance could not be kept with at most " +
                       std::to_string(grid.options().max_nodes) + " entries.",
                     width))
          lines.push_back(line);
      return lines;
    }

    void
    append(std::vector<std::string>       &lines,
           const std::vector<std::string> &further)
    {
      lines.insert(lines.end(), further.begin(), further.end());
    }

    std::string
    shear_limits_line(const ContactPointLaw &law, const FrictionGrid &grid)
    {
      std::string text = "k(T) in " + grid.options().units[0] + ":";
      for (std::size_t k = 0; k < grid.nodes(2).size(); ++k)
        if (const double T = grid.point(0, 0, k)[2]; std::isfinite(T))
          text +=
            " " +
            number(from_si(law.shear_limit(T), grid.options().units[0]), 4) +
            " at " + number(grid.nodes(2)[k]) + " " + grid.options().units[2] +
            ";";
      text.back() = '.';
      return text;
    }
  } // namespace



  std::string
  abaqus_table(const ContactPointLaw &law,
               const FrictionGrid    &grid,
               const double           temperature)
  {
    const SolverUnits       &units = grid.options().units;
    std::vector<std::string> title = {
      "Friction for Abaqus: *FRICTION under *SURFACE INTERACTION.",
      "Not run in that program.",
      units_line(grid)};
    append(title,
           error_lines(grid.interpolation_error(),
                       grid,
                       "between the entries"));
    const double limit = from_si(law.shear_limit(temperature), units[0]);
    const bool   known = std::isfinite(limit);
    if (known)
      {
        append(title,
               wrapped("TAUMAX is the shear limit k at " +
                         format_quantity(temperature, units[2], 5) +
                         "; Abaqus knows one number only. " +
                         shear_limits_line(law, grid),
                       66));
      }
    append(title,
           wrapped("Entries: mu, slip rate, pressure, temperature. A user "
                   "subroutine (abaqus_fric_coef.f) has k(T) and the law "
                   "beyond the table as well.",
                   66));

    std::string text = comment_header(title, law, "**");
    text += "*FRICTION" + (known ? ", TAUMAX=" + real(limit) : "") + "\n";
    for (std::size_t k = 0; k < grid.nodes(2).size(); ++k)
      for (std::size_t i = 0; i < grid.nodes(0).size(); ++i)
        for (std::size_t j = 0; j < grid.nodes(1).size(); ++j)
          text += real(grid.mu(i, j, k)) + ", " + real(grid.nodes(1)[j]) +
                  ", " + real(grid.nodes(0)[i]) + ", " +
                  real(grid.nodes(2)[k]) + "\n";
    return text;
  }



  std::string
  lsdyna_table(const ContactPointLaw &law, const FrictionGrid &grid)
  {
    // tables and curves share their numbers
    constexpr std::size_t    first_id = 910000;
    const std::size_t        n_p      = grid.nodes(0).size();
    std::vector<std::string> title    = {
         "Friction for LS-DYNA: mu(v, p), a table for each temperature.",
         "Not run in that program.",
         units_line(grid)};
    append(title,
           error_lines(error_on_planes(grid, 2),
                       grid,
                       "in v and p at these temperatures"));
    append(
      title,
      wrapped("LS-DYNA does not interpolate in temperature: choose one "
              "table. In *CONTACT, FS = 2 makes FD the number of the table "
              "(check it in the manual of your version). The tables do "
              "not limit tau; " +
                shear_limits_line(law, grid),
              66));
    std::string text = comment_header(title, law, "$") + "*KEYWORD\n";
    for (std::size_t k = 0; k < grid.nodes(2).size(); ++k)
      {
        const std::size_t table = first_id + k * (n_p + 1);
        text += "$\n$ T = " + number(grid.nodes(2)[k]) + " " +
                grid.options().units[2] +
                "\n*DEFINE_TABLE_2D\n$#    tbid       sfa      offa\n" +
                column(std::to_string(table), 10) + column("1.0", 10) +
                column("0.0", 10) +
                "\n$#          pressure             curve\n";
        for (std::size_t i = 0; i < n_p; ++i)
          text += column(real(grid.nodes(0)[i]), 20) +
                  column(std::to_string(table + 1 + i), 20) + "\n";
        for (std::size_t i = 0; i < n_p; ++i)
          {
            text += "*DEFINE_CURVE\n$#    lcid      sidr       sfa       sfo"
                    "      offa      offo    dattyp\n" +
                    column(std::to_string(table + 1 + i), 10) +
                    column("0", 10) + column("1.0", 10) + column("1.0", 10) +
                    column("0.0", 10) + column("0.0", 10) + column("0", 10) +
                    "\n$#          velocity                mu\n";
            for (std::size_t j = 0; j < grid.nodes(1).size(); ++j)
              text += column(real(grid.nodes(1)[j]), 20) +
                      column(real(grid.mu(i, j, k)), 20) + "\n";
          }
      }
    return text + "*END\n";
  }



  std::string
  deform_table(const ContactPointLaw &law,
               const FrictionGrid    &grid,
               const std::size_t      velocity)
  {
    const SolverUnits       &units = grid.options().units;
    std::vector<std::string> title = {
      "Friction for DEFORM: FRCFAC, Coulomb, over pressure and temperature,",
      "for v = " + number(grid.nodes(1)[velocity]) + " " + units[1] +
        ". Not run in that program.",
      units_line(grid)};
    append(title,
           error_lines(grid.interpolation_error(1, velocity),
                       grid,
                       "in p and T at this velocity"));
    append(title,
           wrapped("Set the numbers of the two objects, 1 and 2 here. DEFORM "
                   "has no table over velocity: there is a file for each "
                   "velocity, and deform_usr_bcc.f has them all. The table "
                   "does not limit tau; " +
                     shear_limits_line(law, grid),
                   66));
    const std::size_t n_p = grid.nodes(0).size(), n_T = grid.nodes(2).size();
    std::string text = comment_header(title, law, "*") + "FRCFAC 1 2 2 5 " +
                       std::to_string(n_p) + " " + std::to_string(n_T) + " 1\n";
    for (std::size_t i = 0; i < n_p; ++i)
      text += (i == 0 ? "" : " ") + real(grid.nodes(0)[i]);
    text += "\n";
    for (std::size_t k = 0; k < n_T; ++k)
      text += (k == 0 ? "" : " ") + real(grid.nodes(2)[k]);
    text += "\n1.\n";
    for (std::size_t k = 0; k < n_T; ++k)
      {
        for (std::size_t i = 0; i < n_p; ++i)
          text += (i == 0 ? "" : " ") + real(grid.mu(i, velocity, k));
        text += "\n";
      }
    return text;
  }



  std::string
  friction_table_csv(const ContactPointLaw &law, const FrictionGrid &grid)
  {
    std::vector<std::string> title = {
      "Friction coefficient by pressure, sliding velocity and temperature.",
      "mu: friction coefficient; sigma_mu: its standard deviation;",
      "k_Pa: shear limit; tau_Pa: min(mu p, k); trusted: 1 inside of the",
      "training data with a small deviation, else 0.",
      units_line(grid)};
    append(title,
           error_lines(grid.interpolation_error(), grid, "between the rows"));
    std::string text = comment_header(title, law, "#") +
                       "p_Pa,v_m_per_s,T_K,mu,sigma_mu,tau_Pa,k_Pa,trusted\n";
    for (std::size_t k = 0; k < grid.nodes(2).size(); ++k)
      for (std::size_t j = 0; j < grid.nodes(1).size(); ++j)
        for (std::size_t i = 0; i < grid.nodes(0).size(); ++i)
          {
            const ContactPoint  point   = grid.point(i, j, k);
            const LawPrediction at      = law.predict(point);
            const double        k_Pa    = law.shear_limit(point[2]);
            const double        coulomb = at.mean * point[0];
            for (const double value : {point[0],
                                       point[1],
                                       point[2],
                                       grid.mu(i, j, k),
                                       at.deviation,
                                       coulomb > k_Pa ? k_Pa : coulomb,
                                       k_Pa})
              text += number(value) + ",";
            text += at.trusted ? "1\n" : "0\n";
          }
    return text;
  }



  double
  error_on_planes(const FrictionGrid &grid, const unsigned int coordinate)
  {
    double result = 0.;
    for (std::size_t node = 0; node < grid.nodes(coordinate).size(); ++node)
      result = std::max(result, grid.interpolation_error(coordinate, node));
    return result;
  }
} // namespace asperity
