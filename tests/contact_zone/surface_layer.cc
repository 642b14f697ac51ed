#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scene_examples.h"

using namespace asperity;

// The uppermost rows of material points stand at 40 times two abscissae; a
// state that is linear in depth and between two of them is met exactly, and one
// that jumps at the ends of the period goes over to its image.
TEST(SurfaceLayer, is_linear_in_depth_and_along_the_edge_over_the_period)
{
  const SceneParameters      parameters = coarse_scene();
  const Scene<2>             scene(parameters);
  const BasisTable<2>       &body    = scene.chip->table();
  std::vector<MaterialState> history = scene.chip->history();
  for (std::size_t q = 0; q < history.size(); ++q)
    {
      history[q].plastic_strain = body.position[q][0] / scene.length;
      history[q].temperature    = 300. + body.position[q][1] / 1e-6;
    }
  const auto  points = scene.surface_layer->at_edge(history);
  const auto &edge   = scene.contact->table();
  double      first  = scene.length;
  for (const auto &position : body.position)
    first = std::min(first, position[0]);
  const double temperature = 300. + edge.position[0][1] / 1e-6;
  ASSERT_EQ(points.size(), edge.position.size());
  for (std::size_t q = 0; q < points.size(); ++q)
    {
      const double x = edge.position[q][0];
      EXPECT_NEAR(points[q].temperature, temperature, 1e-9);
      if (x > first && x < scene.length - first)
        EXPECT_NEAR(points[q].plastic_strain, x / scene.length, 1e-12);
      else
        {
          // From the last point's 1 - first/L to the first point's first/L.
          const double last = 1. - first / scene.length,
                       way  = x < first ? x + first : x - scene.length + first;
          EXPECT_NEAR(points[q].plastic_strain,
                      last + (first / scene.length - last) * way / (2. * first),
                      1e-12);
        }
    }
  EXPECT_NEAR(scene.surface_layer->mean_temperature(history),
              temperature,
              1e-9);
}

// Only the uppermost points of cells count: what the others have leaves the
// line through those unchanged, whether the uppermost cells lie on others of
// their size (a strip of 0.3 um) or on those of twice the size (0.1 um).
TEST(SurfaceLayer, looks_at_the_uppermost_points_of_two_cells)
{
  for (const double strip : {0.1e-6, 0.3e-6})
    {
      SceneParameters parameters = coarse_scene();
      parameters.mesh.strip      = strip;
      const Scene<2>             scene(parameters);
      const BasisTable<2>       &body    = scene.chip->table();
      std::vector<MaterialState> history = scene.chip->history();
      const unsigned int n = std::lround(std::sqrt(body.points_per_element));
      for (const auto &element : body.elements)
        for (unsigned int i = 0; i < body.points_per_element; ++i)
          {
            MaterialState &state    = history[element.first_point + i];
            const double   y        = body.position[element.first_point + i][1];
            const bool     is_upper = i >= body.points_per_element - n;
            state.plastic_strain    = is_upper ? y / 1e-6 : 100.;
            state.temperature       = is_upper ? 300. + y / 1e-6 : 5000.;
          }
      const double y = scene.contact->table().position[0][1] / 1e-6;
      for (const auto &point : scene.surface_layer->at_edge(history))
        {
          EXPECT_NEAR(point.plastic_strain, y, 1e-9);
          EXPECT_NEAR(point.temperature, 300. + y, 1e-9);
        }
    }
}

// A strain that falls steeply towards the edge ends at zero there.
TEST(SurfaceLayer, has_no_negative_strain)
{
  const Scene<2>             scene(coarse_scene());
  const BasisTable<2>       &body    = scene.chip->table();
  std::vector<MaterialState> history = scene.chip->history();
  double                     top     = 0.;
  for (const auto &position : body.position)
    top = std::max(top, position[1]);
  for (std::size_t q = 0; q < history.size(); ++q)
    history[q].plastic_strain = (top - body.position[q][1]) / top;
  for (const auto &point : scene.surface_layer->at_edge(history))
    EXPECT_EQ(point.plastic_strain, 0.);
}

// The same in two directions: bilinear between points, also of different cells,
// and over the ends of both periods.
TEST(SurfaceLayer, of_a_patch_is_bilinear_over_the_periods)
{
  const Scene<3>              scene(narrow_scene());
  const BasisTable<3>        &body   = scene.chip->table();
  const std::array<double, 2> period = {{scene.length, scene.width}};
  std::array<double, 2>       first  = period;
  for (const auto &position : body.position)
    for (unsigned int d = 0; d < 2; ++d)
      first[d] = std::min(first[d], position[d]);
  // Along a period: straight, and back over its end.
  const auto part = [&](const double x, const unsigned int d) {
    const double a = first[d] / period[d], s = x / period[d];
    if (s > a && s < 1. - a)
      return s;
    return 1. - a + (2. * a - 1.) * (s < a ? s + a : s - 1. + a) / (2. * a);
  };
  std::vector<MaterialState> history = scene.chip->history();
  for (std::size_t q = 0; q < history.size(); ++q)
    {
      const auto &at            = body.position[q];
      history[q].plastic_strain = at[0] / period[0] * at[1] / period[1];
      history[q].temperature    = 300. + at[2] / 1e-6;
    }
  const auto  points = scene.surface_layer->at_edge(history);
  const auto &edge   = scene.contact->table();
  ASSERT_EQ(points.size(), edge.position.size());
  for (std::size_t q = 0; q < points.size(); ++q)
    {
      const auto &at = edge.position[q];
      EXPECT_NEAR(points[q].plastic_strain,
                  part(at[0], 0) * part(at[1], 1),
                  1e-12);
      EXPECT_NEAR(points[q].temperature, 300. + at[2] / 1e-6, 1e-9);
    }
}

// Cells of two sizes, a ridge's along y, have the values of a grid: linear
// along x between the nearest points, also of cells beside one another.
TEST(SurfaceLayer, of_cells_of_different_sizes_is_linear_between_lines_of_them)
{
  SceneParameters parameters      = narrow_scene();
  parameters.geometry.width       = 1. / 4. * parameters.geometry.length;
  parameters.mesh.adaptive_levels = 1;
  Scene<3>     scene(parameters);
  const double half = scene.length / 2.;
  scene.adapt_mesh(
    parameters, {[&](const dealii::Point<3> &, const dealii::Point<3> &upper) {
      return upper[0] <= half ? 1u : 0u;
    }});
  const BasisTable<3>       &body    = scene.chip->table();
  std::vector<MaterialState> history = scene.chip->history();
  std::set<double>           lines;
  double                     top = 0.;
  for (const auto &at : body.position)
    top = std::max(top, at[2]);
  for (std::size_t q = 0; q < history.size(); ++q)
    {
      const auto &at            = body.position[q];
      history[q].plastic_strain = std::pow(at[0] / scene.length, 2);
      history[q].temperature    = 300. + at[1] / 1e-6;
    }
  for (const auto &element : body.elements)
    {
      const auto last =
        body.position[element.first_point + body.points_per_element - 1];
      if (top - last[2] > 1e-9)
        continue;
      for (unsigned int i = 0; i < body.points_per_element; ++i)
        lines.insert(
          std::round(1e15 * body.position[element.first_point + i][0]) * 1e-15);
    }
  const std::vector<double> x(lines.begin(), lines.end());
  const auto                points = scene.surface_layer->at_edge(history);
  const auto               &edge   = scene.contact->table();
  std::set<double>          sizes(edge.JxW.begin(), edge.JxW.end());
  EXPECT_GT(*sizes.rbegin() / *sizes.begin(), 3.);
  for (std::size_t q = 0; q < points.size(); ++q)
    {
      const auto &at    = edge.position[q];
      const auto  after = std::upper_bound(x.begin(), x.end(), at[0]);
      if (after == x.begin() || after == x.end())
        continue;
      const double a = *(after - 1), b = *after, s = (at[0] - a) / (b - a);
      EXPECT_NEAR(points[q].plastic_strain,
                  ((1. - s) * a * a + s * b * b) / std::pow(scene.length, 2),
                  1e-9);
      const bool is_inside =
        at[1] > 0.2 * scene.width && at[1] < 0.8 * scene.width;
      if (is_inside)
        {
          EXPECT_NEAR(points[q].temperature, 300. + at[1] / 1e-6, 1e-6);
        }
    }
}
