#include <asperity/base/errors.h>
#include <asperity/flow/fluid_boundary.h>
#include <asperity/flow/shape_table.h>

#include <deal.II/base/qprojector.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace asperity
{
  using dealii::Tensor;

  namespace
  {
    bool
    overlap(const BoundaryIds &a, const BoundaryIds &b)
    {
      return std::any_of(a.begin(), a.end(), [&b](const auto id) {
        return b.count(id) > 0;
      });
    }
  } // namespace



  struct FluidBoundary::Shapes
  {
    using Geometry = dealii::GeometryInfo<2>;

    explicit Shapes(const FluidSpace &space)
      : quadrature(space.degree() + 2)
    {
      const auto &velocity_fe = space.dofs().get_fe().base_element(0);
      const auto &mesh_fe     = space.geometry_dofs().get_fe().base_element(0);
      const auto  cell        = velocity_fe.reference_cell();
      for (unsigned int f = 0; f < Geometry::faces_per_cell; ++f)
        {
          const auto points =
            dealii::QProjector<2>::project_to_face(cell, quadrature, f)
              .get_points();
          velocity.emplace_back(velocity_fe, points);
          geometry.emplace_back(mesh_fe, points);
          normal.push_back(Geometry::unit_normal_vector[f]);
          functions.emplace_back();
          for (unsigned int a = 0; a < velocity_fe.n_dofs_per_face(); ++a)
            functions.back().push_back(velocity_fe.face_to_cell_index(a, f));
        }
    }

    const dealii::QGauss<1> quadrature;

    // By faces
    std::vector<ShapeTable>                velocity, geometry;
    std::vector<Tensor<1, 2>>              normal;
    std::vector<std::vector<unsigned int>> functions; // those that live there
  };



  /** Work space of one face. */
  struct FluidBoundary::Face
  {
    explicit Face(const FluidSpace &space)
      : unknowns(space.dofs().get_fe())
      , mesh_unknowns(space.geometry_dofs().get_fe())
      , dofs(unknowns.dofs())
      , R(dofs.size())
      , K(dofs.size(), dofs.size())
    {}

    unsigned int                                        number;
    CellUnknowns                                        unknowns, mesh_unknowns;
    const std::vector<dealii::types::global_dof_index> &dofs;
    dealii::Vector<double>                              R;
    dealii::FullMatrix<double>                          K;
    NodalVectors                                        x; // of the mesh
    NodalVectors                                        v, wall_v, alpha;
  };



  FluidBoundary::FluidBoundary(const FluidSpace &space, const MovingMesh &mesh)
    : space(space)
    , mesh(mesh)
    , shapes(std::make_unique<Shapes>(space))
  {}



  FluidBoundary::~FluidBoundary() = default;



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
    Face face(space);
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
          reinit(face, cell, f, *condition, u);
          integrate(face, *condition, time, tangent != nullptr);
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
    Face         face(space);
    const Vector at_rest(space.dofs().n_dofs());
    for (const auto &cell : space.cells())
      for (const unsigned int f : cell->face_indices())
        {
          const Condition *condition =
            cell->at_boundary(f) ? condition_on(cell->face(f)->boundary_id()) :
                                   nullptr;
          if (condition == nullptr || condition->kind != Kind::robin)
            continue;
          reinit(face, cell, f, *condition, at_rest);
          integrate(face, *condition, 0., true);
          for (unsigned int i = 0; i < face.dofs.size(); ++i)
            face.R(i) = face.K(i, i);
          space.topology().distribute_local_to_global(face.R,
                                                      face.dofs,
                                                      diagonal);
        }
  }



  void
  FluidBoundary::reinit(Face                   &face,
                        const FluidSpace::Cell &cell,
                        const unsigned int      number,
                        const Condition        &condition,
                        const Vector           &u) const
  {
    face.number = number;
    face.unknowns.reinit(cell);
    face.mesh_unknowns.reinit(space.geometry_cell(cell));
    face.mesh_unknowns.extract(mesh.positions(), face.x);
    if (condition.kind != Kind::robin)
      return;
    face.unknowns.extract(u, face.v);
    face.unknowns.extract(condition.velocity, face.wall_v);
    face.unknowns.extract(condition.alpha, face.alpha);
  }



  void
  FluidBoundary::integrate(Face            &face,
                           const Condition &condition,
                           const double     time,
                           const bool       with_tangent) const
  {
    face.R                 = 0.;
    face.K                 = 0.;
    const ShapeTable &N    = shapes->velocity[face.number],
                     &mesh = shapes->geometry[face.number];
    const bool is_robin    = condition.kind == Kind::robin;
    for (unsigned int q = 0; q < shapes->quadrature.size(); ++q)
      {
        // n ds = cof(J) N dS
        const Tensor<1, 2> n_ds = cofactor(mesh.gradient(q, face.x)) *
                                  shapes->normal[face.number] *
                                  shapes->quadrature.weight(q);
        const double ds    = n_ds.norm();
        const double alpha = is_robin ? N.value(q, face.alpha)[0] : 0.;
        Tensor<1, 2> term; // of the weak form, times w
        if (is_robin)
          term = alpha * (N.value(q, face.v) - N.value(q, face.wall_v));
        else
          term = -condition.traction(dealii::Point<2>(mesh.value(q, face.x)),
                                     n_ds / ds,
                                     time);
        for (const unsigned int a : shapes->functions[face.number])
          for (unsigned int c = 0; c < 2; ++c)
            {
              const auto  &I    = face.unknowns.functions(c);
              const double N_ds = N.values(q)[a] * ds;
              face.R(I[a]) += term[c] * N_ds;
              if (with_tangent && is_robin)
                for (const unsigned int b : shapes->functions[face.number])
                  face.K(I[a], I[b]) += alpha * N_ds * N.values(q)[b];
            }
      }
  }
} // namespace asperity
