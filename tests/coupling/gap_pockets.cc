#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/coupling/gap_pockets.h>
#include <asperity/flow/navier_stokes.h>

#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace asperity;

TEST(GapPockets, are_runs_of_open_columns_across_the_period)
{
  const std::vector<double> voids(8, 1.);
  GapPockets                pockets(voids, 1.);
  EXPECT_EQ(pockets.n_pockets(), 1U);
  pockets.open({2., 2., 0.5, 2., 2., 2., 0.9, 2.}, voids);
  EXPECT_EQ(pockets.n_pockets(), 2U);
  EXPECT_EQ(pockets.pocket(7), pockets.pocket(0));
  EXPECT_NE(pockets.pocket(1), pockets.pocket(3));
  EXPECT_FALSE(pockets.is_flowing()[2]);
  EXPECT_TRUE(pockets.is_flowing()[3]);
  pockets.open(std::vector<double>(8, 0.5), voids);
  EXPECT_EQ(pockets.n_pockets(), 0U);
  EXPECT_EQ(pockets.pocket(3), GapPockets::none);
  EXPECT_NEAR(pockets.total(), 8., 1e-14);
}

// A seal is divided at its narrowest column. One open column alone is too short
// to flow, and part of the seal.
TEST(GapPockets, have_the_seals_beside_them)
{
  const std::vector<double> voids(8, 1.);
  GapPockets                pockets(voids, 1.);
  pockets.open({2., 2., 0.6, 2., 0.5, 0.7, 2., 2.}, voids);
  // The run from 6 over 7 and 0 to 1, and a seal from 2 to 5.
  EXPECT_EQ(pockets.n_pockets(), 1U);
  EXPECT_FALSE(pockets.is_flowing()[3]);
  EXPECT_EQ(pockets.open_neighbour(3), 1U);
  EXPECT_EQ(pockets.open_neighbour(4), 1U);
  EXPECT_EQ(pockets.open_neighbour(5), 6U);
  EXPECT_EQ(pockets.open_neighbour(7), 7U);
  pockets.open({2., 2., 0.5, 0.6, 0.7, 2., 2., 0.5}, voids);
  ASSERT_EQ(pockets.n_pockets(), 2U);
  EXPECT_NEAR(pockets.oil()[0], 3., 1e-14);
  EXPECT_NEAR(pockets.oil()[1], 5., 1e-14);
}

// Parting divides by what was found in the columns, merging adds.
TEST(GapPockets, part_by_content_and_merge)
{
  const std::vector<double> voids(6, 1.);
  GapPockets                pockets(voids, 1.);
  pockets.spread({2., 2., 1., 1., 3., 3.});
  pockets.open({2., 2., 0., 2., 2., 0.}, voids);
  ASSERT_EQ(pockets.n_pockets(), 2U);
  EXPECT_NEAR(pockets.oil()[0], 6. * 5. / 12., 1e-14);
  EXPECT_NEAR(pockets.oil()[1], 6. * 7. / 12., 1e-14);
  pockets.open({2., 2., 2., 2., 2., 0.}, voids);
  EXPECT_NEAR(pockets.oil()[0], 6., 1e-14);
}

TEST(GapPockets, flow_once_their_void_has_closed_to_the_oil)
{
  GapPockets                pockets({1., 1., 1., 0., 0., 0.}, 1.);
  const std::vector<double> gaps = {2., 2., 0., 2., 2., 0.};
  pockets.open(gaps, {1.1, 1.1, 0.9, 1., 1., 1.});
  EXPECT_FALSE(pockets.is_full(0));
  EXPECT_FALSE(pockets.is_flowing()[0]);
  pockets.open(gaps, {1.1, 1., 0.9, 1., 1., 1.});
  EXPECT_TRUE(pockets.is_full(0));
  EXPECT_TRUE(pockets.is_flowing()[0]);
  EXPECT_FALSE(pockets.is_full(1));
  // The dry pocket joins: there is more room than oil again.
  pockets.open({2., 2., 2., 2., 2., 0.}, {1.1, 1., 0.9, 1., 1., 1.});
  EXPECT_FALSE(pockets.is_full(0));
}

TEST(GapPockets, go_through_an_archive)
{
  GapPockets pockets({1., 2., 3., 4., 5.}, 1.);
  pockets.open({2., 2., 0., 2., 2.}, std::vector<double>(5, 0.));
  const std::string bytes =
    to_bytes([&](OutputArchive &archive) { pockets.save(archive); });
  const auto read = [&bytes](GapPockets &into) {
    from_bytes(bytes, "pockets", [&into](InputArchive &archive) {
      into.load(archive);
    });
  };
  GapPockets copy(std::vector<double>(5, 1.), 1.);
  read(copy);
  EXPECT_EQ(copy.oil(), pockets.oil());
  EXPECT_EQ(copy.is_flowing(), pockets.is_flowing());
  GapPockets other(std::vector<double>(4, 1.), 1.);
  EXPECT_THROW(read(other), InputError);
}

namespace
{
  /** A mesh of height 1 and length 4.5 whose roof is a cosine. */
  dealii::Vector<double>
  lifted_roof(const NavierStokes &flow, const double amplitude)
  {
    const dealii::Vector<double> X  = flow.reference_positions();
    const auto                  &fe = flow.space().geometry_dofs().get_fe();
    dealii::Vector<double>       d(X.size());
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell :
         flow.space().geometry_dofs().active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int k = 0; k < dofs.size(); ++k)
          if (fe.system_to_component_index(k).first == 1)
            {
              const unsigned int a = fe.system_to_component_index(k).second;
              const double x = X(dofs[fe.component_to_system_index(0, a)]);
              d(dofs[k]) =
                X(dofs[k]) * amplitude * std::cos(2. * M_PI * x / 4.5);
            }
      }
    return d;
  }



  /** Two chambers in a row of columns, between them a gate that is shut in
   *  every other step, while the roof moves. */
  struct Chambers
  {
    Chambers(const unsigned int  n,
             const unsigned int  gate,
             const unsigned int  gate_end,
             const FluidOptions &options)
      : n(n)
      , gate(gate)
      , gate_end(gate_end)
      , flow(rectangle(n), options, {{0, 1, 0}})
      , pockets(std::vector<double>(n, 4.5 / n), 0.5)
    {}

    /** Opens or shuts the gate and moves the roof to the end of the step.
     *  @return whether the gate is shut */
    bool
    begin(const unsigned int step, const double dt)
    {
      const bool          is_shut = step % 2 == 0;
      std::vector<double> gaps(n, 1.);
      for (unsigned int i = gate; i < gate_end; ++i)
        gaps[i] = is_shut ? 0. : 1.;
      // Behind the last column there always is a wall.
      gaps[n - 1] = 0.;
      pockets.open(gaps, std::vector<double>(n, 0.)); // all flow
      EXPECT_EQ(pockets.n_pockets(), is_shut ? 2U : 1U);
      flow.set_active(pockets.is_flowing());
      flow.begin_step(dt);
      const double amplitude = 0.05 * std::sin(0.3 * (step + 1.));
      EXPECT_TRUE(flow.set_mesh_displacement(lifted_roof(flow, amplitude)));
      flow.boundary().set_wall_velocity(roof, flow.wall_mesh_velocity(roof));
      return is_shut;
    }

    const unsigned int       n, gate, gate_end;
    const BoundaryIds        floor = {2}, roof = {3};
    dealii::Triangulation<2> mesh;
    NavierStokes             flow;
    GapPockets               pockets;

  private:
    const dealii::Triangulation<2> &
    rectangle(const unsigned int n_columns)
    {
      dealii::GridGenerator::subdivided_hyper_rectangle(mesh,
                                                        {n_columns, 1U},
                                                        dealii::Point<2>(),
                                                        dealii::Point<2>(4.5,
                                                                         1.),
                                                        true);
      return mesh;
    }
  };
} // namespace

// Two chambers in a row, a column between them that opens and closes again 100
// times, while a prescribed motion of the mesh raises the roof of one and
// lowers that of the other. The floor gives way as Robin's condition says: a
// pocket whose oil is more than its void by V has, over its floor of length L,
// the pressure alpha a_0 V/L, a_0 = 1/dt, plus that of the mesh's motion, which
// is the same for all of it. What the pockets hold is conserved throughout.
TEST(GapPockets, merge_and_part_a_hundred_times)
{
  FluidOptions options;
  options.model.density             = 1e-3;
  options.model.viscosity.viscosity = 1e-6;
  options.scheme                    = FluidTimeScheme::implicit_euler;
  const unsigned int n              = 45;
  const double       alpha = 100., dt = 0.1;
  Chambers           chambers(n, 20, 25, options);
  NavierStokes      &flow    = chambers.flow;
  GapPockets        &pockets = chambers.pockets;
  const unsigned int n_floor = flow.boundary().nodes(chambers.floor).size();
  flow.boundary().set_robin(chambers.floor,
                            std::vector<double>(n_floor, alpha),
                            NodalVectors(n_floor),
                            NodalVectors(n_floor));
  for (unsigned int step = 0; step < 200; ++step)
    {
      const bool is_shut = chambers.begin(step, dt);
      // The columns are the cells. Those of seals are full, too.
      const std::vector<double> areas = flow.cell_areas();
      std::vector<double>       oil   = pockets.oil();
      for (unsigned int i = 0; i < n; ++i)
        if (!pockets.is_flowing()[i])
          oil[pockets.pocket(i)] -= areas[i];
      flow.set_part_volumes(oil);
      const ConvergenceReport report = flow.solve();
      ASSERT_TRUE(report.converged) << report.reason;

      const std::vector<double> voids = flow.part_volumes();
      for (unsigned int k = 0; k < pockets.n_pockets(); ++k)
        {
          const unsigned int columns = !is_shut ? 44 : k == 0 ? 20 : 19;
          const double       length  = 0.1 * columns;
          const double pressure = alpha * (oil[k] - voids[k]) / (dt * length);
          const double middle   = k == 0 ? (is_shut ? 1. : 2.2) : 3.5;
          // Its end cells are held by the inner walls.
          EXPECT_NEAR(flow.pressure_at({middle, 0.5}),
                      pressure,
                      0.03 * std::abs(pressure) + 0.02)
            << "step " << step;
        }
      flow.accept();
      pockets.spread(areas);
      EXPECT_NEAR(pockets.total(), 4.5, 4.5e-12);
    }
}

// The same without a floor that gives way: the oil is compressed, and each
// pocket has the pressure that the law tells for its content and its void,
// whatever the gate has done.
TEST(GapPockets, of_compressible_oil_have_the_pressure_of_their_density)
{
  FluidOptions options;
  options.model.density             = 1e-3;
  options.model.viscosity.viscosity = 1e-6;
  options.model.compressibility     = {DensityLaw::murnaghan, 10., 8.};
  const unsigned int n              = 18;
  Chambers           chambers(n, 8, 10, options);
  NavierStokes      &flow    = chambers.flow;
  GapPockets        &pockets = chambers.pockets;
  flow.boundary().set_wall_velocity(
    chambers.floor, NodalVectors(flow.boundary().nodes(chambers.floor).size()));
  for (unsigned int step = 0; step < 200; ++step)
    {
      chambers.begin(step, 0.1);
      // The oil in seals is as dense as that beside it.
      const std::vector<double> areas = flow.cell_areas();
      const std::vector<double> oil   = pockets.oil();
      std::vector<double> room(oil.size()), wanted(oil), found(oil.size());
      for (unsigned int i = 0; i < n; ++i)
        room[pockets.pocket(i)] += areas[i];
      for (unsigned int i = 0; i < n; ++i)
        if (!pockets.is_flowing()[i])
          {
            const unsigned int k = pockets.pocket(i);
            wanted[k] -= oil[k] * areas[i] / room[k];
          }
      flow.set_part_volumes(wanted);
      const ConvergenceReport report = flow.solve();
      ASSERT_TRUE(report.converged) << report.reason;

      std::vector<double> contents = flow.cell_contents();
      for (unsigned int i = 0; i < n; ++i)
        if (pockets.is_flowing()[i])
          found[pockets.pocket(i)] += contents[i];
        else
          contents[i] =
            oil[pockets.pocket(i)] * areas[i] / room[pockets.pocket(i)];
      for (unsigned int k = 0; k < oil.size(); ++k)
        {
          EXPECT_NEAR(found[k] / wanted[k], 1., 1e-8) << "step " << step;
          const double p =
            options.model.compressibility.pressure(oil[k] / room[k]);
          EXPECT_NEAR(flow.pressure_at({k == 0 ? 1. : 3.2, 0.5}), p, 2e-3)
            << "step " << step;
        }
      flow.accept();
      pockets.spread(contents);
      EXPECT_NEAR(pockets.total(), 4.5, 4.5e-12);
    }
}
