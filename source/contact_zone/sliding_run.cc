#include <asperity/base/errors.h>
#include <asperity/contact_zone/scene_heat.h>
#include <asperity/contact_zone/sliding_run.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  namespace
  {
    /** Part of the load below which the chip's balance is not refined any
     *  more. */
    constexpr double smallest_load = 1e-4;
  } // namespace



  template <int dim>
  SlidingRun<dim>::SlidingRun(const SceneParameters &parameters,
                              Scene<dim>            &scene)
    : parameters(parameters)
    , scene(scene)
    , protocol_(parameters.load, parameters.protocol)
    , step(std::make_unique<SolidStep>(
        *scene.chip,
        *scene.equilibrium,
        scene.initial_unknowns(),
        parameters.protocol.inertia == Inertia::dynamic ?
          std::optional(parameters.protocol.spectral_radius) :
          std::nullopt))
  {
    if (parameters.mesh.adaptive_levels > 0)
      adaptation =
        std::make_unique<MeshAdaptation<dim>>(parameters, scene, protocol_);
    state_.u = state_.u_previous = scene.initial_unknowns();
    state_.coverage.assign(scene.contact->table().JxW.size(),
                           scene.lubricant ? scene.oil.part_at_start : 0.);
    state_.rows.emplace_back();
    state_.rows.back().max_temperature    = parameters.load.temperature;
    state_.rows.back().max_plastic_strain = parameters.load.plastic_strain;
    state_.rows.back().flash_temperature  = scene.flash_temperature();
    if (!step->is_dynamic())
      return;
    SolidStep::State start = step->state();
    start.v                = scene.translation(parameters.load.velocity, 0.);
    step->set_frame(start.v);
    if (scene.gap_flow != nullptr)
      scene.gap_flow->add(start.u, start.forces, nullptr);
    step->set_state(start);
    if (scene.gap_flow != nullptr)
      lubricated_step_ = std::make_unique<LubricatedStep>(
        *step,
        *scene.gap_flow,
        [this](Vector &u) { return solve(u); },
        parameters.lubrication.coupling);
  }



  template <int dim>
  void
  SlidingRun<dim>::run(const Observer &observer)
  {
    while (!finished())
      {
        dealii::Timer timer;
        StepStart     start;
        if (adaptation)
          start = step_start();
        take_step(
          proposed_step(protocol_.next_time(state_.time) - state_.time));
        if (adaptation)
          adapt_mesh(start);
        record(timer.wall_time());
        observer(*this);
      }
  }



  template <int dim>
  void
  SlidingRun<dim>::take_step(double dt)
  {
    std::string  reason;
    unsigned int halvings = 0;
    while (!try_step(dt, reason))
      {
        ++cuts;
        if (++halvings > parameters.solver.maximum_cuts)
          throw SharedError("Step " + std::to_string(state_.step + 1) +
                            " at t = " + format_quantity(state_.time, "us", 4) +
                            " failed after " + std::to_string(halvings - 1) +
                            " cuts, at a step of " +
                            format_quantity(dt, "ns", 3) + ": " + reason + "." +
                            remedies());
        dt *= 0.5;
      }
  }



  template <int dim>
  bool
  SlidingRun<dim>::finished() const
  {
    if (state_.time >= protocol_.end_time() * (1. - 1e-9))
      return true;
    return parameters.protocol.window == FrictionWindow::steady && is_steady();
  }



  template <int dim>
  bool
  SlidingRun<dim>::is_steady() const
  {
    const double window = parameters.protocol.steady_distance;
    const double slid   = state_.rows.back().sliding_distance;
    const double v      = parameters.load.velocity;
    if (state_.time - 2. * window / v < protocol_.ramp_time())
      return false;
    const auto mean = [&](const double from, const double to) {
      return average_friction(state_.rows, from / v, to / v).mu;
    };
    const double last   = mean(slid - window, slid),
                 before = mean(slid - 2. * window, slid - window);
    return std::abs(last - before) <=
           parameters.protocol.steady_tolerance * std::abs(last);
  }



  template <int dim>
  bool
  SlidingRun<dim>::try_step(const double dt, std::string &reason)
  {
    const std::vector<double> multipliers     = scene.contact->multipliers();
    const auto                begin_lubricant = [&]() {
      if (scene.lubricant)
        scene.lubricant->begin_step(state_.u,
                                    state_.step + 1,
                                    state_.time + dt,
                                    dt);
    };
    warm_oil();
    renew_interface();
    begin_lubricant();
    Vector load   = scene.bottom_load();
    step_pressure = protocol_.pressure(state_.time + dt);
    load *= step_pressure;
    step->begin(dt, load);
    const Vector moved =
      scene.translation(protocol_.displacement(state_.time + dt), 0.);
    std::optional<Vector> tried;
    for (const Predictor &predict : predictors(dt))
      {
        Vector u = predict();
        // In touch, a translation is one already.
        if (tried && u == *tried)
          continue;
        tried = u;
        for (const auto &line : scene.constraints().get_lines())
          u(line.index) = moved(line.index);
        const ConvergenceReport report =
          lubricated_step_ ? lubricated_step_->advance(u, dt) : solve(u);
        if (report.converged && yields_too_much())
          {
            reason = "the plastic strain grows by more than Protocol/Maximum "
                     "strain increment in it";
            scene.contact->set_multipliers(multipliers);
            return false; // another first guess has the same solution
          }
        if (report.converged)
          {
            accept(u, dt);
            return true;
          }
        reason = report.reason;
        scene.contact->set_multipliers(multipliers);
        begin_lubricant();
      }
    return false;
  }



  template <int dim>
  double
  SlidingRun<dim>::proposed_step(const double regular) const
  {
    // A limit that has halved a step is likely to halve the next one, too.
    return parameters.protocol.strain_increment > 0. && state_.step > 0 ?
             std::min(regular, 2. * state_.dt_previous) :
             regular;
  }



  template <int dim>
  bool
  SlidingRun<dim>::yields_too_much() const
  {
    const double limit = parameters.protocol.strain_increment;
    return limit > 0. && scene.chip->largest_strain_increment() > limit;
  }



  template <int dim>
  double
  SlidingRun<dim>::newton_tolerance() const
  {
    double tolerance = parameters.solver.tolerance;
    double pressure  = parameters.load.pressure;
    // What the chip leaves unbalanced is noise to the coupling, whose forces
    // are those of the step.
    if (lubricated_step_)
      {
        tolerance =
          std::min(tolerance, 0.01 * parameters.lubrication.coupling.tolerance);
        pressure = std::max(step_pressure, smallest_load * pressure);
      }
    return tolerance * pressure * scene.area();
  }



  template <int dim>
  ConvergenceReport
  SlidingRun<dim>::solve(Vector &u)
  {
    // A pass of the augmented-Lagrange loop or of the exchange with the
    // lubricant asks for the chip's balance again.
    NewtonOptions options;
    options.maximum_iterations  = parameters.solver.maximum_iterations;
    options.tolerance           = newton_tolerance();
    options.n_energy_components = scene.n_dofs();
    // Steps resemble the ones before them.
    options.first_step_ends = state_.rows.back().newton_iterations == 1;
    for (unsigned int augmentations = 0;;)
      {
        ConvergenceReport report = step->solve(u, options, statistics);
        options.first_step_ends.reset();
        if (!report.converged)
          {
            const std::string in_oil =
              scene.lubricant ? scene.lubricant->reason() : "";
            if (!in_oil.empty())
              report.reason = in_oil;
            return report;
          }
        const Lubricant::Exchange exchange = scene.lubricant ?
                                               scene.lubricant->exchange(u) :
                                               Lubricant::Exchange::converged;
        if (exchange == Lubricant::Exchange::failed)
          {
            report.converged = false;
            report.reason    = scene.lubricant->reason();
            return report;
          }
        const bool penetrates =
          augmentations < parameters.contact.augmentations &&
          scene.contact->state().constraint_violation >
            parameters.contact.penetration_tolerance;
        if (penetrates)
          {
            scene.contact->augment();
            ++augmentations;
          }
        else if (exchange == Lubricant::Exchange::converged)
          return report;
      }
  }



  template <int dim>
  std::vector<typename SlidingRun<dim>::Predictor>
  SlidingRun<dim>::predictors(const double dt) const
  {
    const double x  = protocol_.displacement(state_.time + dt);
    const double dx = x - protocol_.displacement(state_.time);

    const auto extrapolation = [this, dt]() {
      Vector u = state_.u;
      u.sadd(1. + dt / state_.dt_previous,
             -dt / state_.dt_previous,
             state_.u_previous);
      return u;
    };
    const auto translation = [this, dx]() {
      Vector u = state_.u;
      u += scene.translation(dx, 0.);
      return u;
    };
    // In touch, at the start and should the contact be lost where nothing else
    // carries.
    const auto touch = [this, dt, translation]() {
      Vector       u = translation();
      const double shift =
        touching_shift(u, protocol_.pressure(state_.time + dt));
      u += scene.translation(0., shift);
      return u;
    };

    // What has moved so far tells nothing of the way back.
    const bool turns =
      protocol_.direction(state_.time + dt) != protocol_.direction(state_.time);
    std::vector<Predictor> list;
    if (first_guess)
      list.push_back([this]() { return *first_guess; });
    if (state_.step > 1 && !turns)
      list.push_back(extrapolation);
    if (step->is_dynamic())
      list.push_back([this]() { return step->predict(); });
    // At the start nothing but oil that is solved for can carry the chip.
    if (state_.step > 0 || scene.n_unknowns() > scene.n_dofs())
      list.push_back(translation);
    if (!step->is_dynamic())
      list.push_back(touch);
    return list;
  }



  template <int dim>
  double
  SlidingRun<dim>::touching_shift(const Vector &u, const double pressure) const
  {
    Vector     residual(scene.n_unknowns());
    const auto supports = [&](const double shift) {
      Vector shifted = u;
      shifted += scene.translation(0., shift);
      scene.contact->add(shifted, residual, nullptr);
      double force = -scene.contact->state().force[dim - 1];
      if (scene.lubricant)
        {
          if (!scene.lubricant->add(shifted, residual, nullptr))
            return true;
          force -= scene.width * scene.lubricant->state().pressure_force[1];
        }
      return force >= pressure * scene.area();
    };
    if (supports(0.))
      return 0.;
    double low = 0., high = 1e-3 * scene.length;
    while (!supports(high) && high < 1e3 * scene.length)
      high *= 2.;
    // The balance starts there: a small part of what penetrates will do.
    while (high - low > 1e-10 * scene.length)
      (supports(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    return high;
  }



  template <int dim>
  void
  SlidingRun<dim>::accept(const Vector &u, const double dt)
  {
    step->accept(u);
    first_guess.reset();
    if (scene.heat)
      scene.heat->advance(u, dt, frictional_power(dt));
    if (ShearTraction<dim> *shear = scene.contact->shear())
      shear->accept();
    if (scene.lubricant)
      {
        scene.lubricant->accept(u);
        const auto &s = scene.contact->table().parameter;
        for (unsigned int q = 0; q < state_.coverage.size(); ++q)
          state_.coverage[q] =
            scene.lubricant->coverage(dealii::Point<2>(s[q][0], s[q][1]));
      }
    state_.u_previous  = state_.u;
    state_.dt_previous = dt;
    state_.u           = u;
    state_.time += dt;
    ++state_.step;
    // Rounding must not leave a sliver of a step at the end.
    if (std::abs(state_.time - protocol_.end_time()) <
        1e-9 * protocol_.end_time())
      state_.time = protocol_.end_time();
  }



  // Of the members that are defined here.
  template class SlidingRun<2>;
  template class SlidingRun<3>;
} // namespace asperity
