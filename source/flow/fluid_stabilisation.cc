#include <asperity/flow/fluid_cell.h>

#include <cmath>

namespace asperity
{
  using dealii::Tensor;

  namespace
  {
    constexpr unsigned int dim = 2;
  } // namespace



  struct FluidAssembler::Stabilisation
  {
    Tensor<1, 2> Gc;     // G c
    double       G_G;    // G : G
    double       steady; // rho^2 c.G c + 36 eta^2 G : G
    double       tau;
    double       tau_C;
    Tensor<1, 2> grad_p;
    Tensor<1, 2> viscous; // -(lap v + grad div v)
    Tensor<1, 2> r;       // rho acceleration + grad p + eta viscous
  };



  FluidAssembler::Stabilisation
  FluidAssembler::stabilisation(const Cell &cell, const Point &x) const
  {
    const double rho = model_.density;
    const double eta = x.eta.value;

    // The reference cell has length 1 here, 2 in Bazilevs et al. (2007).
    const Tensor<2, 2> G =
      4. * transpose(x.inverse_jacobian) * x.inverse_jacobian;

    Stabilisation s;
    s.Gc     = G * x.c;
    s.G_G    = scalar_product(G, G);
    s.steady = rho * rho * (x.c * s.Gc) + 36. * eta * eta * s.G_G;
    s.tau    = 1. / std::sqrt(4. * rho * rho * rate.now * rate.now + s.steady);
    s.tau_C  = std::sqrt(s.steady) / trace(G);

    for (unsigned int a = 0; a < cell.n_velocity; ++a)
      s.viscous -= trace(cell.H[a]) * cell.v[a] + cell.H[a] * cell.v[a];
    for (unsigned int k = 0; k < cell.n_pressure; ++k)
      s.grad_p += cell.p[k] * cell.m[k];
    s.r = rho * x.acceleration + s.grad_p + eta * s.viscous;
    return s;
  }



  void
  FluidAssembler::set_second_derivatives(Cell              &cell,
                                         const Point       &x,
                                         const unsigned int q) const
  {
    std::array<Tensor<2, 2>, dim> x_second; // of x by the reference coordinates
    for (unsigned int l = 0; l < cell.x.size(); ++l)
      for (unsigned int i = 0; i < dim; ++i)
        x_second[i] += cell.x[l][i] * shapes->geometry.second_derivatives(q)[l];
    for (unsigned int a = 0; a < cell.n_velocity; ++a)
      {
        Tensor<2, 2> H = shapes->velocity.second_derivatives(q)[a];
        for (unsigned int i = 0; i < dim; ++i)
          H -= cell.g[a][i] * x_second[i];
        cell.H[a] = transpose(x.inverse_jacobian) * H * x.inverse_jacobian;
      }
  }



  void
  FluidAssembler::stabilise(Cell              &cell,
                            const Point       &x,
                            const unsigned int q,
                            const bool         with_tangent) const
  {
    set_second_derivatives(cell, x, q);
    const Stabilisation s   = stabilisation(cell, x);
    const double        rho = model_.density;
    const auto         &g   = cell.g;
    const auto         &I   = cell.index;
    for (unsigned int a = 0; a < cell.n_velocity; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        cell.R(I[i][a]) +=
          (s.tau * rho * (x.c * g[a]) * s.r[i] + s.tau_C * x.excess * g[a][i]) *
          x.JxW;
    for (unsigned int k = 0; k < cell.n_pressure; ++k)
      {
        cell.R(I[dim][k]) -= s.tau * (cell.m[k] * s.r) * x.JxW;
        cell.size(I[dim][k]) +=
          s.tau * cell.m[k].norm() * s.grad_p.norm() * x.JxW;
      }
    if (with_tangent)
      add_stabilised_tangent(cell, x, s);
  }



  void
  FluidAssembler::add_stabilised_tangent(Cell                &cell,
                                         const Point         &x,
                                         const Stabilisation &s) const
  {
    const double rho = model_.density, eta = x.eta.value;
    const auto  &g         = cell.g;
    const auto  &I         = cell.index;
    const double tau_3     = s.tau * s.tau * s.tau;
    const double d_tau_eta = -36. * tau_3 * eta * s.G_G;

    // One column: derivatives of r, tau, e and of c by an unknown.
    const auto add_column = [&](const unsigned int  column,
                                const Tensor<1, 2> &dr,
                                const double        d_tau,
                                const double        d_e,
                                const Tensor<1, 2> &dc) {
      const Tensor<1, 2> d_tau_r = s.tau * dr + d_tau * s.r;
      const double       d_tau_C_e =
        s.tau_C * (d_e - d_tau / (tau_3 * s.steady) * x.excess);
      for (unsigned int a = 0; a < cell.n_velocity; ++a)
        for (unsigned int i = 0; i < dim; ++i)
          cell.K(I[i][a], column) +=
            (rho * (x.c * g[a]) * d_tau_r[i] +
             rho * (dc * g[a]) * s.tau * s.r[i] + d_tau_C_e * g[a][i]) *
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
            Tensor<1, 2> dc, dr = d_eta * s.viscous;
            dc[j] = model_.convection ? cell.N[b] : 0.;
            for (unsigned int i = 0; i < dim; ++i)
              dr[i] += rho * x.grad_v[i][j] * dc[j] - eta * cell.H[b][i][j];
            dr[j] += rho * (rate.now * cell.N[b] + x.c * g[b]) -
                     eta * trace(cell.H[b]);
            const double d_tau =
              -tau_3 * rho * rho * (s.Gc * dc) + d_tau_eta * d_eta;
            const double d_e = g[b][j] + cell.N[b] * x.grad_r[j] / x.r;
            add_column(I[j][b], dr, d_tau, d_e, dc);
          }
      }
    for (unsigned int k = 0; k < cell.n_pressure; ++k)
      {
        const double d_eta = x.eta.d_pressure * cell.M[k];
        const double d_e =
          cell.dr[k] *
          ((rate.now - x.r_dot / x.r) * cell.M[k] + x.b * cell.m[k]) / x.r;
        add_column(I[dim][k],
                   cell.m[k] + d_eta * s.viscous,
                   d_tau_eta * d_eta,
                   d_e,
                   Tensor<1, 2>());
      }
  }
} // namespace asperity
