#include <asperity/base/quantity.h>
#include <asperity/contact_zone/accuracy_control.h>
#include <asperity/contact_zone/accuracy_forecast.h>
#include <asperity/contact_zone/load_protocol.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace asperity
{
  namespace
  {
    /** R0 at 300 MPa, 200 m/min and 25 degC with the default settings: its
     *  numbers, and what they were found to give. */
    const ForecastNumbers reference = {14.5, 0.92, 0.14, 120., 8., 1920.};
    constexpr double      iterations_a_step = 3.18;

    /** Error by the mesh for one element in a spot, by as many steps as the
     *  reference has, and what is left to chance if one element is passed. */
    constexpr double error_of_mesh = 2.3, error_of_steps = 0.26e-2,
                     chance_of_mesh = 0.28e-2;

    /** Error by a penalty that lets the tool in by the depth of a spot, if the
     *  chip slides by its length. */
    constexpr double error_of_penalty = 0.38;

    /** Points of a period at which surfaces are cut off. */
    constexpr unsigned int n_points = 4000, fewest_points = 20;

    /** Factor by which the unknowns grow with twice as many spans. */
    constexpr double growth_of_unknowns = 3.2;

    /** Strain and rate [1/s] at which the chip yields below asperities. */
    constexpr double strain = 1., rate = 1e6;

    /** Pressure on what touches over the shear strength there, as measured on
     *  R0 and R1, and the largest share that is found to touch. */
    constexpr double hardness = 2.25, most_contact = 0.8;

    /** A recommendation is at most one halving coarser than what is there, and
     *  half the forecast error may hide. */
    constexpr int    coarsest           = 1;
    constexpr double safety_of_forecast = 2.;

    /** Time of a run over that of a dry one, as measured on the lubricated
     *  scenes. */
    double
    cost_of(const LubricantModel lubricant)
    {
      switch (lubricant)
        {
          case LubricantModel::pocket:
            return 1.2;
          case LubricantModel::reynolds:
            return 1.8;
          case LubricantModel::stokes:
          case LubricantModel::navier_stokes:
            return 6.;
          default:
            return 1.;
        }
    }

    /** Where surfaces touch if they are cut off. */
    struct CutSpots
    {
      double length; ///< of one, the mean [m]
      double depth;  ///< what is cut off, the mean [m]
    };

    /** @param share of the period that touches */
    CutSpots
    cut_spots(const Scene<2> &scene, const double share)
    {
      std::vector<double> gap(n_points);
      for (unsigned int i = 0; i < n_points; ++i)
        {
          const double x = scene.length * i / n_points;
          gap[i] = scene.tool_surface.height(x) - scene.chip_surface.height(x);
        }
      std::vector<double> sorted = gap;
      std::sort(sorted.begin(), sorted.end());
      const auto n_cut = std::clamp<unsigned int>(std::lround(share * n_points),
                                                  fewest_points,
                                                  n_points);
      const double level = sorted[n_cut - 1];
      double       depth = 0.;
      unsigned int n     = 0;
      for (unsigned int i = 0; i < n_points; ++i)
        {
          depth += std::max(0., level - gap[i]) / n_cut;
          if (gap[i] <= level && gap[(i + n_points - 1) % n_points] > level)
            ++n;
        }
      return {n_cut * scene.length / n_points / std::max(1u, n), depth};
    }

    unsigned int
    n_steps(const SceneParameters &parameters)
    {
      const LoadProtocol protocol(parameters.load, parameters.protocol);
      unsigned int       n   = 0;
      const double       end = protocol.end_time() * (1. - 1e-9);
      for (double time = 0.; time < end; time = protocol.next_time(time))
        ++n;
      return n;
    }

    /** What the audit would choose, were all models `automatic`, and heat by
     *  how far it gets. */
    std::string
    models_for(const SceneParameters &parameters, const Scene<2> &scene)
    {
      SceneParameters open  = parameters;
      open.protocol.inertia = Inertia::automatic;
      if (open.lubrication.model != LubricantModel::none)
        open.lubrication.model = LubricantModel::automatic;
      const SceneAudit audit = audit_scene(open, scene);
      HeatModel        heat  = parameters.heat_model();
      for (const AuditEntry &entry : audit.entries)
        if (entry.name == "heat length over peak-to-valley height" &&
            heat != HeatModel::isothermal)
          heat =
            entry.value < 1. ? HeatModel::adiabatic : HeatModel::conducting;
      return "Recommended models: " +
             (audit.lubricant == LubricantModel::none ?
                "dry" :
                "oil by " + name(audit.lubricant)) +
             ", " +
             (audit.inertia == Inertia::dynamic ? "dynamic" : "quasi-static") +
             ", " + name(heat) + ".";
    }

    std::string
    describe(const AccuracyForecast &forecast)
    {
      return "numerical error of mu about " + per_cent(forecast.total()) +
             ", time about " + format_quantity(forecast.time, "1", 2) +
             " times that of the default scene";
    }
  } // namespace



  double
  AccuracyForecast::total() const
  {
    return std::hypot(std::hypot(error.mesh, error.chance),
                      error.step,
                      error.penalty);
  }



  ForecastNumbers
  forecast_numbers(const SceneParameters &parameters, const Scene<2> &scene)
  {
    const Surface &tool   = scene.tool_surface;
    const Surface &chip   = scene.chip_surface;
    const auto     height = [](const Surface &surface) {
      return surface.maximum() - surface.minimum();
    };
    const Surface &rougher = height(tool) >= height(chip) ? tool : chip;
    const double   length  = height(rougher) / rougher.largest_slope();
    const double   k =
      scene.law->shear_limit(std::max(strain, parameters.load.plastic_strain),
                             rate,
                             parameters.load.temperature);
    ForecastNumbers numbers;
    numbers.elements = length / scene.contact_element_length();
    const double way =
      parameters.load.velocity *
      LoadProtocol(parameters.load, parameters.protocol).end_time();
    numbers.way = way / length;
    numbers.contact =
      std::min(most_contact, parameters.load.pressure / (hardness * k));
    numbers.steps          = n_steps(parameters);
    numbers.penalty_factor = scene.penalty() * scene.contact_element_length() /
                             scene.law->young_modulus();
    numbers.unknowns         = scene.n_unknowns();
    const CutSpots spots     = cut_spots(scene, numbers.contact);
    numbers.elements_in_spot = spots.length / scene.contact_element_length();
    numbers.way_over_spot    = way / spots.length;
    numbers.elements_passed  = way / scene.contact_element_length();
    // Round-off of a flat surface is no depth.
    numbers.softness = hardness * k / scene.penalty() /
                       (spots.depth > 1e-9 * scene.length ? spots.depth : 0.);
    return numbers;
  }



  AccuracyForecast
  forecast(const ForecastNumbers &numbers, const LubricantModel lubricant)
  {
    const auto power = [&](double ForecastNumbers::*number,
                           const double             exponent) {
      return std::pow(numbers.*number / reference.*number, exponent);
    };
    AccuracyForecast result;
    result.error.mesh = error_of_mesh * std::pow(numbers.elements_in_spot, -2.);
    result.error.chance =
      chance_of_mesh * std::pow(numbers.elements_passed, -1.4);
    result.error.step    = error_of_steps * power(&ForecastNumbers::steps, -1.);
    result.error.penalty = error_of_penalty * std::pow(numbers.softness, 0.82) *
                           std::pow(numbers.way_over_spot, -0.34);
    const double way_of_a_step =
      numbers.way / numbers.steps / (reference.way / reference.steps);
    const double iterations =
      std::max(1.2,
               iterations_a_step * std::pow(way_of_a_step, 0.2) *
                 power(&ForecastNumbers::elements, 0.28) *
                 power(&ForecastNumbers::contact, 0.1) *
                 power(&ForecastNumbers::penalty_factor, 0.15));
    result.time = cost_of(lubricant) * iterations / iterations_a_step *
                  power(&ForecastNumbers::steps, 1.) *
                  power(&ForecastNumbers::unknowns, 1.);
    return result;
  }



  std::vector<std::string>
  advise(const SceneParameters &parameters, const Scene<2> &scene)
  {
    const ForecastNumbers numbers = forecast_numbers(parameters, scene);
    const LubricantModel  oil     = parameters.lubrication.model;
    if (!std::isfinite(numbers.elements) || numbers.elements == 0. ||
        numbers.contact == 0. || !std::isfinite(numbers.softness))
      return {};
    std::vector<std::string> sentences = {
      models_for(parameters, scene),
      "Forecast (good for a factor of 2: time in ten of ten scenes, the error "
      "in nine before its sources cancel and in six as it is; "
      "Accuracy/Control = estimate tells it): " +
        describe(forecast(numbers, oil)) + "."};
    const double wanted = parameters.accuracy.error;
    if (wanted == 0.)
      return sentences;
    std::optional<Fineness> best;
    AccuracyForecast        of_best;
    for (int mesh = -coarsest; mesh <= 4; ++mesh)
      for (int step = -coarsest; step <= 5; ++step)
        for (int penalty = -coarsest; penalty <= 5; ++penalty)
          {
            if (!has_mesh(parameters, mesh))
              continue;
            ForecastNumbers finer = numbers;
            finer.elements        = std::ldexp(numbers.elements, mesh);
            finer.unknowns *= std::pow(growth_of_unknowns, mesh);
            finer.steps = std::ldexp(numbers.steps, step);
            finer.penalty_factor =
              std::ldexp(numbers.penalty_factor, penalty - mesh);
            finer.elements_in_spot = std::ldexp(numbers.elements_in_spot, mesh);
            finer.elements_passed  = std::ldexp(numbers.elements_passed, mesh);
            finer.softness         = std::ldexp(numbers.softness, -penalty);
            const AccuracyForecast candidate = forecast(finer, oil);
            if (safety_of_forecast * candidate.total() <= wanted &&
                (!best || candidate.time < of_best.time))
              {
                best    = Fineness{mesh, step, penalty};
                of_best = candidate;
              }
          }
    if (!best)
      {
        sentences.push_back("No settings within a few halvings of these keep "
                            "an error of " +
                            per_cent(wanted) + ".");
        return sentences;
      }
    std::string entries;
    for (const auto &[path, value] : entries_of(parameters, *best))
      if (path.find("strain") == std::string::npos &&
          path.find("Steady") == std::string::npos)
        entries += path + " = " + value + ", ";
    sentences.push_back("For " + per_cent(wanted) + ": " + entries +
                        "Mesh/Degree = 2: " + describe(of_best) + ".");
    return sentences;
  }
} // namespace asperity
