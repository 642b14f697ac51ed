#include <asperity/flow/fluid_cell.h>
#include <asperity/solvers/finite.h>

#include <cmath>

namespace asperity
{
  using dealii::Tensor;

  namespace
  {
    constexpr unsigned int dim = 2;
  } // namespace



  FluidAssembler::FluidAssembler(const FluidSpace &space,
                                 const MovingMesh &mesh,
                                 const FluidModel &model)
    : space(space)
    , mesh(mesh)
    , shapes(std::make_unique<Shapes>(space))
    , model_(model)
    , viscosity(model.viscosity)
    , history(space.dofs().n_dofs())
  {}



  FluidAssembler::~FluidAssembler() = default;



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
    Cell         cell(space, *shapes);
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
  FluidAssembler::reinit(Cell                   &cell,
                         const FluidSpace::Cell &it,
                         const Vector           &u,
                         const Vector           &w) const
  {
    cell.unknowns.reinit(it);
    cell.mesh_unknowns.reinit(space.geometry_cell(it));
    cell.unknowns.extract(u, cell.v);
    cell.unknowns.extract(u, dim, cell.p);
    cell.unknowns.extract(history, cell.history);
    cell.mesh_unknowns.extract(mesh.positions(), cell.x);
    cell.mesh_unknowns.extract(w, cell.w);
    if (model_.is_compressible())
      {
        cell.unknowns.extract(history, dim, cell.r_history);
        for (unsigned int k = 0; k < cell.n_pressure; ++k)
          {
            cell.r[k]  = model_.compressibility.ratio(cell.p[k]);
            cell.dr[k] = model_.compressibility.derivative(cell.p[k]);
          }
      }
  }



  void
  FluidAssembler::integrate(Cell &cell, const bool with_tangent) const
  {
    cell.R    = 0.;
    cell.size = 0.;
    if (with_tangent)
      cell.K = 0.;
    for (unsigned int q = 0; q < shapes->quadrature.size(); ++q)
      {
        const Point x = evaluate(cell, q);
        add_size(cell, x);
        galerkin(cell, x, with_tangent);
        if (with_tangent && model_.is_compressible())
          add_compression_tangent(cell, x);
        if (shapes->is_stabilised)
          stabilise(cell, x, q, with_tangent);
      }
  }



  FluidAssembler::Point
  FluidAssembler::evaluate(Cell &cell, const unsigned int q) const
  {
    Point x;
    set_functions(cell, x, q);
    for (unsigned int a = 0; a < cell.n_velocity; ++a)
      {
        x.v += cell.N[a] * cell.v[a];
        x.history += cell.N[a] * cell.history[a];
        for (unsigned int i = 0; i < dim; ++i)
          x.grad_v[i] += cell.v[a][i] * cell.g[a];
      }
    x.w      = shapes->geometry.value(q, cell.w);
    x.p      = shapes->pressure.value(q, cell.p);
    x.D      = 0.5 * (x.grad_v + transpose(x.grad_v));
    x.div_v  = trace(x.grad_v);
    x.excess = x.div_v;
    x.rate   = std::sqrt(2. * scalar_product(x.D, x.D));
    x.eta    = viscosity.evaluate(x.rate, x.p);
    // dv/dt at fixed X always sees the mesh move past the fluid; only the
    // transport of v by itself is what Stokes flow leaves away.
    x.c            = (model_.convection ? x.v : Tensor<1, 2>()) - x.w;
    x.acceleration = rate.now * x.v + x.history + x.grad_v * x.c;
    if (model_.body_force)
      x.acceleration -=
        model_.body_force(dealii::Point<2>(shapes->geometry.value(q, cell.x)),
                          time);
    if (model_.is_compressible())
      set_compression(cell, x, q);
    return x;
  }



  void
  FluidAssembler::set_functions(Cell              &cell,
                                Point             &x,
                                const unsigned int q) const
  {
    const Tensor<2, 2> J = shapes->geometry.gradient(q, cell.x);
    x.JxW                = determinant(J) * shapes->quadrature.weight(q);
    x.inverse_jacobian   = invert(J);
    cell.N               = shapes->velocity.values(q);
    cell.M               = shapes->pressure.values(q);
    for (unsigned int a = 0; a < cell.n_velocity; ++a)
      cell.g[a] = shapes->velocity.gradients(q)[a] * x.inverse_jacobian;
    for (unsigned int k = 0; k < cell.n_pressure; ++k)
      cell.m[k] = shapes->pressure.gradients(q)[k] * x.inverse_jacobian;
  }



  void
  FluidAssembler::add_size(Cell &cell, const Point &x) const
  {
    const double grad_v = x.grad_v.norm();
    const double inertia =
      model_.density * (rate.now * x.v.norm() + x.history.norm() +
                        x.c.norm() * grad_v + x.acceleration.norm());
    const double stress = x.eta.value * grad_v + std::abs(x.p);
    for (unsigned int a = 0; a < cell.n_velocity; ++a)
      {
        const double size =
          (inertia * std::abs(cell.N[a]) + stress * cell.g[a].norm()) * x.JxW;
        for (unsigned int i = 0; i < dim; ++i)
          cell.size(cell.index[i][a]) += size;
      }
    for (unsigned int k = 0; k < cell.n_pressure; ++k)
      cell.size(cell.index[dim][k]) +=
        (grad_v + std::abs(x.r_dot)) * std::abs(cell.M[k]) * x.JxW;
  }



  void
  FluidAssembler::galerkin(Cell        &cell,
                           const Point &x,
                           const bool   with_tangent) const
  {
    const double       rho     = model_.density;
    const auto        &N       = cell.N;
    const auto        &g       = cell.g;
    const auto        &M       = cell.M;
    const auto        &I       = cell.index;
    const double       eta     = x.eta.value;
    const Tensor<2, 2> two_D   = 2. * x.D;
    const Tensor<1, 2> inertia = rho * x.JxW * x.acceleration;
    Tensor<2, 2>       stress  = eta * x.JxW * two_D;
    for (unsigned int i = 0; i < dim; ++i)
      stress[i][i] -= x.p * x.JxW;
    for (unsigned int a = 0; a < cell.n_velocity; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        cell.R(I[i][a]) += inertia[i] * N[a] + stress[i] * g[a];
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
