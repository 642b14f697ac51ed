#include <asperity/base/errors.h>
#include <asperity/contact_zone/scene_heat.h>
#include <asperity/contact_zone/scene_input.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scene_examples.h"

using namespace asperity;

// Meshes that change in three dimensions. Expected values are the plane and
// the mesh that is fine everywhere.

namespace
{
  using PatchRun = CompleteRunIn<3>;

  /** 0.2 um cos(2 pi x/L + 0.4) cos(2 pi y/W) */
  SceneParameters
  hills()
  {
    SceneParameters parameters   = adaptive_patch(16);
    parameters.geometry.width    = parameters.geometry.length;
    parameters.tool.wave_numbers = {1., 1.};
    parameters.tool.across       = {1., -1.};
    parameters.tool.amplitudes   = {0.1e-6, 0.1e-6};
    parameters.tool.phases       = {0.4, 0.4};
    parameters.tool.spans        = std::nullopt; // as fine along x and y
    return parameters;
  }

  /** With shear of half of the chip's strength, and no heat of it. */
  SceneParameters
  with_shear(SceneParameters parameters)
  {
    parameters.interface.law          = InterfaceShear::shear_factor;
    parameters.interface.shear_factor = 0.5;
    parameters.heat.model             = HeatModel::adiabatic;
    return parameters;
  }

  /** @return the end of the plane */
  FrictionRow
  expect_the_plane(SceneParameters parameters)
  {
    std::set<unsigned int> columns;
    const auto             count = [&](const SlidingRun<2> &run) {
      columns.insert(run.state().coverage.size());
    };
    const PatchRun patch(parameters);
    parameters.geometry.dimension = 2;
    const CompleteRun   plane(parameters, count);
    const RemeshReport &a = patch.run.state().remeshing,
                       &b = plane.run.state().remeshing;
    EXPECT_GE(columns.size(), 2u); // the mesh has changed on the way, too
    EXPECT_EQ(a.remeshes, b.remeshes);
    EXPECT_NEAR(a.change, b.change, 1e-5);
    EXPECT_NEAR(a.work_drift(), b.work_drift(), 1e-7);
    EXPECT_GE(b.remeshes, 2u);
    EXPECT_EQ(patch.rows().size(), plane.rows().size());
    for (std::size_t i = 1; i < plane.rows().size(); ++i)
      {
        const FrictionRow &of_patch = patch.rows()[i],
                          &of_plane = plane.rows()[i];
        EXPECT_NEAR(of_patch.mu, of_plane.mu, 1e-6 * std::abs(of_plane.mu))
          << "step " << i;
        EXPECT_NEAR(of_patch.interface_shear,
                    of_plane.interface_shear,
                    1e-6 * std::abs(of_plane.mu));
        EXPECT_NEAR(of_patch.max_plastic_strain,
                    of_plane.max_plastic_strain,
                    1e-5 * of_plane.max_plastic_strain);
      }
    EXPECT_NEAR(a.plastic_work / patch.scene.width,
                b.plastic_work,
                1e-5 * b.plastic_work);
    EXPECT_GT(plane.run.friction().mu, 0.01);
    return plane.rows().back();
  }

  /** With oil that bears a part of the load. */
  SceneParameters
  with_oil(SceneParameters parameters)
  {
    parameters.load.pressure       = 600e6;
    parameters.lubrication.model   = LubricantModel::pocket;
    parameters.lubrication.wetting = 0.4;
    return parameters;
  }

  /** Two ridges, which seal the voids between them. */
  SceneParameters
  two_pockets()
  {
    SceneParameters parameters         = with_oil(adaptive_ridge());
    parameters.tool.wave_numbers       = {2.};
    parameters.lubrication.wetting     = 0.8;
    parameters.lubrication.sealing_gap = 30e-9;
    return parameters;
  }

  /** A mesh that changes once, into the one that is fine from the start. */
  template <int dim>
  void
  expect_the_even_mesh(SceneParameters parameters)
  {
    const CompleteRunIn<dim> adaptive(parameters);
    parameters.mesh.adaptive_levels = 0;
    const CompleteRunIn<dim> even(parameters);
    ASSERT_EQ(adaptive.run.state().remeshing.remeshes, 1u);
    ASSERT_EQ(adaptive.scene.space->n_cells(), even.scene.space->n_cells());
    for (std::size_t i = 0; i < even.rows().size(); ++i)
      {
        EXPECT_NEAR(adaptive.rows()[i].T_x,
                    even.rows()[i].T_x,
                    1e-7 * even.load());
        EXPECT_NEAR(adaptive.rows()[i].interface_T_x,
                    even.rows()[i].interface_T_x,
                    1e-7 * even.load());
      }
  }
} // namespace



// What touches is the same along y, and so are the cells beside it.
TEST(PatchAdaptation,
     extruded_tool_has_the_meshes_and_the_friction_of_the_plane)
{
  expect_the_plane(adaptive_ridge());
}



TEST(PatchAdaptation, of_an_extruded_tool_takes_the_shear_of_the_plane_with_it)
{
  for (const ContactFormulation formulation :
       {ContactFormulation::mortar, ContactFormulation::gauss_point})
    {
      SceneParameters parameters     = with_shear(adaptive_ridge());
      parameters.contact.formulation = formulation;
      EXPECT_GT(expect_the_plane(parameters).interface_shear, 0.05);
    }
}



// The first change refines everything: nothing is worked before it.
TEST(PatchAdaptation, that_refines_all_at_once_gives_the_same_steps)
{
  SceneParameters parameters      = hills();
  parameters.mesh.remesh_distance = parameters.geometry.length;
  parameters.protocol.slide_steps = 2;
  expect_the_even_mesh<3>(parameters);
}



TEST(PatchAdaptation, that_refines_a_sheared_face_at_once_gives_the_same_steps)
{
  SceneParameters parameters      = with_shear(adaptive_ridge());
  parameters.mesh.remesh_distance = parameters.geometry.length;
  expect_the_even_mesh<3>(parameters);
  parameters.geometry.dimension = 2;
  expect_the_even_mesh<2>(parameters);
}



// Where spots stick, shear has a memory.
TEST(PatchAdaptation, of_spots_that_stick_keeps_their_shear)
{
  SceneParameters parameters                = adaptive_ridge();
  parameters.geometry.dimension             = 2;
  parameters.interface.law                  = InterfaceShear::coulomb;
  parameters.interface.friction_coefficient = 2.;
  parameters.interface.stick_penalty        = 0.01;
  parameters.mesh.halo                      = 1;
  parameters.mesh.remesh_distance           = 0.02e-6;
  parameters.protocol.sliding_distance      = 0.1e-6;
  const CompleteRun adaptive(parameters);
  EXPECT_GE(adaptive.run.state().remeshing.remeshes, 1u);
  parameters.mesh.adaptive_levels = 0;
  const CompleteRun even(parameters);
  // The first step is that of the coarse mesh. Shear that was lost at a change
  // would leave the next steps 8, 4 and 3 % behind.
  EXPECT_GT(even.rows()[2].sticking, 0.5);
  for (std::size_t i = 2; i < even.rows().size(); ++i)
    {
      const double expected = even.rows()[i].interface_T_x;
      EXPECT_NEAR(adaptive.rows()[i].interface_T_x,
                  expected,
                  0.02 * std::abs(expected))
        << "step " << i;
    }
}



TEST(PatchAdaptation, of_an_extruded_tool_takes_the_oil_of_the_plane_with_it)
{
  const FrictionRow end =
    expect_the_plane(with_shear(with_oil(adaptive_ridge())));
  EXPECT_GT(end.oil_pressure, 1e8);
}



// The one pocket, and pockets that the contact seals.
TEST(PatchAdaptation, that_refines_all_at_once_leaves_the_oil_as_it_is)
{
  for (SceneParameters parameters : {with_oil(adaptive_ridge()), two_pockets()})
    {
      parameters.mesh.remesh_distance = parameters.geometry.length;
      parameters.protocol.slide_steps = 2;
      expect_the_even_mesh<3>(parameters);
      parameters.geometry.dimension = 2;
      expect_the_even_mesh<2>(parameters);
    }
}



TEST(PatchAdaptation, keeps_the_oil_of_each_pocket)
{
  const PatchRun run(two_pockets());
  unsigned int   n_pockets = 0;
  EXPECT_GE(run.run.state().remeshing.remeshes, 2u);
  for (std::size_t i = 1; i < run.rows().size(); ++i)
    {
      const FrictionRow &row = run.rows()[i];
      EXPECT_NEAR(row.oil_reference_volume,
                  run.rows()[1].oil_reference_volume,
                  1e-14 * row.oil_reference_volume);
      EXPECT_NEAR(row.T_y,
                  -run.run.protocol().pressure(row.time) * run.scene.length,
                  1e-7 * run.load());
      n_pockets = std::max<unsigned int>(n_pockets, row.pockets);
    }
  EXPECT_EQ(n_pockets, 2u);
  EXPECT_GT(run.rows().back().oil_pressure, 1e8);
}



TEST(PatchAdaptation, of_an_extruded_tool_takes_the_heat_of_the_plane_with_it)
{
  SceneParameters parameters = with_shear(adaptive_ridge());
  parameters.heat.model      = HeatModel::conducting;
  const FrictionRow end      = expect_the_plane(parameters);
  EXPECT_GT(end.flash_temperature, parameters.load.temperature + 5.);
}



TEST(PatchAdaptation, that_refines_all_at_once_leaves_the_heat_as_it_is)
{
  SceneParameters parameters      = with_shear(adaptive_ridge());
  parameters.heat.model           = HeatModel::conducting;
  parameters.mesh.remesh_distance = parameters.geometry.length;
  expect_the_even_mesh<3>(parameters);
  parameters.geometry.dimension = 2;
  expect_the_even_mesh<2>(parameters);
}



// What is stored goes over with the temperature, and nothing comes or goes.
TEST(PatchAdaptation, keeps_the_balance_of_heat)
{
  SceneParameters parameters = with_shear(hills());
  parameters.heat.model      = HeatModel::conducting;
  Scene<3>      scene(parameters);
  SlidingRun<3> run(parameters, scene);
  double        largest = 0.;
  run.run([&](const SlidingRun<3> &) {
    largest = std::max(largest, scene.heat->balance_error());
  });
  EXPECT_GE(run.state().remeshing.remeshes, 2u);
  EXPECT_LT(largest, 1e-9);
  EXPECT_LT(scene.heat->amounts().balance_error(), 1e-9);
  EXPECT_GT(scene.heat->amounts().friction, 0.);
  // The projection is no limiter; its overshoot is told.
  const double excess = run.state().remeshing.temperature_excess;
  EXPECT_LT(excess,
            1e-3 * (run.state().rows.back().flash_temperature -
                    parameters.load.temperature));
}



TEST(PatchAdaptation, follows_hills_and_loses_no_plastic_work)
{
  SceneParameters parameters = hills();
  const PatchRun  adaptive(parameters);
  const auto     &report = adaptive.run.state().remeshing;
  EXPECT_GE(report.remeshes, 2u);
  EXPECT_EQ(report.strain_excess, 0.);
  EXPECT_LE(std::abs(report.work_drift()), 1e-4);
  EXPECT_GT(report.change, 0.);
  EXPECT_LE(report.change, 0.1); // a spot has but three elements
  EXPECT_GT(report.plastic_work, 0.);
  EXPECT_EQ(report.bounded, 0u);
  EXPECT_EQ(adaptive.run.coarser_meshes(), "");
  parameters.mesh.adaptive_levels = 0;
  const PatchRun even(parameters);
  const double   mu = even.run.friction().mu;
  EXPECT_NEAR(adaptive.run.friction().mu, mu, 0.005 * mu);
  EXPECT_LT(adaptive.run.mean_unknowns(), 0.95 * even.run.mean_unknowns());
}



TEST(PatchAdaptation, has_no_more_unknowns_than_it_may)
{
  SceneParameters parameters    = hills();
  parameters.mesh.most_unknowns = 1300;
  const PatchRun      run(parameters);
  const RemeshReport &report = run.run.state().remeshing;
  EXPECT_LE(report.most_unknowns, 1300u);
  EXPECT_GT(report.bounded, 0u);
  EXPECT_EQ(run.run.coarser_meshes().find(
              "The contacts want finer meshes than the 1300 unknowns of "
              "Mesh/Maximum unknowns make: "),
            0u);
  for (const FrictionRow &row : run.rows())
    EXPECT_NEAR(row.T_y,
                -run.run.protocol().pressure(row.time) * run.scene.length,
                1e-7 * run.load());
}



TEST(PatchAdaptation, refuses_what_does_not_go_over_and_a_bound_that_is_too_low)
{
  const auto message = [](const EntryValues &entries) -> std::string {
    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator(handler);
    SceneParameters          parameters;
    parameters.declare(declarator);
    declarator.set("Geometry/Dimension", "3");
    declarator.set("Mesh/Adaptive levels", "3");
    for (const auto &[path, value] : entries)
      declarator.set(path, value);
    try
      {
        parameters.check(declarator);
        const Scene<3> scene(parameters);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "nothing";
  };
  const std::string found = "entry 'Mesh/Adaptive levels': found 3 with ";
  EXPECT_EQ(message({{"Protocol/Inertia", "dynamic"}}),
            found + "a chip that has inertia; expected 0, or "
                    "Protocol/Inertia = quasi-static.");
  EXPECT_EQ(message({{"Mesh/Maximum unknowns", "100"}})
              .find(
                "Entry 'Mesh/Maximum unknowns': found 100, but the 0 levels "
                "that are along the whole contact edge have "),
            0u);
}
