#include <asperity/coupling/gap_flow.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>

// A gap that falls into pockets.
namespace asperity
{
  std::vector<double>
  GapFlow::column_voids() const
  {
    const auto             &fe = flow_.space().dofs().get_fe();
    const dealii::QGauss<2> quadrature(fe.degree + 1);
    dealii::FEValues<2>     values(flow_.mapping(),
                               fe,
                               quadrature,
                               dealii::update_JxW_values);
    std::vector<double>     voids(mesh_.smallest_gaps().size());
    for (const auto &cell : flow_.space().dofs().active_cell_iterators())
      {
        values.reinit(cell);
        for (const double JxW : values.get_JxW_values())
          voids[mesh_.column_of_cell(cell->active_cell_index())] += JxW;
      }
    return voids;
  }



  void
  GapFlow::switch_columns()
  {
    pockets_->open(mesh_.smallest_gaps());
    if (pockets_->n_pockets() == 0)
      return;
    std::vector<bool> active(flow_.space().active().size());
    for (unsigned int cell = 0; cell < active.size(); ++cell)
      active[cell] = pockets_->is_open()[mesh_.column_of_cell(cell)];
    if (active != flow_.space().active())
      flow_.set_active(active);
    flow_.set_part_volumes(oil_of_parts());
  }



  std::vector<double>
  GapFlow::oil_of_parts() const
  {
    const FluidSpace         &space = flow_.space();
    const std::vector<double> oil   = pockets_->oil();
    std::vector<double>       of_parts(space.parts().size());
    for (const auto &cell : space.cells())
      {
        const unsigned int index = cell->active_cell_index();
        of_parts[space.part_of_cell(index)] =
          oil[pockets_->pocket(mesh_.column_of_cell(index))];
      }
    return of_parts;
  }



  void
  GapFlow::account_for_oil()
  {
    const std::vector<double> wanted = oil_of_parts(),
                              voids  = flow_.part_volumes();
    state_.oil_volume                = 0.;
    volume_error_                    = 0.;
    for (unsigned int part = 0; part < wanted.size(); ++part)
      {
        state_.oil_volume += wanted[part];
        volume_error_ =
          std::max(volume_error_, std::abs(wanted[part] - voids[part]));
      }
    state_.oil_volume += pockets_->sealed_oil();
    volume_error_ /= state_.oil_volume;
    state_.n_pockets = pockets_->n_pockets();
    pockets_->spread(column_voids());
  }



  const std::optional<GapPockets> &
  GapFlow::pockets() const
  {
    return pockets_;
  }



  double
  GapFlow::volume_error() const
  {
    return volume_error_;
  }
} // namespace asperity
