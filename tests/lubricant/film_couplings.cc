#include <asperity/lubricant/film_term.h>
#include <asperity/splines/spline_fit.h>

#include <gtest/gtest.h>

#include <cmath>

// A factorisation without pivoting eliminates unknowns with the same couplings
// in their order: the pressure of a cell before its fraction, which has no
// pivot of its own where the film has cavitated.
TEST(FilmCouplings, of_a_fraction_are_those_of_its_pressure)
{
  using namespace asperity;
  const SplineSpace<2> space(KnotVector(2,
                                        {0., 0.4, 1., 1.5, 2., 3., 4.},
                                        true),
                             KnotVector(2, {0., 0.5, 1.}));
  const SplineCurve    tool = interpolate_periodic_function(
    [](const double x) { return 1.5 + 0.2 * std::sin(M_PI * x); },
    0.,
    4.,
    16,
    3);
  FilmTermOptions options;
  options.cells_per_span    = 2;
  const unsigned int n_chip = 2 * space.n_functions();
  const FilmTerm     film(space, PatchGeometry<2>(), tool, options, n_chip);
  const unsigned int n = n_chip + film.n_unknowns();
  dealii::DynamicSparsityPattern pattern(n);
  film.add_couplings(pattern);
  const auto coupled = [&](const unsigned int i, const unsigned int j) {
    return pattern.exists(i, j) || pattern.exists(j, i);
  };
  for (unsigned int p = n_chip; p < n; p += 2)
    for (unsigned int i = 0; i < n; ++i)
      EXPECT_EQ(coupled(p, i), coupled(p + 1, i)) << p << ", " << i;
}
