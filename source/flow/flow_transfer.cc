#include <asperity/base/errors.h>
#include <asperity/flow/flow_transfer.h>

#include <deal.II/base/geometry_info.h>

namespace asperity
{
  using dealii::Point;
  using Vector   = dealii::Vector<double>;
  using Geometry = dealii::GeometryInfo<2>;
  using Cell     = dealii::DoFHandler<2>::cell_iterator;

  namespace
  {
    /** A point of a cell, in the coordinates of the reference square. */
    struct Place
    {
      Cell     cell;
      Point<2> xi;
    };



    /** The same point in the ancestor on the coarse mesh. */
    Place
    climb(Place place)
    {
      while (place.cell->level() > 0)
        {
          const Cell   parent = place.cell->parent();
          unsigned int child  = 0;
          while (parent->child(child) != place.cell)
            ++child;
          place.xi   = Geometry::child_to_cell_coordinates(place.xi, child);
          place.cell = parent;
        }
      return place;
    }



    /** The same point in the active descendant. */
    Place
    descend(Place place)
    {
      while (place.cell->has_children())
        {
          const unsigned int child = Geometry::child_cell_from_point(place.xi);
          place.xi   = Geometry::cell_to_child_coordinates(place.xi, child);
          place.cell = place.cell->child(child);
        }
      return place;
    }



    double
    value_at(const Place                                  &place,
             const dealii::FiniteElement<2>               &fe,
             const Vector                                 &u,
             const unsigned int                            component,
             std::vector<dealii::types::global_dof_index> &dofs)
    {
      place.cell->get_dof_indices(dofs);
      double value = 0.;
      for (unsigned int k = 0; k < dofs.size(); ++k)
        if (fe.system_to_component_index(k).first == component)
          value += fe.shape_value(k, place.xi) * u(dofs[k]);
      return value;
    }
  } // namespace



  Vector
  interpolate_to_mesh(const dealii::DoFHandler<2> &from,
                      const Vector                &u,
                      const dealii::DoFHandler<2> &to)
  {
    const auto &old_mesh = from.get_triangulation();
    if (old_mesh.n_cells(0) != to.get_triangulation().n_cells(0))
      throw InputError("A flow can be interpolated between refinements of one "
                       "coarse mesh only; found coarse meshes of " +
                       std::to_string(old_mesh.n_cells(0)) + " and " +
                       std::to_string(to.get_triangulation().n_cells(0)) +
                       " cells.");
    const auto &old_fe = from.get_fe(), &new_fe = to.get_fe();
    std::vector<dealii::types::global_dof_index> dofs(new_fe.n_dofs_per_cell()),
      old_cell_dofs(old_fe.n_dofs_per_cell());
    Vector result(to.n_dofs());
    for (const auto &cell : to.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int k = 0; k < dofs.size(); ++k)
          {
            Place place = climb({cell, new_fe.unit_support_point(k)});
            place.cell  = Cell(&old_mesh, 0, place.cell->index(), &from);
            result(dofs[k]) =
              value_at(descend(place),
                       old_fe,
                       u,
                       new_fe.system_to_component_index(k).first,
                       old_cell_dofs);
          }
      }
    return result;
  }
} // namespace asperity
