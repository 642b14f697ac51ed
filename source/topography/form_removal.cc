#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/splines/banded_solver.h>
#include <asperity/topography/form_removal.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    /** Legendre polynomials P_0..P_degree at @p count points on [-1, 1]. */
    std::vector<std::vector<double>>
    legendre_table(const unsigned int count, const unsigned int degree)
    {
      std::vector<std::vector<double>> table(count);
      for (unsigned int i = 0; i < count; ++i)
        {
          const double t = count > 1 ? 2. * i / (count - 1.) - 1. : 0.;
          auto        &p = table[i];
          p              = {1., t};
          for (unsigned int k = 2; k <= degree; ++k)
            p.push_back(((2. * k - 1.) * t * p[k - 1] - (k - 1.) * p[k - 2]) /
                        k);
          p.resize(degree + 1);
        }
      return table;
    }

    /** The products P_a(x) P_b(y) with a + b <= degree, as pairs (a, b). */
    std::vector<std::pair<unsigned int, unsigned int>>
    products(const unsigned int degree, const bool one_row)
    {
      std::vector<std::pair<unsigned int, unsigned int>> result;
      for (unsigned int b = 0; b <= (one_row ? 0 : degree); ++b)
        for (unsigned int a = 0; a + b <= degree; ++a)
          result.emplace_back(a, b);
      return result;
    }

    /** One least-squares fit, subtracted; false if the points do not determine
     *  it. */
    bool
    fit_and_subtract(HeightMap &map, const unsigned int degree)
    {
      const auto         terms = products(degree, map.ny == 1);
      const unsigned int n     = terms.size();
      const auto         px    = legendre_table(map.nx, degree);
      const auto         py    = legendre_table(map.ny, degree);

      std::vector<double> sums(n * n), coefficients(n), value(n);
      for (unsigned int j = 0; j < map.ny; ++j)
        for (unsigned int i = 0; i < map.nx; ++i)
          {
            const double z = map(i, j);
            if (std::isnan(z))
              continue;
            for (unsigned int k = 0; k < n; ++k)
              value[k] = px[i][terms[k].first] * py[j][terms[k].second];
            for (unsigned int k = 0; k < n; ++k)
              {
                coefficients[k] += value[k] * z;
                for (unsigned int l = 0; l <= k; ++l)
                  sums[k * n + l] += value[k] * value[l];
              }
          }
      BandedSolver normal_equations(n, n - 1, false); // the band is all of it
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int l = 0; l < n; ++l)
          normal_equations.add(k, l, sums[std::max(k, l) * n + std::min(k, l)]);
      if (!normal_equations.factorize())
        return false;
      normal_equations.solve(coefficients);

      for (unsigned int j = 0; j < map.ny; ++j)
        for (unsigned int i = 0; i < map.nx; ++i)
          for (unsigned int k = 0; k < n; ++k)
            map(i, j) -=
              coefficients[k] * px[i][terms[k].first] * py[j][terms[k].second];
      return true;
    }
  } // namespace

  void
  remove_form(HeightMap &map, const unsigned int degree)
  {
    const auto n_coefficients = products(degree, map.ny == 1).size();
    if (map.n_valid() < n_coefficients)
      throw InputError("The F-operator of degree " + std::to_string(degree) +
                       " needs " + std::to_string(n_coefficients) +
                       " valid points, and " +
                       quoted_name(map.provenance.file) + " has " +
                       std::to_string(map.n_valid()) + ".");
    // The second fit removes what the first one left by round-off of the normal
    // equations.
    if (!fit_and_subtract(map, degree) || !fit_and_subtract(map, degree))
      throw InputError("The valid points of " +
                       quoted_name(map.provenance.file) +
                       " do not determine a form of degree " +
                       std::to_string(degree) + "; choose a lower one.");
  }
} // namespace asperity
