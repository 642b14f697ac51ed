#include <asperity/base/errors.h>
#include <asperity/flow/navier_stokes.h>

// Cells of a flow that are switched on and off, and the volume of its parts.
namespace asperity
{
  void
  NavierStokes::set_active(const std::vector<bool> &active)
  {
    std::vector<bool> was_idle(u.size());
    for (unsigned int i = 0; i < was_idle.size(); ++i)
      was_idle[i] = space_.is_idle(i);
    space_.set_active(active);
    wanted_volumes.clear();
    inner_walls =
      std::make_unique<WallNodes>(WallNodes::on_inner_walls(space_));
    is_factorised = false;

    // What is new has gone with the mesh.
    Vector w = mesh.old_displacement();
    w -= mesh.older_displacement();
    w *= dt_old > 0. ? 1. / dt_old : 0.;
    const auto &fe          = space_.dofs().get_fe();
    const auto &geometry_fe = space_.geometry_dofs().get_fe();
    const auto &velocity    = fe.base_element(0);
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell()),
      geometry_dofs(geometry_fe.n_dofs_per_cell());
    for (const auto &cell : space_.cells())
      {
        cell->get_dof_indices(dofs);
        space_.geometry_cell(cell)->get_dof_indices(geometry_dofs);
        for (unsigned int k = 0; k < dofs.size(); ++k)
          {
            const auto [component, a] = fe.system_to_component_index(k);
            if (!was_idle[dofs[k]] || component == 2)
              continue;
            double value = 0.;
            for (unsigned int l = 0; l < geometry_dofs.size(); ++l)
              if (geometry_fe.system_to_component_index(l).first == component)
                value +=
                  geometry_fe.shape_value(l, velocity.unit_support_point(a)) *
                  w(geometry_dofs[l]);
            u(dofs[k]) = u_old(dofs[k]) = u_older(dofs[k]) = value;
          }
      }
    if (options.element == FluidElement::equal_order)
      {
        u             = u_old;
        volume_source = 0.;
        divergence    = galerkin_divergence();
      }
  }



  void
  NavierStokes::set_part_volumes(const std::vector<double> &volumes)
  {
    if (!volumes.empty() && volumes.size() != space_.parts().size())
      throw InputError("A flow has " + std::to_string(space_.parts().size()) +
                       " parts, found " + std::to_string(volumes.size()) +
                       " volumes.");
    wanted_volumes = volumes;
  }



  std::vector<double>
  NavierStokes::part_volumes() const
  {
    return level.volumes();
  }



  void
  NavierStokes::prescribe_inner_walls(
    std::map<unsigned int, double> &prescribed) const
  {
    if (inner_walls == nullptr)
      return;
    const NodalVectors w = inner_walls->extract_geometry(mesh.velocity());
    for (unsigned int n = 0; n < w.size(); ++n)
      for (unsigned int i = 0; i < 2; ++i)
        prescribed[inner_walls->dof(n, i)] = w[n][i];
  }



  void
  NavierStokes::constrain(const std::map<unsigned int, double> &prescribed)
  {
    constraints.copy_from(space_.topology());
    dealii::AffineConstraints<double> all;
    for (const auto &entry : prescribed)
      all.add_line(entry.first);
    for (const unsigned int i : level.held_dofs())
      all.add_line(i);
    for (const unsigned int i : space_.idle_dofs())
      all.add_line(i);
    all.close();
    constraints.merge(all,
                      dealii::AffineConstraints<
                        double>::MergeConflictBehavior::left_object_wins);
    constraints.close();
    std::vector<unsigned int> now;
    for (const auto &line : constraints.get_lines())
      now.push_back(line.index);
    if (now != constrained)
      is_factorised = false;
    constrained.swap(now);
  }



  void
  NavierStokes::fill_empty_rows()
  {
    if (inner_walls == nullptr)
      return;
    for (const unsigned int i : constrained)
      if (matrix.diag_element(i) == 0.)
        matrix.diag_element(i) = 1.;
  }
} // namespace asperity
