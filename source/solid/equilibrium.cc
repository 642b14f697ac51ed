#include <asperity/base/errors.h>
#include <asperity/solid/equilibrium.h>
#include <asperity/solvers/finite.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  namespace
  {
    /** Of the equations with an unsymmetric part, relative: below what a step
     *  of Newton's method gains, but for the last, which is judged by its
     *  residual. With 1e-4 there are as many steps, with 1e-2 more. */
    constexpr double krylov_tolerance = 1e-3;
  } // namespace



  Equilibrium::Equilibrium(const unsigned int                       n_dofs,
                           const std::vector<ForceTerm *>          &terms,
                           const dealii::AffineConstraints<double> &constraints,
                           const LinearSolverKind                   solver_kind,
                           const SharedSystem                      &shared)
    : shared(shared)
    , terms(terms)
    , constraints(constraints)
    , solver(make_linear_solver(solver_kind, shared))
    , solver_is_symmetric(is_for_symmetric(solver_kind))
    , unsymmetric(shared.ranks)
    , support(dealii::numbers::invalid_unsigned_int)
    , load(n_dofs)
    , inertia_constant(n_dofs)
  {
    for (const auto &line : constraints.get_lines())
      if (!line.entries.empty())
        throw ComputationError(
          "Component " + std::to_string(line.index) +
          " of a displacement is constrained by others, but a force balance "
          "takes prescribed components only.");
    dealii::DynamicSparsityPattern couplings(n_dofs);
    for (const ForceTerm *term : terms)
      term->add_couplings(couplings);
    for (unsigned int i = 0; i < n_dofs; ++i)
      couplings.add(i, i);
    pattern.copy_from(couplings);
    matrix.reinit(pattern);
    for (auto entry = matrix.begin(); entry != matrix.end(); ++entry)
      if (entry->row() != entry->column() &&
          (constraints.is_constrained(entry->row()) ||
           constraints.is_constrained(entry->column())))
        eliminated.push_back(entry);
  }



  bool
  Equilibrium::assemble(const Vector &u, Vector &R, const bool with_tangent)
  {
    dealii::Timer timer;
    R = 0.;
    if (with_tangent)
      {
        matrix        = 0.;
        matrix_is_new = true;
      }
    if (!add_terms(u, R, with_tangent ? &matrix : nullptr))
      return false;
    if (with_tangent)
      collect_parts();
    R -= load;
    if (mass != nullptr)
      {
        Vector inertia(u.size());
        mass->vmult(inertia, u);
        R.sadd(static_weight, mass_factor, inertia);
        R += inertia_constant;
        if (with_tangent)
          {
            matrix *= static_weight;
            dense_part.scale(static_weight);
            unsymmetric.scale(static_weight);
            matrix.add(mass_factor, *mass);
          }
      }
    constraints.set_zero(R);
    cost_.assembly += timer.wall_time();
    return true;
  }



  bool
  Equilibrium::add_terms(const Vector                 &u,
                         Vector                       &R,
                         dealii::SparseMatrix<double> *tangent)
  {
    const Ranks &ranks  = shared.ranks;
    bool         exists = true;
    // Terms may be collective: where one fails on a rank, all go on.
    for (ForceTerm *term : terms)
      if (exists || ranks.are_several())
        exists = term->add(u, R, tangent) && exists;
    if (!ranks.all(exists))
      return false;
    ranks.sum(R.begin(), R.size());
    return true;
  }



  void
  Equilibrium::collect_parts()
  {
    dense_part.clear();
    unsymmetric.clear();
    for (const ForceTerm *term : terms)
      {
        for (const RankOneTerm &dense : term->rank_one_terms())
          dense_part.add(dense.vector, dense.factor);
        if (const auto *part = term->unsymmetric_tangent())
          unsymmetric.add(*part);
      }
    if (solver_is_symmetric)
      return;
    unsymmetric.add_to(matrix, dealii::AffineConstraints<double>());
    unsymmetric.clear();
  }



  bool
  Equilibrium::residual(const Vector &u, Vector &R)
  {
    return assemble(u, R, false);
  }



  bool
  Equilibrium::linearize(const Vector &u, Vector &R)
  {
    return assemble(u, R, true);
  }



  void
  Equilibrium::eliminate_prescribed()
  {
    for (auto entry : eliminated)
      entry->value() = 0.;
    for (const auto &line : constraints.get_lines())
      {
        double &diagonal = matrix.diag_element(line.index);
        diagonal         = std::max(1., std::abs(diagonal));
      }
  }



  bool
  Equilibrium::direction(const Vector &R, Vector &d)
  {
    if ((matrix_is_new || !is_factorised) && !factorize())
      return false;
    dealii::Timer timer;
    d = R;
    d *= -1.;
    const bool solved = solve(d);
    cost_.solution += timer.wall_time();
    return solved && is_finite(d);
  }



  bool
  Equilibrium::factorize()
  {
    dealii::Timer timer;
    eliminate_prescribed();
    dense_part.drop_rows(constraints);
    if (support < matrix.m() && !dense_part.empty())
      {
        Vector unit(matrix.m());
        unit(support) = 1.;
        // The dense part is that of all ranks, the matrix their sum.
        double add = std::abs(matrix.diag_element(support));
        shared.ranks.sum(&add, 1);
        if (shared.ranks.is_first())
          matrix.add(support, support, add);
        dense_part.add(unit, -add);
      }
    is_factorised = solver->factorize(matrix) && dense_part.factorize(*solver);
    matrix_is_new = false;
    ++cost_.factorisations;
    cost_.factorisation += timer.wall_time();
    return is_factorised;
  }



  std::string
  Equilibrium::direction_failure() const
  {
    return solver->failure();
  }



  bool
  Equilibrium::has_tangent() const
  {
    return is_factorised;
  }



  bool
  Equilibrium::solve(Vector &b)
  {
    const auto apply_inverse = [this](Vector &x) {
      solver->solve(x);
      dense_part.correct(x);
    };
    if (unsymmetric.empty())
      {
        apply_inverse(b);
        return true;
      }
    return unsymmetric.solve(apply_inverse, constraints, krylov_tolerance, b) ||
           solve_with_fallback(b);
  }



  bool
  Equilibrium::solve_with_fallback(Vector &b)
  {
    if (!fallback)
      fallback = make_linear_solver(shared.ranks.are_several() ?
                                      LinearSolverKind::mumps :
                                      LinearSolverKind::umfpack,
                                    shared);
    dealii::SparseMatrix<double> sum(pattern);
    sum.copy_from(matrix);
    unsymmetric.add_to(sum, constraints);
    LowRankUpdate dense = dense_part;
    if (!fallback->factorize(sum) || !dense.factorize(*fallback))
      return false;
    fallback->solve(b);
    dense.correct(b);
    ++cost_.factorisations;
    return true;
  }



  void
  Equilibrium::set_support(const unsigned int dof)
  {
    support = dof;
  }



  void
  Equilibrium::set_load(const Vector &new_load)
  {
    load = new_load;
  }



  void
  Equilibrium::set_inertia(const dealii::SparseMatrix<double> *new_mass,
                           const double                        factor,
                           const Vector                       &constant,
                           const double                        weight)
  {
    mass             = new_mass;
    mass_factor      = factor;
    inertia_constant = constant;
    static_weight    = weight;
  }



  bool
  Equilibrium::prescribe(Vector &u, const Vector &target)
  {
    Vector increment(u.size()), R(u.size()), coupling(u.size());
    for (const auto &line : constraints.get_lines())
      increment(line.index) = target(line.index) - u(line.index);
    if (increment.linfty_norm() == 0.)
      return true;
    if (!assemble(u, R, true))
      return false;
    matrix.vmult(coupling, increment);
    if (shared.ranks.is_first()) // every rank has all of it
      dense_part.vmult_add(coupling, increment);
    unsymmetric.vmult_add(coupling, increment);
    shared.ranks.sum(coupling.begin(), coupling.size());
    R += coupling;
    constraints.set_zero(R);
    Vector d(u.size());
    if (!direction(R, d))
      return false;
    u += d;
    for (const auto &line : constraints.get_lines())
      u(line.index) = target(line.index);
    return true;
  }



  void
  Equilibrium::back_substitute(Vector &force) const
  {
    constraints.set_zero(force);
    solver->solve(force);
  }



  bool
  Equilibrium::forces(const Vector &u, Vector &R)
  {
    R = 0.;
    return add_terms(u, R, nullptr);
  }



  std::unique_ptr<dealii::SparseMatrix<double>>
  Equilibrium::make_matrix() const
  {
    return std::make_unique<dealii::SparseMatrix<double>>(pattern);
  }



  const dealii::SparseMatrix<double> &
  Equilibrium::tangent() const
  {
    return matrix;
  }



  const EquilibriumCost &
  Equilibrium::cost() const
  {
    return cost_;
  }



  void
  Equilibrium::add_cost(const EquilibriumCost &earlier)
  {
    cost_.assembly += earlier.assembly;
    cost_.factorisation += earlier.factorisation;
    cost_.solution += earlier.solution;
    cost_.factorisations += earlier.factorisations;
  }
} // namespace asperity
