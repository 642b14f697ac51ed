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



  void
  SlidingRun::record(const double seconds)
  {
    const ContactState<2> contact = scene.contact->state();
    FrictionRow        row;
    row.step             = state_.step;
    row.time             = state_.time;
    row.sliding_distance = protocol_.displacement(state_.time);
    row.T_x              = contact.force[0];
    row.T_y              = contact.force[1];
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



  void
  SlidingRun::record_heat(FrictionRow &row) const
  {
    const HeatAmounts &heat = scene.heat->amounts();
    row.plastic_heat        = heat.plastic;
    row.friction_heat       = heat.friction;
    row.stored_heat         = heat.stored;
    row.depth_heat          = heat.depth;
    row.tool_heat           = heat.tool;
    row.heat_balance_error  = scene.heat->balance_error();
  }



  FrictionResult
  SlidingRun::friction() const
  {
    const double end   = state_.time;
    const double begin = parameters.protocol.window == FrictionWindow::time ?
                           (1. - parameters.protocol.window_fraction) * end :
                           std::max(0.,
                                    end - parameters.protocol.steady_distance /
                                            parameters.load.velocity);
    return average_friction(state_.rows, begin, end);
  }



  FrictionJudgement
  SlidingRun::judgement() const
  {
    return judge_friction(state_.rows, friction(), protocol_, scene.length);
  }



  std::string
  SlidingRun::excess_shear() const
  {
    const ShearTraction<2> *shear = scene.contact->shear();
    if (shear == nullptr || parameters.interface.uses_shear_strength())
      return "";
    const std::vector<double>  k     = shear_strength();
    const std::vector<double> &tau   = shear->at_points();
    std::size_t                worst = 0;
    for (std::size_t q = 0; q < k.size(); ++q)
      if (std::abs(tau[q]) * k[worst] > std::abs(tau[worst]) * k[q])
        worst = q;
    if (std::abs(tau[worst]) <= k[worst])
      return "";
    return "Coulomb's law asks for a shear stress of up to " +
           format_quantity(std::abs(tau[worst]), "MPa", 3) +
           " where the chip itself bears " +
           format_quantity(k[worst], "MPa", 3) +
           ": try Interface/Shear law = limited Coulomb.";
  }



  std::string
  SlidingRun::coarse_film() const
  {
    const auto *film = dynamic_cast<const FilmTerm *>(scene.lubricant.get());
    return film == nullptr ? "" : film->coarseness();
  }



  std::string
  SlidingRun::remedies() const
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



  const RunState &
  SlidingRun::state() const
  {
    return state_;
  }



  void
  SlidingRun::set_state(const RunState &state)
  {
    state_ = state;
    // The counts go on from those of the rows.
    for (const FrictionRow &row : state.rows)
      statistics.iterations += row.newton_iterations;
  }



  SolidStep &
  SlidingRun::solid_step()
  {
    return *step;
  }



  const SolidStep &
  SlidingRun::solid_step() const
  {
    return *step;
  }



  LubricatedStep *
  SlidingRun::lubricated_step() const
  {
    return lubricated_step_.get();
  }



  const LoadProtocol &
  SlidingRun::protocol() const
  {
    return protocol_;
  }



  double
  SlidingRun::period() const
  {
    return scene.length;
  }



  const NewtonStatistics &
  SlidingRun::newton_statistics() const
  {
    return statistics;
  }



  unsigned int
  SlidingRun::n_cuts() const
  {
    return cuts;
  }



  unsigned int
  SlidingRun::mean_unknowns() const
  {
    if (!adaptation || statistics.iterations == 0)
      return scene.n_unknowns();
    return static_cast<unsigned int>(
      std::lround(state_.remeshing.unknown_iterations / statistics.iterations));
  }
} // namespace asperity
