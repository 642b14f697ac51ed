#include <asperity/flow/moving_mesh.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <array>

namespace asperity
{
  using dealii::Tensor;

  namespace
  {
    /** Cofactor of I + grad d: n ds = cof(F) N dS. */
    Tensor<2, 2>
    cofactor(const Tensor<2, 2> &grad_d)
    {
      Tensor<2, 2> cof;
      cof[0][0] = 1. + grad_d[1][1];
      cof[0][1] = -grad_d[1][0];
      cof[1][0] = -grad_d[0][1];
      cof[1][1] = 1. + grad_d[0][0];
      return cof;
    }

    const dealii::FEValuesExtractors::Vector displacement_field(0);
    const dealii::FEValuesExtractors::Scalar pressure_field(2);
  } // namespace



  MovingMesh::MovingMesh(const FluidSpace &space)
    : space_(space)
    , mapping_(space.geometry_dofs().get_fe().degree)
    , now(space.geometry_dofs().n_dofs())
    , old(now)
    , older(now)
  {
    set_displacement(now);
  }



  bool
  MovingMesh::set_displacement(const Vector &d)
  {
    now   = d;
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
    const auto               &fe = space_.geometry_dofs().get_fe();
    const dealii::QGauss<2>   quadrature(fe.degree + 1);
    dealii::FEValues<2>       values(space_.reference_mapping(),
                               fe,
                               quadrature,
                               dealii::update_gradients);
    std::vector<Tensor<2, 2>> grad_d(quadrature.size());
    for (const auto &cell : space_.geometry_dofs().active_cell_iterators())
      {
        values.reinit(cell);
        values[displacement_field].get_function_gradients(now, grad_d);
        for (Tensor<2, 2> F : grad_d)
          {
            F[0][0] += 1.;
            F[1][1] += 1.;
            if (!(determinant(F) > 0.))
              return true;
          }
      }
    return false;
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
          return v * (cofactor(grad) * face.normal_vector(q)) * face.JxW(q);
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
    const auto             &fe          = space_.dofs().get_fe();
    const auto             &geometry_fe = space_.geometry_dofs().get_fe();
    const dealii::QGauss<2> quadrature(fe.degree + geometry_fe.degree);
    dealii::FEValues<2>     pressure(space_.reference_mapping(),
                                 fe,
                                 quadrature,
                                 dealii::update_values);
    dealii::FEValues<2>     geometry(space_.reference_mapping(),
                                 geometry_fe,
                                 quadrature,
                                 dealii::update_gradients |
                                   dealii::update_JxW_values);
    const Vector            w = velocity();
    std::vector<double> ratio_old(quadrature.size()), ratio_older(ratio_old);
    std::array<std::vector<Tensor<2, 2>>, 4> grad;
    grad.fill(std::vector<Tensor<2, 2>>(quadrature.size()));
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    Vector                                       local(dofs.size());
    for (const auto &cell : space_.cells())
      {
        const double mean =
          mean_ratio[space_.part_of_cell(cell->active_cell_index())];
        pressure.reinit(cell);
        geometry.reinit(space_.geometry_cell(cell));
        pressure[pressure_field].get_function_values(r_old, ratio_old);
        pressure[pressure_field].get_function_values(r_older, ratio_older);
        unsigned int k = 0;
        for (const Vector *field : {&now, &old, &older, &w})
          geometry[displacement_field].get_function_gradients(*field,
                                                              grad[k++]);
        local = 0.;
        for (const unsigned int q : pressure.quadrature_point_indices())
          {
            const auto area = [&](const unsigned int time) {
              return determinant(
                grad[time][q] +
                Tensor<2, 2>(dealii::unit_symmetric_tensor<2>()));
            };
            // div w in the present cell, times its area
            const double dilation =
              scalar_product(cofactor(grad[0][q]), grad[3][q]);
            const double content =
              rate_.old * area(1) * (ratio_old[q] - mean) +
              rate_.older * area(2) * (ratio_older[q] - mean) -
              mean * (rate_.now * area(0) - dilation);
            for (unsigned int i = 0; i < dofs.size(); ++i)
              local(i) += content * pressure[pressure_field].value(i, q) *
                          geometry.JxW(q);
          }
        cell->get_dof_indices(dofs);
        space_.topology().distribute_local_to_global(local, dofs, R);
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
