#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/coupling/gap_flow.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <numeric>

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



  std::vector<double>
  GapFlow::column_voids() const
  {
    std::vector<double>        voids = by_column(flow_.cell_areas());
    const std::vector<double> &lift  = mesh_.lift();
    const SplineCurve          curve = chip_curve();
    for (unsigned int k = 0; k < voids.size(); ++k)
      {
        // A quadratic lift over a quadratic edge: Simpson's rule is exact.
        double x[3];
        for (unsigned int i = 0; i < 3; ++i)
          x[i] = curve.value(mesh_.chip_nodes()[2 * k + i].parameter)[0];
        if (x[2] < x[0]) // the end of the period is its start
          x[2] += length;
        voids[k] -= (lift[2 * k] * (-3. * x[0] + 4. * x[1] - x[2]) +
                     4. * lift[2 * k + 1] * (x[2] - x[0]) +
                     lift[2 * k + 2] * (x[0] - 4. * x[1] + 3. * x[2])) /
                    6.;
        voids[k] = std::max(voids[k], 0.);
      }
    return voids;
  }



  std::vector<bool>
  GapFlow::find_wet_columns(
    const GapPockets                             &empty,
    const std::vector<std::pair<double, double>> &intervals) const
  {
    const unsigned int n = mesh_.smallest_gaps().size();
    std::vector<bool>  wet(n, intervals.empty());
    const SplineCurve  curve = chip_curve();
    std::vector<bool>  is_taken(empty.n_pockets());
    for (const auto &[from, to] : intervals)
      {
        const std::string name =
          "Lubrication/Pockets: found the interval from " +
          format_quantity(from, "um") + " to " + format_quantity(to, "um");
        unsigned int pocket = GapPockets::none;
        for (unsigned int k = 0; k < n; ++k)
          {
            const double x =
              curve.value(mesh_.chip_nodes()[2 * k + 1].parameter)[0];
            if (x < from || x > to)
              continue;
            if (empty.open_neighbour(k) != k)
              throw InputError(
                name + ", which holds a place, at " +
                format_quantity(x, "um", 4) + ", where the gap of " +
                format_quantity(mesh_.smallest_gaps()[k], "nm", 3) +
                " is below the sealing gap; expected an interval between two "
                "such places.");
            pocket = empty.pocket(k);
          }
        if (pocket == GapPockets::none)
          throw InputError(name +
                           ", which holds no column of the oil's mesh; "
                           "expected a wider one within the period of " +
                           format_quantity(length, "um") + ".");
        if (is_taken[pocket])
          throw InputError(name + ", which lies in the same pocket as another "
                                  "one; expected one interval a pocket.");
        is_taken[pocket] = true;
        for (unsigned int k = 0; k < n; ++k)
          wet[k] = wet[k] || empty.pocket(k) == pocket;
      }
    return wet;
  }



  void
  GapFlow::fill_pockets(const GapFlowOptions &options)
  {
    std::vector<double> oil = column_voids();
    GapPockets          empty(oil, options.sealing_gap);
    empty.open(mesh_.smallest_gaps(), oil);
    if (empty.n_pockets() == 0)
      throw InputError("The oil has no room to flow, since the gap is nowhere "
                       "wider than the sealing gap at the start.");
    const std::vector<bool> wet = find_wet_columns(empty, options.pockets);
    for (unsigned int k = 0; k < oil.size(); ++k)
      oil[k] *=
        wet[k] ? options.wetting * density.ratio(options.initial_pressure) : 0.;
    pockets_.emplace(oil, options.sealing_gap);
    switch_columns();
    const std::vector<double> voids = column_voids();
    state_.void_volume      = std::accumulate(voids.begin(), voids.end(), 0.);
    state_.oil_volume       = pockets_->total();
    state_.reference_volume = pockets_->total();
    state_.n_pockets        = pockets_->n_pockets();
  }



  void
  GapFlow::switch_columns()
  {
    pockets_->open(mesh_.smallest_gaps(), column_voids());
    std::vector<bool> active(flow_.space().active().size());
    for (unsigned int cell = 0; cell < active.size(); ++cell)
      active[cell] = pockets_->is_flowing()[mesh_.column_of_cell(cell)];
    if (active != flow_.space().active())
      flow_.set_active(active);
    column_pressures = find_column_pressures();
  }



  std::vector<double>
  GapFlow::find_column_pressures() const
  {
    const dealii::FEValuesExtractors::Scalar pressure_field(2);
    const auto                              &fe = flow_.space().dofs().get_fe();
    const dealii::QGauss<2>                  quadrature(fe.degree + 1);
    dealii::FEValues<2>                      values(flow_.mapping(),
                               fe,
                               quadrature,
                               dealii::update_values |
                                 dealii::update_JxW_values);
    std::vector<double>                      p(quadrature.size());
    std::vector<double> sums(mesh_.smallest_gaps().size()), area(sums);
    for (const auto &cell : flow_.space().cells())
      {
        const unsigned int column =
          mesh_.column_of_cell(cell->active_cell_index());
        values.reinit(cell);
        values[pressure_field].get_function_values(flow_.solution(), p);
        for (const unsigned int q : values.quadrature_point_indices())
          {
            sums[column] += p[q] * values.JxW(q);
            area[column] += values.JxW(q);
          }
      }
    for (unsigned int k = 0; k < sums.size(); ++k)
      if (area[k] > 0.)
        sums[k] /= area[k];
    std::vector<double> pressures(sums);
    for (unsigned int k = 0; k < sums.size(); ++k)
      if (pockets_->open_neighbour(k) != GapPockets::none)
        pressures[k] = sums[pockets_->open_neighbour(k)];
    return pressures;
  }



  std::vector<double>
  GapFlow::column_ratios() const
  {
    std::vector<double> ratios;
    for (const double p : column_pressures)
      ratios.push_back(density.ratio(p));
    return ratios;
  }



  std::vector<double>
  GapFlow::oil_of_parts() const
  {
    std::vector<double>       left  = pockets_->oil();
    const std::vector<double> voids = column_voids(), ratios = column_ratios();
    for (unsigned int k = 0; k < voids.size(); ++k)
      if (pockets_->pocket(k) != GapPockets::none && !pockets_->is_flowing()[k])
        left[pockets_->pocket(k)] -= ratios[k] * voids[k];
    const FluidSpace   &space = flow_.space();
    std::vector<double> of_parts(space.parts().size());
    for (const auto &cell : space.cells())
      {
        const unsigned int index = cell->active_cell_index();
        of_parts[space.part_of_cell(index)] =
          left[pockets_->pocket(mesh_.column_of_cell(index))];
      }
    return of_parts;
  }



  std::string
  GapFlow::overfilled() const
  {
    bool all_full = true;
    for (unsigned int k = 0; k < pockets_->n_pockets(); ++k)
      all_full = all_full && pockets_->is_full(k);
    if (all_full)
      return "";
    const std::vector<double> oil = pockets_->oil(), voids = column_voids();
    std::vector<double>       room(oil.size());
    for (unsigned int k = 0; k < voids.size(); ++k)
      if (pockets_->pocket(k) != GapPockets::none)
        room[pockets_->pocket(k)] += voids[k];
    for (unsigned int k = 0; k < oil.size(); ++k)
      if (!pockets_->is_full(k) && oil[k] > (1. + GapPockets::slack) * room[k])
        return "a pocket of oil fills within the step";
    return "";
  }



  GapFlow::Vector
  GapFlow::seal_forces() const
  {
    const dealii::FEValuesExtractors::Vector velocity_field(0);
    const auto                              &fe = flow_.space().dofs().get_fe();
    const dealii::QGauss<1>                  quadrature(fe.degree + 1);
    dealii::FEFaceValues<2>                  face(flow_.mapping(),
                                 fe,
                                 quadrature,
                                 dealii::update_values |
                                   dealii::update_JxW_values |
                                   dealii::update_normal_vectors);
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    Vector forces(flow_.space().dofs().n_dofs()), local(dofs.size());
    for (const auto &cell : flow_.space().dofs().active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        {
          const unsigned int column =
            mesh_.column_of_cell(cell->active_cell_index());
          if (!cell->at_boundary(f) || pockets_->is_flowing()[column] ||
              cell->face(f)->boundary_id() != ColumnMesh::chip_wall)
            continue;
          face.reinit(cell, f);
          local = 0.;
          for (const unsigned int q : face.quadrature_point_indices())
            for (unsigned int i = 0; i < dofs.size(); ++i)
              // n points out of the oil, into the chip.
              local(i) +=
                column_pressures[column] *
                (face[velocity_field].value(i, q) * face.normal_vector(q)) *
                face.JxW(q);
          cell->get_dof_indices(dofs);
          flow_.space().topology().distribute_local_to_global(local,
                                                              dofs,
                                                              forces);
        }
    return forces;
  }



  void
  GapFlow::account_for_oil()
  {
    const std::vector<double> wanted   = oil_of_parts(),
                              contents = flow_.cell_contents(),
                              voids = column_voids(), ratios = column_ratios();
    std::vector<double> found(wanted.size());
    for (const auto &cell : flow_.space().cells())
      {
        const unsigned int index = cell->active_cell_index();
        found[flow_.space().part_of_cell(index)] += contents[index];
      }
    volume_error_ = 0.;
    for (unsigned int part = 0; part < wanted.size(); ++part)
      volume_error_ =
        std::max(volume_error_,
                 std::abs(wanted[part] - found[part]) / pockets_->total());
    std::vector<double> shares = by_column(contents);
    for (unsigned int k = 0; k < shares.size(); ++k)
      if (!pockets_->is_flowing()[k])
        shares[k] = ratios[k] * voids[k];
    pockets_->spread(shares);
    state_.void_volume = std::accumulate(voids.begin(), voids.end(), 0.);
    const std::vector<double> amounts = pockets_->amounts();
    state_.oil_volume                 = 0.;
    std::vector<double> oil(pockets_->n_pockets()), room(oil.size());
    for (unsigned int k = 0; k < amounts.size(); ++k)
      {
        state_.oil_volume += amounts[k] / ratios[k];
        if (pockets_->pocket(k) == GapPockets::none)
          continue;
        oil[pockets_->pocket(k)] += amounts[k] / ratios[k];
        room[pockets_->pocket(k)] += voids[k];
      }
    state_.n_pockets = pockets_->n_pockets();
    pocket_coverage.resize(oil.size());
    for (unsigned int i = 0; i < oil.size(); ++i)
      pocket_coverage[i] =
        pockets_->is_full(i) || oil[i] >= room[i] ? 1. : oil[i] / room[i];
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
