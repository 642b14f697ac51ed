#include <asperity/flow/fluid_cell.h>
#include <asperity/solvers/finite.h>

#include <cmath>

namespace asperity
{
  using dealii::Tensor;

  namespace
  {
    constexpr unsigned int dim = 2;

    const dealii::FEValuesExtractors::Vector velocity_field(0);
    const dealii::FEValuesExtractors::Scalar pressure_field(2);
  } // namespace



  FluidAssembler::FluidAssembler(const FluidSpace &space,
                                 const MovingMesh &mesh,
                                 const FluidModel &model)
    : space(space)
    , mesh(mesh)
    , model_(model)
    , viscosity(model.viscosity)
    , history(space.dofs().n_dofs())
  {}



  void
  FluidAssembler::set_model(const FluidModel &model)
  {
    model_    = model;
    viscosity = LubricantViscosity(model.viscosity);
  }



  void
  FluidAssembler::set_step(const BackwardDifference &new_rate,
                           const Vector             &new_history,
                           const double              new_time)
  {
    rate    = new_rate;
    history = new_history;
    time    = new_time;
  }



  const FluidModel &
  FluidAssembler::model() const
  {
    return model_;
  }



  bool
  FluidAssembler::add(const Vector                            &u,
                      const dealii::AffineConstraints<double> &constraints,
                      Vector                                  &R,
                      Vector                                  &scale,
                      dealii::SparseMatrix<double>            *tangent) const
  {
    Cell         cell(space, mesh, model_.is_compressible());
    const Vector w = mesh.velocity();
    for (const auto &it : space.cells())
      {
        reinit(cell, it, u, w);
        integrate(cell, tangent != nullptr);
        if (!is_finite(cell.R) ||
            (tangent != nullptr && !std::isfinite(cell.K.frobenius_norm())))
          return false;
        space.topology().distribute_local_to_global(cell.R, cell.dofs, R);
        for (unsigned int i = 0; i < cell.dofs.size(); ++i)
          scale(cell.dofs[i]) += cell.size(i);
        if (tangent != nullptr)
          constraints.distribute_local_to_global(cell.K, cell.dofs, *tangent);
      }
    return true;
  }



  void
  FluidAssembler::reinit(Cell &cell,
                         const dealii::DoFHandler<2>::active_cell_iterator &it,
                         const Vector                                      &u,
                         const Vector &w) const
  {
    cell.flow.reinit(it);
    cell.geometry.reinit(space.geometry_cell(it));
    it->get_dof_indices(cell.dofs);
    cell.flow[velocity_field].get_function_values(u, cell.v);
    cell.flow[velocity_field].get_function_gradients(u, cell.grad_v);
    cell.flow[velocity_field].get_function_values(history, cell.rate);
    cell.flow[pressure_field].get_function_values(u, cell.p);
    cell.geometry[velocity_field].get_function_values(w, cell.w);
    if (cell.stabilised)
      {
        cell.flow[pressure_field].get_function_gradients(u, cell.grad_p);
        cell.flow[velocity_field].get_function_hessians(
          u, cell.second_derivatives);
      }
    if (cell.is_compressible)
      {
        cell.geometry[velocity_field].get_function_divergences(w, cell.div_w);
        cell.flow[pressure_field].get_function_values(history, cell.r_history);
        for (unsigned int k = 0; k < cell.n_pressure; ++k)
          {
            const double p = u(cell.dofs[cell.index[dim][k]]);
            cell.r[k]      = model_.compressibility.ratio(p);
            cell.dr[k]     = model_.compressibility.derivative(p);
          }
      }
  }



  void
  FluidAssembler::integrate(Cell &cell, const bool with_tangent) const
  {
    cell.R    = 0.;
    cell.size = 0.;
    cell.K    = 0.;
    for (unsigned int q = 0; q < cell.quadrature.size(); ++q)
      {
        const Point x = evaluate(cell, q);
        add_size(cell, x);
        galerkin(cell, x, with_tangent);
        if (with_tangent && cell.is_compressible)
          add_compression_tangent(cell, x);
        if (cell.stabilised)
          stabilise(cell, x, with_tangent);
      }
  }



  FluidAssembler::Point
  FluidAssembler::evaluate(Cell &cell, const unsigned int q) const
  {
    Point x;
    x.q      = q;
    x.JxW    = cell.flow.JxW(q);
    x.grad_v = cell.grad_v[q];
    x.D      = 0.5 * (x.grad_v + transpose(x.grad_v));
    x.div_v  = trace(x.grad_v);
    x.excess = x.div_v;
    x.p      = cell.p[q];
    x.rate   = std::sqrt(2. * scalar_product(x.D, x.D));
    x.eta    = viscosity.evaluate(x.rate, x.p);
    // dv/dt at fixed X always sees the mesh move past the fluid; only the
    // transport of v by itself is what Stokes flow leaves away.
    x.c = (model_.convection ? cell.v[q] : Tensor<1, 2>()) - cell.w[q];
    x.acceleration = rate.now * cell.v[q] + cell.rate[q] + x.grad_v * x.c;
    if (model_.body_force)
      x.acceleration -= model_.body_force(cell.flow.quadrature_point(q), time);
    cell.load(q);
    if (cell.is_compressible)
      set_compression(cell, x);
    return x;
  }



  void
  FluidAssembler::add_size(Cell &cell, const Point &x) const
  {
    const double grad_v = x.grad_v.norm();
    const double inertia =
      model_.density * (rate.now * cell.v[x.q].norm() + cell.rate[x.q].norm() +
                        x.c.norm() * grad_v + x.acceleration.norm());
    const double stress = x.eta.value * grad_v + std::abs(x.p);
    for (unsigned int a = 0; a < cell.n_velocity; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        cell.size(cell.index[i][a]) +=
          (inertia * std::abs(cell.N[a]) + stress * cell.g[a].norm()) * x.JxW;
    for (unsigned int k = 0; k < cell.n_pressure; ++k)
      cell.size(cell.index[dim][k]) +=
        (grad_v + std::abs(x.r_dot)) * std::abs(cell.M[k]) * x.JxW;
  }



  void
  FluidAssembler::galerkin(Cell        &cell,
                           const Point &x,
                           const bool   with_tangent) const
  {
    const double       rho   = model_.density;
    const auto        &N     = cell.N;
    const auto        &g     = cell.g;
    const auto        &M     = cell.M;
    const auto        &I     = cell.index;
    const double       eta   = x.eta.value;
    const Tensor<2, 2> two_D = 2. * x.D;
    for (unsigned int a = 0; a < cell.n_velocity; ++a)
      {
        const Tensor<1, 2> D_g = two_D * g[a];
        for (unsigned int i = 0; i < dim; ++i)
          cell.R(I[i][a]) +=
            (rho * x.acceleration[i] * N[a] + eta * D_g[i] - x.p * g[a][i]) *
            x.JxW;
      }
    for (unsigned int k = 0; k < cell.n_pressure; ++k)
      cell.R(I[dim][k]) -= (x.r * x.div_v + x.mass_rate) * M[k] * x.JxW;
    if (!with_tangent)
      return;

    const double transport = model_.convection ? rho * x.JxW : 0.;
    const double d_eta     = x.rate > 0. ? x.eta.d_rate / x.rate * x.JxW : 0.;
    for (unsigned int a = 0; a < cell.n_velocity; ++a)
      {
        const Tensor<1, 2> D_g = two_D * g[a];
        for (unsigned int b = 0; b < cell.n_velocity; ++b)
          {
            const Tensor<1, 2> D_g_b = two_D * g[b];
            const double       diagonal =
              (rho * N[a] * (rate.now * N[b] + x.c * g[b]) +
               eta * (g[a] * g[b])) *
              x.JxW;
            for (unsigned int i = 0; i < dim; ++i)
              {
                cell.K(I[i][a], I[i][b]) += diagonal;
                for (unsigned int j = 0; j < dim; ++j)
                  cell.K(I[i][a], I[j][b]) +=
                    transport * N[a] * x.grad_v[i][j] * N[b] +
                    eta * g[a][j] * g[b][i] * x.JxW + d_eta * D_g[i] * D_g_b[j];
              }
          }
        for (unsigned int k = 0; k < cell.n_pressure; ++k)
          for (unsigned int i = 0; i < dim; ++i)
            {
              const double gradient = -g[a][i] * M[k] * x.JxW;
              cell.K(I[dim][k], I[i][a]) +=
                x.r * gradient - M[k] * N[a] * x.grad_r[i] * x.JxW;
              cell.K(I[i][a], I[dim][k]) +=
                gradient + x.eta.d_pressure * M[k] * D_g[i] * x.JxW;
            }
      }
  }
} // namespace asperity
