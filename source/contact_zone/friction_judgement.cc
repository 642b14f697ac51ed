#include <asperity/base/quantity.h>
#include <asperity/contact_zone/friction_judgement.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** Part of the load by which the mean vertical force may be off. */
    constexpr double load_tolerance = 0.05;

    /** Part of the load below which nothing carries the chip. */
    constexpr double no_force = 0.01;

    /** A coefficient that is zero to the tolerances of the solvers. */
    constexpr double no_friction = 1e-4;

    const std::string no_result = ", so that mu is no friction coefficient";

    /** Mean of the load over the window at the moments of the rows [N/m]: the
     *  same trapezoids as for the force, so that a chip in balance carries
     *  it exactly. */
    double
    mean_load(const std::vector<FrictionRow> &rows,
              const FrictionResult           &friction,
              const LoadProtocol             &protocol,
              const double                    length)
    {
      double impulse = 0.;
      for (std::size_t i = 1; i < rows.size(); ++i)
        {
          const double t0 = std::max(rows[i - 1].time, friction.window_begin),
                       t1 = std::min(rows[i].time, friction.window_end);
          if (t0 < t1)
            impulse += 0.5 * (t1 - t0) *
                       (protocol.pressure(t0) + protocol.pressure(t1)) * length;
        }
      return impulse / (friction.window_end - friction.window_begin);
    }

    /** Steps of the window, after the first touch, in which nothing carries the
     *  chip. */
    unsigned int
    steps_without_force(const std::vector<FrictionRow> &rows,
                        const FrictionResult           &friction,
                        const LoadProtocol             &protocol,
                        const double                    length)
    {
      unsigned int n       = 0;
      bool         touched = false;
      for (const FrictionRow &row : rows)
        {
          const bool carried =
            -row.T_y > no_force * protocol.pressure(row.time) * length;
          if (touched && !carried && row.time >= friction.window_begin)
            ++n;
          touched = touched || carried;
        }
      return n;
    }
  } // namespace



  std::string
  name(const FrictionStatus status)
  {
    switch (status)
      {
        case FrictionStatus::load_not_carried:
          return "load not carried";
        case FrictionStatus::contact_lost:
          return "contact lost";
        case FrictionStatus::along_the_motion:
          return "along the motion";
        case FrictionStatus::scattered:
          return "scattered";
        case FrictionStatus::valid:
          break;
      }
    return "valid";
  }



  FrictionJudgement
  judge_friction(const std::vector<FrictionRow> &rows,
                 const FrictionResult           &friction,
                 const LoadProtocol             &protocol,
                 const double                    length)
  {
    FrictionJudgement judgement;
    judgement.carried_load =
      -friction.T_y / mean_load(rows, friction, protocol, length);
    const auto find = [&](const FrictionStatus status,
                          const std::string   &sentence) {
      if (judgement.status == FrictionStatus::valid)
        judgement.status = status;
      judgement.warnings.push_back(sentence);
    };
    if (!(std::abs(judgement.carried_load - 1.) <= load_tolerance))
      find(FrictionStatus::load_not_carried,
           "Tool and oil carry " +
             format_quantity(100. * judgement.carried_load, "1", 3) +
             " % of the load over the window of mu, since the chip has not "
             "settled" +
             no_result +
             "; let the run last longer (Protocol/End time or Sliding "
             "distance), start nearer (Geometry/Initial gap) or leave the mass "
             "out (Protocol/Inertia = quasi-static).");
    if (const unsigned int n =
          steps_without_force(rows, friction, protocol, length);
        n > 0)
      find(FrictionStatus::contact_lost,
           "Contact is lost: nothing carries the chip in " + std::to_string(n) +
             " steps of the window of mu" + no_result +
             "; smaller steps, a longer run or Protocol/Inertia = "
             "quasi-static help.");
    if (friction.mu < -no_friction)
      find(FrictionStatus::along_the_motion,
           "The tool pushes the chip along its way instead of against it, mu "
           "= " +
             format_quantity(friction.mu, "1", 3) + no_result +
             "; the chip must slide further (Protocol/Sliding distance or End "
             "time).");
    if (friction.spread > std::max(std::abs(friction.mu), no_friction))
      find(FrictionStatus::scattered,
           "mu varies by " + format_quantity(friction.spread, "1", 3) +
             " over its window, more than its mean of " +
             format_quantity(friction.mu, "1", 3) + no_result +
             "; a longer way or a window further from the start "
             "(Protocol/Window fraction) is needed.");
    return judgement;
  }
} // namespace asperity
