#include <asperity/base/text.h>
#include <asperity/flow/pressure_level.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace asperity
{
  namespace
  {
    const dealii::FEValuesExtractors::Vector velocity_field(0);
  }



  PressureLevel::PressureLevel(const FluidSpace    &space,
                               const MovingMesh    &mesh,
                               const FluidBoundary &boundary)
    : space(space)
    , mesh(mesh)
    , boundary(boundary)
    , is_enclosed(space.parts().size(), true)
  {}



  void
  PressureLevel::update(const bool is_compressible)
  {
    is_enclosed.assign(space.parts().size(), !is_compressible);
    for (const auto &cell : space.cells())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() &&
            space.periodic_ids().count(face->boundary_id()) == 0 &&
            !boundary.prescribes_velocity(face->boundary_id()))
          is_enclosed[space.part_of_cell(cell->active_cell_index())] = false;
  }



  bool
  PressureLevel::is_undetermined() const
  {
    return std::find(is_enclosed.begin(), is_enclosed.end(), true) !=
           is_enclosed.end();
  }



  std::vector<unsigned int>
  PressureLevel::held_dofs() const
  {
    std::vector<unsigned int> held;
    for (unsigned int part = 0; part < is_enclosed.size(); ++part)
      if (is_enclosed[part])
        held.push_back(*std::find_if(space.parts()[part].begin(),
                                     space.parts()[part].end(),
                                     [this](const unsigned int i) {
                                       return !space.topology().is_constrained(
                                         i);
                                     }));
    return held;
  }



  std::string
  PressureLevel::balance(const Vector &u,
                         Vector       &source,
                         const double  tolerance) const
  {
    if (!is_undetermined())
      return "";
    const std::vector<double> net   = integrate_divergence(space.dofs(), u),
                              gross = integrate_speed(u);
    const Vector weight             = weights();
    for (unsigned int part = 0; part < is_enclosed.size(); ++part)
      if (is_enclosed[part])
        {
          double excess = net[part], area = 0.;
          for (const unsigned int i : space.parts()[part])
            {
              excess -= source(i);
              area += weight(i);
            }
          if (!(std::abs(excess) <= tolerance * gross[part]))
            {
              std::ostringstream text;
              text << "the prescribed velocities of an enclosed part of the "
                      "fluid would change its volume by "
                   << -excess
                   << " m^2/s, which an incompressible fluid cannot do";
              return text.str();
            }
          for (const unsigned int i : space.parts()[part])
            source(i) += excess * weight(i) / area;
        }
    return "";
  }



  std::vector<double>
  PressureLevel::integrate_divergence(const dealii::DoFHandler<2> &dofs,
                                      const Vector                &field) const
  {
    // By the divergence theorem; inner walls need no care that way.
    const unsigned int      degree = space.degree();
    const dealii::QGauss<2> quadrature(2 * degree + 1);
    dealii::FEValues<2>     values(mesh.mapping(),
                               dofs.get_fe(),
                               quadrature,
                               dealii::update_gradients |
                                 dealii::update_JxW_values);
    std::vector<double>     divergence(quadrature.size());
    std::vector<double>     net(space.parts().size());
    for (const auto &cell : space.cells())
      {
        values.reinit(FluidSpace::Cell(
          &cell->get_triangulation(), cell->level(), cell->index(), &dofs));
        values[velocity_field].get_function_divergences(field, divergence);
        double &sum = net[space.part_of_cell(cell->active_cell_index())];
        for (const unsigned int q : values.quadrature_point_indices())
          sum += divergence[q] * values.JxW(q);
      }
    return net;
  }



  std::vector<double>
  PressureLevel::integrate_speed(const Vector &u) const
  {
    const dealii::QGauss<1>           quadrature(2 * space.degree() + 1);
    dealii::FEFaceValues<2>           face(mesh.mapping(),
                                 space.dofs().get_fe(),
                                 quadrature,
                                 dealii::update_values |
                                   dealii::update_JxW_values);
    std::vector<dealii::Tensor<1, 2>> v(quadrature.size());
    std::vector<double>               gross(space.parts().size());
    for (const auto &cell : space.cells())
      for (const unsigned int f : cell->face_indices())
        {
          if (!cell->at_boundary(f))
            continue;
          face.reinit(cell, f);
          face[velocity_field].get_function_values(u, v);
          for (const unsigned int q : face.quadrature_point_indices())
            gross[space.part_of_cell(cell->active_cell_index())] +=
              v[q].norm() * face.JxW(q);
        }
    return gross;
  }



  std::vector<double>
  PressureLevel::volumes() const
  {
    const std::vector<double> areas = mesh.cell_areas();
    std::vector<double>       volume(space.parts().size());
    for (const auto &cell : space.cells())
      {
        const unsigned int index = cell->active_cell_index();
        volume[space.part_of_cell(index)] += areas[index];
      }
    return volume;
  }



  void
  PressureLevel::impose_volumes(const std::vector<double> &wanted,
                                Vector                    &source) const
  {
    if (wanted.empty())
      return;
    const std::vector<double> present = volumes();
    std::vector<double>       sums =
      integrate_divergence(space.geometry_dofs(), mesh.velocity());
    for (unsigned int part = 0; part < wanted.size(); ++part)
      sums[part] += mesh.rate().now * (wanted[part] - present[part]);
    impose_sums(sums, source);
  }



  void
  PressureLevel::impose_contents(const std::vector<double> &wanted,
                                 const Vector              &u,
                                 const Vector              &ratio,
                                 Vector                    &source) const
  {
    if (wanted.empty())
      return;
    std::vector<double> sums = integrate_slip(u, ratio);
    for (unsigned int part = 0; part < wanted.size(); ++part)
      sums[part] += mesh.rate().now * wanted[part];
    impose_sums(sums, source);
  }



  std::vector<double>
  PressureLevel::integrate_slip(const Vector &u, const Vector &ratio) const
  {
    const dealii::FEValuesExtractors::Scalar pressure_field(2);
    const dealii::QGauss<1>                  quadrature(2 * space.degree() + 1);
    dealii::FEFaceValues<2>                  face(mesh.mapping(),
                                 space.dofs().get_fe(),
                                 quadrature,
                                 dealii::update_values |
                                   dealii::update_normal_vectors |
                                   dealii::update_JxW_values);
    dealii::FEFaceValues<2>                  geometry(mesh.mapping(),
                                     space.geometry_dofs().get_fe(),
                                     quadrature,
                                     dealii::update_values);
    const Vector                             w_field = mesh.velocity();
    std::vector<dealii::Tensor<1, 2>>        v(quadrature.size()), w(v);
    std::vector<double>                      r(quadrature.size());
    std::vector<double>                      slip(space.parts().size());
    for (const auto &cell : space.cells())
      for (const unsigned int f : cell->face_indices())
        {
          if (!cell->at_boundary(f) ||
              !boundary.prescribes_velocity(cell->face(f)->boundary_id()))
            continue;
          face.reinit(cell, f);
          geometry.reinit(space.geometry_cell(cell), f);
          face[velocity_field].get_function_values(u, v);
          geometry[velocity_field].get_function_values(w_field, w);
          face[pressure_field].get_function_values(ratio, r);
          for (const unsigned int q : face.quadrature_point_indices())
            slip[space.part_of_cell(cell->active_cell_index())] +=
              r[q] * ((v[q] - w[q]) * face.normal_vector(q)) * face.JxW(q);
        }
    return slip;
  }



  void
  PressureLevel::impose_sums(const std::vector<double> &sums,
                             Vector                    &source) const
  {
    const Vector weight = weights();
    for (unsigned int part = 0; part < sums.size(); ++part)
      {
        double missing = sums[part], area = 0.;
        for (const unsigned int i : space.parts()[part])
          {
            missing -= source(i);
            area += weight(i);
          }
        for (const unsigned int i : space.parts()[part])
          source(i) += missing * weight(i) / area;
      }
  }



  void
  PressureLevel::fix_mean(Vector &u, const double mean) const
  {
    if (!is_undetermined())
      return;
    const Vector weight = weights();
    for (unsigned int part = 0; part < is_enclosed.size(); ++part)
      if (is_enclosed[part])
        {
          double integral = 0., area = 0.;
          for (const unsigned int i : space.parts()[part])
            {
              integral += weight(i) * u(i);
              area += weight(i);
            }
          for (const unsigned int i : space.parts()[part])
            u(i) += mean - integral / area;
        }
  }



  PressureLevel::Vector
  PressureLevel::weights() const
  {
    const auto                                  &fe = space.dofs().get_fe();
    const dealii::QGauss<2>                      quadrature(fe.degree + 1);
    dealii::FEValues<2>                          values(mesh.mapping(),
                               fe,
                               quadrature,
                               dealii::update_values |
                                 dealii::update_JxW_values);
    Vector                                       weight(space.dofs().n_dofs());
    dealii::Vector<double>                       local(fe.n_dofs_per_cell());
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : space.cells())
      {
        values.reinit(cell);
        local = 0.;
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (fe.system_to_component_index(i).first == 2)
            for (const unsigned int q : values.quadrature_point_indices())
              local(i) += values.shape_value(i, q) * values.JxW(q);
        cell->get_dof_indices(dofs);
        space.topology().distribute_local_to_global(local, dofs, weight);
      }
    return weight;
  }
} // namespace asperity
