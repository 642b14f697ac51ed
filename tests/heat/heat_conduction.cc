#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/heat/heat_conduction.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "chip_examples.h"

namespace
{
  using namespace asperity;
  using namespace heat_example;

  const ThermalProperties material{3., 2., 5.};

  /**
   * Of T = t phi with phi = cos(pi x) exp(z), or cos(pi x) cos(pi y) exp(z) in
   * three dimensions, in the current position, on a block that is sheared and
   * stretched, x = X + 0.4 Z and z = 0.7 Z + 0.2 Z^2, whose splines have it
   * exactly from degree 2 on. Backward Euler has no error, so that of the space
   * is left: its L2 norm after one step of length one.
   */
  template <int dim>
  double
  error_on_a_deformed_block(const unsigned int degree, const unsigned int n)
  {
    const BlockIn<dim> block(degree, 2., 2 * n, BlockIn<dim>::columns(1., n));
    const unsigned int up      = dim - 1;
    const auto         stretch = [up](const Point<dim> &X) {
      return 0.7 + 0.4 * X[up];
    };
    const auto phi = [up](const Point<dim> &X) {
      const double Z = X[up], x = X[0] + 0.4 * Z, z = 0.7 * Z + 0.2 * Z * Z;
      return std::cos(M_PI * x) * (dim == 3 ? std::cos(M_PI * X[1]) : 1.) *
             std::exp(z);
    };
    const Vector        u    = block.displacement([up](const Point<dim> &X) {
      std::vector<double> moved(dim, 0.);
      moved[0]  = 0.4 * X[up];
      moved[up] = -0.3 * X[up] + 0.2 * X[up] * X[up];
      return moved;
    });
    HeatConduction<dim> body = block.conduction(material);
    body.begin_step(u, 1.);
    // s = rho0 c phi - J lambda t Laplace(phi), per reference volume.
    Vector power(block.space.n_functions());
    body.add_source(block.at_points([&](const Point<dim> &X) {
      return phi(X) * (10. - stretch(X) * 3. * (1. - up * M_PI * M_PI));
    }),
                    power);
    // The edges keep their length: lambda dphi/dz goes in at the top, and the
    // same out at the bottom.
    block.add_flux(
      block.top, [&](const Point<dim> &X) { return 3. * phi(X); }, power);
    block.add_flux(
      block.bottom, [&](const Point<dim> &X) { return -3. * phi(X); }, power);
    body.accept(body.change(power));
    const Vector rise = body.rise_at_points();
    double       sum  = 0.;
    for (unsigned int q = 0; q < rise.size(); ++q)
      sum += block.cells.JxW[q] *
             std::pow(rise[q] - phi(block.cells.position[q]), 2);
    return std::sqrt(sum);
  }

  template <int dim>
  void
  expect_order(const unsigned int degree, const unsigned int n)
  {
    const double coarse = error_on_a_deformed_block<dim>(degree, n),
                 fine   = error_on_a_deformed_block<dim>(degree, 2 * n);
    EXPECT_GT(std::log2(coarse / fine), degree + 0.9) << coarse;
    EXPECT_LT(fine, n > 4 ? 2e-3 : 1e-2);
  }
} // namespace



TEST(HeatConduction, converges_in_space_on_a_deformed_body)
{
  expect_order<2>(2, 6);
  expect_order<2>(3, 6);
}



TEST(HeatConduction, converges_in_space_in_three_dimensions)
{
  expect_order<3>(2, 3);
}



TEST(HeatConduction, converges_in_time)
{
  // T = sin(t) cos(pi x) in an insulated block; s = rho c cos(t) cos(pi x) +
  // lambda pi^2 T.
  const Block block(3, 2., 16, {0., 1.});
  const auto  error = [&](const unsigned int n_steps) {
    HeatConduction<2> body = block.conduction(material);
    const double      dt   = 1. / n_steps;
    for (unsigned int i = 1; i <= n_steps; ++i)
      {
        body.begin_step(block.at_rest(), dt);
        Vector       power(block.space.n_functions());
        const double s =
          10. * std::cos(i * dt) + 3. * M_PI * M_PI * std::sin(i * dt);
        body.add_source(block.at_points([s](const Point<2> &X) {
          return s * std::cos(M_PI * X[0]);
        }),
                        power);
        body.accept(body.change(power));
      }
    const Vector rise    = body.rise_at_points();
    double       largest = 0.;
    for (unsigned int q = 0; q < rise.size(); ++q)
      largest =
        std::max(largest,
                 std::abs(rise[q] -
                          std::sin(1.) *
                            std::cos(M_PI * block.cells.position[q][0])));
    return largest;
  };
  const double coarse = error(20), fine = error(40);
  EXPECT_NEAR(std::log2(coarse / fine), 1., 0.1);
  EXPECT_LT(fine, 0.005);
}



namespace
{
  /** Mean rise of the top, and amplitude of the wave in it, after `duration`
   *  under a flux of 1 and the wave cos(2 pi x/L), in three dimensions
   *  cos(2 pi x/L) cos(2 pi y/L), with L = 1, on a block that a half-space
   *  continues. */
  template <int dim>
  std::pair<double, double>
  warm_from_above(const unsigned int         n_spans,
                  const std::vector<double> &rows,
                  const double               duration,
                  const unsigned int         n_steps)
  {
    const BlockIn<dim>  block(2, 1., n_spans, rows);
    HeatConduction<dim> body = block.conduction(material);
    body.continue_beyond(block.bottom, waves<dim>(1., n_spans / 4));
    const auto wave = [](const Point<dim> &X) {
      return std::cos(2. * M_PI * X[0]) *
             (dim == 3 ? std::cos(2. * M_PI * X[1]) : 1.);
    };
    for (unsigned int i = 0; i < n_steps; ++i)
      {
        body.begin_step(block.at_rest(), duration / n_steps);
        Vector power(block.space.n_functions());
        block.add_flux(
          block.top, [&](const Point<dim> &X) { return 1. + wave(X); }, power);
        body.accept(body.change(power));
      }
    const Vector top  = values_at_points(block.top, body.rise());
    double       mean = 0., amplitude = 0.;
    for (unsigned int q = 0; q < top.size(); ++q)
      {
        mean += block.top.JxW[q] * top[q];
        amplitude += (dim == 3 ? 4. : 2.) * block.top.JxW[q] * top[q] *
                     wave(block.top.position[q]);
      }
    EXPECT_NEAR(body.stored() + body.passed_on(), duration, 1e-10 * duration);
    return {mean, amplitude};
  }
} // namespace



TEST(HeatConduction, goes_on_into_the_depth_as_if_there_were_no_edge)
{
  // 2 q sqrt(t/(pi lambda rho c)) and q/(lambda kappa) at the surface of a
  // half-space; an insulated block of height 0.1 would be at 10 t = 20 in the
  // mean, and at coth(0.2 pi) = 1.8 times the amplitude.
  const double duration  = 20.;
  const double mean      = 2. * std::sqrt(duration / (M_PI * 30.)),
               amplitude = 1. / (3. * 2. * M_PI);
  for (const double height : {0.1, 0.5, 2.})
    {
      const auto [found_mean, found_amplitude] =
        warm_from_above<2>(16, rows(height, 0.02, 1.3), duration, 200);
      EXPECT_NEAR(found_mean, mean, 0.01 * mean) << height;
      EXPECT_NEAR(found_amplitude, amplitude, 0.002 * amplitude) << height;
    }
}



TEST(HeatConduction, goes_on_into_the_depth_below_a_face)
{
  // As above, with kappa = 2 pi sqrt(2).
  const double duration  = 20.;
  const double mean      = 2. * std::sqrt(duration / (M_PI * 30.)),
               amplitude = 1. / (3. * 2. * M_PI * std::sqrt(2.));
  const auto [found_mean, found_amplitude] =
    warm_from_above<3>(8, rows(0.1, 0.03, 1.3), duration, 60);
  EXPECT_NEAR(found_mean, mean, 0.01 * mean);
  EXPECT_NEAR(found_amplitude, amplitude, 0.01 * amplitude);
}



TEST(HeatConduction, conserves_heat_to_round_off)
{
  Block block(2, 2., 8, rows(1., 0.1, 1.4));
  block.space.refine_to_level(1, [](const auto &, const auto &high) {
    return high[1] > 0.9;
  });
  block.cells  = tabulate_cells(block.space, {}, dealii::QGauss<2>(2));
  block.top    = block.edge(Edge::top);
  block.bottom = block.edge(Edge::bottom);
  HeatConduction<2> body = block.conduction(material);
  body.continue_beyond(block.bottom, waves(2., 3));
  double put_in = 0.;
  for (unsigned int i = 0; i < 20; ++i)
    {
      const double dt = std::pow(10., -4. * std::abs(std::sin(i)));
      const Vector u  = block.displacement([&](const Point<2> &X) {
        return std::vector<double>{0.1 * std::sin(M_PI * X[0] + i),
                                   0.3 * X[1] * std::cos(M_PI * X[0])};
      });
      body.begin_step(u, dt);
      Vector     power(block.space.n_functions());
      const auto source = block.at_points(
        [&](const Point<2> &X) { return std::sin(5. * X[0] + i) + 0.5; });
      body.add_source(source, power);
      for (unsigned int q = 0; q < source.size(); ++q)
        put_in += dt * block.cells.JxW[q] * source[q];
      const double before = body.stored() + body.passed_on();
      body.accept(body.change(power));
      const double gained = body.stored() + body.passed_on() - before;
      EXPECT_NEAR(gained, dt * power.mean_value() * power.size(), 1e-12);
    }
  EXPECT_NEAR(body.stored() + body.passed_on(), put_in, 1e-12 * put_in);
}



TEST(HeatConduction, keeps_heat_where_it_is_done_without_conductivity)
{
  const Block       block(2, 2., 8, rows(1., 0.1, 1.4));
  HeatConduction<2> body   = block.conduction({1e-12, 2., 5.});
  const auto        source = block.at_points(
    [](const Point<2> &X) { return 3. + 2. * X[1] - X[1] * X[1]; });
  for (unsigned int i = 0; i < 3; ++i)
    {
      body.begin_step(block.at_rest(), 0.1);
      Vector power(block.space.n_functions());
      body.add_source(source, power);
      body.accept(body.change(power));
    }
  const Vector rise = body.rise_at_points();
  for (unsigned int q = 0; q < rise.size(); ++q)
    EXPECT_NEAR(rise[q], 0.3 * source[q] / 10., 1e-11);
}



TEST(HeatConduction, goes_on_from_an_archive_and_refuses_another_body)
{
  const Block block(2, 2., 8, rows(1., 0.1, 1.4));
  const auto  step = [&](HeatConduction<2> &body) {
    body.begin_step(block.at_rest(), 0.1);
    Vector power(block.space.n_functions());
    Block::add_flux(
      block.top, [](const Point<2> &X) { return X[0]; }, power);
    body.accept(body.change(power));
  };
  HeatConduction<2> body = block.conduction(material);
  body.continue_beyond(block.bottom, waves(2., 2));
  step(body);
  const std::string bytes =
    to_bytes([&](OutputArchive &archive) { body.save(archive); });
  HeatConduction<2> copy = block.conduction(material);
  copy.continue_beyond(block.bottom, waves(2., 2));
  from_bytes(bytes, "The chip", [&](InputArchive &archive) {
    copy.load(archive);
  });
  step(body);
  step(copy);
  EXPECT_EQ(copy.rise(), body.rise());
  EXPECT_EQ(copy.passed_on(), body.passed_on());

  const Block       smaller(2, 2., 7, rows(1., 0.1, 1.4));
  HeatConduction<2> other = smaller.conduction(material);
  try
    {
      from_bytes(bytes, "The chip", [&](InputArchive &archive) {
        other.load(archive);
      });
      FAIL();
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("temperatures of the chip"),
                std::string::npos)
        << error.what();
    }
}
