#ifndef asperity_campaign_campaign_report_h
#define asperity_campaign_campaign_report_h

#include <asperity/campaign/campaign.h>

#include <iosfwd>

namespace asperity
{
  /**
   * What a campaign ends with, in its output directory: `friction_law.json`,
   * `history.csv`, `sensitivity.csv`, `summary.json`, the folder `export`, and
   * a page for people on @p out.
   * @param wall_time of this session [s]
   */
  void
  report_campaign(const CampaignParameters &parameters,
                  const Campaign           &campaign,
                  const double              wall_time,
                  std::ostream             &out);
} // namespace asperity

#endif
