#include <asperity/contact_zone/audit.h>

#include <gtest/gtest.h>

#include <cmath>

#include "scene_examples.h"

using namespace asperity;

// The numbers of the audit against their definitions.

namespace
{
  double
  number(const SceneAudit &audit, const std::string &name)
  {
    for (const AuditEntry &entry : audit.entries)
      if (entry.name == name)
        return entry.value;
    ADD_FAILURE() << "no entry " << name;
    return 0.;
  }

  bool
  warns(const SceneAudit &audit, const std::string &words)
  {
    for (const std::string &warning : audit.warnings)
      if (warning.find(words) != std::string::npos)
        return true;
    return false;
  }
} // namespace

TEST(SceneAudit, numbers_follow_their_definitions)
{
  const SceneParameters parameters = coarse_scene();
  const Scene<2>        scene(parameters);
  const SceneAudit      audit = audit_scene(parameters, scene);
  const double E = scene.law->young_modulus(), nu = scene.law->poisson_ratio(),
               rho = scene.law->density();
  // There and back through 5 um within the ramp of 50 ns.
  const double wave_speed =
    std::sqrt(E * (1. - nu) / ((1. + nu) * (1. - 2. * nu)) / rho);
  EXPECT_NEAR(number(audit, "wave transits of the chip during the load ramp"),
              5e-8 * wave_speed / 10e-6,
              1e-9);
  const double v = 200. / 60.;
  EXPECT_NEAR(number(audit, "rho v^2 over the pressure"),
              rho * v * v / 300e6,
              1e-12);
  EXPECT_NEAR(number(audit, "sliding distance over the period"),
              v * 2.5e-7 / 10e-6,
              1e-12);
  // 2 sqrt(a t), a = k/(rho c) with k = 45 W/(m K) and the chip's own c
  EXPECT_NEAR(number(audit, "heat length over peak-to-valley height"),
              2. *
                std::sqrt(45. /
                          (rho * parameters.material.heating.heat_capacity) *
                          2.5e-7) /
                0.682e-6,
              0.01);
  // 10 slide steps over 0.8 of the way
  EXPECT_NEAR(number(audit, "time steps across the steepest asperity"),
              0.682 / 0.75 / (v * 2.5e-7 * 0.8 / 10. * 1e6),
              0.1);
  EXPECT_NEAR(number(audit, "chip height over the length of an asperity"),
              5. / (0.682 / 0.75),
              0.05);
  EXPECT_NEAR(number(audit, "largest slope of the tool"), 0.75, 0.005);
  EXPECT_NEAR(number(audit, "chip height over peak-to-valley height"),
              5. / 0.682,
              0.01);
  EXPECT_NEAR(number(audit, "elements across the steepest asperity"),
              0.682 / 0.75 / 0.25,
              0.05);
  EXPECT_EQ(audit.inertia, Inertia::quasi_static);
}

TEST(SceneAudit, heat_spreads_as_conductivity_and_heat_capacity_of_the_chip_say)
{
  SceneParameters parameters = coarse_scene();
  const Scene<2>  scene(parameters);
  const double    length = number(audit_scene(parameters, scene),
                               "heat length over peak-to-valley height");
  parameters.material.heating.heat_capacity *= 4.;
  EXPECT_NEAR(number(audit_scene(parameters, scene),
                     "heat length over peak-to-valley height"),
              0.5 * length,
              1e-12 * length);
  parameters.heat.chip_conductivity *= 9.;
  EXPECT_NEAR(number(audit_scene(parameters, scene),
                     "heat length over peak-to-valley height"),
              1.5 * length,
              1e-12 * length);
}

TEST(SceneAudit, flat_bodies_have_no_asperities_to_complain_of)
{
  SceneParameters parameters   = coarse_scene();
  parameters.tool.kind         = SurfaceKind::flat;
  parameters.lubrication.model = LubricantModel::automatic;
  const Scene<2>   scene(parameters);
  const SceneAudit audit = audit_scene(parameters, scene);
  EXPECT_TRUE(audit.warnings.empty()) << audit.warnings.front();
  // No asperity drives a flow.
  EXPECT_EQ(number(audit, "pressure differences by flow over the load"), 0.);
  EXPECT_FALSE(
    std::isfinite(number(audit, "heat length over peak-to-valley height")));
}

TEST(SceneAudit, tells_what_is_left_out_where_the_interface_bears_shear)
{
  SceneParameters parameters = coarse_scene();
  const Scene<2>  scene(parameters);
  const auto      warned = [&](const std::string &what) {
    return warns(audit_scene(parameters, scene), what);
  };
  EXPECT_FALSE(warned("The heat of friction is left out"));
  parameters.interface.law          = InterfaceShear::shear_factor;
  parameters.interface.shear_factor = 0.8;
  EXPECT_FALSE(warned("The heat of friction is left out"));
  EXPECT_FALSE(warned("nearly as strong as the chip"));
  parameters.heat.model = HeatModel::adiabatic;
  EXPECT_TRUE(warned("The heat of friction is left out"));
  parameters.heat.model             = HeatModel::automatic;
  parameters.interface.shear_factor = 0.99;
  EXPECT_FALSE(warned("The heat of friction is left out"));
  EXPECT_TRUE(warned("With a Shear factor of 0.99 the interface is nearly"));
}

TEST(SceneAudit, warns_of_waves_and_steps_that_are_too_coarse)
{
  SceneParameters parameters          = coarse_scene();
  parameters.tool.wave_numbers        = {1., 16.};
  parameters.tool.amplitudes          = {0.2e-6, 1e-9};
  parameters.tool.phases              = {0., 0.};
  parameters.protocol.slide_steps     = 1;
  parameters.load.velocity            = 100.;
  parameters.protocol.window_fraction = 0.1;
  SceneAudit audit = audit_scene(parameters, Scene<2>(parameters));
  // 40/16
  EXPECT_TRUE(warns(audit, "number 16 of a period, has 2.5 elements"));
  EXPECT_TRUE(warns(audit, "slides over the steepest asperity in"));
  EXPECT_TRUE(warns(audit, "shorter than two time steps"));

  parameters                   = coarse_scene();
  parameters.chip.kind         = SurfaceKind::harmonics;
  parameters.chip.wave_numbers = {2., 3., 5.};
  parameters.chip.amplitudes   = {0.03e-6, 0.03e-6, 0.02e-6};
  parameters.chip.phases       = {1., 2., 3.};
  parameters.mesh.spans        = 160;
  const std::string missed     = "height of the chip that its mesh misses";
  audit                        = audit_scene(parameters, Scene<2>(parameters));
  EXPECT_LT(number(audit, missed), 0.01);
  EXPECT_FALSE(warns(audit, "misses the chip's surface"));
  // Beyond what 160 spans can follow: the whole wave is missed somewhere.
  parameters.chip.wave_numbers = {2., 3., 110.};
  audit                        = audit_scene(parameters, Scene<2>(parameters));
  EXPECT_GT(number(audit, missed), 0.1);
  EXPECT_TRUE(warns(audit, "misses the chip's surface"));
}

TEST(SceneAudit, warns_of_a_way_that_is_none)
{
  SceneParameters parameters = coarse_scene();
  const Scene<2>  scene(parameters);
  const double    length = number(audit_scene(parameters, scene),
                               "time steps across the steepest asperity") *
                        parameters.load.velocity *
                        (parameters.protocol.end_time * 0.8 / 10.);
  const double      end      = parameters.protocol.end_time;
  const std::string sentence = "less than a fiftieth of the length";
  parameters.load.velocity   = 0.021 * length / end;
  EXPECT_FALSE(warns(audit_scene(parameters, scene), sentence));
  parameters.load.velocity = 0.019 * length / end;
  EXPECT_TRUE(warns(audit_scene(parameters, scene), sentence));
}

TEST(SceneAudit, warns_of_a_chip_that_is_a_thin_sheet)
{
  SceneParameters parameters = coarse_scene();
  // Asperities of 0.682/0.75 um times 20
  parameters.geometry.length = 200e-6;
  const SceneAudit audit     = audit_scene(parameters, Scene<2>(parameters));
  EXPECT_NEAR(number(audit, "chip height over the length of an asperity"),
              5. / 18.19,
              0.01);
  EXPECT_TRUE(warns(audit, "times as high as its asperities are long"));
  parameters.geometry.length = 20e-6;
  EXPECT_TRUE(warns(audit_scene(parameters, Scene<2>(parameters)),
                    "2.8 times as high as its asperities are long"));
  parameters.geometry.length = 10e-6;
  EXPECT_FALSE(warns(audit_scene(parameters, Scene<2>(parameters)),
                     "times as high as its asperities are long"));
}

TEST(SceneAudit, a_ramp_shorter_than_ten_transits_needs_inertia)
{
  SceneParameters parameters   = coarse_scene();
  parameters.protocol.end_time = 5e-8;
  const Scene<2>   scene(parameters);
  const SceneAudit audit = audit_scene(parameters, scene);
  EXPECT_LT(number(audit, "wave transits of the chip during the load ramp"),
            10.);
  EXPECT_EQ(audit.inertia, Inertia::dynamic);
}

TEST(SceneAudit, steady_window_slides_as_far_as_it_may)
{
  SceneParameters parameters           = coarse_scene();
  parameters.protocol.window           = FrictionWindow::steady;
  parameters.protocol.maximum_distance = 12e-6;
  const Scene<2> scene(parameters);
  EXPECT_NEAR(number(audit_scene(parameters, scene),
                     "sliding distance over the period"),
              1.2,
              1e-9);
}

TEST(SceneAudit, warns_of_what_spoils_the_result)
{
  SceneParameters parameters = coarse_scene();
  parameters.mesh.spans      = 80;
  const Scene<2> good(parameters);
  EXPECT_TRUE(audit_scene(parameters, good).warnings.empty());

  parameters.geometry.height        = 1.5e-6;
  parameters.mesh.spans             = 24;
  parameters.contact.penalty_factor = 1e-3;
  for (double &a : parameters.tool.amplitudes)
    a *= 3.;
  const Scene<2>   poor(parameters);
  const SceneAudit audit = audit_scene(parameters, poor);
  for (const std::string words : {"steeper than 1.5",
                                  "penalty is soft",
                                  "bottom feels the asperities",
                                  "does not resolve the tool"})
    EXPECT_TRUE(warns(audit, words)) << words;
}

TEST(SceneAudit, passes_on_what_the_reader_of_a_surface_complains_of)
{
  SceneParameters parameters = coarse_scene();
  parameters.tool.kind       = SurfaceKind::measured;
  auto &topography           = parameters.tool.topography;
  topography.file =
    ASPERITY_SOURCE_DIR "/parameter_files/surfaces/polished_tool.x3p";
  topography.length = 20e-6;
  topography.start  = 3e-6;
  Scene<2>   scene(parameters);
  auto      &report = *scene.tool_surface.topography;
  const auto before = audit_scene(parameters, scene).warnings.size();
  report.sanity.warnings.push_back("The unit is a guess.");
  const SceneAudit audit = audit_scene(parameters, scene);
  EXPECT_EQ(audit.warnings.size(), before + 1);
  EXPECT_TRUE(warns(audit, "Tool surface: The unit is a guess."));
}

TEST(SceneAudit, warns_of_hills_as_ridges_and_of_waves_that_are_filtered_out)
{
  SceneParameters parameters = coarse_scene();
  parameters.tool.kind       = SurfaceKind::measured;
  auto &topography           = parameters.tool.topography;
  topography.file =
    ASPERITY_SOURCE_DIR "/parameter_files/surfaces/polished_tool.x3p";
  topography.length = 20e-6;
  Scene<2> scene(parameters);
  auto    &report = *scene.tool_surface.topography;
  auto    &map    = report.map;
  // sin(x) + h sin(y) has the autocorrelation (cos(x) + h^2 cos(y))/(1 + h^2).
  const auto waves = [&](const double hills) {
    map.dx = map.dy = 0.5e-6;
    for (unsigned int j = 0; j < map.ny; ++j)
      for (unsigned int i = 0; i < map.nx; ++i)
        map(i, j) = 1e-7 * (std::sin(0.3 * i) + hills * std::sin(0.3 * j));
    report.texture = areal_texture(map);
  };
  waves(0.1);
  topography.s_filter      = 4e-6; // 2.7 times three pixels
  const SceneAudit grooves = audit_scene(parameters, scene);
  EXPECT_FALSE(warns(grooves, "texture"));
  EXPECT_FALSE(warns(grooves, "S-filter"));
  // Along y it does not decay, along x where cos(x) = 0.192.
  const double bound = std::acos(0.192) / 0.3 / (map.ny / 2);
  EXPECT_NEAR(number(grooves, "texture aspect ratio Str, Tool"),
              bound,
              0.05 * bound);
  EXPECT_NEAR(number(grooves, "S-filter over three pixels, Tool"),
              4. / 1.5,
              1e-9);
  waves(0.9);
  topography.s_filter    = 10e-6;
  const SceneAudit hills = audit_scene(parameters, scene);
  EXPECT_TRUE(warns(hills, "texture aspect ratio Str is 0.7"));
  EXPECT_TRUE(warns(hills, "without shear of the interface mu in the mean"));
  parameters.interface.law = InterfaceShear::shear_factor;
  EXPECT_TRUE(warns(audit_scene(parameters, scene),
                    "with a shear factor of 0.5 mu in the mean"));
  // slowest along y, where 1 + 0.81 cos(y) = 0.362, fastest near x = y, where
  // cos(x) = 0.2
  EXPECT_NEAR(number(hills, "texture aspect ratio Str, Tool"),
              std::sqrt(2.) * std::acos(0.2) / std::acos(-0.638 / 0.81),
              0.02);
  report.texture = ArealTexture();
  EXPECT_TRUE(warns(audit_scene(parameters, scene),
                    "the map is too small to tell: Str is at most 1"));
  EXPECT_TRUE(warns(hills, "S-filter of 10 um leaves out waves"));
}

TEST(SceneAudit, chooses_the_lubricant_model_by_the_flow)
{
  SceneParameters parameters   = coarse_scene();
  parameters.lubrication.model = LubricantModel::automatic;
  // 12 eta v l/(h^2 p) with the void of R0, 0.335 um, and asperities of 0.9 um
  parameters.load.velocity = 22.5 / 60.;
  const Scene<2> scene(parameters);
  SceneAudit     audit = audit_scene(parameters, scene);
  EXPECT_EQ(audit.lubricant, LubricantModel::pocket);
  const double h = 0.335e-6, l = 0.682e-6 / 0.75;
  EXPECT_NEAR(number(audit, "pressure differences by flow over the load"),
              12. * 0.032 * 0.375 * l / (h * h * 300e6),
              0.02 * 0.004);
  // Murnaghan: (1 + 10 * 0.3/1.6)^(1/10)
  EXPECT_NEAR(number(audit, "compression of the oil at the load"),
              1. - std::pow(1. + 10. * 0.3 / 1.6, -0.1),
              1e-6);

  // 12 eta l^2/(h^2 t p), as the surfaces close by h in the ramp of 50 ns
  const double squeeze = 12. * 0.032 * l * l / (h * h * 50e-9 * 300e6);
  EXPECT_NEAR(number(audit, "squeeze pressure in closing gaps over the load"),
              squeeze,
              0.02 * squeeze);

  parameters.lubrication.wetting = 0.6;
  audit = audit_scene(parameters, Scene<2>(parameters));
  EXPECT_EQ(audit.lubricant, LubricantModel::reynolds);
  parameters.lubrication.oil.viscosity.viscosity = 0.032 * 0.9e-3 / squeeze;
  audit = audit_scene(parameters, Scene<2>(parameters));
  EXPECT_EQ(audit.lubricant, LubricantModel::pocket);
  parameters.lubrication.oil.viscosity.viscosity = 0.032;
  parameters.lubrication.wetting                 = 1.;
  parameters.load.velocity                       = 200.;
  audit = audit_scene(parameters, Scene<2>(parameters));
  EXPECT_EQ(audit.lubricant, LubricantModel::reynolds);
  parameters.lubrication.wetting = 0.;
  audit = audit_scene(parameters, Scene<2>(parameters));
  EXPECT_EQ(audit.lubricant, LubricantModel::none);
}
