#include <asperity/contact_zone/scene_heat.h>
#include <asperity/contact_zone/sliding_run.h>
#include <asperity/lubricant/film_term.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** Distance from the softest temperature that a failed step mentions [K].
     */
    constexpr double near_melting = 50.;
  } // namespace



  template <int dim>
  void
  SlidingRun<dim>::record(const double seconds)
  {
    const ContactState<dim> contact = scene.contact->state();
    const LineLoad          force   = per_width(contact.force);
    FrictionRow             row;
    row.step             = state_.step;
    row.time             = state_.time;
    row.sliding_distance = protocol_.displacement(state_.time);
    row.T_x              = force.along;
    row.T_y              = force.up;
    row.T_transverse     = force.across;
    if (scene.lubricant)
      record_lubricant(row);
    row.mu =
      friction_coefficient(row.T_x, row.T_y, protocol_.direction(state_.time));
    record_interface(row);
    row.contact_fraction = contact.contact_fraction;
    row.max_penetration  = std::max(0., contact.max_penetration);
    row.mean_gap         = contact.mean_gap;
    for (const MaterialState &point : scene.chip->history())
      {
        row.max_plastic_strain =
          std::max(row.max_plastic_strain, point.plastic_strain);
        row.max_temperature = std::max(row.max_temperature, point.temperature);
      }
    row.flash_temperature = scene.flash_temperature();
    if (scene.heat)
      record_heat(row);
    unsigned int iterations = 0;
    for (const FrictionRow &earlier : state_.rows)
      iterations += earlier.newton_iterations;
    row.newton_iterations = statistics.iterations - iterations;
    // Those of this process: a restarted one has not made the earlier ones.
    const unsigned int factorisations =
      scene.equilibrium->cost().factorisations;
    row.factorisations      = factorisations - recorded_factorisations;
    recorded_factorisations = factorisations;
    row.wall_time           = seconds;
    state_.rows.push_back(row);
    state_.remeshing.unknown_iterations +=
      1. * scene.n_unknowns() * row.newton_iterations;
    state_.remeshing.most_unknowns =
      std::max(state_.remeshing.most_unknowns, scene.n_unknowns());
  }



  template <int dim>
  void
  SlidingRun<dim>::record_heat(FrictionRow &row) const
  {
    const HeatAmounts &heat = scene.heat->amounts();
    row.plastic_heat        = heat.plastic / scene.width;
    row.friction_heat       = heat.friction / scene.width;
    row.stored_heat         = heat.stored / scene.width;
    row.depth_heat          = heat.depth / scene.width;
    row.tool_heat           = heat.tool / scene.width;
    row.heat_balance_error  = scene.heat->balance_error();
  }



  template <int dim>
  FrictionResult
  SlidingRun<dim>::friction() const
  {
    const double end   = state_.time;
    const double begin = parameters.protocol.window == FrictionWindow::time ?
                           (1. - parameters.protocol.window_fraction) * end :
                           std::max(0.,
                                    end - parameters.protocol.steady_distance /
                                            parameters.load.velocity);
    return average_friction(state_.rows, begin, end);
  }



  template <int dim>
  FrictionJudgement
  SlidingRun<dim>::judgement() const
  {
    return judge_friction(state_.rows, friction(), protocol_, scene.length);
  }



  template <int dim>
  std::string
  SlidingRun<dim>::excess_shear() const
  {
    const ShearTraction<dim> *shear = scene.contact->shear();
    if (shear == nullptr || parameters.interface.uses_shear_strength())
      return "";
    const std::vector<double> k = shear_strength();
    const auto  tau   = [&](const std::size_t q) { return shear->size_at(q); };
    std::size_t worst = 0;
    for (std::size_t q = 0; q < k.size(); ++q)
      if (tau(q) * k[worst] > tau(worst) * k[q])
        worst = q;
    if (tau(worst) <= k[worst])
      return "";
    return "Coulomb's law asks for a shear stress of up to " +
           format_quantity(tau(worst), "MPa", 3) +
           " where the chip itself bears " +
           format_quantity(k[worst], "MPa", 3) +
           ": try Interface/Shear law = limited Coulomb.";
  }



  template <int dim>
  std::string
  SlidingRun<dim>::coarser_meshes() const
  {
    const RemeshReport &report = state_.remeshing;
    if (report.bounded == 0 && report.missing_levels == 0)
      return "";
    return "The contacts want finer meshes than the " +
           std::to_string(parameters.mesh.most_unknowns) +
           " unknowns of Mesh/Maximum unknowns make: " +
           std::to_string(report.bounded) + " of " +
           std::to_string(report.remeshes) +
           " changes took a coarser one, with fewer cells beside them" +
           (report.missing_levels > 0 ?
              " and without up to " + std::to_string(report.missing_levels) +
                " of the " + std::to_string(parameters.mesh.adaptive_levels) +
                " Adaptive levels." :
              ".");
  }



  template <int dim>
  std::string
  SlidingRun<dim>::coarse_film() const
  {
    const auto *film = dynamic_cast<const FilmTerm *>(scene.lubricant.get());
    return film == nullptr ? "" : film->coarseness();
  }



  template <int dim>
  std::string
  SlidingRun<dim>::remedies() const
  {
    std::string           sentences;
    const auto           &viscosity = parameters.lubrication.oil.viscosity;
    const LubricantModel &model     = parameters.lubrication.model;
    if (model != LubricantModel::none && model != LubricantModel::pocket &&
        viscosity.pressure_law != PressureLaw::none &&
        viscosity.stress_limit == StressLimit::none)
      sentences +=
        " The viscosity of the oil grows with its pressure, and nothing limits "
        "its shear stress: try Lubricant/Stress limit = circular.";
    if (const std::string excess = excess_shear(); !excess.empty())
      sentences += " " + excess;
    const auto   softening = parameters.material.softening();
    const double hottest   = state_.rows.back().max_temperature;
    if (softening &&
        hottest > softening->temperature_at(Softening::floor) - near_melting)
      sentences += " The chip is at " + format_quantity(hottest, "degC", 4) +
                   ", where it has hardly any strength left below its melting "
                   "temperature (" +
                   parameters.material.melting_entry() + ").";
    return sentences;
  }



  template <int dim>
  const RunState &
  SlidingRun<dim>::state() const
  {
    return state_;
  }



  template <int dim>
  void
  SlidingRun<dim>::set_state(const RunState &state)
  {
    state_ = state;
    if (adaptation)
      adaptation->set_taken(state.remeshing.taken);
    // The counts go on from those of the rows.
    for (const FrictionRow &row : state.rows)
      statistics.iterations += row.newton_iterations;
  }



  template <int dim>
  SolidStep &
  SlidingRun<dim>::solid_step()
  {
    return *step;
  }



  template <int dim>
  const SolidStep &
  SlidingRun<dim>::solid_step() const
  {
    return *step;
  }



  template <int dim>
  LubricatedStep *
  SlidingRun<dim>::lubricated_step() const
  {
    return lubricated_step_.get();
  }



  template <int dim>
  const LoadProtocol &
  SlidingRun<dim>::protocol() const
  {
    return protocol_;
  }



  template <int dim>
  double
  SlidingRun<dim>::period() const
  {
    return scene.length;
  }



  template <int dim>
  const NewtonStatistics &
  SlidingRun<dim>::newton_statistics() const
  {
    return statistics;
  }



  template <int dim>
  unsigned int
  SlidingRun<dim>::n_cuts() const
  {
    return cuts;
  }



  template <int dim>
  unsigned int
  SlidingRun<dim>::mean_unknowns() const
  {
    if (!adaptation || statistics.iterations == 0)
      return scene.n_unknowns();
    return static_cast<unsigned int>(
      std::lround(state_.remeshing.unknown_iterations / statistics.iterations));
  }



  template <int dim>
  double
  SlidingRun<dim>::area() const
  {
    return scene.area();
  }



  template <int dim>
  typename SlidingRun<dim>::LineLoad
  SlidingRun<dim>::per_width(const dealii::Tensor<1, dim> &force) const
  {
    return {force * scene.motion / scene.width,
            force[dim - 1] / scene.width,
            force * scene.across() / scene.width};
  }



  // Of the members that are defined here.
  template class SlidingRun<2>;
  template class SlidingRun<3>;
} // namespace asperity
