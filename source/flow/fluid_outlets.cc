#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/flow/fluid_outlets.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace asperity
{
  using dealii::Tensor;

  namespace
  {
    const dealii::FEValuesExtractors::Vector velocity_field(0);
    const dealii::FEValuesExtractors::Scalar pressure_field(2);

    /** Calls `work` with the cells and faces of a side that are on. */
    template <typename Work>
    void
    for_faces(const FluidSpace                &space,
              const dealii::types::boundary_id side,
              const Work                      &work)
    {
      for (const auto &cell : space.cells())
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f) && cell->face(f)->boundary_id() == side)
            work(cell, f);
    }



    /** Adds -eta ((grad v)^T n) . w of one point, and its derivative. */
    void
    add_shear_at(const dealii::FEFaceValues<2> &values,
                 const unsigned int             q,
                 const Tensor<2, 2>            &grad_v,
                 const double                   p,
                 const LubricantViscosity      &viscosity,
                 dealii::Vector<double>        &local,
                 dealii::FullMatrix<double>    &K)
    {
      const auto          &fe   = values.get_fe();
      const Tensor<1, 2>   n    = values.normal_vector(q);
      const Tensor<2, 2>   D    = 0.5 * (grad_v + transpose(grad_v));
      const double         rate = std::sqrt(2. * scalar_product(D, D));
      const ViscosityValue eta  = viscosity.evaluate(rate, p);
      const Tensor<1, 2>   t    = transpose(grad_v) * n;
      for (unsigned int i = 0; i < local.size(); ++i)
        {
          const unsigned int c = fe.system_to_component_index(i).first;
          if (c == 2)
            continue;
          const double N = values.shape_value(i, q) * values.JxW(q);
          local(i) -= eta.value * t[c] * N;
          for (unsigned int j = 0; j < local.size(); ++j)
            {
              const unsigned int d = fe.system_to_component_index(j).first;
              if (d == 2)
                {
                  K(i, j) -=
                    eta.d_pressure * values.shape_value(j, q) * t[c] * N;
                  continue;
                }
              const Tensor<1, 2> g = values.shape_grad(j, q);
              const double d_rate  = rate > 0. ? 2. * (D * g)[d] / rate : 0.;
              K(i, j) -=
                (eta.value * g[c] * n[d] + eta.d_rate * d_rate * t[c]) * N;
            }
        }
    }
  } // namespace



  FluidOutlets::FluidOutlets(const FluidSpace               &space,
                             const MovingMesh               &mesh,
                             const FluidAssembler           &assembler,
                             const std::vector<FluidOutlet> &outlets)
    : space(space)
    , mesh(mesh)
    , assembler(assembler)
    , outlets(outlets)
    , passed_(outlets.size())
  {
    for (const FluidOutlet &outlet : outlets)
      if (!(outlet.resistance >= 0.))
        throw InputError("An outlet of a flow has the resistance " +
                         format_number(outlet.resistance) +
                         " Pa s/m; expected none that is negative.");
  }



  FluidOutlets::Side
  FluidOutlets::measure(const FluidOutlet &outlet) const
  {
    const auto                                  &fe = space.dofs().get_fe();
    const dealii::QGauss<1>                      quadrature(fe.degree + 2);
    dealii::FEFaceValues<2>                      values(mesh.mapping(),
                                   fe,
                                   quadrature,
                                   dealii::update_values |
                                     dealii::update_JxW_values |
                                     dealii::update_normal_vectors);
    dealii::FEFaceValues<2>                      geometry(mesh.mapping(),
                                     space.geometry_dofs().get_fe(),
                                     quadrature,
                                     dealii::update_values);
    const Vector                                 w = mesh.velocity();
    Side                                         side;
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    std::vector<Tensor<1, 2>>                    w_values(quadrature.size());
    std::map<unsigned int, double>               flux;
    for_faces(space, outlet.side, [&](const auto &cell, const unsigned int f) {
      values.reinit(cell, f);
      geometry.reinit(space.geometry_cell(cell), f);
      geometry[velocity_field].get_function_values(w, w_values);
      cell->get_dof_indices(dofs);
      for (const unsigned int q : values.quadrature_point_indices())
        {
          const Tensor<1, 2> n = values.normal_vector(q) * values.JxW(q);
          side.swept += w_values[q] * n;
          side.height += values.JxW(q);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            {
              const unsigned int c = fe.system_to_component_index(i).first;
              if (c < 2 && fe.has_support_on_face(i, f))
                flux[dofs[i]] += values.shape_value(i, q) * n[c];
            }
        }
    });
    side.flux.reinit(flux.size());
    for (const auto &[dof, value] : flux)
      {
        side.flux(side.dofs.size()) = value;
        side.dofs.push_back(dof);
      }
    return side;
  }



  void
  FluidOutlets::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    for (const FluidOutlet &outlet : outlets)
      if (outlet.resistance > 0.)
        space.topology().add_entries_local_to_global(measure(outlet).dofs,
                                                     pattern);
  }



  void
  FluidOutlets::add(const Vector                            &u,
                    const dealii::AffineConstraints<double> &constraints,
                    Vector                                  &R,
                    Vector                                  &scale,
                    dealii::SparseMatrix<double>            *tangent) const
  {
    for (const FluidOutlet &outlet : outlets)
      {
        add_pressure(outlet, u, constraints, R, scale, tangent);
        add_shear(outlet, u, constraints, R, scale, tangent);
      }
  }



  void
  FluidOutlets::add_pressure(
    const FluidOutlet                       &outlet,
    const Vector                            &u,
    const dealii::AffineConstraints<double> &constraints,
    Vector                                  &R,
    Vector                                  &scale,
    dealii::SparseMatrix<double>            *tangent) const
  {
    const Side side = measure(outlet);
    double     q    = -side.swept;
    for (unsigned int i = 0; i < side.dofs.size(); ++i)
      q += side.flux(i) * u(side.dofs[i]);
    const double R_h   = outlet.resistance / side.height;
    const double p     = outlet.pressure + R_h * q;
    Vector       force = side.flux;
    force *= p;
    space.topology().distribute_local_to_global(force, side.dofs, R);
    for (unsigned int i = 0; i < side.dofs.size(); ++i)
      scale(side.dofs[i]) += std::abs(force(i));
    if (tangent == nullptr || outlet.resistance == 0.)
      return;
    dealii::FullMatrix<double> K(side.dofs.size(), side.dofs.size());
    for (unsigned int i = 0; i < side.dofs.size(); ++i)
      for (unsigned int j = 0; j < side.dofs.size(); ++j)
        K(i, j) = R_h * side.flux(i) * side.flux(j);
    constraints.distribute_local_to_global(K, side.dofs, *tangent);
  }



  void
  FluidOutlets::add_shear(const FluidOutlet                       &outlet,
                          const Vector                            &u,
                          const dealii::AffineConstraints<double> &constraints,
                          Vector                                  &R,
                          Vector                                  &scale,
                          dealii::SparseMatrix<double> *tangent) const
  {
    const LubricantViscosity viscosity(assembler.model().viscosity);
    const auto              &fe = space.dofs().get_fe();
    const dealii::QGauss<1>  quadrature(fe.degree + 2);
    dealii::FEFaceValues<2>  values(mesh.mapping(),
                                   fe,
                                   quadrature,
                                   dealii::update_values |
                                     dealii::update_gradients |
                                     dealii::update_JxW_values |
                                     dealii::update_normal_vectors);
    const unsigned int       n_dofs = fe.n_dofs_per_cell();
    std::vector<dealii::types::global_dof_index> dofs(n_dofs);
    dealii::Vector<double>                       local(n_dofs);
    dealii::FullMatrix<double>                   K(n_dofs, n_dofs);
    std::vector<Tensor<2, 2>>                    grad_v(quadrature.size());
    std::vector<double>                          p(quadrature.size());
    for_faces(space, outlet.side, [&](const auto &cell, const unsigned int f) {
      values.reinit(cell, f);
      values[velocity_field].get_function_gradients(u, grad_v);
      values[pressure_field].get_function_values(u, p);
      local = 0.;
      K     = 0.;
      for (const unsigned int q : values.quadrature_point_indices())
        add_shear_at(values, q, grad_v[q], p[q], viscosity, local, K);
      cell->get_dof_indices(dofs);
      space.topology().distribute_local_to_global(local, dofs, R);
      for (unsigned int i = 0; i < n_dofs; ++i)
        scale(dofs[i]) += std::abs(local(i));
      if (tangent != nullptr)
        constraints.distribute_local_to_global(K, dofs, *tangent);
    });
  }



  std::vector<double>
  FluidOutlets::outflow(const Vector &u) const
  {
    std::vector<double> q;
    for (const FluidOutlet &outlet : outlets)
      {
        const Side side = measure(outlet);
        q.push_back(-side.swept);
        for (unsigned int i = 0; i < side.dofs.size(); ++i)
          q.back() += side.flux(i) * u(side.dofs[i]);
      }
    return q;
  }



  void
  FluidOutlets::accept(const Vector &u)
  {
    const BackwardDifference &rate = mesh.rate();
    if (rate.now == 0.)
      return;
    const std::vector<double> q = outflow(u);
    const auto integrate        = [&rate](double &now, double &old, double q) {
      const double next = (q - rate.old * now - rate.older * old) / rate.now;
      old               = now;
      now               = next;
    };
    for (unsigned int i = 0; i < q.size(); ++i)
      {
        integrate(passed_[i].in, passed_[i].in_old, std::max(-q[i], 0.));
        integrate(passed_[i].out, passed_[i].out_old, std::max(q[i], 0.));
      }
  }



  const std::vector<PassedVolume> &
  FluidOutlets::passed() const
  {
    return passed_;
  }



  void
  FluidOutlets::set_passed(const std::vector<PassedVolume> &passed)
  {
    passed_ = passed;
  }
} // namespace asperity
