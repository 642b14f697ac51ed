#include <asperity/base/archive.h>
#include <asperity/flow/navier_stokes.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/numerics/data_component_interpretation.h>
#include <deal.II/numerics/vector_tools.h>

#include <algorithm>
#include <numeric>
#include <vector>

// What a flow knows about itself, and its state.
namespace asperity
{
  using dealii::Tensor;

  namespace
  {
    template <typename State>
    auto
    vectors(State &state)
    {
      return std::vector{&state.u,
                         &state.u_old,
                         &state.displacement,
                         &state.displacement_old,
                         &state.divergence};
    }
  } // namespace



  void
  FluidState::save(OutputArchive &archive) const
  {
    archive << time << dt << n_steps;
    for (const auto *v : vectors(*this))
      archive << *v;
    archive << active << passed;
  }



  void
  FluidState::load(InputArchive &archive)
  {
    archive >> time >> dt >> n_steps;
    for (auto *v : vectors(*this))
      archive >> fixed_length(*v, "unknowns of a flow");
    archive >> fixed_length(active, "cells of a flow");
    archive >> fixed_length(passed, "outlets of a flow");
  }



  NavierStokes::Vector
  NavierStokes::reference_positions() const
  {
    Vector X(space_.geometry_dofs().n_dofs());
    dealii::VectorTools::get_position_vector(space_.reference_mapping(),
                                             space_.geometry_dofs(),
                                             X);
    return X;
  }



  NodalVectors
  NavierStokes::wall_mesh_velocity(const BoundaryIds &ids) const
  {
    return boundary_.nodes(ids).extract_geometry(mesh.velocity());
  }



  void
  NavierStokes::set_initial_velocity(const FluidFunction &velocity)
  {
    const auto                                  &fe = space_.dofs().get_fe();
    const auto                                  &v  = fe.base_element(0);
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : space_.dofs().active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int a = 0; a < v.n_dofs_per_cell(); ++a)
          {
            const auto value = velocity(mapping().transform_unit_to_real_cell(
                                          cell, v.unit_support_point(a)),
                                        time_old);
            for (unsigned int i = 0; i < 2; ++i)
              u(dofs[fe.component_to_system_index(i, a)]) = value[i];
          }
      }
    space_.topology().distribute(u);
    u_old      = u;
    divergence = 0.;
    // That of a compressible fluid may be its rate.
    if (!is_compressible())
      divergence = galerkin_divergence();
  }



  const NavierStokes::Vector &
  NavierStokes::solution() const
  {
    return u;
  }



  void
  NavierStokes::set_solution(const Vector &new_u)
  {
    u = new_u;
  }



  NodalVectors
  NavierStokes::wall_velocity(const BoundaryIds &ids) const
  {
    return boundary_.nodes(ids).extract(u);
  }



  NodalVectors
  NavierStokes::wall_force(const BoundaryIds &ids) const
  {
    NodalVectors force = boundary_.nodes(ids).extract(cell_forces);
    for (auto &f : force)
      f *= -1.;
    return force;
  }



  Tensor<1, 2>
  NavierStokes::total_wall_force(const BoundaryIds &ids) const
  {
    Tensor<1, 2> total;
    for (const auto &f : wall_force(ids))
      total += f;
    return total;
  }



  std::vector<double>
  NavierStokes::outflow() const
  {
    return outlets.outflow(u);
  }



  const std::vector<PassedVolume> &
  NavierStokes::passed_volumes() const
  {
    return outlets.passed();
  }



  bool
  NavierStokes::is_enclosed() const
  {
    return level.is_undetermined();
  }



  double
  NavierStokes::volume() const
  {
    const std::vector<double> parts = part_volumes();
    return std::accumulate(parts.begin(), parts.end(), 0.);
  }



  Tensor<1, 2>
  NavierStokes::velocity_at(const dealii::Point<2> &x) const
  {
    dealii::Vector<double> value(3);
    dealii::VectorTools::point_value(mapping(), space_.dofs(), u, x, value);
    Tensor<1, 2> v;
    v[0] = value(0);
    v[1] = value(1);
    return v;
  }



  double
  NavierStokes::pressure_at(const dealii::Point<2> &x) const
  {
    dealii::Vector<double> value(3);
    dealii::VectorTools::point_value(mapping(), space_.dofs(), u, x, value);
    return value(2);
  }



  void
  NavierStokes::attach_to(dealii::DataOut<2> &output) const
  {
    using Interpretation =
      dealii::DataComponentInterpretation::DataComponentInterpretation;
    const std::vector<Interpretation> interpretation = {
      dealii::DataComponentInterpretation::component_is_part_of_vector,
      dealii::DataComponentInterpretation::component_is_part_of_vector,
      dealii::DataComponentInterpretation::component_is_scalar};
    output.add_data_vector(space_.dofs(),
                           u,
                           {"velocity", "velocity", "pressure"},
                           interpretation);
  }



  const dealii::Mapping<2> &
  NavierStokes::mapping() const
  {
    return mesh.mapping();
  }



  const FluidSpace &
  NavierStokes::space() const
  {
    return space_;
  }



  FluidState
  NavierStokes::state() const
  {
    return {time_old,
            dt_old,
            n_steps,
            u_old,
            u_older,
            mesh.old_displacement(),
            mesh.older_displacement(),
            divergence,
            space_.active(),
            outlets.passed()};
  }



  void
  NavierStokes::set_state(const FluidState &state)
  {
    if (state.active != space_.active())
      set_active(state.active);
    time_old   = state.time;
    dt_old     = state.dt;
    dt         = 0.;
    n_steps    = state.n_steps;
    u          = state.u;
    u_old      = state.u;
    u_older    = state.u_old;
    divergence = state.divergence;
    outlets.set_passed(state.passed);
    mesh.set_displacement(state.displacement);
    mesh.set_history(state.displacement, state.displacement_old);
  }



  const NewtonStatistics &
  NavierStokes::statistics() const
  {
    return statistics_;
  }
} // namespace asperity
