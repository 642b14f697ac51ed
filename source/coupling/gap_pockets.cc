#include <asperity/base/archive.h>
#include <asperity/coupling/gap_pockets.h>

#include <algorithm>
#include <numeric>

namespace asperity
{
  GapPockets::GapPockets(const std::vector<double> &voids,
                         const double               sealing_gap)
    : sealing_gap(sealing_gap)
    , oil_(voids)
    , open_(voids.size(), true)
    , pocket_(voids.size())
  {
    number_pockets();
  }



  void
  GapPockets::open(const std::vector<double> &gaps)
  {
    for (unsigned int i = 0; i < gaps.size(); ++i)
      open_[i] = gaps[i] >= sealing_gap;
    for (const Run &run : open_runs())
      if (run.end - run.first < smallest_run)
        for (unsigned int i = run.first; i < run.end; ++i)
          open_[i % open_.size()] = false;
    number_pockets();
  }



  std::vector<GapPockets::Run>
  GapPockets::open_runs() const
  {
    // Runs begin behind closed columns; without any there is one.
    const unsigned int n = open_.size();
    std::vector<Run>   runs;
    if (std::find(open_.begin(), open_.end(), false) == open_.end())
      return {{0, n}};
    for (unsigned int i = 0; i < n; ++i)
      if (open_[i] && !open_[(i + n - 1) % n])
        {
          unsigned int end = i;
          while (open_[end % n])
            ++end;
          runs.push_back({i, end});
        }
    return runs;
  }



  void
  GapPockets::number_pockets()
  {
    n_pockets_ = 0;
    for (const Run &run : open_runs())
      {
        for (unsigned int i = run.first; i < run.end; ++i)
          pocket_[i % open_.size()] = n_pockets_;
        ++n_pockets_;
      }
  }



  void
  GapPockets::spread(const std::vector<double> &contents)
  {
    std::vector<double> sum(n_pockets_);
    for (unsigned int i = 0; i < contents.size(); ++i)
      if (open_[i])
        sum[pocket_[i]] += contents[i];
    const std::vector<double> pocket_oil = oil();
    for (unsigned int i = 0; i < contents.size(); ++i)
      if (open_[i])
        oil_[i] = pocket_oil[pocket_[i]] * contents[i] / sum[pocket_[i]];
  }



  const std::vector<bool> &
  GapPockets::is_open() const
  {
    return open_;
  }



  unsigned int
  GapPockets::n_pockets() const
  {
    return n_pockets_;
  }



  unsigned int
  GapPockets::pocket(const unsigned int column) const
  {
    return pocket_[column];
  }



  std::vector<double>
  GapPockets::oil() const
  {
    std::vector<double> sums(n_pockets_);
    for (unsigned int i = 0; i < oil_.size(); ++i)
      if (open_[i])
        sums[pocket_[i]] += oil_[i];
    return sums;
  }



  double
  GapPockets::sealed_oil() const
  {
    double sum = 0.;
    for (unsigned int i = 0; i < oil_.size(); ++i)
      if (!open_[i])
        sum += oil_[i];
    return sum;
  }



  void
  GapPockets::save(OutputArchive &archive) const
  {
    archive << oil_ << open_;
  }



  void
  GapPockets::load(InputArchive &archive)
  {
    archive >> fixed_length(oil_, "columns of oil") >>
      fixed_length(open_, "open columns of oil");
    number_pockets();
  }
} // namespace asperity
