#include <asperity/base/quantity.h>
#include <asperity/contact_zone/accuracy_control.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** Factors by which the time of a run grows with twice as many elements
     *  along the edge, time steps, and twice the penalty: those of unknowns and
     *  Newton iterations of R0 (parameter_files/reference_scenes/README.md). A
     *  patch has twice as many across, too: those of hills grow by 4 and 1.3
     *  (parameter_files/surface_patches/README.md). */
    constexpr double cost_of_mesh = 3.5, cost_of_mesh_of_patch = 5.,
                     cost_of_steps = 1.27, cost_of_penalty = 1.1;

    /** Wanted error at which rounds begin with a quarter of the spans. For a
     *  smaller one some would end there, with short steps and stiff penalties,
     *  where estimates mislead (tools/benchmarks/README.md, "What is chosen").
     */
    constexpr double coarsest_start = 0.02;

    /** Part of the wanted error that may be used up by a choice made on coarser
     *  settings. */
    constexpr double safety_of_choice = 0.8;

    /** Most halvings at once, of elements and of the others. Estimates reach no
     *  further. */
    constexpr int most_of_mesh = 2, most = 4;



    /** Which numbers keep the wanted error. */
    std::vector<std::string>
    met_by(const ErrorEstimate &error, const double wanted)
    {
      std::vector<std::string> names;
      if (error.total() <= wanted)
        names.push_back("mu");
      if (is_met(error, wanted))
        names.push_back("corrected_mu");
      return names;
    }
  } // namespace



  std::vector<std::pair<std::string, std::string>>
  entries_of(const SceneParameters &parameters, const Fineness &fineness)
  {
    const SceneParameters settings = with_fineness(parameters, fineness);
    std::vector<std::pair<std::string, std::string>> entries = {
      {"Mesh/Spans", std::to_string(settings.mesh.spans)},
      {"Mesh/Refinement levels", std::to_string(settings.mesh.refinement)},
      {"Mesh/Adaptive levels", std::to_string(settings.mesh.adaptive_levels)},
      {"Protocol/Ramp steps", std::to_string(settings.protocol.ramp_steps)},
      {"Protocol/Slide steps", std::to_string(settings.protocol.slide_steps)},
      {"Protocol/Steady step",
       format_quantity(settings.protocol.steady_step, "nm")},
      {"Protocol/Maximum strain increment",
       format_quantity(settings.protocol.strain_increment, "1")},
      {"Contact/Penalty factor",
       format_quantity(settings.contact.penalty_factor, "1")}};
    if (settings.mesh.across)
      entries.emplace_back("Mesh/Spans across",
                           std::to_string(*settings.mesh.across));
    if (settings.contact.penalty)
      entries.emplace_back("Contact/Penalty",
                           format_quantity(*settings.contact.penalty, "Pa/m"));
    return entries;
  }



  Fineness
  cheapest(const SceneParameters &parameters)
  {
    // By order 2; a coarser mesh is for the companions, and should be none of
    // the coarsest.
    const double halvings =
      0.5 * std::log2(coarsest_start / parameters.accuracy.error);
    const long start = std::lround(std::clamp(halvings - 2., -2., 0.));
    int        mesh  = 0;
    while (mesh > start && has_mesh(parameters, mesh - 3))
      --mesh;
    return {mesh, -1, -1};
  }



  bool
  is_met(const ErrorEstimate &error, const double wanted)
  {
    return error.uncertainty() <= wanted;
  }



  double
  relative_cost(const Fineness &finer, const unsigned int dimension)
  {
    return std::pow(dimension == 3 ? cost_of_mesh_of_patch : cost_of_mesh,
                    finer.mesh) *
           std::pow(cost_of_steps, finer.step) *
           std::pow(cost_of_penalty, finer.penalty);
  }



  std::optional<Fineness>
  next_fineness(const AccuracyRound                         &last,
                const double                                 wanted,
                const std::function<bool(const Fineness &)> &is_possible)
  {
    const double            target    = safety_of_choice * wanted;
    double                  best_cost = 0.;
    std::optional<Fineness> best;
    const auto              try_more = [&](const Fineness &more) {
      const Fineness candidate{last.fineness.mesh + more.mesh,
                               last.fineness.step + more.step,
                               last.fineness.penalty + more.penalty};
      const double cost = relative_cost(more, last.settings.geometry.dimension);
      if (last.error.after(more).uncertainty() <= target &&
          (!best || cost < best_cost) && is_possible(candidate))
        {
          best      = candidate;
          best_cost = cost;
        }
    };
    for (int mesh = 0; mesh <= most_of_mesh; ++mesh)
      for (int step = 0; step <= most; ++step)
        for (int penalty = 0; penalty <= most; ++penalty)
          if (mesh + step + penalty > 0)
            try_more({mesh, step, penalty});
    if (best)
      return best;
    // Further off than estimates reach: what dominates first.
    Fineness          next   = last.fineness;
    const std::string source = last.error.largest();
    ++(source == "mesh" ? next.mesh :
       source == "step" ? next.step :
                          next.penalty);
    if (is_possible(next))
      return next;
    return {};
  }



  std::string
  describe(const AccuracyRound &round)
  {
    const SceneParameters    &settings = round.settings;
    const ProtocolParameters &protocol = settings.protocol;
    const std::string         sliding =
      protocol.window == FrictionWindow::time ?
                std::to_string(protocol.slide_steps) + " steps" :
                "steps of " + format_quantity(protocol.steady_step, "nm", 3);
    return std::to_string(settings.mesh.spans) + " spans, " +
           std::to_string(protocol.ramp_steps) + " + " + sliding +
           ", penalty factor " +
           format_quantity(settings.contact.penalty_factor, "1", 3) +
           ": mu = " + format_quantity(round.run.mu, "1", 4) + " +- " +
           per_cent(round.error.total()) + " (mesh " +
           per_cent(std::abs(round.error.mesh)) + ", steps " +
           per_cent(std::abs(round.error.step)) + ", penalty " +
           per_cent(std::abs(round.error.penalty)) + ", chance " +
           per_cent(round.error.chance) + "), corrected " +
           format_quantity(round.error.corrected(round.run.mu), "1", 4) +
           " +- " + per_cent(round.error.uncertainty()) + ", " +
           std::to_string(round.run.unknowns) + " unknowns, " +
           std::to_string(round.run.newton_iterations) + " Newton iterations";
  }



  nlohmann::ordered_json
  to_json(const AccuracyReport &report, const double mu)
  {
    const auto of = [](const ErrorEstimate &error, const double mu) {
      return nlohmann::ordered_json({{"corrected_mu", error.corrected(mu)},
                                     {"uncertainty", error.uncertainty()},
                                     {"error", error.total()},
                                     {"mesh", std::abs(error.mesh)},
                                     {"step", std::abs(error.step)},
                                     {"penalty", std::abs(error.penalty)},
                                     {"chance", error.chance},
                                     {"unresolved", error.unresolved}});
    };
    nlohmann::ordered_json summary =
      report.error ? of(*report.error, mu) : nlohmann::ordered_json();
    if (report.error)
      {
        summary["by_source"] = {{"mesh", report.error->mesh},
                                {"step", report.error->step},
                                {"penalty", report.error->penalty},
                                {"chance", report.error->chance}};
        summary["met_by"]    = met_by(*report.error, report.wanted);
      }
    summary["wanted"] = report.wanted;
    summary["runs"]   = report.runs;
    summary["cost"]   = report.cost;
    if (report.rounds.empty())
      return summary;
    nlohmann::ordered_json rounds = nlohmann::ordered_json::array();
    for (const AccuracyRound &round : report.rounds)
      {
        const SceneParameters &settings = round.settings;
        nlohmann::ordered_json entry    = of(round.error, round.run.mu);
        entry["mu"]                     = round.run.mu;
        entry["spans"]                  = settings.mesh.spans;
        entry["refinement_levels"]      = settings.mesh.refinement;
        entry["ramp_steps"]             = settings.protocol.ramp_steps;
        entry["slide_steps"]            = settings.protocol.slide_steps;
        entry["steady_step"]            = settings.protocol.steady_step;
        entry["penalty_factor"]         = settings.contact.penalty_factor;
        entry["unknowns"]               = round.run.unknowns;
        entry["newton_iterations"]      = round.run.newton_iterations;
        rounds.push_back(entry);
      }
    summary["rounds"] = rounds;
    return summary;
  }
} // namespace asperity
