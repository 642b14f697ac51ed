#include "treatment_warnings.h"

#include <asperity/base/quantity.h>
#include <asperity/base/text.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    /** Half of it is the way of the profile's ends, over peak to valley. On
     *  waves, a step and self-affine profiles errors of 10 % begin at 16. */
    constexpr double large_trend = 0.12;

    /** Jump between the ends of a profile over the rise of its trend, where the
     *  trend is none of the surface: 3 to 11 % on those. */
    constexpr double ends_that_meet = 0.2;

    void
    warn_of_spikes(TopographyReport &report)
    {
      if (report.spikes.heights.empty())
        return;
      const auto found =
        extract_profile(crop(report.spikes, report.window), report.line)
          .heights;
      const auto n =
        std::count_if(found.begin(), found.end(), [](const double z) {
          return std::isnan(z);
        });
      if (n > 0)
        report.warnings.push_back(
          "Spike threshold = 0 leaves " + std::to_string(n) +
          (n == 1 ? " point" : " points") + " in the profile that " +
          (n == 1 ? "stands" : "stand") +
          " out of the neighbours by more than " +
          format_number(usual_spike_threshold) +
          " robust standard deviations, as errors of the instrument do, and the "
          "tool gets a peak that no surface had; expected is 8, unless these are "
          "the surface itself.");
    }

    void
    warn_of_trend(TopographyReport &report)
    {
      const ContinuationReport  &c = report.continuation;
      const std::vector<double> &z = report.measured.heights;
      const auto [low, high]       = std::minmax_element(z.begin(), z.end());
      const double rise            = c.removed_trend * report.measured.length(),
                   part            = std::abs(rise) / (*high - *low);
      if (part > large_trend &&
          std::abs(c.jump_before) < ends_that_meet * std::abs(rise))
        report.warnings.push_back(
          "The periodic continuation tilts the profile by " +
          format_quantity(std::abs(rise), "nm", 3) + " over its length, " +
          format_quantity(100. * part, "1", 2) +
          " % of peak to valley, although its ends meet without (a jump of " +
          format_quantity(std::abs(c.jump_before), "nm", 2) + " instead of " +
          format_quantity(std::abs(c.jump_before - rise), "nm", 2) +
          "); expected is a piece without a trend, or Periodic continuation = none where "
          "the profile is periodic already.");
    }
  } // namespace

  HeightMap
  mark_spikes(const HeightMap &map)
  {
    if (map.ny == 1 || map.n_valid() < smallest_map_with_spikes)
      return {};
    HeightMap         marked = map;
    const std::size_t n      = remove_spikes(marked, usual_spike_threshold);
    if (n == 0 || n > largest_spike_fraction * map.n_valid())
      return {};
    for (std::size_t i = 0; i < map.heights.size(); ++i)
      marked.heights[i] =
        std::isnan(marked.heights[i]) && !std::isnan(map.heights[i]) ?
          missing_height :
          0.;
    return marked;
  }

  void
  warn_of_treatment(TopographyReport &report)
  {
    warn_of_spikes(report);
    warn_of_trend(report);
  }
} // namespace asperity
