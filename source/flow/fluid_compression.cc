#include <asperity/flow/fluid_cell.h>

// The continuity equation of a compressible fluid.
namespace asperity
{
  bool
  FluidModel::is_compressible() const
  {
    return compressibility.law != DensityLaw::incompressible;
  }



  FluidAssembler::Vector
  FluidAssembler::density_ratio(const Vector &u) const
  {
    Vector r(u.size());
    for (unsigned int i = space.n_velocity_dofs(); i < u.size(); ++i)
      r(i) = model_.compressibility.ratio(u(i));
    return r;
  }



  void
  FluidAssembler::set_compression(const Cell        &cell,
                                  Point             &x,
                                  const unsigned int q) const
  {
    x.r = 0.;
    for (unsigned int k = 0; k < cell.n_pressure; ++k)
      {
        x.r += cell.r[k] * cell.M[k];
        x.grad_r += cell.r[k] * cell.m[k];
      }
    const double div_w = scalar_product(shapes->geometry.gradient(q, cell.w),
                                        transpose(x.inverse_jacobian));
    const double r_history = shapes->pressure.value(q, cell.r_history);
    x.b                    = x.v - x.w;
    x.dilation             = rate.now + x.div_v - div_w;
    x.mass_rate            = (rate.now - div_w) * x.r + x.b * x.grad_r;
    x.r_dot                = rate.now * x.r + r_history + x.b * x.grad_r;
    x.excess               = x.div_v + x.r_dot / x.r;
  }



  void
  FluidAssembler::add_compression_tangent(Cell &cell, const Point &x) const
  {
    const auto &I = cell.index[Cell::dim];
    for (unsigned int l = 0; l < cell.n_pressure; ++l)
      {
        const double change =
          cell.dr[l] * (x.dilation * cell.M[l] + x.b * cell.m[l]) * x.JxW;
        for (unsigned int k = 0; k < cell.n_pressure; ++k)
          cell.K(I[k], I[l]) -= cell.M[k] * change;
      }
  }



  void
  FluidAssembler::add_continuity(const Vector &u, Vector &R) const
  {
    Cell         cell(space, *shapes);
    const Vector w = mesh.velocity();
    for (const auto &it : space.cells())
      {
        reinit(cell, it, u, w);
        cell.R = 0.;
        for (unsigned int q = 0; q < shapes->quadrature.size(); ++q)
          {
            const Point x = evaluate(cell, q);
            for (unsigned int k = 0; k < cell.n_pressure; ++k)
              cell.R(cell.index[Cell::dim][k]) -=
                (x.r * x.div_v + x.mass_rate) * cell.M[k] * x.JxW;
          }
        space.topology().distribute_local_to_global(cell.R, cell.dofs, R);
      }
  }
} // namespace asperity
