#include <asperity/base/mpi_session.h>
#include <asperity/solvers/saddle_point_krylov.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/vector_memory.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity
{
  namespace
  {
    using Vector = dealii::Vector<double>;
    using Matrix = dealii::SparseMatrix<double>;
    using Amg    = dealii::TrilinosWrappers::PreconditionAMG;

    void
    initialize(Amg                                  &amg,
               const Matrix                         &matrix,
               const std::vector<std::vector<bool>> &constant_modes,
               const bool                            is_velocity)
    {
      Amg::AdditionalData data;
      data.higher_order_elements = is_velocity;
      data.aggregation_threshold = 0.02;
      data.constant_modes        = constant_modes;
      // Chebyshev polynomials want a symmetric matrix, which convection spoils.
      if (is_velocity)
        {
          data.smoother_type   = "ILU";
          data.smoother_sweeps = 1;
        }
      // Entries are small where lengths are micrometres: none is dropped.
      amg.initialize(matrix, data, 0.);
    }



    /** Entries of the second block of a vector. */
    void
    scale_from(Vector &v, const unsigned int first, const double factor)
    {
      for (unsigned int i = first; i < v.size(); ++i)
        v(i) *= factor;
    }
  } // namespace



  /** K with weighted rows of the second block. */
  class SaddlePointKrylov::ScaledMatrix
  {
  public:
    explicit ScaledMatrix(const SaddlePointKrylov &solver)
      : solver(solver)
    {}

    void
    vmult(Vector &y, const Vector &x) const
    {
      solver.matrix->vmult(y, x);
      scale_from(y, solver.n_first, solver.row_weight);
    }

  private:
    const SaddlePointKrylov &solver;
  };



  /** P^-1 of the scaled matrix. */
  class SaddlePointKrylov::BlockTriangular
  {
  public:
    explicit BlockTriangular(const SaddlePointKrylov &solver)
      : solver(solver)
      , r(solver.matrix->m() - solver.n_first)
      , p(r)
      , f(solver.n_first)
      , v(f)
    {}

    void
    vmult(Vector &y, const Vector &x) const
    {
      const unsigned int n = solver.n_first;
      std::copy(x.begin() + n, x.end(), r.begin());
      r *= -1. / solver.row_weight;
      solver.apply_schur(p, r);
      solver.gradient.vmult(f, p);
      for (unsigned int i = 0; i < n; ++i)
        f(i) = x(i) - f(i);
      solver.velocity_inverse.vmult(v, f);
      std::copy(v.begin(), v.end(), y.begin());
      std::copy(p.begin(), p.end(), y.begin() + n);
    }

  private:
    const SaddlePointKrylov &solver;
    mutable Vector           r, p, f, v;
  };



  SaddlePointKrylov::StartedMpi::StartedMpi()
  {
    MpiSession::start();
  }



  SaddlePointKrylov::SaddlePointKrylov(
    const std::vector<std::vector<bool>> &components,
    const KrylovOptions                  &options)
    : options(options)
    , modes(components)
    , n_first(components.front().size())
  {}



  void
  SaddlePointKrylov::build_patterns()
  {
    dealii::DynamicSparsityPattern own(n_first);
    dealii::DynamicSparsityPattern other(n_first, matrix->m() - n_first);
    for (unsigned int r = 0; r < n_first; ++r)
      for (auto entry = matrix->begin(r); entry != matrix->end(r); ++entry)
        if (entry->column() < n_first)
          own.add(r, entry->column());
        else
          other.add(r, entry->column() - n_first);
    velocity_pattern.copy_from(own);
    velocity.reinit(velocity_pattern);
    gradient_pattern.copy_from(other);
    gradient.reinit(gradient_pattern);
    laplacian.reinit(laplacian_pattern);
  }



  void
  SaddlePointKrylov::copy_blocks()
  {
    for (unsigned int r = 0; r < n_first; ++r)
      for (auto entry = matrix->begin(r); entry != matrix->end(r); ++entry)
        if (entry->column() < n_first)
          velocity.set(r, entry->column(), entry->value());
        else
          gradient.set(r, entry->column() - n_first, entry->value());
  }



  void
  SaddlePointKrylov::build_laplacian()
  {
    inverse_scale = schur->inertia;
    for (unsigned int i = 0; i < n_first; ++i)
      {
        double &d = inverse_scale(i);
        if (is_convective)
          d = std::abs(velocity.diag_element(i));
        d = d > 0. ? 1. / d : 0.;
      }
    const bool is_new = laplacian.empty();
    if (!is_new)
      laplacian = 0.;
    gradient.Tmmult(laplacian, gradient, inverse_scale, is_new);
    // G^T D^-1 G has the couplings of C, too.
    const unsigned int n = laplacian.m();
    for (unsigned int r = 0; r < n; ++r)
      for (auto entry = matrix->begin(n_first + r);
           entry != matrix->end(n_first + r);
           ++entry)
        if (entry->column() >= n_first && laplacian.diag_element(r) > 0.)
          laplacian.add(r, entry->column() - n_first, -entry->value());
    // Constrained unknowns couple to none; any diagonal makes them zero.
    const double size = laplacian.linfty_norm();
    for (unsigned int r = 0; r < n; ++r)
      if (!(laplacian.diag_element(r) > 0.))
        laplacian.diag_element(r) = size;
    initialize(laplacian_inverse,
               laplacian,
               {std::vector<bool>(laplacian.m(), true)},
               false);
  }



  bool
  SaddlePointKrylov::prepare(const Matrix        &new_matrix,
                             const SchurEstimate &new_schur)
  {
    matrix = &new_matrix;
    schur  = &new_schur;
    if (!std::isfinite(matrix->frobenius_norm()))
      return false;
    is_convective = schur->is_convective;
    has_mass      = !is_convective && !schur->mass.empty();
    has_laplacian = is_convective || schur->inertia.linfty_norm() > 0.;
    if (gradient.empty())
      build_patterns();
    copy_blocks();
    row_weight = velocity.frobenius_norm() / gradient.frobenius_norm();
    try
      {
        initialize(velocity_inverse, velocity, modes, true);
        if (has_laplacian)
          build_laplacian();
        if (has_mass)
          mass_inverse.initialize(schur->mass);
      }
    catch (const dealii::ExceptionBase &)
      {
        return false;
      }
    return true;
  }



  void
  SaddlePointKrylov::apply_schur(Vector &x, const Vector &b) const
  {
    if (is_convective)
      {
        apply_commutator(x, b);
        return;
      }
    x = 0.;
    Vector y(b);
    if (has_mass)
      {
        // The mass matrix knows nothing of the level that is held. Its equation
        // is minus the sum of the others of its set.
        for (const auto &set : schur->levels)
          {
            double sum = 0.;
            for (const unsigned int i : set)
              sum += b(i);
            y(set.front()) -= sum;
          }
        mass_inverse.vmult(x, y);
        for (const auto &set : schur->levels)
          {
            const double level = x(set.front());
            for (const unsigned int i : set)
              x(i) -= level;
          }
      }
    if (has_laplacian)
      {
        laplacian_inverse.vmult(y, b);
        x += y;
      }
  }



  void
  SaddlePointKrylov::apply_commutator(Vector &x, const Vector &b) const
  {
    Vector y(b.size()), f(n_first), g(n_first);
    laplacian_inverse.vmult(y, b);
    gradient.vmult(f, y);
    f.scale(inverse_scale);
    velocity.vmult(g, f);
    g.scale(inverse_scale);
    gradient.Tvmult(y, g);
    laplacian_inverse.vmult(x, y);
  }



  ConvergenceReport
  SaddlePointKrylov::solve(Vector &rhs) const
  {
    ConvergenceReport report;
    scale_from(rhs, n_first, row_weight);
    const double size = rhs.l2_norm();
    Vector       x(rhs.size());
    if (size == 0.)
      {
        report.converged = true;
        return report;
      }
    dealii::SolverControl control(options.maximum_iterations,
                                  options.tolerance * size,
                                  false,
                                  false);
    // Gives the basis back, unlike the default.
    dealii::PrimitiveVectorMemory<Vector> memory;
    dealii::SolverFGMRES<Vector>          fgmres(
      control,
      memory,
      dealii::SolverFGMRES<Vector>::AdditionalData(options.restart));
    try
      {
        fgmres.solve(ScaledMatrix(*this), x, rhs, BlockTriangular(*this));
        report.converged = true;
      }
    catch (const dealii::ExceptionBase &)
      {
        report.reason = "the Krylov solver did not converge in " +
                        std::to_string(control.last_step()) + " iterations";
      }
    report.iterations = control.last_step();
    report.residual   = control.last_value() / size;
    rhs.swap(x);
    return report;
  }
} // namespace asperity
