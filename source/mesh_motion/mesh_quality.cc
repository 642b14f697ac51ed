#include <asperity/mesh_motion/mesh_quality.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <sstream>

namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  MeshWatch::MeshWatch(const dealii::DoFHandler<2> &dofs,
                       const dealii::Mapping<2>    &reference,
                       const double                 smallest_allowed)
    : dof_handler(dofs)
    , smallest_allowed(smallest_allowed)
    , reference_positions(dofs.n_dofs())
  {
    const dealii::FiniteElement<2> &fe = dofs.get_fe();
    std::vector<Point<2>>           points(dofs.n_dofs());
    dealii::DoFTools::map_dofs_to_support_points(reference, dofs, points);
    std::vector<dealii::types::global_dof_index> local(fe.n_dofs_per_cell());
    for (const auto &cell : dofs.active_cell_iterators())
      {
        cell->get_dof_indices(local);
        for (unsigned int k = 0; k < local.size(); ++k)
          reference_positions(local[k]) =
            points[local[k]][fe.system_to_component_index(k).first];
      }

    const dealii::FiniteElement<2> &scalar = fe.base_element(0);
    node_dofs.resize(scalar.n_dofs_per_cell());
    for (unsigned int i = 0; i < node_dofs.size(); ++i)
      for (unsigned int component = 0; component < 2; ++component)
        node_dofs[i][component] = fe.component_to_system_index(component, i);

    const dealii::QGauss<2> quadrature(scalar.degree + 1);
    std::vector<Point<2>>   places = scalar.get_unit_support_points();
    places.insert(places.end(),
                  quadrature.get_points().begin(),
                  quadrature.get_points().end());
    gradients.resize(places.size());
    values.resize(places.size());
    for (unsigned int q = 0; q < places.size(); ++q)
      for (unsigned int i = 0; i < node_dofs.size(); ++i)
        {
          gradients[q].push_back(scalar.shape_grad(i, places[q]));
          values[q].push_back(scalar.shape_value(i, places[q]));
        }
  }



  MeshQuality
  MeshWatch::quality(const Vector &displacement) const
  {
    MeshQuality                                  result;
    bool                                         first = true;
    std::vector<Point<2>>                        x(node_dofs.size());
    std::vector<dealii::types::global_dof_index> local(
      dof_handler.get_fe().n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(local);
        for (unsigned int i = 0; i < x.size(); ++i)
          for (unsigned int component = 0; component < 2; ++component)
            {
              const auto dof  = local[node_dofs[i][component]];
              x[i][component] = reference_positions(dof) + displacement(dof);
            }
        for (unsigned int q = 0; q < values.size(); ++q)
          {
            Tensor<1, 2> J_1, J_2; // columns of J
            Point<2>     place;
            for (unsigned int i = 0; i < x.size(); ++i)
              {
                J_1 += gradients[q][i][0] * x[i];
                J_2 += gradients[q][i][1] * x[i];
                place += values[q][i] * x[i];
              }
            const double lengths        = J_1.norm() * J_2.norm();
            const double det_J          = J_1[0] * J_2[1] - J_1[1] * J_2[0];
            const double scaled         = lengths > 0. ? det_J / lengths : 0.;
            result.largest_aspect_ratio = std::max({result.largest_aspect_ratio,
                                                    J_1.norm() / J_2.norm(),
                                                    J_2.norm() / J_1.norm()});
            if (first || scaled < result.smallest_scaled_jacobian)
              {
                first                           = false;
                result.smallest_scaled_jacobian = scaled;
                result.worst_cell               = cell->active_cell_index();
                result.worst_place              = place;
              }
          }
      }
    return result;
  }



  ConvergenceReport
  MeshWatch::check(const Vector &displacement) const
  {
    const MeshQuality worst = quality(displacement);
    ConvergenceReport report;
    report.residual  = worst.smallest_scaled_jacobian;
    report.converged = report.residual >= smallest_allowed;
    if (!report.converged)
      {
        std::ostringstream reason;
        reason << "the mesh is too distorted: scaled Jacobian "
               << report.residual << " (at least " << smallest_allowed
               << " is allowed) in cell " << worst.worst_cell << " at ("
               << worst.worst_place << ") m";
        report.reason = reason.str();
      }
    return report;
  }
} // namespace asperity
