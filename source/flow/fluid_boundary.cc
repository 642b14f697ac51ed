#include <asperity/base/errors.h>
#include <asperity/flow/fluid_boundary.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace asperity
{
  using dealii::Tensor;

  namespace
  {
    const dealii::FEValuesExtractors::Vector velocity_field(0);

    bool
    overlap(const BoundaryIds &a, const BoundaryIds &b)
    {
      return std::any_of(a.begin(), a.end(), [&b](const auto id) {
        return b.count(id) > 0;
      });
    }
  } // namespace



  /** Work space of one face. */
  struct FluidBoundary::Face
  {
    explicit Face(const FluidSpace &space, const MovingMesh &mesh)
      : quadrature(space.degree() + 2)
      , values(mesh.mapping(),
               space.dofs().get_fe(),
               quadrature,
               dealii::update_values | dealii::update_JxW_values |
                 dealii::update_normal_vectors |
                 dealii::update_quadrature_points)
      , dofs(space.dofs().get_fe().n_dofs_per_cell())
      , R(dofs.size())
      , K(dofs.size(), dofs.size())
      , v(quadrature.size())
      , wall_v(quadrature.size())
      , alpha(quadrature.size())
    {}

    const dealii::QGauss<1>                      quadrature;
    dealii::FEFaceValues<2>                      values;
    std::vector<dealii::types::global_dof_index> dofs;
    dealii::Vector<double>                       R;
    dealii::FullMatrix<double>                   K;
    std::vector<Tensor<1, 2>>                    v, wall_v, alpha;
  };



  FluidBoundary::FluidBoundary(const FluidSpace &space, const MovingMesh &mesh)
    : space(space)
    , mesh(mesh)
  {}



  void
  FluidBoundary::set_velocity(const BoundaryIds        &ids,
                              const FluidFunction      &velocity,
                              const std::array<bool, 2> components)
  {
    Condition condition;
    condition.kind       = Kind::velocity;
    condition.function   = velocity;
    condition.components = components;
    set(ids, condition);
  }



  void
  FluidBoundary::set_wall_velocity(const BoundaryIds  &ids,
                                   const NodalVectors &velocity)
  {
    check_size(ids, velocity.size());
    Condition condition;
    condition.kind  = Kind::wall_velocity;
    condition.nodal = velocity;
    set(ids, condition);
  }



  void
  FluidBoundary::set_traction(const BoundaryIds      &ids,
                              const TractionFunction &traction)
  {
    Condition condition;
    condition.kind     = Kind::traction;
    condition.traction = traction;
    set(ids, condition);
  }



  void
  FluidBoundary::set_robin(const BoundaryIds         &ids,
                           const std::vector<double> &alpha,
                           const NodalVectors        &velocity,
                           const NodalVectors        &force)
  {
    check_size(ids, alpha.size());
    check_size(ids, velocity.size());
    check_size(ids, force.size());
    if (!std::all_of(alpha.begin(), alpha.end(), [](const double a) {
          return std::isfinite(a) && a >= 0.;
        }))
      throw InputError("A Robin coefficient of the fluid is negative or not "
                       "finite.");
    Condition condition;
    condition.kind  = Kind::robin;
    condition.nodal = force;
    condition.alpha.reinit(space.dofs().n_dofs());
    condition.velocity.reinit(space.dofs().n_dofs());
    const WallNodes &wall = nodes(ids);
    for (unsigned int n = 0; n < wall.size(); ++n)
      for (unsigned int i = 0; i < 2; ++i)
        {
          condition.alpha(wall.dof(n, i))    = alpha[n];
          condition.velocity(wall.dof(n, i)) = velocity[n][i];
        }
    set(ids, condition);
  }



  void
  FluidBoundary::set(const BoundaryIds &ids, const Condition &condition)
  {
    for (const auto &other : conditions)
      if (other.first != ids && overlap(other.first, ids))
        throw InputError("A boundary of the fluid has two conditions; release "
                         "the first before the second is set.");
    if (overlap(ids, space.periodic_ids()))
      throw InputError(
        "A periodic side of the fluid has a boundary condition.");
    conditions[ids] = condition;
  }



  void
  FluidBoundary::release(const BoundaryIds &ids)
  {
    conditions.erase(ids);
  }



  void
  FluidBoundary::check_size(const BoundaryIds &ids, const std::size_t n) const
  {
    if (n != nodes(ids).size())
      throw InputError("A wall of the fluid has " +
                       std::to_string(nodes(ids).size()) + " nodes, found " +
                       std::to_string(n) + " values.");
  }



  const WallNodes &
  FluidBoundary::nodes(const BoundaryIds &ids) const
  {
    auto &entry = nodes_[ids];
    if (entry == nullptr)
      entry = std::make_unique<WallNodes>(space, ids);
    return *entry;
  }



  const FluidBoundary::Condition *
  FluidBoundary::condition_on(const dealii::types::boundary_id id) const
  {
    for (const auto &entry : conditions)
      if (entry.first.count(id) > 0)
        return &entry.second;
    return nullptr;
  }



  bool
  FluidBoundary::prescribes_velocity(const dealii::types::boundary_id id) const
  {
    const Condition *condition = condition_on(id);
    return condition != nullptr &&
           (condition->kind == Kind::velocity ||
            condition->kind == Kind::wall_velocity) &&
           condition->components[0] && condition->components[1];
  }



  std::map<unsigned int, double>
  FluidBoundary::prescribed(const double time) const
  {
    std::map<unsigned int, double> values;
    for (const auto &[ids, condition] : conditions)
      {
        if (condition.kind != Kind::velocity &&
            condition.kind != Kind::wall_velocity)
          continue;
        const WallNodes &wall = nodes(ids);
        NodalVectors     v    = condition.nodal;
        if (condition.kind == Kind::velocity)
          for (const auto &x : wall.positions(mesh.mapping()))
            v.push_back(condition.function(x, time));
        for (unsigned int n = 0; n < wall.size(); ++n)
          for (unsigned int i = 0; i < 2; ++i)
            if (condition.components[i])
              values.emplace(wall.dof(n, i), v[n][i]);
      }
    return values;
  }



  void
  FluidBoundary::add(const Vector                            &u,
                     const double                             time,
                     const dealii::AffineConstraints<double> &constraints,
                     Vector                                  &R,
                     Vector                                  &scale,
                     dealii::SparseMatrix<double>            *tangent) const
  {
    Face face(space, mesh);
    for (const auto &cell : space.cells())
      for (const unsigned int f : cell->face_indices())
        {
          if (!cell->at_boundary(f))
            continue;
          const Condition *condition =
            condition_on(cell->face(f)->boundary_id());
          if (condition == nullptr || (condition->kind != Kind::traction &&
                                       condition->kind != Kind::robin))
            continue;
          face.values.reinit(cell, f);
          integrate(face, *condition, u, time);
          cell->get_dof_indices(face.dofs);
          space.topology().distribute_local_to_global(face.R, face.dofs, R);
          for (unsigned int i = 0; i < face.dofs.size(); ++i)
            scale(face.dofs[i]) += std::abs(face.R(i));
          if (tangent != nullptr)
            constraints.distribute_local_to_global(face.K, face.dofs, *tangent);
        }
    for (const auto &[ids, condition] : conditions)
      if (condition.kind == Kind::robin)
        {
          const WallNodes &wall = nodes(ids);
          for (unsigned int n = 0; n < wall.size(); ++n)
            for (unsigned int i = 0; i < 2; ++i)
              space.topology().distribute_local_to_global(
                wall.dof(n, i), -condition.nodal[n][i], R);
        }
  }



  void
  FluidBoundary::add_robin_diagonal(Vector &diagonal) const
  {
    Face         face(space, mesh);
    const Vector at_rest(space.dofs().n_dofs());
    for (const auto &cell : space.cells())
      for (const unsigned int f : cell->face_indices())
        {
          const Condition *condition =
            cell->at_boundary(f) ? condition_on(cell->face(f)->boundary_id()) :
                                   nullptr;
          if (condition == nullptr || condition->kind != Kind::robin)
            continue;
          face.values.reinit(cell, f);
          integrate(face, *condition, at_rest, 0.);
          for (unsigned int i = 0; i < face.dofs.size(); ++i)
            face.R(i) = face.K(i, i);
          cell->get_dof_indices(face.dofs);
          space.topology().distribute_local_to_global(face.R,
                                                      face.dofs,
                                                      diagonal);
        }
  }



  void
  FluidBoundary::integrate(Face            &face,
                           const Condition &condition,
                           const Vector    &u,
                           const double     time) const
  {
    face.R               = 0.;
    face.K               = 0.;
    const auto &values   = face.values;
    const auto &fe       = space.dofs().get_fe();
    const bool  is_robin = condition.kind == Kind::robin;
    if (is_robin)
      {
        values[velocity_field].get_function_values(u, face.v);
        values[velocity_field].get_function_values(condition.velocity,
                                                   face.wall_v);
        values[velocity_field].get_function_values(condition.alpha, face.alpha);
      }
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const double alpha = is_robin ? face.alpha[q][0] : 0.;
        Tensor<1, 2> term; // of the weak form, times w
        if (is_robin)
          term = alpha * (face.v[q] - face.wall_v[q]);
        else
          term = -condition.traction(values.quadrature_point(q),
                                     values.normal_vector(q),
                                     time);
        for (unsigned int i = 0; i < face.dofs.size(); ++i)
          {
            const unsigned int component =
              fe.system_to_component_index(i).first;
            if (component == 2)
              continue;
            const double N_i = values.shape_value(i, q) * values.JxW(q);
            face.R(i) += term[component] * N_i;
            for (unsigned int j = 0; is_robin && j < face.dofs.size(); ++j)
              if (fe.system_to_component_index(j).first == component)
                face.K(i, j) += alpha * N_i * values.shape_value(j, q);
          }
      }
  }
} // namespace asperity
