#include <asperity/base/archive.h>
#include <asperity/coupling/gap_pockets.h>

#include <algorithm>
#include <numeric>

namespace asperity
{
  GapPockets::GapPockets(const std::vector<double> &oil,
                         const double               sealing_gap)
    : sealing_gap(sealing_gap)
    , oil_(oil)
    , open_(oil.size(), true)
    , flowing(oil.size(), true)
    , pocket_(oil.size())
    , neighbour(oil.size())
    , full(1, true)
  {
    std::iota(neighbour.begin(), neighbour.end(), 0);
  }



  void
  GapPockets::open(const std::vector<double> &gaps,
                   const std::vector<double> &voids)
  {
    const unsigned int n = open_.size();
    for (unsigned int i = 0; i < n; ++i)
      open_[i] = gaps[i] >= sealing_gap;
    for (const Run &run : open_runs())
      if (run.end - run.first < smallest_run)
        for (unsigned int i = run.first; i < run.end; ++i)
          open_[i % n] = false;
    number_pockets(gaps);
    std::vector<double> room(full.size());
    for (unsigned int i = 0; i < n; ++i)
      if (pocket_[i] != none)
        room[pocket_[i]] += voids[i];
    const std::vector<double> amounts = oil();
    for (unsigned int k = 0; k < full.size(); ++k)
      full[k] = amounts[k] >= (1. - slack) * room[k];
    for (unsigned int i = 0; i < n; ++i)
      flowing[i] = open_[i] && full[pocket_[i]];
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
  GapPockets::number_pockets(const std::vector<double> &gaps)
  {
    const unsigned int     n    = open_.size();
    const std::vector<Run> runs = open_runs();
    full.assign(runs.size(), true);
    pocket_.assign(n, none);
    neighbour.assign(n, none);
    const auto belongs =
      [&](const unsigned int i, const unsigned int k, const unsigned int to) {
        pocket_[i % n]   = k;
        neighbour[i % n] = to % n;
      };
    for (unsigned int k = 0; k < runs.size(); ++k)
      {
        for (unsigned int i = runs[k].first; i < runs[k].end; ++i)
          belongs(i, k, i);
        // The seal behind the run, up to its narrowest column and beyond.
        const unsigned int next = (k + 1) % runs.size();
        unsigned int       end  = runs[k].end;
        while (!open_[end % n])
          ++end;
        unsigned int narrowest = runs[k].end;
        for (unsigned int i = narrowest; i < end; ++i)
          if (gaps[i % n] < gaps[narrowest % n])
            narrowest = i;
        for (unsigned int i = runs[k].end; i < end; ++i)
          if (i <= narrowest)
            belongs(i, k, runs[k].end - 1);
          else
            belongs(i, next, runs[next].first);
      }
  }



  void
  GapPockets::spread(const std::vector<double> &contents)
  {
    std::vector<double> sum(full.size());
    for (unsigned int i = 0; i < contents.size(); ++i)
      if (pocket_[i] != none)
        sum[pocket_[i]] += contents[i];
    const std::vector<double> amounts = oil();
    for (unsigned int i = 0; i < contents.size(); ++i)
      if (pocket_[i] != none)
        oil_[i] = amounts[pocket_[i]] * contents[i] / sum[pocket_[i]];
  }



  const std::vector<bool> &
  GapPockets::is_flowing() const
  {
    return flowing;
  }



  unsigned int
  GapPockets::n_pockets() const
  {
    return full.size();
  }



  unsigned int
  GapPockets::pocket(const unsigned int column) const
  {
    return pocket_[column];
  }



  unsigned int
  GapPockets::open_neighbour(const unsigned int column) const
  {
    return neighbour[column];
  }



  bool
  GapPockets::is_full(const unsigned int pocket) const
  {
    return full[pocket];
  }



  std::vector<double>
  GapPockets::oil() const
  {
    std::vector<double> sums(full.size());
    for (unsigned int i = 0; i < oil_.size(); ++i)
      if (pocket_[i] != none)
        sums[pocket_[i]] += oil_[i];
    return sums;
  }



  const std::vector<double> &
  GapPockets::amounts() const
  {
    return oil_;
  }



  double
  GapPockets::total() const
  {
    return std::accumulate(oil_.begin(), oil_.end(), 0.);
  }



  void
  GapPockets::save(OutputArchive &archive) const
  {
    archive << oil_ << open_ << flowing << pocket_ << neighbour << full;
  }



  void
  GapPockets::load(InputArchive &archive)
  {
    archive >> fixed_length(oil_, "columns of oil") >>
      fixed_length(open_, "open columns of oil") >>
      fixed_length(flowing, "columns that oil flows in") >>
      fixed_length(pocket_, "pockets of columns") >>
      fixed_length(neighbour, "neighbours of columns") >> full;
  }
} // namespace asperity
