#include <asperity/base/errors.h>
#include <asperity/flow/navier_stokes.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

// Cells of a flow that are switched on and off, and the volume of its parts.
namespace asperity
{
  void
  NavierStokes::set_active(const std::vector<bool> &active)
  {
    std::vector<bool> was_idle(u.size());
    for (unsigned int i = 0; i < was_idle.size(); ++i)
      was_idle[i] = space_.is_idle(i);
    const std::vector<bool> was_active = space_.active();
    space_.set_active(active);
    wanted_volumes.clear();
    inner_walls =
      std::make_unique<WallNodes>(WallNodes::on_inner_walls(space_));
    is_factorised = false;
    start_unknowns(was_idle);
    if (options.element == FluidElement::equal_order)
      restart_divergence(was_active);
  }



  void
  NavierStokes::restart_divergence(const std::vector<bool> &was_active)
  {
    u = u_old;
    if (!is_compressible())
      {
        volume_source = 0.;
        divergence    = galerkin_divergence();
        return;
      }
    // The rate of the density is known no longer; where no cell has been
    // switched nothing changes.
    std::vector<dealii::types::global_dof_index> dofs(
      space_.dofs().get_fe().n_dofs_per_cell());
    for (const auto &cell : space_.dofs().active_cell_iterators())
      if (was_active[cell->active_cell_index()] !=
          space_.active()[cell->active_cell_index()])
        {
          cell->get_dof_indices(dofs);
          for (const auto i : dofs)
            divergence(i) = 0.;
        }
  }



  void
  NavierStokes::start_unknowns(const std::vector<bool> &was_idle)
  {
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
    start_pressures(was_idle);
  }



  void
  NavierStokes::start_pressures(const std::vector<bool> &was_idle)
  {
    for (const auto &part : space_.parts())
      for (Vector *state : {&u, &u_old, &u_older})
        {
          double       sum     = 0.;
          unsigned int n_known = 0;
          for (const unsigned int i : part)
            if (!was_idle[i])
              {
                sum += (*state)(i);
                ++n_known;
              }
          for (const unsigned int i : part)
            if (was_idle[i])
              (*state)(i) = n_known > 0 ? sum / n_known : 0.;
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



  bool
  NavierStokes::is_compressible() const
  {
    return options.model.is_compressible();
  }



  std::vector<double>
  NavierStokes::cell_areas() const
  {
    return mesh.cell_areas();
  }



  std::vector<double>
  NavierStokes::cell_contents() const
  {
    const dealii::FEValuesExtractors::Scalar pressure_field(2);
    const auto                              &fe = space_.dofs().get_fe();
    const dealii::QGauss<2>                  quadrature(fe.degree + 1);
    dealii::FEValues<2>                      values(mapping(),
                               fe,
                               quadrature,
                               dealii::update_values |
                                 dealii::update_JxW_values);
    const Vector                             ratio = assembler.density_ratio(u);
    std::vector<double>                      r(quadrature.size());
    std::vector<double>                      contents(space_.active().size());
    for (const auto &cell : space_.cells())
      {
        values.reinit(cell);
        values[pressure_field].get_function_values(ratio, r);
        for (const unsigned int q : values.quadrature_point_indices())
          contents[cell->active_cell_index()] += r[q] * values.JxW(q);
      }
    return contents;
  }



  void
  NavierStokes::account_for_content()
  {
    if (!is_compressible())
      {
        level.impose_volumes(wanted_volumes, volume_source);
        return;
      }
    const Vector r_old   = assembler.density_ratio(u_old),
                 r_older = assembler.density_ratio(u_older);
    std::vector<double> mean_ratio;
    for (const auto &part : space_.parts())
      {
        double sum = 0.;
        for (const unsigned int i : part)
          sum += r_old(i);
        mean_ratio.push_back(sum / part.size());
        for (const unsigned int i : part)
          volume_source(i) *= mean_ratio.back();
      }
    content_source = 0.;
    mesh.add_content_history(r_old, r_older, mean_ratio, content_source);
    content_source *= -1.;
    // The whole source makes the content, but the history is no size to compare
    // a residual with.
    Vector whole = content_source;
    whole += volume_source;
    whole += source;
    const Vector uneven = whole;
    level.impose_contents(wanted_volumes, u, assembler.density_ratio(u), whole);
    content_source += whole;
    content_source -= uneven;
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
