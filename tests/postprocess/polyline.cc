#include <asperity/base/errors.h>
#include <asperity/postprocess/polyline.h>
#include <asperity/postprocess/vtu_series.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "../files.h"
#include "vtu_reader.h"

using namespace asperity;

namespace
{
  /** A quarter circle of radius 3 um with its normals. */
  Polyline
  quarter_circle(const unsigned int n)
  {
    Polyline line;
    line.vectors.resize(1);
    line.vectors[0].first = "traction [Pa]";
    line.scalars.resize(1);
    line.scalars[0].first = "contact pressure [Pa]";
    for (unsigned int i = 0; i < n; ++i)
      {
        const double               angle = M_PI / 2. * i / (n - 1);
        const dealii::Tensor<1, 2> normal({std::cos(angle), std::sin(angle)});
        line.points.emplace_back(3e-6 * normal);
        line.vectors[0].second.push_back(-2e9 * normal);
        line.scalars[0].second.push_back(1e9 * i);
      }
    return line;
  }

  std::string
  written(const Polyline &line)
  {
    std::ostringstream out;
    write_polyline(out, line, 2.5e-7, 12);
    return out.str();
  }
} // namespace



TEST(Polyline, points_and_fields_read_back)
{
  const VtuReader file(written(quarter_circle(11)));
  ASSERT_EQ(file.n_points, 11u);
  EXPECT_EQ(file.n_cells, 10u);
  EXPECT_NEAR(file.time(), 2.5e-7, 1e-13);
  const auto points   = file.points();
  const auto traction = file.field("traction [Pa]");
  const auto pressure = file.field("contact pressure [Pa]");
  const auto segments = file.connectivity();
  ASSERT_EQ(points.size(), 33u);
  ASSERT_EQ(traction.size(), 33u);
  ASSERT_EQ(pressure.size(), 11u);
  for (unsigned int i = 0; i < 11; ++i)
    {
      EXPECT_NEAR(std::hypot(points[3 * i], points[3 * i + 1]), 3e-6, 1e-12);
      EXPECT_EQ(points[3 * i + 2], 0.f);
      EXPECT_NEAR(traction[3 * i] * 3e-6, -2e9 * points[3 * i], 1e-2);
      EXPECT_NEAR(traction[3 * i + 1] * 3e-6, -2e9 * points[3 * i + 1], 1e-2);
      EXPECT_EQ(pressure[i], 1e9f * i);
    }
  for (int i = 0; i < 10; ++i)
    {
      EXPECT_EQ(segments[2 * i], i);
      EXPECT_EQ(segments[2 * i + 1], i + 1);
    }
}



TEST(Polyline, a_number_that_is_not_finite_is_refused_by_name)
{
  Polyline line             = quarter_circle(5);
  line.scalars[0].second[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message_of<ComputationError>([&]() {
              written(line);
            }).find("contact pressure [Pa]"),
            std::string::npos);

  line                         = quarter_circle(5);
  line.vectors[0].second[4][1] = std::numeric_limits<double>::infinity();
  EXPECT_NE(message_of<ComputationError>([&]() {
              written(line);
            }).find("'traction [Pa]'"),
            std::string::npos);

  line              = quarter_circle(5);
  line.points[0][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message_of<ComputationError>([&]() {
              written(line);
            }).find("position"),
            std::string::npos);

  // Finite in double precision, infinite in the file.
  line                      = quarter_circle(5);
  line.scalars[0].second[0] = 1e40;
  EXPECT_THROW(written(line), ComputationError);
}



TEST(Polyline, lengths_that_do_not_fit_are_refused)
{
  Polyline line = quarter_circle(5);
  line.scalars[0].second.pop_back();
  EXPECT_THROW(written(line), ComputationError);
  EXPECT_THROW(written(Polyline()), ComputationError);
}



TEST(VtuSeries, record_names_the_files_with_their_times)
{
  const std::string folder = test_folder();
  VtuSeries         series(folder, "tool");
  for (unsigned int step = 1; step <= 2; ++step)
    series.write(step, step * 1.25e-7, [&](std::ostream &out) {
      write_polyline(out, quarter_circle(5), step * 1.25e-7, step);
    });
  EXPECT_EQ(n_files(folder), 3u);
  EXPECT_EQ(VtuReader(content(series.path(2))).n_points, 5u);
  const std::string record = content(folder + "/tool.pvd");
  EXPECT_NE(record.find("timestep=\"1.25e-07\" group=\"\" part=\"0\" "
                        "file=\"tool_000001.vtu\""),
            std::string::npos);
  EXPECT_NE(record.find("timestep=\"2.5e-07\""), std::string::npos);
}



TEST(VtuSeries, restart_continues_the_record_and_drops_later_pictures)
{
  const std::string folder = test_folder();
  const auto        fill   = [](std::ostream &out) { out << "picture"; };
  {
    VtuSeries series(folder, "chip");
    for (const unsigned int step : {0u, 10u, 20u, 30u})
      series.write(step, step * 1e-9, fill);
  }
  const std::string whole = content(folder + "/chip.pvd");
  overwrite(folder + "/chip_notes.vtu", "of somebody else");
  {
    VtuSeries series(folder, "chip", 10);
    EXPECT_FALSE(std::filesystem::exists(series.path(20)));
    EXPECT_TRUE(std::filesystem::exists(series.path(10)));
    for (const unsigned int step : {20u, 30u})
      series.write(step, step * 1e-9, fill);
  }
  EXPECT_EQ(content(folder + "/chip.pvd"), whole);
  VtuSeries(folder, "chip");
  EXPECT_EQ(n_files(folder), 2u); // the empty record, and what is not ours
}



TEST(VtuSeries, a_failed_picture_is_not_in_the_record)
{
  const std::string folder = test_folder();
  VtuSeries         series(folder, "contact");
  EXPECT_THROW(series.write(1,
                            1e-9,
                            [](std::ostream &out) {
                              write_polyline(out, Polyline(), 1e-9, 1);
                            }),
               ComputationError);
  EXPECT_EQ(content(folder + "/contact.pvd").find("DataSet"),
            std::string::npos);
  EXPECT_EQ(n_files(folder), 1u);
}
