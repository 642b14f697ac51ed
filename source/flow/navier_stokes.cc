#include <asperity/flow/navier_stokes.h>
#include <asperity/solvers/finite.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/numerics/vector_tools.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using dealii::Tensor;

  namespace
  {
    /** Steps may grow by this factor under BDF2, which loses zero-stability
     *  at 1 + sqrt(2). */
    constexpr double largest_growth = 2.;
  } // namespace



  NavierStokes::NavierStokes(const dealii::Triangulation<2>   &triangulation,
                             const FluidOptions               &options,
                             const std::vector<PeriodicSides> &periodic,
                             const std::vector<FluidOutlet>   &outlets)
    : options(options)
    , space_(triangulation,
             options.element,
             options.degree,
             options.geometry_degree,
             periodic)
    , mesh(space_)
    , boundary_(space_, mesh)
    , assembler(space_, mesh, options.model)
    , outlets(space_, mesh, assembler, outlets)
    , level(space_, mesh, boundary_)
    , schur(space_)
    , solver(make_flow_solver(space_,
                              options.linear_solver,
                              options.solver,
                              options.krylov))
    , u(space_.dofs().n_dofs())
    , u_old(u)
    , u_older(u)
    , cell_forces(u)
    , volume_source(u)
    , content_source(u)
    , source(u)
    , scale(u)
    , divergence(u)
  {
    dealii::Table<2, dealii::DoFTools::Coupling> coupling(3, 3);
    coupling.fill(dealii::DoFTools::always);
    if (options.element == FluidElement::taylor_hood && !is_compressible())
      coupling(2, 2) = dealii::DoFTools::none;
    dealii::DynamicSparsityPattern couplings(u.size());
    dealii::DoFTools::make_sparsity_pattern(space_.dofs(),
                                            coupling,
                                            couplings,
                                            space_.topology());
    this->outlets.add_couplings(couplings);
    pattern.copy_from(couplings);
    matrix.reinit(pattern);
  }



  FluidBoundary &
  NavierStokes::boundary()
  {
    return boundary_;
  }



  void
  NavierStokes::set_model(const FluidModel &model)
  {
    assembler.set_model(model);
    is_factorised = false;
  }



  void
  NavierStokes::set_material_walls(const BoundaryIds &ids)
  {
    material_walls = ids;
  }



  bool
  NavierStokes::set_mesh_displacement(const Vector &displacement)
  {
    return mesh.set_displacement(displacement);
  }



  double
  NavierStokes::mesh_rate() const
  {
    return mesh.rate().now;
  }



  bool
  NavierStokes::set_initial_displacement(const Vector &displacement)
  {
    mesh.set_history(displacement, displacement);
    return mesh.set_displacement(displacement);
  }



  void
  NavierStokes::begin_step(const double new_dt)
  {
    dt = new_dt;
    BackwardDifference rate;
    if (options.scheme == FluidTimeScheme::bdf2 && n_steps > 0 &&
        dt <= (1. + 1e-9) * largest_growth * dt_old)
      rate = BackwardDifference::bdf2(dt, dt_old);
    else if (options.scheme != FluidTimeScheme::steady)
      rate = BackwardDifference::implicit_euler(dt);
    mesh.set_rate(rate);
    Vector history(u_old), older(u_older);
    if (is_compressible())
      for (Vector *state : {&history, &older})
        {
          const Vector r = assembler.density_ratio(*state);
          std::copy(r.begin() + space_.n_velocity_dofs(),
                    r.end(),
                    state->begin() + space_.n_velocity_dofs());
        }
    history *= rate.old;
    history.add(rate.older, older);
    assembler.set_step(rate, history, time());
    u = u_old;
  }



  void
  NavierStokes::forget_tangent()
  {
    is_factorised = false;
  }



  std::string
  NavierStokes::prepare()
  {
    std::map<unsigned int, double> prescribed = boundary_.prescribed(time());
    prescribe_inner_walls(prescribed);
    level.update(is_compressible());
    constrain(prescribed);
    for (const auto &entry : prescribed)
      u(entry.first) = entry.second;
    for (const unsigned int i : space_.idle_dofs())
      u(i) = 0.;
    space_.topology().distribute(u);

    cell_size     = std::sqrt(volume() / space_.cells().size());
    volume_source = 0.;
    if (!material_walls.empty())
      mesh.add_swept_volume_defect(material_walls, volume_source);
    source = 0.;
    source.add(-divergence_memory(), divergence);
    account_for_content();
    const std::string problem =
      level.balance(u, volume_source, options.flux_tolerance);
    source += volume_source;
    source += content_source;
    return problem;
  }



  double
  NavierStokes::divergence_memory() const
  {
    if (options.element != FluidElement::equal_order || dt == 0.)
      return 0.;
    double V = 0.;
    for (unsigned int i = 0; i < space_.n_velocity_dofs(); ++i)
      V = std::max(V, std::abs(u_old(i)));
    const double nu =
      assembler.model().viscosity.viscosity / assembler.model().density;
    const double h = cell_size;
    return 1. / (1. + dt * (2. * V / h + 34. * nu / (h * h)));
  }



  ConvergenceReport
  NavierStokes::solve()
  {
    ConvergenceReport report;
    if (mesh.is_valid())
      report.reason = prepare();
    else
      report.reason = "a cell of the fluid mesh is inverted";
    if (!report.reason.empty())
      return report;

    NewtonOptions newton_options;
    newton_options.tolerance                = options.tolerance;
    newton_options.maximum_iterations       = options.maximum_newton_iterations;
    newton_options.merit                    = NewtonMerit::residual_norm;
    newton_options.kept_tangent_contraction = options.kept_tangent_contraction;
    momentum_scale = continuity_scale = 0.;
    report = newton(*this, u, newton_options, statistics_);
    if (level.is_undetermined())
      {
        level.fix_mean(u, options.mean_pressure);
        Vector R(u.size());
        assemble(u, R, nullptr);
      }
    return report;
  }



  void
  NavierStokes::accept()
  {
    if (options.element == FluidElement::equal_order)
      divergence = galerkin_divergence();
    outlets.accept(u);
    u_older = u_old;
    u_old   = u;
    mesh.accept();
    time_old += dt;
    dt_old = dt;
    dt     = 0.;
    ++n_steps;
  }



  double
  NavierStokes::time() const
  {
    return time_old + dt;
  }



  bool
  NavierStokes::assemble(const Vector                 &u,
                         Vector                       &R,
                         dealii::SparseMatrix<double> *tangent)
  {
    cell_forces = 0.;
    scale       = 0.;
    if (tangent != nullptr)
      *tangent = 0.;
    if (!assembler.add(u, constraints, cell_forces, scale, tangent))
      return false;
    outlets.add(u, constraints, cell_forces, scale, tangent);
    R = cell_forces;
    boundary_.add(u, time(), constraints, R, scale, tangent);
    R += source;
    for (const auto &line : constraints.get_lines())
      R(line.index) = 0.;
    for (unsigned int i = space_.n_velocity_dofs(); i < u.size(); ++i)
      scale(i) += std::abs(volume_source(i));
    update_scales();
    return true;
  }



  void
  NavierStokes::update_scales()
  {
    const unsigned int n_velocity = space_.n_velocity_dofs();
    double             momentum = 0., continuity = 0.;
    for (unsigned int i = 0; i < u.size(); ++i)
      (i < n_velocity ? momentum : continuity) += scale(i) * scale(i);
    momentum_scale = std::max(momentum_scale, std::sqrt(momentum));
    // Of a divergence that is carried along only the change counts.
    continuity_scale = std::max(continuity_scale,
                                std::max(1e-4, 1. - divergence_memory()) *
                                  std::sqrt(continuity));

    // A fluid at rest under pressure moves by round-off only; the flow that
    // such a pressure could drive is the size to compare it with.
    const double viscosity = assembler.model().viscosity.viscosity;
    continuity_scale =
      std::max(continuity_scale, 1e-4 * momentum_scale / viscosity * cell_size);
  }



  double
  NavierStokes::norm(const Vector &R) const
  {
    const unsigned int n_velocity = space_.n_velocity_dofs();
    double             momentum = 0., continuity = 0.;
    for (unsigned int i = 0; i < R.size(); ++i)
      (i < n_velocity ? momentum : continuity) += R(i) * R(i);
    const auto relative = [](const double squares, const double reference) {
      return squares > 0. ? std::sqrt(squares) / reference : 0.;
    };
    return std::max(relative(momentum, momentum_scale),
                    relative(continuity, continuity_scale));
  }



  bool
  NavierStokes::residual(const Vector &u, Vector &R)
  {
    return assemble(u, R, nullptr) && is_finite(R);
  }



  bool
  NavierStokes::linearize(const Vector &u, Vector &R)
  {
    is_factorised = false;
    if (!assemble(u, R, &matrix))
      return false;
    fill_empty_rows();
    return is_finite(R);
  }



  bool
  NavierStokes::direction(const Vector &R, Vector &d)
  {
    // The tangent is that at the iterate of the last linearize(), the estimate
    // of the Schur complement need not be.
    const auto estimate = [this]() -> const SchurEstimate & {
      return schur.of_tangent(
        u, assembler, boundary_, level.held_dofs(), convection_dominates());
    };
    linear_failure = "the tangent is singular";
    if (!is_factorised && !solver->prepare(matrix, estimate))
      return false;
    is_factorised = true;
    d             = R;
    d *= -1.;
    const ConvergenceReport report = solver->solve(d);
    statistics_.linear_iterations += report.iterations;
    if (!report.converged)
      linear_failure = report.reason;
    constraints.distribute(d);
    return report.converged && is_finite(d);
  }



  bool
  NavierStokes::convection_dominates() const
  {
    // Lies between a step at Re = 100 (0.01), where the estimate without
    // convection is as good, and a steady cylinder (300), where it fails.
    constexpr double limit = 30.;

    const FluidModel &model = assembler.model();
    if (!model.convection)
      return false;
    double speed = 0.;
    for (unsigned int i = 0; i < space_.n_velocity_dofs(); ++i)
      speed = std::max(speed, std::abs(u(i)));
    const double area = volume();
    return model.density * speed * std::sqrt(area) >
           limit * (model.viscosity.viscosity +
                    model.density * mesh.rate().now * area);
  }



  std::string
  NavierStokes::direction_failure() const
  {
    return linear_failure;
  }



  bool
  NavierStokes::has_tangent() const
  {
    return is_factorised;
  }
} // namespace asperity
