#include <asperity/isogeometric/spline_space.h>
#include <asperity/postprocess/chip_output.h>
#include <asperity/postprocess/friction_table.h>
#include <asperity/postprocess/polyline.h>
#include <asperity/postprocess/summary.h>
#include <asperity/postprocess/vtu_series.h>

#include <deal.II/base/quadrature_lib.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "../files.h"

using namespace asperity;

namespace
{
  const double length = 10e-6, height = 5e-6, lift = 0.4e-6;

  /** A rough tool with six waves. */
  double
  tool_height(const double x)
  {
    const double a[]   = {0.16, 0.12, 0.09, 0.06, 0.04, 0.02};
    const double phi[] = {0.3, 1.9, 4.1, 5.2, 0.9, 2.6};
    double       y     = height + 0.4e-6;
    for (unsigned int k = 1; k <= 6; ++k)
      y += 1e-6 * a[k - 1] * std::cos(2. * M_PI * k * x / length + phi[k - 1]);
    return y;
  }

  /** Displacement of a chip that is lifted against the tool and slides. */
  std::vector<double>
  displacement(const dealii::Point<2> &X, const double distance)
  {
    const double gap = tool_height(X[0] + distance) - height - lift;
    const double y   = X[1] / height;
    return {distance, lift + std::min(gap, 0.) * y * y * y * y};
  }

  void
  write_chip(const std::string &folder, const double distance)
  {
    std::vector<double> x, y;
    for (unsigned int i = 0; i <= 80; ++i)
      x.push_back(length * i / 80);
    for (unsigned int j = 0; j <= 8; ++j)
      y.push_back(height * (1. - std::pow(1. - j / 8., 1.5)));
    const SplineSpace<2> space(KnotVector(2, x, true), KnotVector(2, y));
    const auto           u = space.project(
      [&](const dealii::Point<2> &X) { return displacement(X, distance); }, 2);

    ChipFields fields;
    fields.displacement.reinit(2 * space.n_functions());
    for (unsigned int a = 0; a < space.n_functions(); ++a)
      for (unsigned int c = 0; c < 2; ++c)
        fields.displacement[2 * a + c] = u[c][a];
    std::vector<double> strain;
    for (const auto &X :
         tabulate_cells(space, {}, dealii::QGauss<2>(3)).position)
      strain.push_back(lift + 1e-7 - displacement(X, distance)[1]);
    for (double &value : strain)
      value *= 2e6;
    fields.quadrature_scalars.emplace_back("equivalent plastic strain [-]",
                                           strain);
    const ChipOutput<2> output(space, {}, 2, 3);
    VtuSeries(folder, "chip").write(50, 2.5e-7, [&](std::ostream &out) {
      output.write(out, fields, 2.5e-7, 50);
    });
  }

  void
  write_lines(const std::string &folder, const double distance)
  {
    Polyline tool, contact;
    contact.scalars.resize(1, {"contact pressure [Pa]", {}});
    contact.vectors.resize(1, {"traction [Pa]", {}});
    for (unsigned int i = 0; i <= 400; ++i)
      {
        const double x = length * i / 400;
        tool.points.emplace_back(x, tool_height(x));
        const auto u = displacement({x, height}, distance);
        contact.points.emplace_back(x + u[0], height + u[1]);
        const double pressure = 1e16 * (lift - u[1]);
        const double slope =
          (tool_height(x + u[0] + 1e-9) - tool_height(x + u[0])) / 1e-9;
        contact.scalars[0].second.push_back(pressure);
        contact.vectors[0].second.push_back(pressure *
                                            dealii::Tensor<1, 2>({slope, -1.}) /
                                            std::sqrt(1. + slope * slope));
      }
    for (const auto &[name, line] :
         {std::make_pair("tool", tool), std::make_pair("contact", contact)})
      VtuSeries(folder, name).write(50, 2.5e-7, [&](std::ostream &out) {
        write_polyline(out, line, 2.5e-7, 50);
      });
  }

  void
  write_tables(const std::string &folder)
  {
    FrictionTable table(folder);
    for (unsigned int step = 1; step <= 50; ++step)
      {
        FrictionRow row;
        row.step             = step;
        row.time             = 5e-9 * step;
        row.sliding_distance = 3.3 * row.time;
        row.mu = 0.2 + 0.1 * std::exp(-0.1 * step) + 0.01 * std::sin(step / 3.);
        row.contact_fraction = 0.4 * (1. - std::exp(-0.2 * step));
        table.append(row);
      }
    nlohmann::ordered_json summary;
    summary["friction"]["mu"]     = 0.2037;
    summary["friction"]["spread"] = 0.0074;
    summary["friction"]["window"] = {1.25e-7, 2.5e-7};
    write_summary(folder + "/summary.json", summary);
  }

  int
  run(const std::string &command)
  {
    return std::system((command + " > /dev/null 2>&1").c_str());
  }

  const std::string script = ASPERITY_SOURCE_DIR "/tools/plot_run.py";
} // namespace



TEST(PlotRun, a_run_becomes_two_pictures)
{
  if (run("/usr/bin/python3 -c 'import matplotlib, numpy'") != 0)
    GTEST_SKIP() << "matplotlib is not installed";
  const std::string folder = test_folder();
  write_chip(folder, 0.82e-6);
  write_lines(folder, 0.82e-6);
  write_tables(folder);
  ASSERT_EQ(run(script + " " + folder + " --step 50"), 0);
  for (const std::string name : {"deformed_topography.png", "friction.png"})
    {
      const std::string picture = content(folder + "/" + name);
      EXPECT_EQ(picture.substr(1, 3), "PNG");
      EXPECT_GT(picture.size(), 20000u) << name << " is blank";
    }
  // There is no such step, and no such run: exit status 2, no trace.
  EXPECT_EQ(WEXITSTATUS(run(script + " " + folder + " --step 51")), 2);
  EXPECT_EQ(WEXITSTATUS(run(script + " " + folder + "/missing")), 2);
}
