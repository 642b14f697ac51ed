#include <asperity/base/archive.h>
#include <asperity/lubricant/pocket_tracker.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{
  using namespace asperity;

  constexpr double S = 10.;

  /** Pockets of a gap that is 1 in the given open intervals and 0 between
   *  them, sealed below 0.5, each with its length as volume. Neighbours meet in
   *  the middle of the seal. */
  std::vector<PocketExtent>
  script(const std::vector<PeriodicInterval> &open)
  {
    std::vector<PocketExtent> pockets;
    for (unsigned int i = 0; i < open.size(); ++i)
      {
        const unsigned int n         = open.size();
        const auto        &before    = open[(i + n - 1) % n];
        const auto        &after     = open[(i + 1) % n];
        double             left_seal = open[i].begin - before.end;
        if (left_seal < 0.)
          left_seal += S;
        double right_seal = after.begin - open[i].end;
        if (right_seal < 0.)
          right_seal += S;
        double       begin = open[i].begin - 0.5 * left_seal;
        const double end   = open[i].end + 0.5 * right_seal;
        const double turn  = begin < 0. ? S : 0.;
        pockets.push_back({open[i], {begin + turn, end + turn}});
      }
    std::sort(pockets.begin(), pockets.end(), [](const auto &a, const auto &b) {
      return a.domain.begin < b.domain.begin;
    });
    return pockets;
  }



  void
  step(PocketTracker                       &tracker,
       const std::vector<PeriodicInterval> &open,
       const std::map<std::string, double> &pressures = {})
  {
    const auto          pockets = script(open);
    std::vector<double> volumes, old_pressures;
    for (const PocketExtent &pocket : pockets)
      volumes.push_back(pocket.open.length());
    for (const Pocket &pocket : tracker.pockets())
      old_pressures.push_back(
        pressures.count(pocket.name) ? pressures.at(pocket.name) : 0.);
    tracker.update(pockets, volumes, old_pressures);
  }



  double
  total_mass(const PocketTracker &tracker)
  {
    double sum = tracker.sealed_mass();
    for (const Pocket &pocket : tracker.pockets())
      sum += pocket.mass;
    return sum;
  }



  /** Names and masses, as "A 3, B 1.5". */
  std::string
  content(const PocketTracker &tracker)
  {
    std::string text;
    for (const Pocket &pocket : tracker.pockets())
      {
        std::ostringstream mass;
        mass << pocket.mass;
        text += (text.empty() ? "" : ", ") + pocket.name + " " + mass.str();
      }
    return text;
  }



  std::string
  news(const PocketTracker &tracker)
  {
    std::string text;
    for (const PocketEvent &event : tracker.events())
      text += (text.empty() ? "" : "; ") + to_string(event);
    return text;
  }



  /** A on [1, 3] with 2 kg/m, B on [4, 6] with 3, C on [7, 9] with 5. */
  PocketTracker
  three_pockets()
  {
    PocketTracker tracker(S);
    step(tracker, {{1., 3.}, {4., 6.}, {7., 9.}});
    tracker.set_masses({2., 3., 5.});
    return tracker;
  }
} // namespace



TEST(PocketTracker, merging_adds_masses_under_the_name_of_the_larger_part)
{
  PocketTracker tracker = three_pockets();
  EXPECT_EQ(content(tracker), "A 2, B 3, C 5");
  step(tracker, {{1., 3.}, {3.9, 9.}});
  // B overlaps the new pocket by 2, as C does: the first of equals goes on
  EXPECT_EQ(content(tracker), "A 2, B 8");
  EXPECT_EQ(news(tracker), "step 2: pocket C has become part of B");
  step(tracker, {{0., 10.}});
  EXPECT_EQ(content(tracker), "B 10");
  EXPECT_EQ(news(tracker), "step 3: pocket A has become part of B");
}



TEST(PocketTracker, splitting_distributes_by_volume)
{
  PocketTracker tracker = three_pockets();
  step(tracker, {{1., 3.}, {4., 6.}, {7., 7.4}, {7.5, 9.1}});
  // 0.4 and 1.6 of C's mass of 5
  EXPECT_EQ(content(tracker), "A 2, B 3, D 1, C 4");
  EXPECT_EQ(news(tracker), "step 2: pocket D has split from C");
  step(tracker, {{1., 3.}, {4., 6.}, {7., 9.1}});
  EXPECT_EQ(content(tracker), "A 2, B 3, C 5");
  step(tracker, {{1., 3.}, {4., 6.}, {7., 7.4}, {7.5, 9.1}});
  // a name is never used again
  EXPECT_EQ(content(tracker), "A 2, B 3, E 1, C 4");
}



TEST(PocketTracker, a_closed_pocket_leaks_to_the_lower_pressure)
{
  for (const bool left_is_lower : {true, false})
    {
      PocketTracker tracker = three_pockets();
      step(tracker,
           {{1., 3.}, {7., 9.}},
           {{"A", left_is_lower ? 1. : 9.}, {"B", 100.}, {"C", 5.}});
      EXPECT_EQ(content(tracker), left_is_lower ? "A 5, C 5" : "A 2, C 8");
      EXPECT_EQ(news(tracker),
                std::string("step 2: pocket B has closed, its oil is in ") +
                  (left_is_lower ? "A" : "C"));
    }
  // C's neighbours are B and, around the period, A
  PocketTracker tracker = three_pockets();
  step(tracker, {{1., 3.}, {4., 6.}}, {{"A", 1.}, {"B", 2.}, {"C", 3.}});
  EXPECT_EQ(content(tracker), "B 3, A 7");
}



TEST(PocketTracker, where_everything_closes_the_oil_stays_and_comes_back)
{
  PocketTracker tracker = three_pockets();
  step(tracker, {});
  EXPECT_EQ(content(tracker), "");
  EXPECT_EQ(tracker.sealed_mass(), 10.);
  EXPECT_EQ(total_mass(tracker), 10.);
  EXPECT_EQ(tracker.events().size(), 3u);
  step(tracker, {});
  step(tracker, {{2., 3.}, {5., 8.}});
  EXPECT_EQ(content(tracker), "D 2.5, E 7.5");
  EXPECT_EQ(tracker.sealed_mass(), 0.);
  EXPECT_EQ(news(tracker),
            "step 4: pocket D has opened; step 4: pocket E has opened");
}



TEST(PocketTracker, new_pockets_are_empty)
{
  PocketTracker tracker = three_pockets();
  step(tracker, {{1., 3.}, {3.2, 3.8}, {4., 6.}, {7., 9.}});
  EXPECT_EQ(content(tracker), "A 2, D 0, B 3, C 5");
  EXPECT_EQ(news(tracker), "step 2: pocket D has opened");
}



TEST(PocketTracker, names_travel_with_the_pockets_around_the_period)
{
  // Steps of 0.25 are more than the width of the seals, 0.1.
  PocketTracker tracker(S);
  for (unsigned int k = 0; k <= 80; ++k)
    {
      std::vector<PeriodicInterval> open;
      for (const auto &[begin, end] :
           {std::pair{0., 4.9}, {5., 7.9}, {8., 9.9}})
        {
          const double first_turn = std::fmod(begin + .25 * k, S);
          open.push_back({first_turn, first_turn + (end - begin)});
        }
      step(tracker, open);
      if (k == 0)
        tracker.set_masses({2., 3., 5.});
      else
        EXPECT_EQ(news(tracker), "");
    }
  // Two turns later they are where they were; the first one wraps around.
  EXPECT_EQ(content(tracker), "A 2, B 3, C 5");
  EXPECT_EQ(tracker.pockets()[0].extent.open.begin, 5.);
}



TEST(PocketTracker, a_small_pocket_may_move_by_more_than_its_width)
{
  PocketTracker tracker(S);
  step(tracker, {{1., 3.}, {4., 4.1}, {7., 9.}});
  tracker.set_masses({2., .125, 5.});
  step(tracker, {{1., 3.}, {4.2, 4.3}, {7., 9.}});
  EXPECT_EQ(content(tracker), "A 2, B 0.125, C 5");
  EXPECT_EQ(news(tracker), "");
}



TEST(PocketTracker, goes_on_from_its_state)
{
  PocketTracker tracker = three_pockets();
  step(tracker, {{1., 3.}, {4., 6.}, {7., 7.5}, {7.6, 9.}});
  PocketTracker     other(S);
  const std::string bytes =
    to_bytes([&](OutputArchive &archive) { archive << tracker; });
  from_bytes(bytes, "the pockets", [&](InputArchive &archive) {
    archive >> other;
  });
  for (PocketTracker *each : {&tracker, &other})
    step(*each, {{1., 2.1}, {2.2, 3.}, {7., 9.}});
  EXPECT_EQ(content(other), content(tracker));
  EXPECT_EQ(news(other), news(tracker));
}



namespace
{
  /** Random harmonics that slide against each other while the distance goes up
   *  and down, now and then to where all is closed or nothing. */
  struct RandomGap
  {
    std::mt19937                           random;
    std::uniform_real_distribution<double> uniform{0., 1.};
    double                                 phases[2][8];

    explicit RandomGap(const unsigned int seed)
      : random(seed)
    {
      for (auto &surface : phases)
        for (double &phase : surface)
          phase = 2. * M_PI * uniform(random);
    }

    std::vector<PocketExtent>
    pockets(const unsigned int step)
    {
      std::vector<double> s, gaps;
      const double        distance = 3. * std::sin(.2 * step);
      for (unsigned int i = 0; i < 100; ++i)
        {
          s.push_back(S * i / 100.);
          double gap = distance + .1 * uniform(random);
          for (unsigned int k = 1; k <= 8; ++k)
            for (const double slip : {0., .05 * step})
              gap += std::cos(2. * M_PI * k * (s[i] - slip) / S +
                              phases[slip > 0.][k - 1]) /
                     k;
          gaps.push_back(gap);
        }
      return find_pockets(s, gaps, S, .3);
    }
  };



  /** Every pocket that is new or gone has its event, with names never used
   *  before. */
  void
  check_names(const std::set<std::string> &before,
              const PocketTracker         &tracker,
              std::set<std::string>       &ever)
  {
    std::set<std::string> expected = before, now;
    for (const PocketEvent &event : tracker.events())
      if (event.kind == PocketEventKind::opened ||
          event.kind == PocketEventKind::split)
        {
          EXPECT_TRUE(ever.insert(event.pocket).second) << event.pocket;
          expected.insert(event.pocket);
        }
      else
        EXPECT_EQ(expected.erase(event.pocket), 1u) << event.pocket;
    for (const Pocket &pocket : tracker.pockets())
      EXPECT_TRUE(now.insert(pocket.name).second) << pocket.name;
    EXPECT_EQ(now, expected);
  }
} // namespace



TEST(PocketTracker, random_histories_conserve_mass_and_names)
{
  unsigned int n_events = 0, n_sealed = 0;
  for (unsigned int seed = 0; seed < 5; ++seed)
    {
      RandomGap             gap(seed);
      PocketTracker         tracker(S);
      std::set<std::string> ever;
      double                total = 0.;
      for (unsigned int k = 0; k < 500; ++k)
        {
          std::set<std::string> before;
          std::vector<double>   pressures, volumes, masses;
          for (const Pocket &pocket : tracker.pockets())
            {
              before.insert(pocket.name);
              pressures.push_back(gap.uniform(gap.random));
            }
          const auto pockets = gap.pockets(k);
          for (const PocketExtent &pocket : pockets)
            volumes.push_back(pocket.open.length() * gap.uniform(gap.random));
          tracker.update(pockets, volumes, pressures);
          check_names(before, tracker, ever);
          n_events += tracker.events().size();
          if (k < 50 && !pockets.empty()) // filled anew for a while
            {
              for (unsigned int i = 0; i < pockets.size(); ++i)
                masses.push_back(1e-9 * gap.uniform(gap.random));
              tracker.set_masses(masses);
              total = total_mass(tracker);
            }
          EXPECT_EQ(total_mass(tracker), total);
          n_sealed += tracker.sealed_mass() > 0.;
          for (const Pocket &pocket : tracker.pockets())
            EXPECT_GE(pocket.mass, 0.);
        }
    }
  // The histories are worth it.
  EXPECT_GT(n_events, 1000u);
  EXPECT_GT(n_sealed, 0u);
}
