#include <asperity/base/errors.h>
#include <asperity/coupling/ale_fluid.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <map>

namespace asperity
{
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;

  namespace
  {
    Vector
    interleaved(const NodalVectors &nodal)
    {
      Vector v(2 * nodal.size());
      for (unsigned int n = 0; n < nodal.size(); ++n)
        for (unsigned int i = 0; i < 2; ++i)
          v(2 * n + i) = nodal[n][i];
      return v;
    }



    NodalVectors
    nodal_vectors(const Vector &v)
    {
      NodalVectors nodal(v.size() / 2);
      for (unsigned int n = 0; n < nodal.size(); ++n)
        for (unsigned int i = 0; i < 2; ++i)
          nodal[n][i] = v(2 * n + i);
      return nodal;
    }
  } // namespace



  AleFluid::AleFluid(NavierStokes      &flow,
                     const BoundaryIds &wall,
                     const MeshUpdate  &mesh_update)
    : flow(flow)
    , wall(wall)
    , mesh_update(mesh_update)
  {
    if (flow.space().degree() != flow.space().geometry_dofs().get_fe().degree)
      throw InputError("Coupling needs the fluid's velocity and mesh "
                       "displacement to be of the same degree.");
    geometry_dof = match_geometry(wall);
  }



  std::vector<unsigned int>
  AleFluid::match_geometry(const BoundaryIds &ids) const
  {
    const WallNodes                     &nodes = flow.boundary().nodes(ids);
    std::map<unsigned int, unsigned int> node_of_dof;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      node_of_dof[nodes.dof(n, 0)] = n;
    std::vector<unsigned int> geometry_dof(2 * nodes.size());

    const auto &fe          = flow.space().dofs().get_fe();
    const auto &geometry_fe = flow.space().geometry_dofs().get_fe();
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell()),
      geometry_dofs(geometry_fe.n_dofs_per_cell());
    for (const auto &cell : flow.space().dofs().active_cell_iterators())
      {
        if (!cell->at_boundary())
          continue;
        cell->get_dof_indices(dofs);
        flow.space().geometry_cell(cell)->get_dof_indices(geometry_dofs);
        for (unsigned int a = 0; a < fe.base_element(0).n_dofs_per_cell(); ++a)
          {
            const auto node =
              node_of_dof.find(dofs[fe.component_to_system_index(0, a)]);
            if (node == node_of_dof.end())
              continue;
            for (unsigned int i = 0; i < 2; ++i)
              geometry_dof[2 * node->second + i] =
                geometry_dofs[geometry_fe.component_to_system_index(i, a)];
          }
      }
    return geometry_dof;
  }



  void
  AleFluid::add_moving_wall(const BoundaryIds &ids, const Motion &motion)
  {
    moving_walls.push_back({ids, motion, match_geometry(ids)});
    flow.boundary().set_wall_velocity(ids, flow.wall_mesh_velocity(ids));
  }



  void
  AleFluid::set_sliding_walls(const BoundaryIds &ids)
  {
    sliding_walls = ids;
  }



  void
  AleFluid::begin_step(const double dt)
  {
    flow.begin_step(dt);
  }



  ConvergenceReport
  AleFluid::solve(const WallCondition &condition, WallResponse &response)
  {
    flow.set_mesh_displacement(
      mesh_displacement(condition.displacement, flow.time()));
    for (const MovingWall &moving : moving_walls)
      flow.boundary().set_wall_velocity(moving.ids,
                                        flow.wall_mesh_velocity(moving.ids));

    const NodalVectors wall_velocity = flow.wall_mesh_velocity(wall);
    if (std::isfinite(condition.alpha))
      {
        Vector on_fluid = condition.force;
        on_fluid *= -1.;
        flow.boundary().set_robin(wall,
                                  std::vector<double>(wall_velocity.size(),
                                                      condition.alpha),
                                  wall_velocity,
                                  nodal_vectors(on_fluid));
      }
    else
      flow.boundary().set_wall_velocity(wall, wall_velocity);

    const ConvergenceReport report = flow.solve();
    if (report.converged)
      {
        response.force         = interleaved(flow.wall_force(wall));
        response.velocity      = interleaved(flow.wall_velocity(wall));
        response.wall_velocity = interleaved(wall_velocity);
        // Where the fluid has gone the wall moves without it.
        const WallNodes &nodes = flow.boundary().nodes(wall);
        for (unsigned int i = 0; i < response.velocity.size(); ++i)
          if (flow.space().is_idle(nodes.dof(i / 2, i % 2)))
            response.velocity(i) = response.wall_velocity(i);
      }
    return report;
  }



  void
  AleFluid::accept()
  {
    flow.accept();
  }



  bool
  AleFluid::is_sealed() const
  {
    if (flow.is_compressible())
      return false;
    for (const auto id :
         flow.space().dofs().get_triangulation().get_boundary_ids())
      if (wall.count(id) == 0 && sliding_walls.count(id) == 0 &&
          flow.space().periodic_ids().count(id) == 0 &&
          !flow.boundary().prescribes_velocity(id))
        return false;
    return true;
  }



  double
  AleFluid::rate_coefficient() const
  {
    return flow.mesh_rate();
  }



  void
  AleFluid::integrate(std::vector<double> &length, NodalVectors &normal) const
  {
    const WallNodes                     &nodes = flow.boundary().nodes(wall);
    std::map<unsigned int, unsigned int> node_of_dof;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      node_of_dof[nodes.dof(n, 0)] = n;
    length.assign(nodes.size(), 0.);
    normal.assign(nodes.size(), Tensor<1, 2>());

    const auto             &fe = flow.space().dofs().get_fe();
    const dealii::QGauss<1> quadrature(fe.degree + 2);
    dealii::FEFaceValues<2> face(flow.mapping(),
                                 fe,
                                 quadrature,
                                 dealii::update_values |
                                   dealii::update_JxW_values |
                                   dealii::update_normal_vectors);
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : flow.space().dofs().active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        {
          if (!cell->at_boundary(f) ||
              wall.count(cell->face(f)->boundary_id()) == 0)
            continue;
          face.reinit(cell, f);
          cell->get_dof_indices(dofs);
          for (unsigned int k = 0; k < dofs.size(); ++k)
            {
              const auto node = node_of_dof.find(dofs[k]);
              if (node == node_of_dof.end())
                continue;
              for (unsigned int q = 0; q < quadrature.size(); ++q)
                {
                  const double weight = face.shape_value(k, q) * face.JxW(q);
                  length[node->second] += weight;
                  normal[node->second] += weight * face.normal_vector(q);
                }
            }
        }
  }



  Vector
  AleFluid::lengths() const
  {
    std::vector<double> length;
    NodalVectors        normal;
    integrate(length, normal);
    Vector lengths(2 * length.size());
    for (unsigned int n = 0; n < length.size(); ++n)
      lengths(2 * n) = lengths(2 * n + 1) = length[n];
    return lengths;
  }



  std::vector<Vector>
  AleFluid::uniform_loads() const
  {
    std::vector<double> length;
    NodalVectors        normal;
    integrate(length, normal);
    // n points out of the fluid, hence into the solid.
    std::vector<Vector> loads(3, interleaved(normal));
    for (unsigned int i = 0; i < 2; ++i)
      {
        loads[1 + i] = 0.;
        for (unsigned int n = 0; n < length.size(); ++n)
          loads[1 + i](2 * n + i) = length[n];
      }
    return loads;
  }



  Vector
  AleFluid::mesh_displacement(const Vector &displacement,
                              const double  time) const
  {
    Vector boundary(flow.space().geometry_dofs().n_dofs());
    for (unsigned int i = 0; i < geometry_dof.size(); ++i)
      boundary(geometry_dof[i]) = displacement(i);
    for (const MovingWall &moving : moving_walls)
      {
        const Tensor<1, 2> d = moving.motion(time);
        for (unsigned int i = 0; i < moving.geometry_dof.size(); ++i)
          boundary(moving.geometry_dof[i]) = d[i % 2];
      }
    return mesh_update(boundary);
  }



  std::vector<dealii::Point<2>>
  AleFluid::positions() const
  {
    return flow.boundary().nodes(wall).positions(
      flow.space().reference_mapping());
  }
} // namespace asperity
