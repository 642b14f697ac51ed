#include <asperity/base/errors.h>
#include <asperity/contact_zone/friction_result.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** What is interpolated between rows and averaged over a window. */
    constexpr double FrictionRow::*averaged[] = {&FrictionRow::T_x,
                                                 &FrictionRow::T_y,
                                                 &FrictionRow::T_transverse,
                                                 &FrictionRow::contact_fraction,
                                                 &FrictionRow::interface_T_x,
                                                 &FrictionRow::interface_T_y,
                                                 &FrictionRow::oil_pressure,
                                                 &FrictionRow::oil_T_x,
                                                 &FrictionRow::shear_T_x,
                                                 &FrictionRow::shear_T_y,
                                                 &FrictionRow::friction_heat,
                                                 &FrictionRow::tool_heat};

    /** The piecewise linear history between two rows at time t. */
    FrictionRow
    interpolate(const FrictionRow &a, const FrictionRow &b, const double t)
    {
      const double w   = (t - a.time) / (b.time - a.time);
      FrictionRow  row = b;
      row.time         = t;
      for (double FrictionRow::*const entry : averaged)
        row.*entry = (1. - w) * a.*entry + w * b.*entry;
      return row;
    }

  } // namespace



  double
  friction_coefficient(const double T_x,
                       const double T_y,
                       const double direction)
  {
    return T_x != 0. && T_y != 0. ? std::copysign(1., direction) * T_x / T_y :
                                    0.;
  }



  FrictionResult
  average_friction(const std::vector<FrictionRow> &rows,
                   const double                    begin,
                   const double                    end)
  {
    if (rows.size() < 2 || !(begin < end) || rows.back().time <= begin)
      throw ComputationError("The friction window holds no time step: it "
                             "starts at " +
                             std::to_string(begin * 1e6) + " us.");
    // The direction of the window: a chip turns back before it.
    const double way =
      rows.back().sliding_distance - rows[rows.size() - 2].sliding_distance;
    FrictionResult result;
    result.window_begin = std::max(begin, rows.front().time);
    result.window_end   = std::min(end, rows.back().time);
    result.mu_end = friction_coefficient(rows.back().T_x, rows.back().T_y, way);

    FrictionRow sum;
    double      mu = 0., mu_squared = 0.;
    for (std::size_t i = 1; i < rows.size(); ++i)
      {
        const double t0 = std::max(rows[i - 1].time, result.window_begin),
                     t1 = std::min(rows[i].time, result.window_end);
        if (t0 >= t1)
          continue;
        const FrictionRow a = interpolate(rows[i - 1], rows[i], t0),
                          b = interpolate(rows[i - 1], rows[i], t1);
        const double half   = 0.5 * (t1 - t0);
        const double mu_a   = friction_coefficient(a.T_x, a.T_y, way),
                     mu_b   = friction_coefficient(b.T_x, b.T_y, way);
        for (double FrictionRow::*const entry : averaged)
          sum.*entry += half * (a.*entry + b.*entry);
        mu += half * (mu_a + mu_b);
        mu_squared += half * (mu_a * mu_a + mu_b * mu_b);
      }
    const double duration = result.window_end - result.window_begin;
    result.T_x            = sum.T_x / duration;
    result.T_y            = sum.T_y / duration;
    result.transverse =
      sum.T_y != 0. ? sum.T_transverse / std::abs(sum.T_y) : 0.;
    result.contact_fraction = sum.contact_fraction / duration;
    result.oil_pressure     = sum.oil_pressure / duration;
    result.oil_T_x          = sum.oil_T_x / duration;
    result.shear_T_x        = sum.shear_T_x / duration;
    result.mu               = friction_coefficient(sum.T_x, sum.T_y, way);
    result.interface_T_x    = sum.interface_T_x / duration;
    result.interface_T_y    = sum.interface_T_y / duration;
    result.interface_shear =
      friction_coefficient(sum.interface_T_x, sum.T_y, way);
    result.oil_shear  = friction_coefficient(sum.shear_T_x, sum.T_y, way);
    result.ploughing  = result.mu - result.interface_shear - result.oil_shear;
    const double mean = mu / duration;
    result.spread =
      std::sqrt(std::max(0., mu_squared / duration - mean * mean));
    return result;
  }



  std::optional<double>
  share_of_tool(const std::vector<FrictionRow> &rows,
                const double                    begin,
                const double                    end)
  {
    double tool = 0., friction = 0.;
    for (std::size_t i = 1; i < rows.size(); ++i)
      {
        const double t0 = std::max(rows[i - 1].time, begin),
                     t1 = std::min(rows[i].time, end);
        if (t0 >= t1)
          continue;
        const FrictionRow a = interpolate(rows[i - 1], rows[i], t0),
                          b = interpolate(rows[i - 1], rows[i], t1);
        tool += b.tool_heat - a.tool_heat;
        friction += b.friction_heat - a.friction_heat;
      }
    return friction > 0. ? std::optional(tool / friction) : std::nullopt;
  }



  std::vector<DistanceMean>
  means_over_distance(const std::vector<FrictionRow> &all, const double window)
  {
    std::vector<DistanceMean> means;
    // A chip that slides back has left its way forward behind.
    const auto farthest =
      std::max_element(all.begin(),
                       all.end(),
                       [](const FrictionRow &a, const FrictionRow &b) {
                         return a.sliding_distance < b.sliding_distance;
                       });
    const std::vector<FrictionRow> rows(all.begin(),
                                        farthest + (farthest != all.end()));
    if (rows.size() < 2)
      return means;
    const FrictionRow &last = rows.back();
    const double       velocity =
      (last.sliding_distance - rows.front().sliding_distance) /
      (last.time - rows.front().time);
    for (unsigned int i = 0;; ++i)
      {
        const double from = i * window, to = (i + 1) * window;
        if (to > last.sliding_distance * (1. + 1e-12))
          return means;
        means.push_back(
          {from,
           to,
           average_friction(rows, from / velocity, to / velocity).mu});
      }
  }
} // namespace asperity
