#include <asperity/flow/navier_stokes.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>

// What the divergence of the initial velocity needs, lest the pressure of small
// steps explode.
namespace asperity
{
  namespace
  {
    using Vector = dealii::Vector<double>;

    const dealii::FEValuesExtractors::Vector velocity_field(0);
    const dealii::FEValuesExtractors::Scalar pressure_field(2);

    /** int v.w - int phi div w - int q div v */
    void
    assemble_saddle_point(const FluidSpace                        &space,
                          const dealii::Mapping<2>                &mapping,
                          const dealii::AffineConstraints<double> &constraints,
                          dealii::SparseMatrix<double>            &matrix)
    {
      const auto                                  &fe = space.dofs().get_fe();
      const unsigned int                           n  = fe.n_dofs_per_cell();
      const dealii::QGauss<2>                      quadrature(fe.degree + 1);
      dealii::FEValues<2>                          values(mapping,
                                 fe,
                                 quadrature,
                                 dealii::update_values |
                                   dealii::update_gradients |
                                   dealii::update_JxW_values);
      dealii::FullMatrix<double>                   K(n, n);
      std::vector<dealii::types::global_dof_index> dofs(n);
      matrix = 0.;
      for (const auto &cell : space.cells())
        {
          values.reinit(cell);
          const auto &v = values[velocity_field];
          const auto &p = values[pressure_field];
          K             = 0.;
          for (const unsigned int q : values.quadrature_point_indices())
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                K(i, j) += (v.value(i, q) * v.value(j, q) -
                            p.value(j, q) * v.divergence(i, q) -
                            p.value(i, q) * v.divergence(j, q)) *
                           values.JxW(q);
          cell->get_dof_indices(dofs);
          constraints.distribute_local_to_global(K, dofs, matrix);
        }
    }



    /** Of the entries from the first on. */
    double
    norm_from(const Vector &vector, const unsigned int first)
    {
      double squares = 0.;
      for (unsigned int i = first; i < vector.size(); ++i)
        squares += vector(i) * vector(i);
      return std::sqrt(squares);
    }



    // Of the projection of the initial velocity.
    constexpr double       tolerance           = 1e-13;
    constexpr unsigned int maximum_repetitions = 20;



    /** Adds -epsilon |phi|^2, which makes the projection regular with any
     *  pressure level; a few repetitions from the last phi remove its
     *  influence. */
    void
    regularize(const FluidSpace &space, dealii::SparseMatrix<double> &matrix)
    {
      constexpr double epsilon = 1e-7;
      for (unsigned int i = space.n_velocity_dofs(); i < matrix.m(); ++i)
        if (!space.topology().is_constrained(i))
          matrix.add(i, i, -epsilon);
    }
  } // namespace



  Vector
  NavierStokes::galerkin_divergence() const
  {
    Vector result(volume_source);
    result += content_source;
    assembler.add_continuity(u, result);
    return result;
  }



  ConvergenceReport
  NavierStokes::project_initial_velocity()
  {
    ConvergenceReport report;
    report.converged = options.element == FluidElement::equal_order;
    if (report.converged)
      return report;
    report.reason = prepare();
    if (!report.reason.empty())
      return report;
    dealii::SparseMatrix<double> saddle_point(pattern);
    // The equations themselves, and those without the prescribed unknowns.
    assemble_saddle_point(space_, mapping(), space_.topology(), saddle_point);
    assemble_saddle_point(space_, mapping(), constraints, matrix);
    fill_empty_rows();
    is_factorised                 = false; // no tangent of the flow
    const unsigned int n_velocity = space_.n_velocity_dofs();
    regularize(space_, matrix);
    const auto estimate = [this]() -> const SchurEstimate & {
      return schur.of_projection(matrix, level.held_dofs());
    };
    if (!solver->prepare(matrix, estimate))
      {
        report.reason = "the projection of the initial velocity is singular";
        return report;
      }

    Vector x(u), load(u.size()), R(u.size());
    std::fill(x.begin() + n_velocity, x.end(), 0.);
    saddle_point.vmult(load, x); // M v_0, and the source in place of - B v_0
    for (unsigned int i = n_velocity; i < u.size(); ++i)
      load(i) = -volume_source(i);
    // One velocity everywhere would have a residual of about this size.
    const double size = u.linfty_norm() * std::sqrt(volume());
    for (; report.iterations < maximum_repetitions; ++report.iterations)
      {
        saddle_point.vmult(R, x); // M v - B^T phi, and - B v
        R -= load;
        report.residual = norm_from(R, n_velocity);
        constraints.set_zero(R);
        if (report.iterations > 0 && report.residual <= tolerance * size)
          {
            report.converged = true;
            break;
          }
        R *= -1.;
        const ConvergenceReport linear = solver->solve(R);
        statistics_.linear_iterations += linear.iterations;
        if (!linear.converged)
          {
            report.reason = linear.reason;
            return report;
          }
        constraints.distribute(R);
        x += R;
      }
    if (!report.converged)
      report.reason = "the projection of the initial velocity did not converge";
    std::copy_n(x.begin(), n_velocity, u.begin());
    u_old = u;
    return report;
  }
} // namespace asperity
