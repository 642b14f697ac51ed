#include <asperity/coupling/gap_flow.h>

#include <algorithm>
#include <cmath>

// A gap that falls into pockets.
namespace asperity
{
  std::vector<double>
  GapFlow::by_column(const std::vector<double> &of_cells) const
  {
    std::vector<double> sums(mesh_.smallest_gaps().size());
    for (unsigned int cell = 0; cell < of_cells.size(); ++cell)
      sums[mesh_.column_of_cell(cell)] += of_cells[cell];
    return sums;
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
    const std::vector<double> wanted   = oil_of_parts(),
                              contents = flow_.cell_contents();
    std::vector<double> found(wanted.size());
    for (const auto &cell : flow_.space().cells())
      {
        const unsigned int index = cell->active_cell_index();
        found[flow_.space().part_of_cell(index)] += contents[index];
      }
    double oil    = pockets_->sealed_oil();
    volume_error_ = 0.;
    for (unsigned int part = 0; part < wanted.size(); ++part)
      {
        oil += wanted[part];
        volume_error_ =
          std::max(volume_error_, std::abs(wanted[part] - found[part]));
      }
    volume_error_ /= oil;
    state_.oil_volume =
      flow_.is_compressible() ? flow_.volume() + pockets_->sealed_oil() : oil;
    state_.n_pockets = pockets_->n_pockets();
    pockets_->spread(by_column(contents));
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
