#include <asperity/flow/wall_nodes.h>

#include <map>

namespace asperity
{
  WallNodes::WallNodes(const FluidSpace &space, const BoundaryIds &ids)
    : space(space)
  {
    const auto        &fe       = space.dofs().get_fe();
    const auto        &velocity = fe.base_element(0);
    const unsigned int n_face   = velocity.n_dofs_per_face();
    std::vector<dealii::types::global_dof_index> cell_dofs(
      fe.n_dofs_per_cell());
    std::set<unsigned int> known;
    for (const auto &cell : space.dofs().active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        {
          if (!cell->at_boundary(f) ||
              ids.count(cell->face(f)->boundary_id()) == 0)
            continue;
          cell->get_dof_indices(cell_dofs);
          for (unsigned int k = 0; k < n_face; ++k)
            {
              const unsigned int a = velocity.face_to_cell_index(k, f);
              const unsigned int i = fe.component_to_system_index(0, a);
              const unsigned int j = fe.component_to_system_index(1, a);
              if (!known.insert(cell_dofs[i]).second)
                continue;
              place.push_back({cell, velocity.unit_support_point(a)});
              dofs.push_back({{static_cast<unsigned int>(cell_dofs[i]),
                               static_cast<unsigned int>(cell_dofs[j])}});
            }
        }
  }



  WallNodes::WallNodes(const FluidSpace &space)
    : space(space)
  {}



  WallNodes
  WallNodes::on_inner_walls(const FluidSpace &space)
  {
    const auto                                  &fe = space.dofs().get_fe();
    const auto                                  &velocity = fe.base_element(0);
    WallNodes                                    walls(space);
    std::vector<dealii::types::global_dof_index> cell_dofs(
      fe.n_dofs_per_cell());
    std::set<unsigned int> known;
    for (const auto &cell : space.cells())
      {
        cell->get_dof_indices(cell_dofs);
        for (unsigned int a = 0; a < velocity.n_dofs_per_cell(); ++a)
          {
            const unsigned int i =
              cell_dofs[fe.component_to_system_index(0, a)];
            const unsigned int j =
              cell_dofs[fe.component_to_system_index(1, a)];
            if (!space.is_on_inner_wall(i) || !known.insert(i).second)
              continue;
            walls.place.push_back({cell, velocity.unit_support_point(a)});
            walls.dofs.push_back({{i, j}});
          }
      }
    return walls;
  }



  unsigned int
  WallNodes::size() const
  {
    return dofs.size();
  }



  unsigned int
  WallNodes::dof(const unsigned int node, const unsigned int component) const
  {
    return dofs[node][component];
  }



  std::vector<dealii::Point<2>>
  WallNodes::positions(const dealii::Mapping<2> &mapping) const
  {
    std::vector<dealii::Point<2>> result;
    result.reserve(size());
    for (const Place &node : place)
      result.push_back(
        mapping.transform_unit_to_real_cell(node.cell, node.unit_point));
    return result;
  }



  NodalVectors
  WallNodes::extract(const dealii::Vector<double> &unknowns) const
  {
    NodalVectors result(size());
    for (unsigned int n = 0; n < size(); ++n)
      for (unsigned int i = 0; i < 2; ++i)
        result[n][i] = unknowns(dofs[n][i]);
    return result;
  }



  NodalVectors
  WallNodes::extract_geometry(const dealii::Vector<double> &field) const
  {
    const auto &fe = space.geometry_dofs().get_fe();
    std::vector<dealii::types::global_dof_index> cell_dofs(
      fe.n_dofs_per_cell());
    NodalVectors result(size());
    for (unsigned int n = 0; n < size(); ++n)
      {
        space.geometry_cell(place[n].cell)->get_dof_indices(cell_dofs);
        for (unsigned int k = 0; k < cell_dofs.size(); ++k)
          result[n][fe.system_to_component_index(k).first] +=
            fe.shape_value(k, place[n].unit_point) * field(cell_dofs[k]);
      }
    return result;
  }
} // namespace asperity
