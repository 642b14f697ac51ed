#include <asperity/base/errors.h>
#include <asperity/contact_zone/scene_checkpoint.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "scene_examples.h"

using namespace asperity;

namespace
{
  /** All but the time that the machine took. */
  void
  expect_identical(const FrictionRow &a, const FrictionRow &b)
  {
    FrictionRow without_time = a;
    without_time.wall_time   = b.wall_time;
    std::vector<double> first, second;
    for (const FrictionColumn &column : friction_columns())
      {
        first.push_back(column.value(without_time));
        second.push_back(column.value(b));
      }
    EXPECT_EQ(first, second) << "step " << a.step;
  }

  /** Runs to the end, keeps the state after a step, and runs from there
   *  again.
   *  @return how often the mesh has changed */
  template <int dim = 2>
  unsigned int
  expect_identical_rest(const SceneParameters &parameters,
                        const unsigned int     stop)
  {
    std::string kept;
    // The observer needs the scene of the run, so there is no CompleteRun.
    Scene<dim>      scene(parameters);
    SlidingRun<dim> run(parameters, scene);
    run.run([&](const SlidingRun<dim> &now) {
      if (now.state().step == stop)
        kept = save(now, scene);
    });

    Scene<dim>      second_scene(parameters);
    SlidingRun<dim> second(parameters, second_scene);
    load(kept, second, second_scene);
    EXPECT_EQ(save(second, second_scene), kept);
    EXPECT_EQ(second.state().step, stop);
    second.run([](const SlidingRun<dim> &) {});

    EXPECT_EQ(second.state().rows.size(), run.state().rows.size());
    for (std::size_t i = 0; i < run.state().rows.size(); ++i)
      expect_identical(run.state().rows[i], second.state().rows[i]);
    EXPECT_EQ(second.state().u, run.state().u);
    EXPECT_EQ(second_scene.chip->history().size(),
              scene.chip->history().size());
    for (std::size_t q = 0; q < scene.chip->history().size(); ++q)
      EXPECT_EQ(second_scene.chip->history()[q].plastic_strain,
                scene.chip->history()[q].plastic_strain);
    return run.state().remeshing.remeshes;
  }
} // namespace

TEST(Restart, goes_on_identically_from_any_quasi_static_step)
{
  for (const unsigned int stop : {1, 4, 9, 14})
    expect_identical_rest(coarse_scene(), stop);
}

TEST(Restart, goes_on_identically_in_a_dynamic_run)
{
  SceneParameters parameters  = coarse_scene();
  parameters.protocol.inertia = Inertia::dynamic;
  for (const unsigned int stop : {1, 7})
    expect_identical_rest(parameters, stop);
}

TEST(Restart, keeps_the_multipliers_of_augmented_contact)
{
  SceneParameters parameters               = coarse_scene();
  parameters.contact.augmentations         = 2;
  parameters.contact.penetration_tolerance = 1e-12;
  expect_identical_rest(parameters, 8);
}

TEST(Restart, keeps_the_shear_of_dry_and_wet_contact)
{
  SceneParameters parameters            = coarse_scene();
  parameters.interface.law              = InterfaceShear::limited_coulomb;
  parameters.interface.wet_shear_factor = 0.2;
  for (const unsigned int stop : {1, 8})
    expect_identical_rest(parameters, stop);
  parameters.lubrication.model   = LubricantModel::pocket;
  parameters.lubrication.wetting = 0.6;
  expect_identical_rest(parameters, 8);
}

TEST(Restart, goes_on_identically_in_three_dimensions)
{
  SceneParameters parameters         = narrow_scene();
  parameters.interface.law           = InterfaceShear::limited_coulomb;
  parameters.load.direction          = M_PI / 6.;
  parameters.lubrication.model       = LubricantModel::pocket;
  parameters.lubrication.wetting     = 0.7;
  parameters.lubrication.sealing_gap = 200e-9;
  expect_identical_rest<3>(parameters, 3);
}

// Before the mesh first changes, and between later changes.
TEST(Restart, goes_on_identically_on_a_mesh_that_has_changed)
{
  SceneParameters parameters         = adaptive_ridge();
  parameters.interface.law           = InterfaceShear::limited_coulomb;
  parameters.load.pressure           = 600e6;
  parameters.lubrication.model       = LubricantModel::pocket;
  parameters.lubrication.wetting     = 0.4;
  parameters.lubrication.sealing_gap = 30e-9;
  EXPECT_GE(expect_identical_rest<3>(parameters, 4), 2u);
  parameters.geometry.dimension = 2;
  for (const unsigned int stop : {1, 2, 5})
    EXPECT_GE(expect_identical_rest(parameters, stop), 2u);
}

TEST(Restart, refuses_cells_that_do_not_tile_the_chip)
{
  const SceneParameters     parameters = adaptive_ridge();
  Scene<3>                  scene(parameters);
  const auto                hierarchy = scene.space->hierarchy();
  std::vector<CellIndex<3>> cells;
  for (unsigned int cell = 0; cell < hierarchy->n_cells(); ++cell)
    cells.push_back(hierarchy->cell_index(cell));
  scene.set_mesh(parameters, cells);
  EXPECT_EQ(scene.space->hierarchy(), hierarchy);
  const auto message = [&](const std::vector<CellIndex<3>> &of) -> std::string {
    try
      {
        scene.set_mesh(parameters, of);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  };
  const std::string refusal = "The cells of the mesh do not tile the chip; "
                              "expected those of a checkpoint of this scene.";
  std::vector<CellIndex<3>> missing = cells, twice = cells, beyond = cells,
                            child = cells;
  missing.pop_back();
  EXPECT_EQ(message(missing), refusal);
  twice.back() = twice.front();
  EXPECT_EQ(message(twice), refusal);
  beyond.back().spans[0] += 1000;
  EXPECT_EQ(message(beyond), refusal);
  child.back().level += 7;
  EXPECT_EQ(message(child), refusal);
}

TEST(Restart, keeps_what_a_steady_window_has_seen)
{
  SceneParameters parameters           = coarse_scene();
  parameters.protocol.window           = FrictionWindow::steady;
  parameters.protocol.steady_distance  = 0.2e-6;
  parameters.protocol.steady_step      = 60e-9;
  parameters.protocol.steady_tolerance = 0.1;
  parameters.protocol.maximum_distance = 1.5e-6;
  expect_identical_rest(parameters, 7);
}

TEST(Restart, keeps_the_heat_of_chip_and_tool)
{
  SceneParameters parameters       = coarse_scene();
  parameters.heat.model            = HeatModel::conducting;
  parameters.heat.tool_temperature = 400.;
  for (const unsigned int stop : {1, 9})
    expect_identical_rest(parameters, stop);
  // The viscosity follows the temperature of the tool.
  parameters.lubrication.model               = LubricantModel::reynolds;
  parameters.lubrication.wetting             = 0.8;
  parameters.lubrication.oil.temperature.law = TemperatureLaw::vogel;
  expect_identical_rest(parameters, 8);
}

TEST(Restart, keeps_the_oil_of_each_pocket)
{
  SceneParameters parameters         = coarse_scene();
  parameters.load.pressure           = 1300e6;
  parameters.load.temperature        = 948.15;
  parameters.lubrication.model       = LubricantModel::pocket;
  parameters.lubrication.wetting     = 0.3;
  parameters.lubrication.sealing_gap = 20e-9;
  for (const unsigned int stop : {3, 8, 12})
    expect_identical_rest(parameters, stop);
  parameters.lubrication.oil.compressibility.law = DensityLaw::incompressible;
  parameters.lubrication.sealing_gap             = 0.;
  expect_identical_rest(parameters, 7);
}

TEST(Restart, keeps_the_oil_of_a_film)
{
  SceneParameters parameters     = coarse_scene();
  parameters.lubrication.model   = LubricantModel::reynolds;
  parameters.lubrication.wetting = 0.8;
  for (const unsigned int stop : {2, 9})
    expect_identical_rest(parameters, stop);
}

TEST(Restart, keeps_the_flow_in_the_gap_and_what_the_coupling_has_learnt)
{
  SceneParameters parameters       = coarse_scene();
  parameters.protocol.inertia      = Inertia::dynamic;
  parameters.protocol.slide_steps  = 5;
  parameters.lubrication.model     = LubricantModel::navier_stokes;
  parameters.lubrication.mesh.rows = 1;
  for (const unsigned int stop : {1, 6})
    expect_identical_rest(parameters, stop);
}

// Waves of the same length on both surfaces seal the gap in six places where
// their crests meet, and open it again.
TEST(Restart, goes_on_identically_where_pockets_have_just_split_or_merged)
{
  SceneParameters parameters         = coarse_scene();
  parameters.tool.wave_numbers       = {6};
  parameters.tool.amplitudes         = {0.03e-6};
  parameters.tool.phases             = {0.};
  parameters.chip.kind               = SurfaceKind::harmonics;
  parameters.chip.wave_numbers       = {6};
  parameters.chip.amplitudes         = {0.03e-6};
  parameters.chip.phases             = {M_PI};
  parameters.load.velocity           = 400. / 60.;
  parameters.protocol.inertia        = Inertia::dynamic;
  parameters.protocol.slide_steps    = 16;
  parameters.lubrication.model       = LubricantModel::navier_stokes;
  parameters.lubrication.mesh.rows   = 1;
  parameters.lubrication.sealing_gap = 60e-9;
  parameters.geometry.initial_gap    = 0.05e-6;
  const CompleteRun run(parameters);
  const auto       &rows    = run.rows();
  unsigned int      n_split = 0, n_merged = 0;
  for (unsigned int i = 2; i < rows.size(); ++i)
    {
      const bool split  = rows[i - 1].pockets == 1 && rows[i].pockets > 1;
      const bool merged = rows[i - 1].pockets > 1 && rows[i].pockets == 1;
      if (split || merged)
        expect_identical_rest(parameters, rows[i].step);
      n_split += split;
      n_merged += merged;
    }
  EXPECT_EQ(n_split, 1U);
  EXPECT_EQ(n_merged, 1U);
}

TEST(Restart, keeps_the_oil_that_has_left_the_gap)
{
  SceneParameters parameters             = coarse_scene();
  parameters.protocol.inertia            = Inertia::dynamic;
  parameters.protocol.slide_steps        = 5;
  parameters.lubrication.model           = LubricantModel::navier_stokes;
  parameters.lubrication.mesh.rows       = 1;
  parameters.lubrication.flow.left.kind  = GapEndKind::pressure;
  parameters.lubrication.flow.right.kind = GapEndKind::resistance;
  expect_identical_rest(parameters, 4);
}

TEST(Restart, refuses_the_state_of_another_mesh_and_one_that_is_cut_short)
{
  SceneParameters parameters = coarse_scene(), finer = coarse_scene();
  finer.mesh.spans = 48;
  Scene<2>          scene(parameters), finer_scene(finer);
  SlidingRun<2>     run(parameters, scene), finer_run(finer, finer_scene);
  const std::string state   = save(run, scene);
  const auto        message = [](const auto &call) -> std::string {
    try
      {
        call();
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  };
  EXPECT_EQ(message([&]() { load(state, finer_run, finer_scene); }),
            "The checkpoint holds " + std::to_string(scene.n_unknowns()) +
              " displacements, but " +
              std::to_string(finer_scene.n_unknowns()) + " are expected.");
  EXPECT_EQ(message(
              [&]() { load(state.substr(0, state.size() / 2), run, scene); }),
            "The state of the run is damaged: it does not hold what is "
            "expected of it.");
}

TEST(Restart, warns_of_another_program_and_refuses_other_inputs)
{
  const std::string path =
    std::filesystem::temp_directory_path() / "asperity_restart_program";
  std::filesystem::remove_all(path);
  const CheckpointFolder folder(path);
  InputRecord            inputs;
  inputs.entries.push_back({"Load/Pressure", "300 MPa", false, ""});
  inputs.entries.push_back({"Output/Restart", "false", false, ""});
  folder.write({"program 1", inputs, ""}, 5);
  inputs.entries[1].value = "true";
  EXPECT_TRUE(find_checkpoint(folder, inputs, "program 1").warnings.empty());
  const auto found = find_checkpoint(folder, inputs, "program 2");
  ASSERT_EQ(found.warnings.size(), 1u);
  EXPECT_EQ(found.warnings[0],
            "The checkpoint '" + folder.path(5) +
              "' was written by another program, program 1, than the one that "
              "goes on from it.");
  inputs.entries[0].value = "900 MPa";
  EXPECT_THROW(find_checkpoint(folder, inputs, "program 1"), InputError);
  std::filesystem::remove_all(path);
}

TEST(Restart, knows_which_entries_may_differ)
{
  // Each is an entry that exists, and those of the load are none of them.
  SceneParameters          parameters;
  dealii::ParameterHandler handler;
  ParameterDeclarator      declarator(handler);
  parameters.declare(declarator);
  std::set<std::string> differ;
  for (const ParameterEntry &entry : declarator.entries())
    if (entry.subsection != "Output" && may_differ_on_restart(entry.path()))
      differ.insert(entry.path());
  EXPECT_EQ(differ,
            (std::set<std::string>{"Accuracy/Control",
                                   "Accuracy/Error",
                                   "Accuracy/Maximum unknowns",
                                   "Coupling/Maximum iterations",
                                   "Protocol/Maximum distance",
                                   "Protocol/Steady distance",
                                   "Protocol/Steady tolerance",
                                   "Protocol/Window fraction",
                                   "Solver/Linear solver",
                                   "Solver/Maximum cuts",
                                   "Solver/Maximum iterations"}));
}
