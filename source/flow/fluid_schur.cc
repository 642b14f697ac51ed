#include <asperity/flow/fluid_cell.h>
#include <asperity/flow/fluid_schur.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  FluidSchur::FluidSchur(const FluidSpace &space)
    : space(space)
  {
    const unsigned int first = space.n_velocity_dofs();
    for (const auto &line : space.topology().get_lines())
      if (line.index >= first)
        {
          pressure_topology.add_line(line.index - first);
          for (const auto &entry : line.entries)
            pressure_topology.add_entry(line.index - first,
                                        entry.first - first,
                                        entry.second);
        }
    pressure_topology.close();

    const auto                                  &fe = space.dofs().get_fe();
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    std::vector<dealii::types::global_dof_index> pressure;
    dealii::DynamicSparsityPattern couplings(space.dofs().n_dofs() - first);
    for (const auto &cell : space.dofs().active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        pressure.clear();
        for (const auto i : dofs)
          if (i >= first)
            pressure.push_back(i - first);
        pressure_topology.add_entries_local_to_global(pressure,
                                                      couplings,
                                                      false);
      }
    estimate.mass_pattern.copy_from(couplings);
  }



  const SchurEstimate &
  FluidSchur::of_tangent(const Vector                    &u,
                         const FluidAssembler            &assembler,
                         const FluidBoundary             &boundary,
                         const std::vector<unsigned int> &held_dofs,
                         const bool                       is_convective)
  {
    estimate.is_convective = is_convective;
    estimate.mass.reinit(estimate.mass_pattern);
    estimate.inertia.reinit(space.dofs().n_dofs());
    assembler.add_schur_estimate(u,
                                 pressure_topology,
                                 estimate.mass,
                                 estimate.inertia);
    // A steady flow's Robin terms are no inertia.
    if (estimate.inertia.linfty_norm() > 0.)
      boundary.add_robin_diagonal(estimate.inertia);
    for (const unsigned int i : space.idle_dofs())
      if (i < space.n_velocity_dofs())
        estimate.inertia(i) = 1.;
      else
        estimate.mass.diag_element(i - space.n_velocity_dofs()) = 1.;
    estimate.inertia.grow_or_shrink(space.n_velocity_dofs());
    set_levels(held_dofs);
    return estimate;
  }



  const SchurEstimate &
  FluidSchur::of_projection(const dealii::SparseMatrix<double> &matrix,
                            const std::vector<unsigned int>    &held_dofs)
  {
    estimate.is_convective = false;
    estimate.mass.clear();
    estimate.inertia.reinit(space.n_velocity_dofs());
    for (unsigned int i = 0; i < estimate.inertia.size(); ++i)
      estimate.inertia(i) = matrix.diag_element(i);
    set_levels(held_dofs);
    return estimate;
  }



  void
  FluidSchur::set_levels(const std::vector<unsigned int> &held_dofs)
  {
    const unsigned int first = space.n_velocity_dofs();
    estimate.levels.clear();
    for (const auto &part : space.parts())
      for (const unsigned int held : held_dofs)
        if (std::binary_search(part.begin(), part.end(), held))
          {
            std::vector<unsigned int> set = {held - first};
            for (const unsigned int i : part)
              if (i != held && !space.topology().is_constrained(i))
                set.push_back(i - first);
            estimate.levels.push_back(set);
          }
  }



  void
  FluidAssembler::add_schur_estimate(
    const Vector                            &u,
    const dealii::AffineConstraints<double> &pressure_topology,
    dealii::SparseMatrix<double>            &mass,
    Vector                                  &inertia) const
  {
    const unsigned int         first = space.n_velocity_dofs();
    Cell                       cell(space, *shapes);
    const Vector               w = mesh.velocity();
    dealii::FullMatrix<double> M(cell.n_pressure, cell.n_pressure);
    std::vector<dealii::types::global_dof_index> pressure(cell.n_pressure);
    for (const auto &it : space.cells())
      {
        reinit(cell, it, u, w);
        M      = 0.;
        cell.R = 0.;
        for (unsigned int q = 0; q < shapes->quadrature.size(); ++q)
          {
            const Point  x = evaluate(cell, q);
            const double inverse =
              x.JxW * (1. / x.eta.value +
                       rate.now * model_.compressibility.derivative(x.p));
            for (unsigned int k = 0; k < cell.n_pressure; ++k)
              for (unsigned int l = 0; l < cell.n_pressure; ++l)
                M(k, l) += cell.M[k] * cell.M[l] * inverse;
            for (unsigned int a = 0; a < cell.n_velocity; ++a)
              for (unsigned int i = 0; i < Cell::dim; ++i)
                cell.R(cell.index[i][a]) +=
                  model_.density * rate.now * cell.N[a] * cell.N[a] * x.JxW;
          }
        for (unsigned int k = 0; k < cell.n_pressure; ++k)
          pressure[k] = cell.dofs[cell.index[2][k]] - first;
        pressure_topology.distribute_local_to_global(M, pressure, mass);
        space.topology().distribute_local_to_global(cell.R, cell.dofs, inertia);
      }
  }
} // namespace asperity
