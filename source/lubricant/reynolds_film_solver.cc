#include <asperity/lubricant/reynolds_film.h>
#include <asperity/solvers/finite.h>
#include <asperity/solvers/linear_solver.h>
#include <asperity/solvers/newton.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asperity
{
  namespace
  {
    using Vector = dealii::Vector<double>;

    /** The equations of a film between given walls; unknowns are p_i/p_s and
     *  theta_i in turn, rows R_i over the largest flow and phi_i. */
    class FilmSystem : public NonlinearSystem
    {
    public:
      FilmSystem(const ReynoldsFilm &film,
                 const FilmGeometry &geometry,
                 const FilmStep     &step)
        : film(film)
        , geometry(geometry)
        , step(step)
        , pressure_scale(film.typical_pressure(geometry, step))
        , balance_scale(largest_flow())
        , states(film.n_cells())
        , solver(make_linear_solver(LinearSolverKind::klu))
      {
        dealii::DynamicSparsityPattern couplings(2 * film.n_cells());
        for (unsigned int i = 0; i < film.n_cells(); ++i)
          {
            couplings.add(2 * i, 2 * i + 1);
            couplings.add(2 * i + 1, 2 * i);
          }
        for (unsigned int f = 0; f < film.n_faces(); ++f)
          if (film.left_cell(f) && film.right_cell(f))
            for (unsigned int c = 0; c < 2; ++c)
              {
                couplings.add(2 * *film.left_cell(f),
                              2 * *film.right_cell(f) + c);
                couplings.add(2 * *film.right_cell(f),
                              2 * *film.left_cell(f) + c);
              }
        for (unsigned int i = 0; i < 2 * film.n_cells(); ++i)
          couplings.add(i, i);
        pattern.copy_from(couplings);
        matrix.reinit(pattern);
      }

      bool
      residual(const Vector &z, Vector &R) override
      {
        film.linearize(to_states(z), geometry, pressure_scale, linearization);
        const auto balance = film.balance(linearization, geometry, step);
        for (unsigned int i = 0; i < film.n_cells(); ++i)
          {
            R(2 * i)     = balance[i] / balance_scale;
            R(2 * i + 1) = linearization.complementarity[i].value;
          }
        return is_finite(R);
      }

      bool
      linearize(const Vector &z, Vector &R) override
      {
        if (!residual(z, R))
          return false;
        matrix               = 0.;
        const double storage = step.is_steady() ? 0. : 1. / balance_scale;
        for (unsigned int i = 0; i < film.n_cells(); ++i)
          {
            const FilmContent         &m   = linearization.content[i];
            const FilmComplementarity &phi = linearization.complementarity[i];
            matrix.add(2 * i, 2 * i, storage * m.d_pressure * pressure_scale);
            matrix.add(2 * i, 2 * i + 1, storage * m.d_fraction);
            matrix.add(2 * i + 1, 2 * i, phi.d_pressure * pressure_scale);
            matrix.add(2 * i + 1, 2 * i + 1, phi.d_fraction);
          }
        const double dt = (step.is_steady() ? 1. : step.dt) / balance_scale;
        for (unsigned int f = 0; f < film.n_faces(); ++f)
          {
            const auto &d = linearization.fluxes[f].flow.derivative;
            for (const bool row_is_left : {true, false})
              for (const bool column_is_left : {true, false})
                add_face(f,
                         row_is_left,
                         column_is_left,
                         (row_is_left ? dt : -dt) * pressure_scale *
                           d[column_is_left ? left_pressure : right_pressure],
                         (row_is_left ? dt : -dt) *
                           d[column_is_left ? left_fraction : right_fraction]);
          }
        return true;
      }

      bool
      direction(const Vector &R, Vector &d) override
      {
        if (!solver->factorize(matrix))
          return false;
        d.equ(-1., R);
        solver->solve(d);
        return is_finite(d);
      }

      Vector
      to_vector(const std::vector<FilmState> &given) const
      {
        Vector z(2 * film.n_cells());
        for (unsigned int i = 0; i < film.n_cells(); ++i)
          {
            z(2 * i)     = given[i].pressure / pressure_scale;
            z(2 * i + 1) = given[i].fraction;
          }
        return z;
      }

      const std::vector<FilmState> &
      to_states(const Vector &z)
      {
        for (unsigned int i = 0; i < film.n_cells(); ++i)
          states[i] = {pressure_scale * z(2 * i), z(2 * i + 1)};
        return states;
      }

    private:
      void
      add_face(const unsigned int f,
               const bool         row_is_left,
               const bool         column_is_left,
               const double       d_pressure,
               const double       d_fraction)
      {
        const auto row = row_is_left ? film.left_cell(f) : film.right_cell(f);
        const auto column =
          column_is_left ? film.left_cell(f) : film.right_cell(f);
        if (!row || !column)
          return;
        matrix.add(2 * *row, 2 * *column, d_pressure);
        matrix.add(2 * *row, 2 * *column + 1, d_fraction);
      }

      double
      largest_flow() const
      {
        const double eta  = film.lubricant().viscosity().parameters().viscosity;
        double       flow = 0.;
        for (const FilmFace &face : geometry.faces)
          flow =
            std::max(flow,
                     std::abs(face.couette_speed) * face.gap +
                       std::pow(face.gap, 3) / (12. * eta) * pressure_scale /
                         (face.distance * film.n_cells()));
        return flow * (step.is_steady() ? 1. : step.dt);
      }

      const ReynoldsFilm &film;
      const FilmGeometry &geometry;
      const FilmStep     &step;
      const double        pressure_scale; ///< [Pa]
      const double        balance_scale;  ///< of R_i, in its unit

      std::vector<FilmState>        states;
      FilmLinearization             linearization;
      dealii::SparsityPattern       pattern;
      dealii::SparseMatrix<double>  matrix;
      std::unique_ptr<LinearSolver> solver;
    };
  } // namespace



  std::string
  ReynoldsFilm::contradiction(const FilmGeometry &geometry,
                              const FilmStep     &step) const
  {
    if (!ends.periodic)
      return "";
    if (step.is_steady())
      return "a steady periodic film does not know how much oil it holds";
    const auto total = [](const std::vector<double> &values) {
      return std::accumulate(values.begin(), values.end(), 0.);
    };
    const double oil =
      total(step.old_content) + step.dt * total(geometry.supply);
    if (lubricant_.is_incompressible() &&
        oil > (1. - 1e-12) * total(geometry.volume))
      return "an incompressible lubricant fills the whole period or more, so "
             "that its pressure has no level";
    return "";
  }



  ConvergenceReport
  ReynoldsFilm::solve(const FilmGeometry     &geometry,
                      const FilmStep         &step,
                      std::vector<FilmState> &states) const
  {
    ConvergenceReport report;
    report.reason = contradiction(geometry, step);
    if (!report.reason.empty())
      return report;
    NewtonOptions options;
    options.tolerance          = 1e-11;
    options.maximum_iterations = 200;
    options.line_search_trials = 30;
    options.merit              = NewtonMerit::residual_norm;
    FilmSystem       system(*this, geometry, step);
    NewtonStatistics statistics;
    Vector           z      = system.to_vector(states);
    report                  = newton(system, z, options, statistics);
    states                  = system.to_states(z);
    const std::string doubt = warning(geometry, states);
    if (!report.converged && !doubt.empty())
      report.reason = doubt;
    return report;
  }
} // namespace asperity
