#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/coupling/partitioned_step.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity
{
  using Vector = dealii::Vector<double>;

  namespace
  {
    /** Forces [N/m] and velocities [m/s] beyond are those of an iteration that
     *  diverges; products of two of them are finite yet. */
    constexpr double largest_norm = 1e100;



    double
    root_mean_square(const Vector &v)
    {
      return v.size() > 0 ? v.l2_norm() / std::sqrt(double(v.size())) : 0.;
    }



    /** The root mean square over a scale; zero of zero. */
    double
    relative(const Vector &v, const double scale)
    {
      const double norm = root_mean_square(v);
      return norm == 0. ? 0. : norm / scale;
    }
  } // namespace



  double
  CouplingResidual::maximum() const
  {
    return std::max({displacement, force, velocity_jump});
  }



  PartitionedStep::PartitionedStep(SolidSide                &solid,
                                   FluidSide                &fluid,
                                   const CouplingParameters &parameters)
    : solid(solid)
    , fluid(fluid)
    , parameters(parameters)
    , acceleration(make_acceleration(parameters.acceleration))
    , robin(parameters.robin_coefficient)
  {
    if (parameters.scheme == CouplingScheme::dirichlet_neumann &&
        fluid.is_sealed())
      throw InputError(
        "Dirichlet-Neumann coupling has no solution here, because the fluid is "
        "incompressible and enclosed, so that a prescribed motion of its walls "
        "contradicts its volume; choose Robin-Neumann.");
    set_state(Vector(fluid.lengths().size()), Vector(fluid.lengths().size()));
  }



  ConvergenceReport
  PartitionedStep::advance(const double dt)
  {
    residuals_.clear();
    solid.begin_step(dt);
    fluid.begin_step(dt);
    if (parameters.scheme == CouplingScheme::dirichlet_neumann)
      condition.alpha = std::numeric_limits<double>::infinity();
    else
      {
        if (!robin.begin_step(solid, fluid))
          {
            ConvergenceReport report;
            report.reason = "the solid gives no Robin coefficient, as it has "
                            "no tangent at the start of the step";
            return report;
          }
        if (robin.value() != condition.alpha)
          acceleration->reset();
        condition.alpha = robin.value();
      }
    acceleration->start_step();
    const ConvergenceReport report = iterate(dt);
    acceleration->finish_step(report.converged);
    if (!report.converged)
      return report;
    solid.accept();
    fluid.accept();
    old_displacement = condition.displacement;
    history.push_front({history.front().time + dt, condition.force});
    if (history.size() > parameters.predictor_degree + 1)
      history.pop_back();
    return report;
  }



  ConvergenceReport
  PartitionedStep::iterate(const double dt)
  {
    ConvergenceReport report;
    WallResponse      response;
    Vector            last_displacement;
    condition.force        = predict(dt);
    condition.displacement = old_displacement;
    for (;;)
      {
        ++report.iterations;
        last_displacement = condition.displacement;
        const ConvergenceReport solid_report =
          solid.solve(condition.force, condition.displacement);
        if (!solid_report.converged)
          {
            report.reason = "in the solid " + solid_report.reason;
            return report;
          }
        robin.observe(solid, fluid, condition.force, condition.displacement);
        const ConvergenceReport fluid_report = fluid.solve(condition, response);
        if (!fluid_report.converged)
          {
            report.reason = "in the fluid " + fluid_report.reason;
            return report;
          }
        if (!(response.force.l2_norm() + response.velocity.l2_norm() <
              largest_norm))
          {
            report.reason = "the coupling iteration diverges";
            return report;
          }
        residuals_.push_back(measure(condition, response, last_displacement));
        report.residual = residuals_.back().maximum();
        if (report.residual <= parameters.tolerance)
          {
            report.converged = true;
            return report;
          }
        if (report.iterations == parameters.maximum_iterations)
          {
            report.reason = "the limit of coupling iterations was reached";
            return report;
          }
        condition.force = acceleration->next(condition.force, response.force);
      }
  }



  Vector
  PartitionedStep::predict(const double dt) const
  {
    const double time = history.front().time + dt;
    Vector       force(history.front().force.size());
    for (const Accepted &a : history)
      {
        double weight = 1.;
        for (const Accepted &b : history)
          if (&a != &b)
            weight *= (time - b.time) / (a.time - b.time);
        force.add(weight, a.force);
      }
    return force;
  }



  CouplingResidual
  PartitionedStep::measure(const WallCondition &condition,
                           const WallResponse  &response,
                           const Vector        &last_displacement)
  {
    Vector step = condition.displacement, correction = condition.displacement;
    step -= old_displacement;
    correction -= last_displacement;
    Vector elastic, mismatch = response.force;
    mismatch -= condition.force;
    if (solid.compliance(response.force, elastic))
      solid.compliance(mismatch, correction);
    const double elastic_scale      = root_mean_square(elastic);
    const double displacement_scale = std::max(
      {root_mean_square(step), elastic_scale, parameters.displacement_floor});
    const double force_scale =
      std::max(root_mean_square(response.force), parameters.force_floor);
    const double velocity_scale =
      std::max({root_mean_square(response.velocity),
                root_mean_square(response.wall_velocity),
                elastic_scale * fluid.rate_coefficient(),
                parameters.velocity_floor});
    Vector jump = response.velocity;
    jump -= response.wall_velocity;

    CouplingResidual residual;
    residual.displacement  = relative(correction, displacement_scale);
    residual.force         = relative(mismatch, force_scale);
    residual.velocity_jump = relative(jump, velocity_scale);
    return residual;
  }



  const std::vector<CouplingResidual> &
  PartitionedStep::residuals() const
  {
    return residuals_;
  }



  double
  PartitionedStep::robin_coefficient() const
  {
    return robin.value();
  }



  const Vector &
  PartitionedStep::force() const
  {
    return history.front().force;
  }



  const Vector &
  PartitionedStep::displacement() const
  {
    return old_displacement;
  }



  void
  PartitionedStep::set_state(const Vector &force, const Vector &displacement)
  {
    old_displacement = displacement;
    history.clear();
    history.push_front({0., force});
  }



  void
  PartitionedStep::save(OutputArchive &archive) const
  {
    robin.save(archive);
    archive << condition.alpha << old_displacement << history;
    acceleration->save(archive);
  }



  void
  PartitionedStep::load(InputArchive &archive)
  {
    const std::size_t n = old_displacement.size();
    robin.load(archive);
    archive >> condition.alpha >>
      fixed_length(old_displacement, "displacements of the interface") >>
      history;
    for (const Accepted &step : history)
      require_length("forces on the interface", step.force.size(), n);
    acceleration->load(archive, n);
  }
} // namespace asperity
