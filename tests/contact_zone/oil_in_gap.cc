#include <asperity/base/errors.h>
#include <asperity/contact_zone/audit.h>

#include <gtest/gtest.h>

#include <algorithm>

#include "scene_examples.h"

using namespace asperity;

// A flat chip under the tool a cos(2 pi x/L) has the mean gap a when they
// touch, and g more when they are g apart.

namespace
{
  const double L = 10e-6, a = 0.2e-6;

  SceneParameters
  wave_scene(const LubricantModel model,
             const OilAmount      amount,
             const double         initial_gap)
  {
    SceneParameters parameters      = coarse_scene();
    parameters.tool.wave_numbers    = {1.};
    parameters.tool.amplitudes      = {a};
    parameters.tool.phases          = {0.7};
    parameters.geometry.initial_gap = initial_gap;
    parameters.lubrication.model    = model;
    parameters.lubrication.amount   = amount;
    parameters.lubrication.wetting  = 0.8;
    parameters.lubrication.film     = 60e-9;
    return parameters;
  }

  double
  oil_volume(const SceneParameters &parameters)
  {
    return Scene<2>(parameters).lubricant->state().reference_volume;
  }
} // namespace

TEST(OilInGap, at_touch_or_by_film_does_not_depend_on_the_initial_gap)
{
  for (const LubricantModel model :
       {LubricantModel::pocket, LubricantModel::reynolds})
    for (const double gap : {0., 0.02e-6, 0.05e-6, 0.1e-6})
      {
        // the error of the spline that follows the cosine
        EXPECT_NEAR(oil_volume(
                      wave_scene(model, OilAmount::void_at_touch, gap)),
                    0.8 * a * L,
                    1e-5 * a * L);
        EXPECT_NEAR(oil_volume(
                      wave_scene(model, OilAmount::film_thickness, gap)),
                    60e-9 * L,
                    1e-12 * a * L);
      }
}

TEST(OilInGap, part_of_the_void_at_the_start_counts_the_initial_gap)
{
  for (const double gap : {0.02e-6, 0.1e-6})
    for (const LubricantModel model :
         {LubricantModel::pocket, LubricantModel::reynolds})
      EXPECT_NEAR(oil_volume(wave_scene(model, OilAmount::void_at_start, gap)),
                  0.8 * (a + gap) * L,
                  1e-5 * a * L);
}

TEST(OilInGap, pockets_share_a_film_as_they_share_the_void)
{
  SceneParameters parameters =
    wave_scene(LubricantModel::pocket, OilAmount::film_thickness, 0.);
  parameters.tool.wave_numbers       = {2.};
  parameters.lubrication.sealing_gap = 10e-9;
  const Scene<2> scene(parameters);
  EXPECT_EQ(scene.lubricant->state().n_pockets, 2u);
  EXPECT_NEAR(scene.lubricant->state().reference_volume,
              60e-9 * L,
              1e-12 * a * L);
}

TEST(OilInGap, a_film_needs_a_pocket_that_takes_it)
{
  SceneParameters parameters =
    wave_scene(LubricantModel::pocket, OilAmount::film_thickness, 0.);
  parameters.lubrication.sealing_gap = 1e-6;
  try
    {
      Scene<2> scene(parameters);
      FAIL();
    }
  catch (const InputError &error)
    {
      EXPECT_STREQ(error.what(),
                   "Lubrication/Sealing gap: found 1000 nm, and the surfaces "
                   "are nowhere further apart at the start, so that no pocket "
                   "takes the oil; expected less.");
    }
}

TEST(OilInGap, more_oil_than_void_raises_the_gap_and_says_so)
{
  for (const LubricantModel model :
       {LubricantModel::pocket, LubricantModel::reynolds})
    {
      SceneParameters parameters =
        wave_scene(model, OilAmount::film_thickness, 0.02e-6);
      parameters.lubrication.film = 0.3e-6;
      const Scene<2> scene(parameters);
      EXPECT_NEAR(scene.oil.initial_gap, 0.1e-6, 1e-12);
      EXPECT_EQ(scene.oil.part_at_start, 1.);
      EXPECT_NEAR(scene.lubricant->state().reference_volume,
                  0.3e-6 * L,
                  1e-9 * a * L);
      EXPECT_EQ(scene.lubricant->state().max_pressure, 0.);
      const SceneAudit audit = audit_scene(parameters, scene);
      EXPECT_NE(std::find(audit.warnings.begin(),
                          audit.warnings.end(),
                          "The gap is flooded: the oil of 300 nm is more than "
                          "the void holds when the surfaces touch, 200 nm, so "
                          "that it is compressed before they do and carries "
                          "the load; the surfaces start 100 nm apart instead "
                          "of 20 nm, so that all of it has room."),
                audit.warnings.end());
    }
}

TEST(OilInGap, part_of_the_void_at_the_start_that_floods_says_why)
{
  LubricationParameters lubrication;
  lubrication.model   = LubricantModel::pocket;
  lubrication.wetting = 0.8;
  // 0.8 (0.2 + 0.05) um fills 0.2 um exactly.
  EXPECT_EQ(oil_in_gap(lubrication, 0.05e-6, a).warning, "");
  EXPECT_EQ(oil_in_gap(lubrication, 0.1e-6, a).warning,
            "The gap is flooded: the oil of 240 nm is more than the void holds "
            "when the surfaces touch, 200 nm, so that it is compressed before "
            "they do and carries the load; Wetting = 0.8 counts the initial "
            "gap of 100 nm as void, Lubrication/Oil amount = part of void at "
            "touch would not.");
  lubrication.wetting = 1.; // a full void was asked for
  EXPECT_EQ(oil_in_gap(lubrication, 0.1e-6, a).warning, "");
}

TEST(OilInGap, a_part_of_no_void_is_refused)
{
  LubricationParameters lubrication;
  lubrication.model  = LubricantModel::pocket;
  lubrication.amount = OilAmount::void_at_touch;
  try
    {
      oil_in_gap(lubrication, 0.1e-6, 0.);
      FAIL();
    }
  catch (const InputError &error)
    {
      EXPECT_STREQ(error.what(),
                   "Lubrication/Oil amount: found part of void at touch, but "
                   "surfaces that fit into each other have no void when they "
                   "touch; expected film thickness.");
    }
}
