#include <asperity/campaign/profile_scatter.h>

#include <cmath>
#include <numeric>

namespace asperity
{
  ProfileScatter::ProfileScatter(const unsigned int n_profiles)
    : n_profiles(n_profiles)
  {}



  void
  ProfileScatter::add(const std::vector<double> &values)
  {
    const double mean =
      std::accumulate(values.begin(), values.end(), 0.) / values.size();
    if (mean == 0.)
      return;
    std::vector<double> row;
    for (const double value : values)
      row.push_back(value / mean - 1.);
    deviations.push_back(row);
  }



  double
  ProfileScatter::total() const
  {
    if (deviations.empty() || n_profiles < 2)
      return 0.;
    double sum = 0.;
    for (const std::vector<double> &row : deviations)
      for (const double deviation : row)
        sum += deviation * deviation;
    return std::sqrt(sum / (deviations.size() * (n_profiles - 1.)));
  }



  double
  ProfileScatter::beyond_factor() const
  {
    if (deviations.size() < 2 || n_profiles < 2)
      return total(); // one point does not tell both parts
    double sum = 0.;
    for (unsigned int k = 0; k < n_profiles; ++k)
      {
        const double b_k = factor(k) - 1.;
        for (const std::vector<double> &row : deviations)
          sum += (row[k] - b_k) * (row[k] - b_k);
      }
    return std::sqrt(sum / ((deviations.size() - 1.) * (n_profiles - 1.)));
  }



  double
  ProfileScatter::factor(const unsigned int profile) const
  {
    double sum = 0.;
    for (const std::vector<double> &row : deviations)
      sum += row[profile];
    return deviations.empty() ? 1. : 1. + sum / deviations.size();
  }



  std::optional<ProfileMean>
  ProfileScatter::mean(const std::vector<std::optional<double>> &values) const
  {
    double n = 0., sum = 0., sum_of_factors = 0.;
    for (unsigned int k = 0; k < n_profiles; ++k)
      if (values[k])
        {
          n += 1.;
          sum += *values[k];
          sum_of_factors += factor(k);
        }
    if (n == n_profiles)
      return ProfileMean{sum / n, 0.};
    if (n == 0. || deviations.empty())
      return {};
    const double mean = sum / sum_of_factors;
    return ProfileMean{mean,
                       std::abs(mean) * beyond_factor() *
                         std::sqrt(n * (1. - n / n_profiles)) / sum_of_factors};
  }
} // namespace asperity
