#include <asperity/base/archive.h>
#include <asperity/coupling/gap_flow.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/numerics/data_out.h>

#include <algorithm>

// What the oil does to the chip, and its state.
namespace asperity
{
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;

  void
  GapFlow::accept(const Vector &)
  {
    const auto [flow_force, max_pressure] = integrate_pressure();
    state_.pressure_force                 = flow_force;
    state_.shear_force                    = Tensor<1, 2>();
    if (!flow_.space().cells().empty())
      state_.shear_force =
        flow_.total_wall_force({ColumnMesh::chip_wall}) - flow_force;
    state_.void_volume = flow_.volume();
    state_.oil_volume  = state_.void_volume;
    if (pockets_)
      {
        for (const Tensor<1, 2> &f : flow_.boundary()
                                       .nodes({ColumnMesh::chip_wall})
                                       .extract(seal_forces()))
          state_.pressure_force += f;
        account_for_oil();
      }
    account_for_ends();
    state_.mean_pressure       = (0. - state_.pressure_force[1]) / length;
    state_.max_pressure        = max_pressure;
    state_.smallest_film       = mesh_.film().smallest_gap;
    state_.coupling_iterations = n_solutions;
  }



  void
  GapFlow::account_for_ends()
  {
    if (flow_.passed_volumes().empty())
      return;
    state_.oil_in  = 0.;
    state_.oil_out = 0.;
    for (const PassedVolume &volume : flow_.passed_volumes())
      {
        state_.oil_in += volume.in;
        state_.oil_out += volume.out;
      }
    state_.reference_volume = initial_content + state_.oil_in - state_.oil_out;
  }



  std::pair<Tensor<1, 2>, double>
  GapFlow::integrate_pressure() const
  {
    const auto                              &fe = flow_.space().dofs().get_fe();
    const dealii::FEValuesExtractors::Scalar pressure_field(2);
    const dealii::QGauss<1>                  quadrature(fe.degree + 1);
    dealii::FEFaceValues<2>                  face(flow_.mapping(),
                                 fe,
                                 quadrature,
                                 dealii::update_values |
                                   dealii::update_JxW_values |
                                   dealii::update_normal_vectors);
    std::vector<double>                      p(quadrature.size());
    Tensor<1, 2>                             force;
    double                                   largest = 0.;
    for (const auto &cell : flow_.space().cells())
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f) &&
            cell->face(f)->boundary_id() == ColumnMesh::chip_wall)
          {
            face.reinit(cell, f);
            face[pressure_field].get_function_values(flow_.solution(), p);
            for (unsigned int q = 0; q < p.size(); ++q)
              {
                // n points out of the fluid, into the chip.
                force += p[q] * face.JxW(q) * face.normal_vector(q);
                largest = std::max(largest, p[q]);
              }
          }
    return {force, largest};
  }



  LubricantState
  GapFlow::state() const
  {
    return state_;
  }



  unsigned int
  GapFlow::column_at(const double parameter) const
  {
    // Columns lie between the vertices of the wall.
    const auto above = std::find_if(wall_pressures.begin() + 1,
                                    wall_pressures.end() - 1,
                                    [parameter](const auto &node) {
                                      return node.first > parameter;
                                    });
    return above - 1 - wall_pressures.begin();
  }



  double
  GapFlow::coverage(const dealii::Point<2> &parameter) const
  {
    if (!pockets_)
      return 1.;
    const unsigned int pocket = pockets_->pocket(column_at(parameter[0]));
    return pocket < pocket_coverage.size() ? pocket_coverage[pocket] : 0.;
  }



  double
  GapFlow::pressure(const dealii::Point<2> &parameter) const
  {
    const unsigned int column = column_at(parameter[0]);
    const auto         below  = wall_pressures.begin() + column;
    const auto         above  = below + 1;
    if (pockets_ && !pockets_->is_flowing()[column])
      return column_pressures[column];
    const double weight =
      (parameter[0] - below->first) / (above->first - below->first);
    const Vector &u = flow_.solution();
    return (1. - weight) * u(below->second) + weight * u(above->second);
  }



  void
  GapFlow::save(OutputArchive &archive) const
  {
    flow_.state().save(archive);
    archive << force << chip;
    if (pockets_)
      pockets_->save(archive);
  }



  void
  GapFlow::load(InputArchive &archive)
  {
    FluidState flow = flow_.state();
    flow.load(archive);
    archive >> fixed_length(force, "forces of the oil") >>
      fixed_length(chip, "displacements under the oil");
    flow_.set_state(flow);
    load_.set_force(force);
    mesh_.update(chip_curve(), {});
    if (pockets_)
      pockets_->load(archive);
  }



  const NavierStokes &
  GapFlow::flow() const
  {
    return flow_;
  }



  const ColumnMesh &
  GapFlow::mesh() const
  {
    return mesh_;
  }



  double
  GapFlow::seconds() const
  {
    return seconds_;
  }



  void
  GapFlow::write(std::ostream      &out,
                 const double       time,
                 const unsigned int step) const
  {
    dealii::DataOut<2> output;
    flow_.attach_to(output);
    const std::vector<bool> &active = flow_.space().active();
    Vector                   pocket(active.size());
    for (unsigned int i = 0; i < active.size(); ++i)
      if (pockets_ && active[i])
        pocket(i) = pockets_->pocket(mesh_.column_of_cell(i));
    output.add_data_vector(pocket, "pocket");
    output.set_cell_selection([&active](const auto &cell) {
      return cell->is_active() && active[cell->active_cell_index()];
    });
    output.build_patches(flow_.mapping(),
                         2,
                         dealii::DataOut<2>::curved_inner_cells);
    output.set_flags(dealii::DataOutBase::VtkFlags(time, step));
    output.write_vtu(out);
  }
} // namespace asperity
