#include <asperity/postprocess/field_picture.h>
#include <asperity/postprocess/vtu_series.h>

#include <cstdlib>
#include <filesystem>

#include "../files.h"
#include "../postprocess/field_examples.h"

using namespace asperity;

// tools/plot_fields.py, with the pictures that 'asperity field' and a run leave
// behind.

namespace
{
  void
  write_pictures(const std::string &folder, const double time)
  {
    std::filesystem::create_directories(folder);
    const FieldSnapshots run = two_cells();
    const FieldMoment    moment{time, 0.1, 3};
    const auto          &values = run.snapshots[0].values;
    VtuSeries(folder, "chip").write(3, time, [&](std::ostream &out) {
      write_chip_fields(out, run, values, moment);
    });
    VtuSeries(folder, "contact").write(3, time, [&](std::ostream &out) {
      write_edge_fields(out, run, values, moment);
    });
  }

  /** Exit status; what it says is in `said`. */
  int
  run(const std::string &command, const std::string &said = "/dev/null")
  {
    return WEXITSTATUS(std::system((command + " > " + said + " 2>&1").c_str()));
  }
} // namespace

TEST(PlotFields, lays_decoded_fields_beside_those_of_a_run)
{
  // without the second that importing it takes
  if (run("/usr/bin/python3 -c 'from importlib.util import find_spec; "
          "exit(not (find_spec(\"matplotlib\") and find_spec(\"numpy\")))'") !=
      0)
    GTEST_SKIP() << "matplotlib is not installed";
  const std::string folder = test_folder(), said = folder + "/said.txt",
                    script = ASPERITY_SOURCE_DIR "/tools/plot_fields.py " +
                             folder + "/decoded " + folder;
  write_pictures(folder + "/decoded", 0.5);
  write_pictures(folder + "/run", 0.5);
  write_pictures(folder + "/late", 0.6);
  ASSERT_EQ(run(script + "/run", said), 0) << content(said);
  EXPECT_NE(content(said).find("contact pressure: difference 0 %"),
            std::string::npos)
    << content(said);
  const std::string picture = content(folder + "/decoded/learned_fields.png");
  EXPECT_EQ(picture.substr(1, 3), "PNG");
  EXPECT_GT(picture.size(), 15000u);
  EXPECT_EQ(run(script + "/late", said), 2);
  EXPECT_NE(content(said).find("has no picture of the contact at 0.5 s; the "
                               "nearest one is at 0.6 s."),
            std::string::npos)
    << content(said);
}
