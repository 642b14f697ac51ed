#include <asperity/contact_zone/sliding_run.h>
#include <asperity/isogeometric/element_view.h>
#include <asperity/isogeometric/space_transfer.h>
#include <asperity/solid/state_transfer.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  namespace
  {
    Vector
    moved(const SpaceTransfer<2> &transfer, const Vector &u)
    {
      const std::vector<double> coefficients =
        transfer.apply(std::vector<double>(u.begin(), u.end()), 2);
      return Vector(coefficients.begin(), coefficients.end());
    }

    /** Where closest points may lie: above those of the edge. */
    std::vector<dealii::Point<1>>
    hints(const BasisTable<2> &edge, const Vector &u)
    {
      std::vector<dealii::Point<1>> x;
      for (const auto &entry : edge.elements)
        {
          const ElementView<2> element(edge, entry);
          for (unsigned int q = 0; q < edge.points_per_element; ++q)
            {
              dealii::Point<2> point = edge.position[element.point(q)];
              element.add_displacement(q, u, point);
              x.emplace_back(point[0]);
            }
        }
      return x;
    }

    /** By how much plastic strains leave the range of others. */
    double
    excess(const std::vector<MaterialState> &states,
           const std::vector<MaterialState> &range)
    {
      const auto less = [](const MaterialState &a, const MaterialState &b) {
        return a.plastic_strain < b.plastic_strain;
      };
      const auto [a, b] =
        std::minmax_element(states.begin(), states.end(), less);
      const auto [low, high] =
        std::minmax_element(range.begin(), range.end(), less);
      return std::max({0.,
                       b->plastic_strain - high->plastic_strain,
                       low->plastic_strain - a->plastic_strain});
    }
  } // namespace



  template <>
  double
  SlidingRun<2>::present_friction() const
  {
    const ContactState<2> contact = scene.contact->state();
    return friction_coefficient(contact.force[0],
                                contact.force[1],
                                protocol_.direction(state_.time));
  }



  template <>
  void
  SlidingRun<2>::adapt_mesh(const StepStart &start)
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
    const auto F = scene.chip->deformation(state_.u_previous);
    if (!scene.adapt_mesh(parameters, adaptation->wanted(time, approach)))
      return;
    go_back(start, *before, F);

    RemeshReport &report = state_.remeshing;
    ++report.remeshes;
    report.plastic_work = work;
    report.work_change +=
      plastic_work(*scene.chip, scene.chip->history(), parameters.load) - work;
    report.strain_excess =
      std::max(report.strain_excess,
               excess(scene.chip->history(), start.history));
    take_step(dt);
    if (state_.time != time || mu == 0.)
      return; // it has been cut, or nothing touched yet
    const double change = std::abs(present_friction() - mu) / std::abs(mu);
    double      &largest =
      time < protocol_.ramp_time() ? report.change_in_ramp : report.change;
    largest = std::max(largest, change);
  }



  template <>
  void
  SlidingRun<2>::go_back(const StepStart                         &start,
                         const SplineHierarchy<2>                &before,
                         const std::vector<dealii::Tensor<2, 3>> &F)
  {
    const SplineHierarchy<2> &after = *scene.space->hierarchy();
    const SpaceTransfer<2>    transfer(before, after);
    first_guess = moved(transfer, state_.u);
    state_.u    = moved(transfer, state_.u_previous);
    scene.chip->set_history(
      transfer_states(before,
                      after,
                      dealii::QGauss<2>(parameters.mesh.n_quadrature_points()),
                      start.history,
                      F,
                      scene.chip->deformation(state_.u)));
    state_.u_previous  = moved(transfer, start.u_previous);
    state_.dt_previous = start.dt_previous;
    state_.time        = start.time;
    --state_.step;
    state_.coverage.assign(scene.contact->table().JxW.size(), 0.);
    scene.contact->set_hints(hints(scene.contact->table(), *first_guess));
    step = std::make_unique<SolidStep>(*scene.chip,
                                       *scene.equilibrium,
                                       state_.u,
                                       std::nullopt);
  }
} // namespace asperity
