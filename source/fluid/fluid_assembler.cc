#include <asperity/fluid/fluid_assembler.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

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



  /** The fields at a quadrature point; names as in the class description. */
  struct FluidAssembler::Point
  {
    unsigned int   q;
    double         JxW;
    Tensor<1, 2>   acceleration; // dv/dt|_X + c.grad v - b
    Tensor<1, 2>   c;            // v - w_mesh, or 0 without convection
    Tensor<2, 2>   grad_v;
    Tensor<2, 2>   D;
    double         div_v;
    double         p;
    double         rate; // of shear
    ViscosityValue eta;
  };



  /** One cell: shape functions, fields, results. Shape functions of one
   *  velocity component are numbered a, those of the pressure k. */
  struct FluidAssembler::Cell
  {
    Cell(const FluidSpace &space, const MovingMesh &mesh)
      : fe(space.dofs().get_fe())
      , quadrature(fe.degree + 1)
      , stabilised(space.element() == FluidElement::equal_order)
      , flow(mesh.mapping(), fe, quadrature, flags(stabilised))
      , geometry(mesh.mapping(),
                 space.geometry_dofs().get_fe(),
                 quadrature,
                 dealii::update_values)
      , n_velocity(fe.base_element(0).n_dofs_per_cell())
      , n_pressure(fe.base_element(1).n_dofs_per_cell())
      , dofs(fe.n_dofs_per_cell())
      , R(dofs.size())
      , size(dofs.size())
      , K(dofs.size(), dofs.size())
      , v(quadrature.size())
      , rate(quadrature.size())
      , w(quadrature.size())
      , grad_p(quadrature.size())
      , grad_v(quadrature.size())
      , p(quadrature.size())
      , N(n_velocity)
      , g(n_velocity)
      , H(n_velocity)
      , M(n_pressure)
      , m(n_pressure)
      , second_derivatives(quadrature.size())
    {
      for (unsigned int a = 0; a < n_velocity; ++a)
        for (unsigned int i = 0; i < dim; ++i)
          index[i].push_back(fe.component_to_system_index(i, a));
      for (unsigned int k = 0; k < n_pressure; ++k)
        index[dim].push_back(fe.component_to_system_index(dim, k));
    }

    static dealii::UpdateFlags
    flags(const bool stabilised)
    {
      const auto basic = dealii::update_values | dealii::update_gradients |
                         dealii::update_JxW_values |
                         dealii::update_quadrature_points;
      return stabilised ? basic | dealii::update_hessians |
                            dealii::update_inverse_jacobians :
                          basic;
    }

    /** Copies the shape functions at a point. */
    void
    load(const unsigned int q)
    {
      for (unsigned int a = 0; a < n_velocity; ++a)
        {
          N[a] = flow.shape_value(index[0][a], q);
          g[a] = flow.shape_grad(index[0][a], q);
          if (stabilised)
            H[a] = flow.shape_hessian(index[0][a], q);
        }
      for (unsigned int k = 0; k < n_pressure; ++k)
        {
          M[k] = flow.shape_value(index[dim][k], q);
          if (stabilised)
            m[k] = flow.shape_grad(index[dim][k], q);
        }
    }

    const dealii::FiniteElement<2> &fe;
    const dealii::QGauss<2>         quadrature;
    const bool                      stabilised;
    dealii::FEValues<2>             flow, geometry;
    const unsigned int              n_velocity, n_pressure;

    std::vector<dealii::types::global_dof_index> dofs;
    std::array<std::vector<unsigned int>, 3> index; // component -> functions

    dealii::Vector<double>     R, size;
    dealii::FullMatrix<double> K;

    std::vector<Tensor<1, 2>> v, rate, w, grad_p;
    std::vector<Tensor<2, 2>> grad_v;
    std::vector<double>       p;

    std::vector<double>       N; // velocity functions
    std::vector<Tensor<1, 2>> g; // their gradients
    std::vector<Tensor<2, 2>> H; // their second derivatives
    std::vector<double>       M; // pressure functions
    std::vector<Tensor<1, 2>> m; // their gradients

    std::vector<Tensor<3, 2>> second_derivatives; // of v: [i][j][l] = v_i,jl
  };



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



  void
  FluidAssembler::add(const Vector                            &u,
                      const dealii::AffineConstraints<double> &constraints,
                      Vector                                  &R,
                      Vector                                  &scale,
                      dealii::SparseMatrix<double>            *tangent) const
  {
    Cell         cell(space, mesh);
    const Vector w = mesh.velocity();
    for (const auto &it : space.dofs().active_cell_iterators())
      {
        cell.flow.reinit(it);
        cell.geometry.reinit(space.geometry_cell(it));
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
        integrate(cell, tangent != nullptr);
        it->get_dof_indices(cell.dofs);
        space.topology().distribute_local_to_global(cell.R, cell.dofs, R);
        for (unsigned int i = 0; i < cell.dofs.size(); ++i)
          scale(cell.dofs[i]) += cell.size(i);
        if (tangent != nullptr)
          constraints.distribute_local_to_global(cell.K, cell.dofs, *tangent);
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
        Point x;
        x.q      = q;
        x.JxW    = cell.flow.JxW(q);
        x.grad_v = cell.grad_v[q];
        x.D      = 0.5 * (x.grad_v + transpose(x.grad_v));
        x.div_v  = trace(x.grad_v);
        x.p      = cell.p[q];
        x.rate   = std::sqrt(2. * scalar_product(x.D, x.D));
        x.eta    = viscosity.evaluate(x.rate, x.p);
        // dv/dt at fixed X always sees the mesh move past the fluid; only the
        // transport of v by itself is what Stokes flow leaves away.
        x.c = (model_.convection ? cell.v[q] : Tensor<1, 2>()) - cell.w[q];
        x.acceleration = rate.now * cell.v[q] + cell.rate[q] + x.grad_v * x.c;
        if (model_.body_force)
          x.acceleration -=
            model_.body_force(cell.flow.quadrature_point(q), time);
        cell.load(q);
        add_size(cell, x);
        galerkin(cell, x, with_tangent);
        if (cell.stabilised)
          stabilisation(cell, x, with_tangent);
      }
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
      cell.size(cell.index[dim][k]) += grad_v * std::abs(cell.M[k]) * x.JxW;
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
      cell.R(I[dim][k]) -= x.div_v * M[k] * x.JxW;
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
              cell.K(I[dim][k], I[i][a]) += gradient;
              cell.K(I[i][a], I[dim][k]) +=
                gradient + x.eta.d_pressure * M[k] * D_g[i] * x.JxW;
            }
      }
  }



  void
  FluidAssembler::stabilisation(Cell        &cell,
                                const Point &x,
                                const bool   with_tangent) const
  {
    const double rho = model_.density;
    const double eta = x.eta.value;
    const auto  &N   = cell.N;
    const auto  &g   = cell.g;
    const auto  &H   = cell.H;
    const auto  &I   = cell.index;

    Tensor<2, 2> inverse_jacobian; // d xi / d x
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        inverse_jacobian[i][j] = cell.flow.inverse_jacobian(x.q)[i][j];
    // The reference cell has length 1 here, 2 in the papers.
    const Tensor<2, 2> G  = 4. * transpose(inverse_jacobian) * inverse_jacobian;
    const Tensor<1, 2> Gc = G * x.c;
    const double       G_G    = scalar_product(G, G);
    const double       steady = rho * rho * (x.c * Gc) + 36. * eta * eta * G_G;
    const double       tau =
      1. / std::sqrt(4. * rho * rho * rate.now * rate.now + steady);
    const double tau_C = std::sqrt(steady) / trace(G);

    // r = rho acceleration + grad p - eta (lap v + grad div v)
    Tensor<1, 2> r        = rho * x.acceleration + cell.grad_p[x.q];
    const auto  &v_second = cell.second_derivatives[x.q];
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        r[i] -= eta * (v_second[i][j][j] + v_second[j][j][i]);

    for (unsigned int a = 0; a < cell.n_velocity; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        cell.R(I[i][a]) +=
          (tau * rho * (x.c * g[a]) * r[i] + tau_C * x.div_v * g[a][i]) * x.JxW;
    for (unsigned int k = 0; k < cell.n_pressure; ++k)
      {
        cell.R(I[dim][k]) -= tau * (cell.m[k] * r) * x.JxW;
        cell.size(I[dim][k]) +=
          tau * cell.m[k].norm() * cell.grad_p[x.q].norm() * x.JxW;
      }
    if (!with_tangent)
      return;

    Tensor<1, 2> viscous; // dr/d eta
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        viscous[i] -= v_second[i][j][j] + v_second[j][j][i];
    const double tau_3     = tau * tau * tau;
    const double d_tau_eta = -36. * tau_3 * eta * G_G;
    const double moves     = model_.convection ? 1. : 0.;

    // One column: derivatives of r, tau, div v and of c by an unknown.
    const auto add_column = [&](const unsigned int  column,
                                const Tensor<1, 2> &dr,
                                const double        d_tau,
                                const double        d_div,
                                const Tensor<1, 2> &dc) {
      const Tensor<1, 2> d_tau_r = tau * dr + d_tau * r;
      const double       d_tau_C_div =
        tau_C * (d_div - d_tau / (tau_3 * steady) * x.div_v);
      for (unsigned int a = 0; a < cell.n_velocity; ++a)
        for (unsigned int i = 0; i < dim; ++i)
          cell.K(I[i][a], column) +=
            (rho * (x.c * g[a]) * d_tau_r[i] + rho * (dc * g[a]) * tau * r[i] +
             d_tau_C_div * g[a][i]) *
            x.JxW;
      for (unsigned int k = 0; k < cell.n_pressure; ++k)
        cell.K(I[dim][k], column) -= (cell.m[k] * d_tau_r) * x.JxW;
    };
    for (unsigned int b = 0; b < cell.n_velocity; ++b)
      {
        const Tensor<1, 2> d_rate =
          x.rate > 0. ? 2. * (x.D * g[b]) / x.rate : Tensor<1, 2>();
        for (unsigned int j = 0; j < dim; ++j)
          {
            const double d_eta = x.eta.d_rate * d_rate[j];
            Tensor<1, 2> dc, dr = d_eta * viscous;
            dc[j] = moves * N[b];
            for (unsigned int i = 0; i < dim; ++i)
              dr[i] += rho * x.grad_v[i][j] * dc[j] - eta * H[b][i][j];
            dr[j] += rho * (rate.now * N[b] + x.c * g[b]) - eta * trace(H[b]);
            const double d_tau =
              -tau_3 * rho * rho * (Gc * dc) + d_tau_eta * d_eta;
            add_column(I[j][b], dr, d_tau, g[b][j], dc);
          }
      }
    for (unsigned int k = 0; k < cell.n_pressure; ++k)
      {
        const double d_eta = x.eta.d_pressure * cell.M[k];
        add_column(I[dim][k],
                   cell.m[k] + d_eta * viscous,
                   d_tau_eta * d_eta,
                   0.,
                   Tensor<1, 2>());
      }
  }
} // namespace asperity
