#include <gtest/gtest.h>

#include <cmath>

#include "flooded_scene.h"

using namespace asperity;

// The coupled step leaves chip, oil and tool in balance: in generalized-alpha,
// with the mass m of the chip and its mean vertical acceleration a,
//   m ((1 - alpha_m) a_1 + alpha_m a_0)
//     = (1 - alpha_f) (T_1 + p_1 L) + alpha_f (T_0 + p_0 L).
TEST(GapFlow, carries_load_and_inertia)
{
  const SceneParameters parameters = flooded_scene();
  const double          rho        = parameters.protocol.spectral_radius;
  const double          alpha_m    = (2. * rho - 1.) / (rho + 1.),
               alpha_f             = rho / (rho + 1.);

  Scene<2>      scene(parameters);
  SlidingRun<2> run(parameters, scene);
  const auto    mass = scene.equilibrium->make_matrix();
  scene.chip->assemble_mass(*mass);
  const dealii::Vector<double> lift = scene.translation(0., 1.);
  dealii::Vector<double>       inertia(lift.size());
  double                       old_inertia = 0., old_force = 0., n_steps = 0.;
  run.run([&](const SlidingRun<2> &now) {
    const FrictionRow &row = now.state().rows.back();
    mass->vmult(inertia, now.solid_step().state().a);
    const double new_inertia = lift * inertia;
    const double new_force =
      row.T_y + now.protocol().pressure(row.time) * scene.length;
    EXPECT_NEAR((1. - alpha_m) * new_inertia + alpha_m * old_inertia,
                (1. - alpha_f) * new_force + alpha_f * old_force,
                1e-4 * parameters.load.pressure * scene.length)
      << "step " << row.step;
    old_inertia = new_inertia;
    old_force   = new_force;
    ++n_steps;
  });
  EXPECT_EQ(n_steps, 15.);
  // Oil carries nearly all.
  const FrictionRow &last = run.state().rows.back();
  EXPECT_NEAR(last.oil_pressure / parameters.load.pressure, 1., 0.1);
}

// Up to the tolerance of 1e-5 between chip and oil.
TEST(GapFlow, keeps_its_volume_in_every_step)
{
  const CompleteRun run(flooded_scene());
  const double      start = run.rows()[1].oil_reference_volume;
  for (unsigned int i = 1; i < run.rows().size(); ++i)
    EXPECT_NEAR(run.rows()[i].void_volume, start, 1e-5 * start) << "step " << i;
}

namespace
{
  /** A flat chip that slides below a tool of small slope. */
  SceneParameters
  slider_scene()
  {
    SceneParameters parameters      = flooded_scene();
    parameters.chip.kind            = SurfaceKind::flat;
    parameters.tool.wave_numbers    = {1, 2};
    parameters.tool.amplitudes      = {0.05e-6, 0.02e-6};
    parameters.tool.phases          = {0.3, 1.9};
    parameters.geometry.initial_gap = 0.1e-6;
    parameters.load.pressure        = 1e6;
    parameters.lubrication.model    = LubricantModel::stokes;
    return parameters;
  }

  /** Lubrication theory of a flat wall that slides with U below a rigid wall at
   *  rest of small slope (O. Reynolds, 1886): with the gap h and I_n the
   *  integral of h^-n over the period, the flow is q = U I_2/(2 I_3) and the
   *  shear stress on the sliding wall -4 eta U/h + 6 eta q/h^2. */
  double
  shear_of_slider(const Scene<2>        &scene,
                  const SceneParameters &parameters,
                  const double           eta)
  {
    const double U   = parameters.load.velocity;
    const auto   sum = [&](const double n) {
      const unsigned int n_points = 1000;
      double             integral = 0.;
      for (unsigned int i = 0; i < n_points; ++i)
        {
          const double x = scene.length * i / n_points;
          integral +=
            std::pow(scene.tool_surface.height(x) - parameters.geometry.height,
                     -n);
        }
      return integral * scene.length / n_points;
    };
    const double q = 0.5 * U * sum(2.) / sum(3.);
    return -4. * eta * U * sum(1.) + 6. * eta * q * sum(2.);
  }
} // namespace

TEST(GapFlow, shears_as_lubrication_theory_says)
{
  const SceneParameters parameters = slider_scene();
  const CompleteRun     run(parameters);
  const double          expected =
    shear_of_slider(run.scene,
                    parameters,
                    parameters.lubrication.oil.viscosity.viscosity);
  // Slopes are at most 0.06, the chip gives way by 1e-4 of the gap.
  EXPECT_NEAR(run.rows().back().shear_T_x / expected, 1., 0.005);
}

// A chip that is 100 K hotter than the tool warms the oil by 50 K.
TEST(GapFlow, is_as_warm_as_the_mean_of_its_walls)
{
  SceneParameters       parameters = slider_scene();
  LubricantTemperature &law        = parameters.lubrication.oil.temperature;
  law.law                          = TemperatureLaw::vogel;
  parameters.load.temperature      = law.reference;

  Scene<2>      scene(parameters);
  SlidingRun<2> run(parameters, scene);
  auto          hot = scene.chip->history();
  for (MaterialState &point : hot)
    point.temperature += 100.;
  scene.chip->set_history(hot);
  run.run([](const SlidingRun<2> &) {});
  const double expected =
    shear_of_slider(scene,
                    parameters,
                    law.viscosity(0.032, law.reference + 50.));
  EXPECT_NEAR(run.state().rows.back().shear_T_x / expected, 1., 0.005);
}

namespace
{
  /** The end of a run with so many times the steps, columns and rows. */
  FrictionRow
  end_of_run(const std::function<void(FlowParameters &)> &choose,
             const unsigned int                           finer_steps = 1,
             const unsigned int                           finer_mesh  = 1)
  {
    SceneParameters parameters = flooded_scene();
    parameters.protocol.ramp_steps *= finer_steps;
    parameters.protocol.slide_steps *= finer_steps;
    parameters.lubrication.mesh.columns_per_span *= finer_mesh;
    parameters.lubrication.mesh.rows *= finer_mesh;
    choose(parameters.lubrication.flow);
    const CompleteRun run(parameters);
    return run.rows().back();
  }

  void
  usual(FlowParameters &)
  {}
} // namespace

// Two solvers agree to what the iterations between chip and oil leave, two ways
// to move the inner nodes to the error that both have.
TEST(GapFlow, answers_alike_by_each_solver_and_mesh_update)
{
  const FrictionRow expected     = end_of_run(usual);
  const auto        expect_alike = [&](const FrictionRow &row,
                                const double       tolerance) {
    EXPECT_NEAR(row.shear_T_x / expected.shear_T_x, 1., tolerance);
    EXPECT_NEAR(row.oil_pressure / expected.oil_pressure, 1., tolerance);
  };
  expect_alike(end_of_run([](FlowParameters &flow) {
                 flow.solver = FlowSolverKind::krylov;
               }),
               1e-4);
  expect_alike(end_of_run([](FlowParameters &flow) {
                 flow.mesh_update = MeshUpdateKind::elastic;
               }),
               0.005);
}

// What another time scheme and another element change is an error of the steps
// and of the mesh: it falls with them.
TEST(GapFlow, other_schemes_and_elements_converge_to_the_same)
{
  const auto euler = [](FlowParameters &flow) {
    flow.time_scheme = FluidTimeScheme::implicit_euler;
  };
  const auto equal_order = [](FlowParameters &flow) {
    flow.element = FluidElement::equal_order;
  };
  const auto difference =
    [](const std::function<void(FlowParameters &)> &choose,
       const unsigned int                           finer_steps,
       const unsigned int                           finer_mesh) {
      return std::abs(end_of_run(choose, finer_steps, finer_mesh).shear_T_x /
                        end_of_run(usual, finer_steps, finer_mesh).shear_T_x -
                      1.);
    };
  const double of_steps = difference(euler, 1, 1);
  EXPECT_GT(of_steps, 1e-4);
  EXPECT_LT(difference(euler, 2, 1), 0.65 * of_steps);
  EXPECT_LT(difference(equal_order, 1, 2), 0.5 * difference(equal_order, 1, 1));
}

// All of the void is one pocket, in which the slow flow hardly makes
// differences of the pressure after the load's ramp: it is that of the mean
// density.
TEST(GapFlow, compressible_oil_has_the_pressure_of_its_density)
{
  SceneParameters parameters = flooded_scene();
  parameters.load.velocity /= 10.;
  parameters.lubrication.flow.compressible = true;
  const CompleteRun run(parameters);
  const auto       &density = parameters.lubrication.oil.compressibility;
  for (unsigned int i = 6; i < run.rows().size(); ++i)
    {
      const FrictionRow &row = run.rows()[i];
      const double       p =
        density.pressure(row.oil_reference_volume / row.void_volume);
      EXPECT_NEAR(row.oil_pressure, p, 0.01 * p) << "step " << i;
    }
}

// Enclosed oil that can be compressed leaves the chip a way to move, so that
// the wall's velocity can be prescribed.
TEST(GapFlow, compressible_oil_allows_dirichlet_neumann_coupling)
{
  struct Enough
  {};
  SceneParameters parameters               = flooded_scene();
  parameters.lubrication.flow.compressible = true;
  std::vector<std::vector<FrictionRow>> rows;
  for (const auto scheme :
       {CouplingScheme::robin_neumann, CouplingScheme::dirichlet_neumann})
    {
      parameters.lubrication.coupling.scheme = scheme;
      Scene<2>      scene(parameters);
      SlidingRun<2> run(parameters, scene);
      EXPECT_THROW(run.run([](const SlidingRun<2> &now) {
        if (now.state().step == 4)
          throw Enough();
      }),
                   Enough);
      rows.push_back(run.state().rows);
    }
  for (unsigned int i = 1; i < rows[0].size(); ++i)
    {
      EXPECT_NEAR(rows[1][i].time / rows[0][i].time, 1., 1e-12);
      EXPECT_NEAR(rows[1][i].oil_pressure / rows[0][i].oil_pressure, 1., 1e-4);
    }
}

TEST(GapFlow, refuses_what_it_cannot_represent)
{
  SceneParameters parameters     = flooded_scene();
  parameters.lubrication.wetting = 0.5;
  EXPECT_NE(complaint(parameters).find("fills the void"), std::string::npos);
  parameters.lubrication.wetting = 1.;
  parameters.protocol.inertia    = Inertia::quasi_static;
  EXPECT_NE(complaint(parameters).find("expected dynamic or automatic"),
            std::string::npos);
  parameters.protocol.inertia = Inertia::automatic;
  EXPECT_EQ(complaint(parameters), "");
  parameters.lubrication.coupling.scheme = CouplingScheme::dirichlet_neumann;
  EXPECT_NE(complaint(parameters)
              .find("expected Robin-Neumann, "
                    "Flow/Compressible = true or open ends."),
            std::string::npos);
  parameters.lubrication.flow.compressible = true;
  EXPECT_EQ(complaint(parameters), "");
  parameters.lubrication.oil.compressibility.law = DensityLaw::incompressible;
  EXPECT_NE(complaint(parameters)
              .find("found true with the Density law "
                    "incompressible"),
            std::string::npos);
}

TEST(GapFlow, makes_the_chip_dynamic)
{
  SceneParameters parameters  = flooded_scene();
  parameters.protocol.inertia = Inertia::automatic;
  const Scene<2> scene(parameters);
  EXPECT_EQ(audit_scene(parameters, scene).inertia, Inertia::dynamic);
}
