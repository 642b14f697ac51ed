#include <asperity/base/archive.h>
#include <asperity/contact/shear_transfer.h>
#include <asperity/contact_zone/scene_heat.h>
#include <asperity/contact_zone/sliding_run.h>
#include <asperity/isogeometric/element_view.h>
#include <asperity/isogeometric/space_transfer.h>
#include <asperity/isogeometric/trace_transfer.h>
#include <asperity/solid/state_transfer.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  namespace
  {
    template <int dim>
    Vector
    moved(const SpaceTransfer<dim> &transfer, const Vector &u)
    {
      const std::vector<double> coefficients =
        transfer.apply(std::vector<double>(u.begin(), u.end()), dim);
      return Vector(coefficients.begin(), coefficients.end());
    }

    template <int dim>
    std::vector<dealii::Point<dim>>
    positions(const BasisTable<dim> &edge, const Vector &u)
    {
      std::vector<dealii::Point<dim>> x = edge.position;
      for (const auto &entry : edge.elements)
        {
          const ElementView<dim> element(edge, entry);
          for (unsigned int q = 0; q < edge.points_per_element; ++q)
            element.add_displacement(q, u, x[element.point(q)]);
        }
      return x;
    }

    /** Where closest points may lie: above those of the edge. */
    template <int dim>
    std::vector<dealii::Point<dim - 1>>
    hints(const BasisTable<dim> &edge, const Vector &u)
    {
      std::vector<dealii::Point<dim - 1>> x;
      for (const dealii::Point<dim> &point : positions(edge, u))
        {
          x.emplace_back();
          for (unsigned int k = 0; k < dim - 1; ++k)
            x.back()[k] = point[k];
        }
      return x;
    }

    /** By how much a value of some states leaves the range of others. */
    double
    excess(double MaterialState::*const      value,
           const std::vector<MaterialState> &states,
           const std::vector<MaterialState> &range)
    {
      const auto less = [value](const MaterialState &a,
                                const MaterialState &b) {
        return a.*value < b.*value;
      };
      const auto [a, b] =
        std::minmax_element(states.begin(), states.end(), less);
      const auto [low, high] =
        std::minmax_element(range.begin(), range.end(), less);
      return std::max({0., *b.*value - *high.*value, *low.*value - *a.*value});
    }
  } // namespace



  template <int dim>
  typename SlidingRun<dim>::StepStart
  SlidingRun<dim>::step_start() const
  {
    StepStart start;
    start.u_previous  = state_.u_previous;
    start.dt_previous = state_.dt_previous;
    start.time        = state_.time;
    start.history     = scene.chip->history();
    start.coverage    = state_.coverage;
    if (const ShearTraction<dim> *shear = scene.contact->shear())
      start.shear = shear->history();
    if (scene.lubricant)
      start.oil = to_bytes(
        [&](OutputArchive &archive) { scene.lubricant->save(archive); });
    if (scene.heat)
      start.heat =
        to_bytes([&](OutputArchive &archive) { scene.heat->save(archive); });
    return start;
  }



  template <int dim>
  double
  SlidingRun<dim>::present_friction() const
  {
    const LineLoad force = per_width(scene.contact->state().force);
    return friction_coefficient(force.along,
                                force.up,
                                protocol_.direction(state_.time));
  }



  template <int dim>
  void
  SlidingRun<dim>::adapt_mesh(const StepStart &start)
  {
    const double time = state_.time, dt = state_.dt_previous;
    const double mu = present_friction(), gap = scene.contact->state().mean_gap;
    // The first step closes the initial gap.
    const double approach =
      state_.step > 1 ? (state_.rows.back().mean_gap - gap) / dt : 0.;
    if (!adaptation->is_needed(time, approach))
      return;
    const auto   before = scene.space->hierarchy();
    const double work =
      plastic_work(*scene.chip, start.history, parameters.load);
    const auto        F = scene.chip->deformation(state_.u_previous);
    const AdaptedMesh mesh =
      scene.adapt_mesh(parameters, adaptation->wanted(time, approach));
    adaptation->set_taken(mesh.number);
    RemeshReport &report = state_.remeshing;
    report.taken         = mesh.number;
    report.missing_levels =
      std::max(report.missing_levels, adaptation->missing_levels(mesh.number));
    if (!mesh.has_changed)
      return;
    go_back(start, *before, F);

    ++report.remeshes;
    if (mesh.number > 0)
      ++report.bounded;
    report.plastic_work = work;
    report.work_change +=
      plastic_work(*scene.chip, scene.chip->history(), parameters.load) - work;
    const auto grow = [&](double &largest, double MaterialState::*const value) {
      largest =
        std::max(largest, excess(value, scene.chip->history(), start.history));
    };
    grow(report.strain_excess, &MaterialState::plastic_strain);
    grow(report.temperature_excess, &MaterialState::temperature);
    take_step(dt);
    if (state_.time != time || mu == 0.)
      return; // it has been cut, or nothing touched yet
    const double change = std::abs(present_friction() - mu) / std::abs(mu);
    double      &largest =
      time < protocol_.ramp_time() ? report.change_in_ramp : report.change;
    largest = std::max(largest, change);
  }



  template <int dim>
  void
  SlidingRun<dim>::go_back(const StepStart                         &start,
                           const SplineHierarchy<dim>              &before,
                           const std::vector<dealii::Tensor<2, 3>> &F)
  {
    const SplineHierarchy<dim> &after = *scene.space->hierarchy();
    const SpaceTransfer<dim>    transfer(before, after);
    first_guess = moved(transfer, state_.u);
    state_.u    = moved(transfer, state_.u_previous);
    scene.chip->set_history(transfer_states(
      before,
      after,
      dealii::QGauss<dim>(parameters.mesh.n_quadrature_points()),
      start.history,
      F,
      scene.chip->deformation(state_.u)));
    state_.u_previous  = moved(transfer, start.u_previous);
    state_.dt_previous = start.dt_previous;
    state_.time        = start.time;
    --state_.step;
    scene.contact->set_hints(hints(scene.contact->table(), *first_guess));
    go_back_at_face(start, before, transfer);
    step = std::make_unique<SolidStep>(*scene.chip,
                                       *scene.equilibrium,
                                       state_.u,
                                       std::nullopt);
  }



  template <int dim>
  void
  SlidingRun<dim>::go_back_at_face(const StepStart            &start,
                                   const SplineHierarchy<dim> &before,
                                   const SpaceTransfer<dim>   &transfer)
  {
    const SplineHierarchy<dim> &after   = *scene.space->hierarchy();
    ContactAssembler<dim>      &contact = *scene.contact;
    const unsigned int          n_points =
      std::lround(std::pow(contact.table().points_per_element, 1. / (dim - 1)));
    const auto moved_points = [&](const std::vector<double> &values) {
      return transfer_edge_history(
        before, after, Edge::top, dealii::QGauss<dim - 1>(n_points), values, 1);
    };
    state_.coverage = moved_points(start.coverage);
    if (ShearTraction<dim> *shear = contact.shear())
      shear->set_history(transfer_shear(before,
                                        after,
                                        Edge::top,
                                        contact.options().formulation,
                                        n_points,
                                        start.shear,
                                        positions(contact.table(), state_.u)));
    if (scene.lubricant)
      from_bytes(start.oil, "The oil", [&](InputArchive &archive) {
        scene.lubricant->load(archive);
      });
    if (scene.heat)
      from_bytes(start.heat, "The heat", [&](InputArchive &archive) {
        scene.heat->take_over(
          archive,
          [&](const std::vector<double> &values) {
            return transfer.apply(values);
          },
          moved_points);
      });
  }



  template <int dim>
  bool
  SlidingRun<dim>::changes_mesh() const
  {
    return adaptation != nullptr;
  }



  template <int dim>
  void
  SlidingRun<dim>::set_mesh(const std::vector<CellIndex<dim>> &cells)
  {
    scene.set_mesh(parameters, cells);
    state_.u = state_.u_previous = scene.initial_unknowns();
    state_.coverage.resize(scene.contact->table().JxW.size());
    step = std::make_unique<SolidStep>(*scene.chip,
                                       *scene.equilibrium,
                                       state_.u,
                                       std::nullopt);
  }



  // Of the members that are defined here.
  template SlidingRun<2>::StepStart
  SlidingRun<2>::step_start() const;
  template SlidingRun<3>::StepStart
  SlidingRun<3>::step_start() const;
  template double
  SlidingRun<2>::present_friction() const;
  template double
  SlidingRun<3>::present_friction() const;
  template void
  SlidingRun<2>::adapt_mesh(const StepStart &);
  template void
  SlidingRun<3>::adapt_mesh(const StepStart &);
  template void
  SlidingRun<2>::go_back(const StepStart &,
                         const SplineHierarchy<2> &,
                         const std::vector<dealii::Tensor<2, 3>> &);
  template void
  SlidingRun<3>::go_back(const StepStart &,
                         const SplineHierarchy<3> &,
                         const std::vector<dealii::Tensor<2, 3>> &);
  template void
  SlidingRun<2>::go_back_at_face(const StepStart &,
                                 const SplineHierarchy<2> &,
                                 const SpaceTransfer<2> &);
  template bool
  SlidingRun<2>::changes_mesh() const;
  template void
  SlidingRun<2>::set_mesh(const std::vector<CellIndex<2>> &);
  template void
  SlidingRun<3>::go_back_at_face(const StepStart &,
                                 const SplineHierarchy<3> &,
                                 const SpaceTransfer<3> &);
  template bool
  SlidingRun<3>::changes_mesh() const;
  template void
  SlidingRun<3>::set_mesh(const std::vector<CellIndex<3>> &);
} // namespace asperity
