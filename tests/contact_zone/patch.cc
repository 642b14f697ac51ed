#include <asperity/base/errors.h>
#include <asperity/contact_zone/audit.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "../files.h"
#include "scene_examples.h"

using namespace asperity;

// Scenes in three dimensions. Expected values are the plane, balances and
// symmetries.

namespace
{
  using PatchRun = CompleteRunIn<3>;

  /** Waves along and across, whose ridges are oblique, over which the chip
   *  slides obliquely.
   *  @param sense of their slope and of the direction, 1 or -1 */
  SceneParameters
  oblique_scene(const double sense)
  {
    SceneParameters parameters   = narrow_scene();
    parameters.geometry.width    = 0.5 * parameters.geometry.length;
    parameters.mesh.spans        = 12;
    parameters.tool.spans        = std::nullopt; // as fine along x and y
    parameters.mesh.across       = 8;
    parameters.tool.wave_numbers = {2., 1.};
    parameters.tool.across       = {sense, -2. * sense};
    parameters.tool.amplitudes   = {0.1e-6, 0.1e-6};
    parameters.tool.phases       = {0.3, 1.};
    parameters.load.direction    = sense * M_PI / 6.;
    return parameters;
  }

  void
  expect_balance(const PatchRun &run)
  {
    for (const FrictionRow &row : run.rows())
      EXPECT_NEAR(row.T_y,
                  -run.run.protocol().pressure(row.time) * run.scene.length,
                  1e-7 * run.load())
        << "step " << row.step;
  }
} // namespace



// A tool that is extruded across the motion is in plane strain.
TEST(Patch, extruded_tool_has_the_friction_of_the_plane)
{
  using Case = std::pair<ContactFormulation, InterfaceShear>;
  for (const auto &[formulation, law] :
       {Case(ContactFormulation::gauss_point, InterfaceShear::none),
        Case(ContactFormulation::mortar, InterfaceShear::coulomb)})
    {
      SceneParameters parameters                = narrow_scene();
      parameters.contact.formulation            = formulation;
      parameters.interface.law                  = law;
      parameters.interface.friction_coefficient = 0.1;
      parameters.heat.model                     = HeatModel::adiabatic;
      const PatchRun patch(parameters);
      parameters.geometry.dimension = 2;
      const CompleteRun plane(parameters);
      ASSERT_EQ(patch.rows().size(), plane.rows().size());
      for (std::size_t i = 1; i < plane.rows().size(); ++i)
        {
          const FrictionRow &a = patch.rows()[i], &b = plane.rows()[i];
          EXPECT_NEAR(a.mu, b.mu, 1e-6 * std::abs(b.mu)) << "step " << i;
          EXPECT_NEAR(a.T_transverse, 0., 1e-6 * plane.load());
          EXPECT_NEAR(a.contact_fraction, b.contact_fraction, 1e-6);
          EXPECT_NEAR(a.max_contact_pressure,
                      b.max_contact_pressure,
                      1e-6 * b.max_contact_pressure);
          EXPECT_NEAR(a.touching_length,
                      b.touching_length,
                      1e-6 * b.touching_length);
          EXPECT_NEAR(a.max_plastic_strain,
                      b.max_plastic_strain,
                      1e-5 * b.max_plastic_strain);
          EXPECT_NEAR(a.max_temperature, b.max_temperature, 1e-4);
          EXPECT_NEAR(a.mean_gap, b.mean_gap, 1e-6 * b.mean_gap);
        }
      EXPECT_GT(plane.run.friction().mu, 0.01);
    }
}



// Finer elements across find the same, with the levels that they bring.
TEST(Patch, extruded_tool_stays_in_plane_strain_on_finer_elements_across)
{
  SceneParameters parameters = narrow_scene();
  parameters.mesh.across     = 8;
  const PatchRun patch(parameters);
  parameters.geometry.dimension = 2;
  const CompleteRun plane(parameters);
  const double      mu = plane.run.friction().mu;
  EXPECT_NEAR(patch.run.friction().mu, mu, 1e-6 * mu);
}



// Tool, chip and way are turned by 90 degrees: (x, y) becomes (-y, x).
TEST(Patch, turned_by_a_right_angle_has_the_same_forces)
{
  SceneParameters parameters                = oblique_scene(1.);
  parameters.load.direction                 = 0.;
  parameters.interface.law                  = InterfaceShear::coulomb;
  parameters.interface.friction_coefficient = 0.1;
  const PatchRun  along_x(parameters);
  SceneParameters turned = parameters;
  std::swap(turned.geometry.length, *turned.geometry.width);
  std::swap(turned.mesh.spans, *turned.mesh.across);
  // k x/L + j y/W = k y'/L - j x'/W, and a wave is that of the opposite signs
  turned.tool.wave_numbers = {1., 2.};
  turned.tool.across       = {-2., 1.};
  turned.tool.phases       = {-0.3, 1.};
  turned.load.direction    = M_PI / 2.;
  const PatchRun along_y(turned);
  expect_balance(along_y);
  ASSERT_EQ(along_x.rows().size(), along_y.rows().size());
  for (std::size_t i = 1; i < along_x.rows().size(); ++i)
    {
      const FrictionRow &a = along_x.rows()[i], &b = along_y.rows()[i];
      // per metre of the width, which is another one
      const double w = *parameters.geometry.width, l = *turned.geometry.width;
      const double load = along_x.load() * w;
      EXPECT_NEAR(a.T_x * w, b.T_x * l, 1e-6 * load) << "step " << i;
      EXPECT_NEAR(a.T_transverse * w, b.T_transverse * l, 1e-6 * load);
      EXPECT_NEAR(a.interface_T_x * w, b.interface_T_x * l, 1e-6 * load);
      EXPECT_NEAR(a.mu, b.mu, 1e-6);
      EXPECT_NEAR(a.contact_fraction, b.contact_fraction, 1e-6);
      EXPECT_NEAR(a.max_contact_pressure,
                  b.max_contact_pressure,
                  1e-6 * a.max_contact_pressure);
    }
  EXPECT_GT(along_x.run.friction().interface_shear, 0.05);
  EXPECT_GT(std::abs(along_x.run.friction().transverse), 1e-3);
}



// A period across has no beginning: the other tool is moved, too.
TEST(Patch, mirrored_and_moved_tool_pushes_to_the_other_side)
{
  const PatchRun  left(oblique_scene(1.));
  SceneParameters mirrored = oblique_scene(-1.);
  const double    part     = 0.5; // of the width, in elements of each level
  for (std::size_t k = 0; k < mirrored.tool.phases.size(); ++k)
    mirrored.tool.phases[k] += 2. * M_PI * mirrored.tool.across[k] * part;
  const PatchRun right(mirrored);
  expect_balance(left);
  const FrictionResult a = left.run.friction(), b = right.run.friction();
  EXPECT_GT(a.mu, 0.002);
  EXPECT_NEAR(a.mu, b.mu, 1e-6 * a.mu);
  EXPECT_GT(std::abs(a.transverse), 0.01 * a.mu);
  EXPECT_NEAR(a.transverse, -b.transverse, 1e-6 * a.mu);
  EXPECT_NEAR(a.contact_fraction, b.contact_fraction, 1e-9);
}



TEST(Patch, interface_with_the_shear_strength_of_the_chip_adds_its_share)
{
  SceneParameters parameters        = oblique_scene(1.);
  parameters.interface.law          = InterfaceShear::shear_factor;
  parameters.interface.shear_factor = 0.3;
  const PatchRun run(parameters);
  expect_balance(run);
  const FrictionResult friction = run.run.friction();
  const double         k        = run.scene.law->shear_limit(0., 0., 298.15);
  EXPECT_GT(friction.interface_shear, 0.);
  // at least m k at the strength before hardening, on what touches
  EXPECT_GT(friction.interface_shear,
            0.9 * 0.3 * k * friction.contact_fraction /
              parameters.load.pressure);
  EXPECT_NEAR(friction.mu,
              friction.ploughing + friction.interface_shear,
              1e-12);
}



namespace
{
  /** What is said against a scene of these lines in three dimensions. */
  std::string
  refusal(const std::string &lines, const std::string &dimension = "3")
  {
    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator(handler);
    SceneParameters          parameters;
    parameters.declare(declarator);
    try
      {
        declarator.read_text("subsection Geometry\n set Dimension = " +
                               dimension + "\nend\n" + lines,
                             "patch.prm");
        parameters.check(declarator);
        Scene<3> scene(parameters);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "nothing";
  }

  std::string
  section(const std::string &name, const std::string &entry)
  {
    return "subsection " + name + "\n set " + entry + "\nend\n";
  }

  void
  expect_said(const std::string &message, const std::string &part)
  {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
} // namespace



TEST(Patch, says_what_three_dimensions_do_not_have)
{
  for (const std::string model : {"Reynolds", "Stokes", "Navier-Stokes"})
    expect_said(refusal(section("Lubrication", "Model = " + model)),
                "found 3 with the lubricant model `" + model + "`, whose f");
}



TEST(Patch, says_which_entries_do_not_make_a_patch)
{
  expect_said(
    refusal(section("Mesh", "Spans across = 20")),
    "Mesh/Spans across': found 20 with 3 refinement levels; expected a "
    "multiple of 8 of at least 24");
  expect_said(refusal(section("Mesh", "Spans across = 16")),
              "found 16 with 3 refinement levels");
  expect_said(refusal(section("Tool", "Wave numbers across = 1, 2")),
              "Tool/Wave numbers across': found 2 values; expected 6");
  expect_said(refusal(
                section("Tool", "Wave numbers across = 1, 2, 0.5, 0, 0, 0")),
              "found 0.5; expected whole numbers");
  expect_said(refusal(section("Accuracy", "Control = estimate") +
                      section("Mesh", "Refinement levels = 0")),
              "found automatic without refinement levels, of which no");
  expect_said(refusal(section("Load", "Sliding direction = 90 deg"), "2"),
              "Load/Sliding direction': found 90 deg in two dimensions");
}



// Numbers in the panels of a factor, as CHOLMOD's analysis of scenes of hills
// counts them.
TEST(Patch, memory_holds_two_factors_as_large_as_counted)
{
  struct Count
  {
    unsigned int degree;
    double       unknowns, numbers;
  };
  for (const Count &count : {Count{2, 1296., 1.051e6},
                             Count{2, 5076., 6.829e6},
                             Count{2, 9024., 16.82e6},
                             Count{2, 20196., 46.48e6},
                             Count{1, 4212., 2.037e6}})
    {
      const double n = count.unknowns / 3.;
      EXPECT_NEAR(numbers_in_factor(n, count.degree),
                  count.numbers,
                  0.1 * count.numbers);
      EXPECT_GT(patch_memory(n, count.degree),
                16. * numbers_in_factor(n, count.degree));
    }
}



TEST(Patch, says_before_it_starts_that_the_memory_is_too_small)
{
  const std::string message = refusal(section("Mesh", "Spans = 2048"));
  expect_said(message, "GB of memory; this machine can give ");
  expect_said(message, "fewer Spans or Spans across");
}



TEST(Patch, says_that_an_asperity_is_too_steep)
{
  SceneParameters parameters = oblique_scene(1.);
  const auto      warns      = [&](const double amplitude) {
    parameters.tool.amplitudes = {amplitude, 0.};
    const Scene<3> scene(parameters);
    const auto     warnings = audit_scene(parameters, scene).warnings;
    return std::any_of(warnings.begin(),
                       warnings.end(),
                       [](const std::string &warning) {
                         return warning.find("deg steep") != std::string::npos;
                       });
  };
  // 1.5 (56 deg) over the steepest slope of the wave (2, 1) of 10 x 5 um
  const double limit = 1.5 / (2. * M_PI * std::hypot(0.2, 0.2)) * 1e-6;
  EXPECT_FALSE(warns(0.99 * limit));
  EXPECT_TRUE(warns(1.01 * limit));
}



TEST(Patch, says_that_the_contact_is_lost)
{
  SceneParameters parameters      = oblique_scene(1.);
  parameters.protocol.slide_steps = 2;
  PatchRun run(parameters);
  EXPECT_NEAR(run.run.judgement().carried_load, 1., 1e-6);
  RunState state        = run.run.state();
  state.rows.back().T_y = 0.;
  run.run.set_state(state);
  const auto warnings = run.run.judgement().warnings;
  EXPECT_TRUE(std::any_of(
    warnings.begin(), warnings.end(), [](const std::string &warning) {
      return warning.rfind("Contact is lost: nothing carries the chip in 1 ",
                           0) == 0;
    }));
}



TEST(Patch, window_of_a_map_has_to_be_chosen_and_to_be_in_it)
{
  const std::string map =
    "subsection Tool\n set Kind = measured\n subsection Topography\n set File "
    "= " ASPERITY_SOURCE_DIR "/parameter_files/surfaces/blasted_tool.x3p\n";
  expect_said(refusal(map + "end\nend\n"),
              "Profile length': found 0 um in three dimensions; expected the "
              "length of the window");
  expect_said(
    refusal(
      map +
      "set Profile length = 5 um\nset Profile direction = 30 deg\nend\nend"
      "\n"),
    "Profile direction': found 30 deg in three dimensions; expected 0");
  expect_said(refusal(map + "set Profile length = 5000 um\nend\nend\n"),
              "5000 um");
}



// A hole of 4 x 4 of the 20 x 20 points of a window of 5 um.
TEST(Patch, says_that_points_of_the_window_are_missing)
{
  const std::string path = test_folder() + "/hole.txt";
  std::ofstream     file(path);
  for (unsigned int j = 0; j < 20; ++j)
    for (unsigned int i = 0; i < 20; ++i)
      {
        const bool hole = i / 4 == 2 && j / 4 == 2;
        file << (hole ? "nan" :
                        std::to_string(0.1 * std::cos(0.1 * M_PI * (i + j))))
             << (i < 19 ? " " : "\n");
      }
  file.close();
  SceneParameters parameters = oblique_scene(1.);
  parameters.tool            = SurfaceParameters();
  parameters.tool.kind       = SurfaceKind::measured;
  TopographyParameters &map  = parameters.tool.topography;
  map.file                   = path;
  map.lateral_unit = map.height_unit = "um";
  map.spacing_x                      = 0.25e-6;
  map.form                           = FormChoice::none;
  map.length                         = 5e-6;
  parameters.geometry.width          = 5e-6;
  map.largest_missing_fraction       = 0.05;
  const Scene<3> scene(parameters);
  const auto     warnings = audit_scene(parameters, scene).warnings;
  EXPECT_TRUE(std::any_of(
    warnings.begin(), warnings.end(), [](const std::string &warning) {
      return warning.find("% of the window's points are missing in the map and "
                          "were filled by straight lines") != std::string::npos;
    }));
  EXPECT_EQ(scene.tool_surface.window->n_filled, 16u);
  map.largest_missing_fraction = 0.03;
  expect_said(message_of<InputError>([&]() { Scene<3> refused(parameters); }),
              "4 % of the window's points are missing");
}
