#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/heat/thermal_contact.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "chip_examples.h"

// The chip is a block that a half-space continues: one more half-space.

namespace
{
  using namespace asperity;
  using namespace heat_example;

  const ThermalProperties steel{45., 7850., 450.}, carbide{88., 15250., 292.};

  constexpr double L = 10e-6;

  /** Steel of 1 um below carbide. */
  template <int dim>
  struct PairIn
  {
    explicit PairIn(const double offset, const unsigned int n_spans = 16)
      : block(2, L, n_spans, rows(1e-6, 0.32e-6 / n_spans, 1.3))
      , chip(block.conduction(steel))
      , contact(block.top, carbide, waves<dim>(L, n_spans), offset)
    {
      chip.continue_beyond(block.bottom, waves<dim>(L, n_spans / 4));
    }

    /** The same heat at all points, which slide over the tool with the place of
     *  the chip along each axis. */
    InterfaceHeat<dim>
    interface(const double conductance,
              const double friction,
              const double place) const
    {
      InterfaceHeat<dim> heat;
      heat.places = places_along(block.top.position);
      for (auto &at : heat.places)
        for (unsigned int d = 0; d < dim - 1; ++d)
          at[d] += place;
      heat.conductance.assign(heat.places.size(), conductance);
      heat.friction.assign(heat.places.size(), friction);
      return heat;
    }

    typename ThermalContact<dim>::Step
    step(const double dt, const InterfaceHeat<dim> &heat)
    {
      chip.begin_step(block.at_rest(), dt);
      const auto step =
        contact.solve(chip, dt, Vector(block.space.n_functions()), heat);
      chip.accept(step.chip_change);
      contact.accept(step);
      return step;
    }

    double
    heat_of_chip() const
    {
      return chip.stored() + chip.passed_on();
    }

    BlockIn<dim>        block;
    HeatConduction<dim> chip;
    ThermalContact<dim> contact;
  };

  using Pair = PairIn<2>;
} // namespace



TEST(ThermalContact, of_unlike_temperature_meets_between_by_effusivity)
{
  // (e1 T1 + e2 T2)/(e1 + e2), at every moment (Carslaw and Jaeger 1959,
  // section 2.9).
  Pair         pair(100.);
  const double e1 = steel.effusivity(), e2 = carbide.effusivity();
  const auto   heat = pair.interface(1e12, 0., 0.);
  for (unsigned int i = 0; i < 100; ++i)
    {
      const auto step = pair.step(2e-9, heat);
      if (i >= 20)
        for (unsigned int q = 0; q < step.chip.size(); ++q)
          {
            EXPECT_NEAR(step.chip[q], 100. * e2 / (e1 + e2), 0.7);
            EXPECT_NEAR(step.tool[q], step.chip[q], 0.01);
          }
    }
  EXPECT_NEAR(pair.heat_of_chip() + pair.contact.heat_of_tool(),
              0.,
              1e-12 * pair.heat_of_chip());
  // e1 e2/(e1 + e2) 2 sqrt(t/pi) per temperature
  EXPECT_NEAR(pair.heat_of_chip(),
              L * 100. * e1 * e2 / (e1 + e2) * 2. * std::sqrt(2e-7 / M_PI),
              0.01 * pair.heat_of_chip());
}



TEST(ThermalContact, shares_frictional_heat_by_effusivity)
{
  Pair         pair(0.);
  const double q = 3e9, e1 = steel.effusivity(), e2 = carbide.effusivity();
  ThermalContact<2>::Step step;
  for (unsigned int i = 0; i < 100; ++i)
    step = pair.step(2e-9, pair.interface(1e12, q, 3e-9 * i));
  const double rise = 2. * q * std::sqrt(2e-7 / M_PI) / (e1 + e2);
  for (const double value : step.chip)
    EXPECT_NEAR(value, rise, 0.005 * rise);
  const double put_in = q * 2e-7 * L;
  EXPECT_NEAR(pair.contact.heat_of_tool() / put_in, e2 / (e1 + e2), 0.004);
  EXPECT_NEAR(pair.contact.heat_of_tool() + pair.heat_of_chip(),
              put_in,
              1e-11 * put_in);
}



TEST(ThermalContact, evens_temperatures_out_as_its_conductance_lets_it)
{
  // Halves of the frictional heat go into both, and the difference D of
  // temperatures drives h D. By Laplace's transform, with b = 1/e1 + 1/e2 and
  // a = 1/e1 - 1/e2,
  //   D = a q/(2 h b) (1 - exp(h^2 b^2 t) erfc(h b sqrt(t))),
  // which tends to a q sqrt(t/pi) as h goes to 0.
  const double q = 3e9, e1 = steel.effusivity(), e2 = carbide.effusivity(),
               a = 1. / e1 - 1. / e2, b = 1. / e1 + 1. / e2, t = 2e-7;
  for (const double h : {0., 1., 1e4, 1e7, 1e8, 1e12})
    {
      Pair                    pair(0.);
      ThermalContact<2>::Step step;
      for (unsigned int i = 0; i < 200; ++i)
        step = pair.step(t / 200, pair.interface(h, q, 3e-9 * i));
      const double z = h * b * std::sqrt(t);
      const double decay =
        z > 20. ? 1. / (z * std::sqrt(M_PI)) : std::exp(z * z) * std::erfc(z);
      const double exact = h < 1e3 ? a * q * std::sqrt(t / M_PI) :
                                     a * q / (2. * h * b) * (1. - decay);
      for (unsigned int p = 0; p < step.chip.size(); ++p)
        {
          EXPECT_NEAR(step.chip[p] - step.tool[p], exact, 0.02 * exact)
            << "h = " << h;
          EXPECT_NEAR(step.to_tool[p],
                      0.5 * q + h * (step.chip[p] - step.tool[p]),
                      1e-6 * q);
        }
      EXPECT_NEAR((pair.contact.heat_of_tool() + pair.heat_of_chip()) /
                    (q * t * L),
                  1.,
                  1e-11);
    }
}



namespace
{
  /** Spots with and without contact, heat at some of them: at each point the
   *  heat is what its two temperatures say, and nothing is lost. */
  template <int dim>
  void
  expect_balance_at_spots(PairIn<dim> pair, const unsigned int n_steps)
  {
    double put_in = 0.;
    for (unsigned int i = 0; i < n_steps; ++i)
      {
        InterfaceHeat<dim> heat = pair.interface(0., 0., 40e-9 * i);
        for (unsigned int q = 0; q < heat.places.size(); ++q)
          {
            double wave = std::sin(6. * M_PI * heat.places[q][0] / L);
            if (dim == 3)
              wave *= std::cos(2. * M_PI * heat.places[q][dim - 2] / L);
            heat.conductance[q] = wave > 0.3 ? 1e9 : (wave > -0.5 ? 1e6 : 0.);
            heat.friction[q]    = wave > 0.3 ? 1e10 * wave : 0.;
            put_in += 1e-9 * pair.block.top.JxW[q] * heat.friction[q];
          }
        const auto   step  = pair.step(1e-9, heat);
        const double scale = 1e10;
        for (unsigned int q = 0; q < heat.places.size(); ++q)
          EXPECT_NEAR(step.to_tool[q],
                      0.5 * heat.friction[q] +
                        heat.conductance[q] * (step.chip[q] - step.tool[q]),
                      1e-7 * scale);
        EXPECT_LT(step.iterations, 60u);
      }
    EXPECT_NEAR(pair.contact.heat_of_tool() + pair.heat_of_chip(),
                put_in,
                1e-11 * put_in);
  }
} // namespace



TEST(ThermalContact, balances_temperatures_at_each_spot)
{
  expect_balance_at_spots(PairIn<2>(-40.), 20);
  expect_balance_at_spots(PairIn<3>(-40., 8), 3);
}



TEST(ThermalContact, goes_on_from_an_archive_and_refuses_another_tool)
{
  Pair pair(10.), copy(10.);
  pair.step(1e-9, pair.interface(1e8, 1e9, 0.));
  const std::string bytes = to_bytes([&](OutputArchive &archive) {
    pair.chip.save(archive);
    pair.contact.save(archive);
  });
  const auto load = [&](HeatConduction<2> &chip, ThermalContact<2> &contact) {
    from_bytes(bytes, "The heat", [&](InputArchive &archive) {
      chip.load(archive);
      contact.load(archive);
    });
  };
  load(copy.chip, copy.contact);
  const auto after = pair.step(2e-9, pair.interface(1e8, 1e9, 1e-8)),
             again = copy.step(2e-9, copy.interface(1e8, 1e9, 1e-8));
  EXPECT_EQ(again.chip, after.chip);
  EXPECT_EQ(again.to_tool, after.to_tool);

  ThermalContact<2> other(pair.block.top, carbide, waves(L, 8), 10.);
  EXPECT_THROW(load(copy.chip, other), InputError);
}
