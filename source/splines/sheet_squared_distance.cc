#include <asperity/splines/sheet_certificate.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    constexpr unsigned int max_degree = SheetPieces::max_degree;



    /** The factors of squares of Bernstein polynomials: coefficient i + j of
     *  degree 2 p in B_i B_j. */
    class SquareFactors
    {
    public:
      SquareFactors()
      {
        for (unsigned int p = 1; p <= max_degree; ++p)
          for (unsigned int i = 0; i <= p; ++i)
            for (unsigned int j = 0; j <= p; ++j)
              table[p][i][j] =
                binomial(p, i) * binomial(p, j) / binomial(2 * p, i + j);
      }

      double table[max_degree + 1][max_degree + 1][max_degree + 1];

    private:
      static double
      binomial(const unsigned int n, const unsigned int k)
      {
        double result = 1.;
        for (unsigned int i = 1; i <= k; ++i)
          result *= double(n + 1 - i) / i;
        return std::round(result);
      }
    };

    const SquareFactors square_factors;



    /** Bernstein coefficient k of degree n of (low + (high - low) u)^2. */
    double
    square_of_place(const double       low,
                    const double       high,
                    const unsigned int n,
                    const unsigned int k)
    {
      const double w = high - low;
      return low * low + 2. * low * w * k / n +
             (k > 1 ? w * w * k * (k - 1.) / (n * (n - 1.)) : 0.);
    }
  } // namespace



  double
  SheetCertificate::form_squared_distance(const Part &part,
                                          double     *coefficients) const
  {
    const unsigned int nx = 2 * p + 1, ny = 2 * q + 1;
    double             places[2 * max_degree + 1];
    for (unsigned int k = 0; k < nx; ++k)
      places[k] = square_of_place(part.low[0], part.high[0], 2 * p, k);
    for (unsigned int l = 0; l < ny; ++l)
      {
        const double y2 = square_of_place(part.low[1], part.high[1], 2 * q, l);
        for (unsigned int k = 0; k < nx; ++k)
          coefficients[l * nx + k] = places[k] + y2;
      }
    double highest = 0.;
    for (unsigned int j = 0; j <= q; ++j)
      for (unsigned int l = j; l <= q; ++l)
        {
          const double *a = part.heights + j * (p + 1);
          const double *b = part.heights + l * (p + 1);
          const double  factor =
            (j == l ? 1. : 2.) * square_factors.table[q][j][l];
          double *line = coefficients + (j + l) * nx;
          for (unsigned int i = 0; i <= p; ++i)
            {
              const double scaled = factor * a[i];
              for (unsigned int k = 0; k <= p; ++k)
                line[i + k] += scaled * b[k] * square_factors.table[p][i][k];
            }
        }
    for (unsigned int k = 0; k < (p + 1) * (q + 1); ++k)
      highest = std::max(highest, std::abs(part.heights[k]));
    const double x      = std::max(-part.low[0], part.high[0]);
    const double y      = std::max(-part.low[1], part.high[1]);
    const double reach2 = x * x + y * y + highest * highest;
    const double noise  = distance.position_noise();
    return 2. * noise * (std::sqrt(reach2) + noise) + 2e-15 * reach2;
  }



  bool
  SheetCertificate::is_monotonic(const double *coefficients,
                                 const double  noise) const
  {
    const unsigned int nx = 2 * p + 1, ny = 2 * q + 1;
    bool               rises[2] = {true, true}, falls[2] = {true, true};
    for (unsigned int l = 0; l < ny; ++l)
      for (unsigned int k = 0; k < nx; ++k)
        for (unsigned int d = 0; d < 2; ++d)
          {
            if ((d == 0 ? k + 1 == nx : l + 1 == ny))
              continue;
            const double *c      = coefficients + l * nx + k;
            const double  change = c[d == 0 ? 1 : nx] - c[0];
            rises[d]             = rises[d] && change > noise;
            falls[d]             = falls[d] && change < -noise;
          }
    return rises[0] || falls[0] || rises[1] || falls[1];
  }
} // namespace asperity
