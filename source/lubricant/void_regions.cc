#include <asperity/lubricant/void_regions.h>

#include <algorithm>
#include <numeric>

namespace asperity
{
  namespace
  {
    /** Elements that are united, each with one of them that stands for all. */
    class UnitedElements
    {
    public:
      explicit UnitedElements(const unsigned int n)
        : parent(n)
      {
        std::iota(parent.begin(), parent.end(), 0u);
      }

      unsigned int
      head(unsigned int e)
      {
        while (parent[e] != e)
          e = parent[e] = parent[parent[e]];
        return e;
      }

      void
      unite(const unsigned int a, const unsigned int b)
      {
        parent[head(b)] = head(a);
      }

    private:
      std::vector<unsigned int> parent;
    };

    /** Where two elements meet. */
    struct Passage
    {
      double                      gap; ///< the larger one of its ends [m]
      std::array<unsigned int, 2> elements;
      unsigned int                direction; ///< from the first to the second
    };

    /** A periodic grid of elements and their nodes. */
    struct Grid
    {
      const std::array<unsigned int, 2> &size;

      /** The one that is so many further along x and y. */
      unsigned int
      beyond(const unsigned int e,
             const unsigned int along_x,
             const unsigned int along_y) const
      {
        return (e % size[0] + along_x) % size[0] +
               (e / size[0] + along_y) % size[1] * size[0];
      }

      unsigned int
      n() const
      {
        return size[0] * size[1];
      }
    };

    std::vector<Passage>
    passages(const Grid &grid, const std::vector<double> &gaps)
    {
      std::vector<Passage> all;
      for (unsigned int e = 0; e < grid.n(); ++e)
        {
          const unsigned int right = grid.beyond(e, 1, 0),
                             back  = grid.beyond(e, 0, 1),
                             far   = grid.beyond(e, 1, 1);
          all.push_back({std::max(gaps[right], gaps[far]), {{e, right}}, 0});
          all.push_back({std::max(gaps[back], gaps[far]), {{e, back}}, 1});
        }
      return all;
    }

    /** Which regions go through the period, along x and y. */
    class WaysThrough
    {
    public:
      WaysThrough(const Grid                 &grid,
                  const VoidRegions          &regions,
                  const std::vector<Passage> &passages,
                  const double                sealing_gap)
        : found(regions.n, {{false, false}})
        , regions(regions)
        , steps(grid.n())
        , turns(grid.n())
        , is_reached(grid.n(), 0)
      {
        for (const Passage &passage : passages)
          if (passage.gap > sealing_gap)
            {
              const auto        &e    = passage.elements;
              const unsigned int d    = passage.direction;
              const unsigned int n    = grid.size[d];
              const unsigned int i    = d == 0 ? e[0] % n : e[0] / grid.size[0];
              const int          turn = i + 1 == n ? 1 : 0;
              steps[e[0]].push_back({e[1], d, turn});
              steps[e[1]].push_back({e[0], d, -turn});
            }
        for (unsigned int e = 0; e < grid.n(); ++e)
          if (regions.open[e] && !is_reached[e])
            walk(e);
      }

      std::vector<std::array<bool, 2>> found;

    private:
      struct Step
      {
        unsigned int to, direction;
        int          turn; ///< into another period, 1, 0 or -1
      };

      /** To all that is open around an element. One that is reached in another
       *  period than before is its own image. */
      void
      walk(const unsigned int begin)
      {
        std::vector<unsigned int> reached = {begin};
        is_reached[begin]                 = 1;
        for (std::size_t k = 0; k < reached.size(); ++k)
          for (const Step &step : steps[reached[k]])
            {
              std::array<int, 2> at = turns[reached[k]];
              at[step.direction] += step.turn;
              if (!is_reached[step.to])
                {
                  is_reached[step.to] = 1;
                  turns[step.to]      = at;
                  reached.push_back(step.to);
                }
              for (unsigned int d = 0; d < 2; ++d)
                if (turns[step.to][d] != at[d])
                  found[regions.region[begin]][d] = true;
            }
      }

      const VoidRegions              &regions;
      std::vector<std::vector<Step>>  steps; ///< of each element
      std::vector<std::array<int, 2>> turns; ///< periods from where it began
      std::vector<char>               is_reached;
    };
  } // namespace



  VoidRegions
  find_regions(const std::array<unsigned int, 2> &size,
               const std::vector<double>         &gaps,
               const double                       sealing_gap)
  {
    const Grid     grid{size};
    UnitedElements united(grid.n());
    VoidRegions    regions;
    regions.region.assign(grid.n(), VoidRegions::none);
    regions.open.assign(grid.n(), 0);
    for (unsigned int e = 0; e < grid.n(); ++e)
      for (const unsigned int along_x : {0, 1})
        for (const unsigned int along_y : {0, 1})
          if (gaps[grid.beyond(e, along_x, along_y)] > sealing_gap)
            regions.open[e] = 1;
    std::vector<Passage> all = passages(grid, gaps);
    std::stable_sort(all.begin(),
                     all.end(),
                     [](const Passage &a, const Passage &b) {
                       return a.gap > b.gap;
                     });
    // Whether what is united has an open element already.
    std::vector<char> has_open = regions.open;
    for (const Passage &passage : all)
      {
        const unsigned int a = united.head(passage.elements[0]),
                           b = united.head(passage.elements[1]);
        if (a == b ||
            (passage.gap <= sealing_gap && has_open[a] && has_open[b]))
          continue;
        united.unite(a, b);
        has_open[a] = has_open[a] || has_open[b];
      }
    std::vector<unsigned int> number(grid.n(), VoidRegions::none);
    for (unsigned int e = 0; e < grid.n(); ++e)
      {
        const unsigned int head = united.head(e);
        if (!has_open[head])
          continue;
        if (number[head] == VoidRegions::none)
          number[head] = regions.n++;
        regions.region[e] = number[head];
      }
    regions.through = WaysThrough(grid, regions, all, sealing_gap).found;
    return regions;
  }
} // namespace asperity
