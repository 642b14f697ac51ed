#include <asperity/lubricant/pocket_extent.h>
#include <asperity/lubricant/region_tracker.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

// Regions of a void and their oil, on grids that are drawn: a digit is the gap
// at a node, and the surfaces seal at 4.

namespace
{
  using namespace asperity;

  using Size = std::array<unsigned int, 2>;

  VoidRegions
  regions_of(const std::vector<std::string> &rows)
  {
    std::vector<double> gaps;
    for (const std::string &row : rows)
      for (const char digit : row)
        gaps.push_back(digit - '0');
    return find_regions({{unsigned(rows[0].size()), unsigned(rows.size())}},
                        gaps,
                        4.);
  }

  TEST(VoidRegions, are_connected_over_the_ends_of_the_period)
  {
    EXPECT_EQ(regions_of({"91119", "91119", "91119"}).n, 1u);
    EXPECT_EQ(regions_of({"99999", "11111", "11111", "99999"}).n, 1u);
    EXPECT_EQ(regions_of({"11111", "11111", "11111"}).n, 0u);
    EXPECT_EQ(regions_of({"11111", "11111", "11111"}).region[7],
              VoidRegions::none);
  }

  TEST(VoidRegions, go_through_where_an_open_way_leads_to_their_image)
  {
    using Through      = std::array<bool, 2>;
    const auto through = [](const std::vector<std::string> &rows) {
      const VoidRegions regions = regions_of(rows);
      return regions.n == 1 ? regions.through[0] : Through{{false, false}};
    };
    EXPECT_EQ(through({"99999", "99999"}), (Through{{true, true}}));
    EXPECT_EQ(through({"1111111", "1119111", "1111111", "1111111"}),
              (Through{{false, false}}));
    EXPECT_EQ(through({"1111111", "9999999", "1111111", "1111111"}),
              (Through{{true, false}}));
    EXPECT_EQ(through({"1191111", "1191111", "1191111", "1191111"}),
              (Through{{false, true}}));
    // over both ends of the period, but not once around
    EXPECT_EQ(through({"9911199", "1111111", "1111111", "9911199"}),
              (Through{{false, false}}));
    // around both before it meets itself
    EXPECT_EQ(through({"9111", "1911", "1191", "1119"}),
              (Through{{true, true}}));
  }

  TEST(VoidRegions, inside_of_a_ring_is_one_of_its_own)
  {
    const std::vector<std::string> ring    = {"9999999",
                                              "9111119",
                                              "9122219",
                                              "9129219",
                                              "9122219",
                                              "9111119",
                                              "9999999"};
    const VoidRegions              regions = regions_of(ring);
    ASSERT_EQ(regions.n, 2u);
    // The four elements at the node in the middle; up to the tightest ring the
    // sealed ones are theirs.
    for (const unsigned int e : {16, 17, 23, 24})
      EXPECT_EQ(regions.region[e], 1u);
    EXPECT_TRUE(regions.open[16]);
    EXPECT_EQ(regions.region[0], 0u);
    EXPECT_EQ(regions.region[7], 0u);
    EXPECT_EQ(regions.region[8], 1u);
    std::vector<std::string> broken = ring;
    broken[5][3] = broken[4][3] = '5';
    EXPECT_EQ(regions_of(broken).n, 1u);
  }

  TEST(VoidRegions, of_an_extruded_gap_are_the_intervals_of_a_profile)
  {
    const std::string         row = "97312469843218";
    std::vector<double>       parameters, gaps;
    const std::vector<double> periods = {14.};
    for (unsigned int i = 0; i < row.size(); ++i)
      {
        parameters.push_back(i);
        gaps.push_back(row[i] - '0');
      }
    const auto        pockets = find_pockets(parameters, gaps, 14., 4.);
    const VoidRegions regions = regions_of({row, row, row});
    ASSERT_EQ(pockets.size(), 2u);
    ASSERT_EQ(regions.n, 2u);
    const unsigned int first = pocket_at(pockets, 0.5, 14.);
    for (unsigned int e = 0; e < 14; ++e)
      for (const unsigned int across : {0, 1, 2})
        EXPECT_EQ(regions.region[e + 14 * across] == 0,
                  pocket_at(pockets, e + 0.5, 14.) == first)
          << e;
  }

  /** Regions in steps, each with as many elements as volume. */
  class RegionsOfOil : public testing::Test
  {
  protected:
    void
    step(const std::vector<std::string> &rows,
         const std::vector<double>      &pressures = {})
    {
      const VoidRegions   next = regions_of(rows);
      std::vector<double> volumes(next.n, 0.);
      for (unsigned int e = 0; e < next.region.size(); ++e)
        if (next.n > 0)
          volumes[next.region[e]] += 1.;
      tracker.update(next, volumes, pressures);
    }

    double
    mass() const
    {
      double sum = tracker.sealed_mass();
      for (const auto &region : tracker.regions())
        sum += region.mass;
      return sum;
    }

    RegionTracker tracker{Size{{8, 3}}};
  };

  TEST_F(RegionsOfOil, merge_and_split_by_their_volumes)
  {
    step({"91911111", "91911111", "91911111"});
    ASSERT_EQ(tracker.regions().size(), 2u);
    tracker.set_masses({3., 5.});
    const std::string a = tracker.regions()[0].name,
                      b = tracker.regions()[1].name;
    step({"91911111", "99911111", "91911111"}, {1., 2.});
    ASSERT_EQ(tracker.regions().size(), 1u);
    EXPECT_EQ(tracker.regions()[0].mass, 8.);
    ASSERT_EQ(tracker.events().size(), 1u);
    EXPECT_EQ(tracker.events()[0].kind, PocketEventKind::merged);
    step({"91911111", "91911111", "91911111"}, {1.});
    ASSERT_EQ(tracker.regions().size(), 2u);
    EXPECT_NEAR(mass(), 8., 1e-15);
    EXPECT_GT(tracker.regions()[0].mass, 0.);
    EXPECT_GT(tracker.regions()[1].mass, 0.);
    EXPECT_EQ(tracker.events().back().kind, PocketEventKind::split);
  }

  TEST_F(RegionsOfOil, leak_where_the_pressure_is_lowest_when_they_close)
  {
    for (const bool left : {true, false})
      {
        tracker = RegionTracker(Size{{8, 3}});
        step({"91111191", "91191191", "91111191"});
        ASSERT_EQ(tracker.regions().size(), 3u);
        tracker.set_masses({1., 2., 4.});
        const VoidRegions  before = tracker.places();
        const unsigned int closed = before.region[3],
                           other  = before.region[left ? 0 : 5];
        std::vector<double> pressures(3, 7.);
        pressures[other]       = 5.;
        const std::string name = tracker.regions()[other].name;
        const double      sum =
          tracker.regions()[closed].mass + tracker.regions()[other].mass;
        step({"91111191", "91111191", "91111191"}, pressures);
        ASSERT_EQ(tracker.regions().size(), 2u);
        EXPECT_EQ(tracker.events()[0].kind, PocketEventKind::closed);
        EXPECT_EQ(tracker.events()[0].other, name);
        const unsigned int heir = tracker.regions()[0].name == name ? 0 : 1;
        EXPECT_EQ(tracker.regions()[heir].name, name);
        EXPECT_EQ(tracker.regions()[heir].mass, sum);
      }
  }

  TEST_F(RegionsOfOil, keep_it_where_everything_is_sealed)
  {
    step({"91911111", "91911111", "91911111"});
    tracker.set_masses({3., 5.});
    step({"11111111", "11111111", "11111111"}, {1., 2.});
    EXPECT_EQ(tracker.sealed_mass(), 8.);
    step({"11111111", "11191111", "11111111"}, {});
    ASSERT_EQ(tracker.regions().size(), 1u);
    EXPECT_EQ(tracker.regions()[0].mass, 8.);
    EXPECT_EQ(tracker.sealed_mass(), 0.);
  }
} // namespace
