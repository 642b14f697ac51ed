#include <asperity/flow/moving_mesh.h>
#include <asperity/flow/shape_table.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/numerics/vector_tools.h>

#include <array>

namespace asperity
{
  using dealii::Tensor;

  namespace
  {
    const dealii::FEValuesExtractors::Vector displacement_field(0);
    const dealii::FEValuesExtractors::Scalar pressure_field(2);
  } // namespace



  struct MovingMesh::Shapes
  {
    explicit Shapes(const FluidSpace &space)
      : mesh(space.geometry_dofs().get_fe())
      , area(mesh.degree + 1)
      , geometry(mesh.base_element(0), area.get_points())
      , content(space.dofs().get_fe().degree + mesh.degree)
      , content_geometry(mesh.base_element(0), content.get_points())
      , pressure(space.dofs().get_fe().base_element(1), content.get_points())
    {}

    const dealii::FiniteElement<2> &mesh;
    const dealii::QGauss<2>         area;
    const ShapeTable                geometry;
    const dealii::QGauss<2>         content;
    const ShapeTable                content_geometry, pressure;
  };



  MovingMesh::MovingMesh(const FluidSpace &space)
    : space_(space)
    , shapes(std::make_unique<Shapes>(space))
    , mapping_(space.geometry_dofs().get_fe().degree)
    , reference(space.geometry_dofs().n_dofs())
    , now(reference.size())
    , old(now)
    , older(now)
  {
    dealii::VectorTools::get_position_vector(space.reference_mapping(),
                                             space.geometry_dofs(),
                                             reference);
    set_displacement(now);
  }



  MovingMesh::~MovingMesh() = default;



  bool
  MovingMesh::set_displacement(const Vector &d)
  {
    if (x.size() > 0 && d == now)
      return valid;
    now = d;
    x   = reference;
    x += now;
    valid = !has_inverted_cell();
    if (valid)
      mapping_.initialize(space_.reference_mapping(),
                          space_.geometry_dofs(),
                          now,
                          true);
    return valid;
  }



  bool
  MovingMesh::has_inverted_cell() const
  {
    CellUnknowns unknowns(shapes->mesh);
    NodalVectors nodes;
    for (const auto &cell : space_.geometry_dofs().active_cell_iterators())
      {
        unknowns.reinit(cell);
        unknowns.extract(x, nodes);
        for (unsigned int q = 0; q < shapes->area.size(); ++q)
          if (!(determinant(shapes->geometry.gradient(q, nodes)) > 0.))
            return true;
      }
    return false;
  }



  std::vector<double>
  MovingMesh::cell_areas() const
  {
    CellUnknowns        unknowns(shapes->mesh);
    NodalVectors        nodes;
    std::vector<double> areas;
    for (const auto &cell : space_.geometry_dofs().active_cell_iterators())
      {
        unknowns.reinit(cell);
        unknowns.extract(x, nodes);
        areas.push_back(0.);
        for (unsigned int q = 0; q < shapes->area.size(); ++q)
          areas.back() += determinant(shapes->geometry.gradient(q, nodes)) *
                          shapes->area.weight(q);
      }
    return areas;
  }



  void
  MovingMesh::add_swept_volume_defect(const BoundaryIds &walls, Vector &R) const
  {
    const auto             &fe          = space_.dofs().get_fe();
    const auto             &geometry_fe = space_.geometry_dofs().get_fe();
    const dealii::QGauss<1> quadrature(fe.degree + geometry_fe.degree);
    dealii::FEFaceValues<2> pressure(space_.reference_mapping(),
                                     fe,
                                     quadrature,
                                     dealii::update_values);
    dealii::FEFaceValues<2> geometry(space_.reference_mapping(),
                                     geometry_fe,
                                     quadrature,
                                     dealii::update_values |
                                       dealii::update_gradients |
                                       dealii::update_normal_vectors |
                                       dealii::update_JxW_values);
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    Vector                                       local(dofs.size());
    for (const auto &cell : space_.cells())
      for (const unsigned int f : cell->face_indices())
        {
          if (!cell->at_boundary(f) ||
              walls.count(cell->face(f)->boundary_id()) == 0)
            continue;
          pressure.reinit(cell, f);
          geometry.reinit(space_.geometry_cell(cell), f);
          const std::vector<double> defect = flux_defect(geometry);
          local                            = 0.;
          for (const unsigned int q : pressure.quadrature_point_indices())
            for (unsigned int i = 0; i < dofs.size(); ++i)
              local(i) += defect[q] * pressure[pressure_field].value(i, q);
          cell->get_dof_indices(dofs);
          space_.topology().distribute_local_to_global(local, dofs, R);
        }
  }



  std::vector<double>
  MovingMesh::flux_defect(const dealii::FEFaceValues<2> &face) const
  {
    const unsigned int                       n = face.n_quadrature_points;
    const std::array<const Vector *, 3>      d = {{&now, &old, &older}};
    std::array<std::vector<Tensor<1, 2>>, 3> value;
    std::array<std::vector<Tensor<2, 2>>, 3> gradient;
    for (unsigned int k = 0; k < 3; ++k)
      {
        value[k].resize(n);
        gradient[k].resize(n);
        face[displacement_field].get_function_values(*d[k], value[k]);
        face[displacement_field].get_function_gradients(*d[k], gradient[k]);
      }
    std::vector<double> defect(n);
    for (unsigned int q = 0; q < n; ++q)
      {
        const auto flux = [&](const Tensor<1, 2> &v, const Tensor<2, 2> &grad) {
          const Tensor<2, 2> F =
            grad + Tensor<2, 2>(dealii::unit_symmetric_tensor<2>());
          // n ds = cof(F) N dS
          return v * (cofactor(F) * face.normal_vector(q)) * face.JxW(q);
        };
        const Tensor<1, 2> v_1 = rate_.now * (value[0][q] - value[1][q]);
        const Tensor<1, 2> v_2 = rate_.older * (value[1][q] - value[2][q]);
        defect[q]              = flux(v_1 - v_2, gradient[0][q]) -
                    flux(v_1, 0.5 * (gradient[0][q] + gradient[1][q])) +
                    flux(v_2, 0.5 * (gradient[1][q] + gradient[2][q]));
      }
    return defect;
  }



  void
  MovingMesh::add_content_history(const Vector              &r_old,
                                  const Vector              &r_older,
                                  const std::vector<double> &mean_ratio,
                                  Vector                    &R) const
  {
    const ShapeTable     &geometry = shapes->content_geometry;
    const Vector          w        = velocity();
    std::array<Vector, 3> positions; // now and before
    positions.fill(reference);
    positions[0] += now;
    positions[1] += old;
    positions[2] += older;
    CellUnknowns unknowns(space_.dofs().get_fe()), mesh_unknowns(shapes->mesh);
    std::array<NodalVectors, 3> nodes;
    NodalVectors                nodal_w;
    std::vector<double>         ratio_old, ratio_older;
    Vector                      local(unknowns.dofs().size());
    for (const auto &cell : space_.cells())
      {
        const double mean =
          mean_ratio[space_.part_of_cell(cell->active_cell_index())];
        unknowns.reinit(cell);
        mesh_unknowns.reinit(space_.geometry_cell(cell));
        unknowns.extract(r_old, 2, ratio_old);
        unknowns.extract(r_older, 2, ratio_older);
        for (unsigned int time = 0; time < 3; ++time)
          mesh_unknowns.extract(positions[time], nodes[time]);
        mesh_unknowns.extract(w, nodal_w);
        local = 0.;
        for (unsigned int q = 0; q < shapes->content.size(); ++q)
          {
            // J of the maps from the reference cell
            std::array<Tensor<2, 2>, 3> J;
            for (unsigned int time = 0; time < 3; ++time)
              J[time] = geometry.gradient(q, nodes[time]);
            // div w in the present cell, times its area
            const double dilation =
              scalar_product(cofactor(J[0]), geometry.gradient(q, nodal_w));
            const double content =
              rate_.old * determinant(J[1]) *
                (shapes->pressure.value(q, ratio_old) - mean) +
              rate_.older * determinant(J[2]) *
                (shapes->pressure.value(q, ratio_older) - mean) -
              mean * (rate_.now * determinant(J[0]) - dilation);
            for (unsigned int k = 0; k < ratio_old.size(); ++k)
              local(unknowns.functions(2)[k]) += content *
                                                 shapes->pressure.values(q)[k] *
                                                 shapes->content.weight(q);
          }
        space_.topology().distribute_local_to_global(local, unknowns.dofs(), R);
      }
  }



  bool
  MovingMesh::is_valid() const
  {
    return valid;
  }



  void
  MovingMesh::set_rate(const BackwardDifference &rate)
  {
    rate_ = rate;
  }



  const BackwardDifference &
  MovingMesh::rate() const
  {
    return rate_;
  }



  void
  MovingMesh::accept()
  {
    older = old;
    old   = now;
  }



  void
  MovingMesh::set_history(const Vector &new_old, const Vector &new_older)
  {
    old   = new_old;
    older = new_older;
  }



  const MovingMesh::Vector &
  MovingMesh::displacement() const
  {
    return now;
  }



  const MovingMesh::Vector &
  MovingMesh::old_displacement() const
  {
    return old;
  }



  const MovingMesh::Vector &
  MovingMesh::older_displacement() const
  {
    return older;
  }



  const MovingMesh::Vector &
  MovingMesh::positions() const
  {
    return x;
  }



  MovingMesh::Vector
  MovingMesh::velocity() const
  {
    Vector w(now);
    w.sadd(rate_.now, rate_.old, old);
    w.add(rate_.older, older);
    return w;
  }



  const dealii::Mapping<2> &
  MovingMesh::mapping() const
  {
    return mapping_;
  }



  const FluidSpace &
  MovingMesh::space() const
  {
    return space_;
  }
} // namespace asperity
