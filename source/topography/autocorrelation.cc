#include <asperity/topography/autocorrelation.h>

#include <gsl/gsl_fft_complex.h>

#include <algorithm>
#include <complex>
#include <memory>

namespace asperity
{
  namespace
  {
    using Complex = std::complex<double>;

    /** The smallest product of 2, 3 and 5 that is at least n. */
    unsigned int
    transform_length(const unsigned int n)
    {
      for (unsigned int length = n;; ++length)
        {
          unsigned int rest = length;
          for (const unsigned int factor : {2u, 3u, 5u})
            while (rest % factor == 0)
              rest /= factor;
          if (rest == 1)
            return length;
        }
    }



    /** Fourier transform of complex numbers side by side, not normalised. */
    class LineTransform
    {
    public:
      LineTransform(const unsigned int n, const gsl_fft_direction direction)
        : n(n)
        , direction(direction)
        , table(gsl_fft_complex_wavetable_alloc(n),
                gsl_fft_complex_wavetable_free)
        , workspace(gsl_fft_complex_workspace_alloc(n),
                    gsl_fft_complex_workspace_free)
      {}

      void
      operator()(Complex *line)
      {
        gsl_fft_complex_transform(reinterpret_cast<double *>(line),
                                  1,
                                  n,
                                  table.get(),
                                  workspace.get(),
                                  direction);
      }

    private:
      unsigned int      n;
      gsl_fft_direction direction;
      std::unique_ptr<gsl_fft_complex_wavetable,
                      decltype(&gsl_fft_complex_wavetable_free)>
        table;
      std::unique_ptr<gsl_fft_complex_workspace,
                      decltype(&gsl_fft_complex_workspace_free)>
        workspace;
    };



    /** Complex numbers on a grid, x fastest. */
    struct Grid
    {
      unsigned int         nx, ny;
      std::vector<Complex> values;

      void
      transform(const gsl_fft_direction direction)
      {
        LineTransform along_x(nx, direction), along_y(ny, direction);
        for (unsigned int j = 0; j < ny; ++j)
          along_x(&values[std::size_t(j) * nx]);
        std::vector<Complex> column(ny);
        for (unsigned int i = 0; i < nx; ++i)
          {
            for (unsigned int j = 0; j < ny; ++j)
              column[j] = values[std::size_t(j) * nx + i];
            along_y(column.data());
            for (unsigned int j = 0; j < ny; ++j)
              values[std::size_t(j) * nx + i] = column[j];
          }
      }
    };



    /**
     * The spectra |A|^2 + i |B|^2 of the real and the imaginary part of a grid
     * a + i b, given its transform F = A + i B: A and B are F(k) + F(-k)* and
     * F(k) - F(-k)*, by 2 and 2 i.
     */
    void
    separate_spectra(Grid &grid)
    {
      for (unsigned int j = 0; j < grid.ny; ++j)
        for (unsigned int i = 0; i < grid.nx; ++i)
          {
            const std::size_t here = std::size_t(j) * grid.nx + i;
            const std::size_t opposite =
              std::size_t((grid.ny - j) % grid.ny) * grid.nx +
              (grid.nx - i) % grid.nx;
            if (opposite < here)
              continue;
            const Complex F = grid.values[here];
            const Complex G = std::conj(grid.values[opposite]);
            grid.values[here] =
              grid.values[opposite] = {0.25 * std::norm(F + G),
                                       0.25 * std::norm(F - G)};
          }
    }



    /** Heights from their mean, and 1 i for each; 0 where there is none and
     *  around the map. */
    Grid
    padded(const HeightMap &map, const unsigned int nx, const unsigned int ny)
    {
      double sum = 0.;
      for (const double z : map.heights)
        sum += std::isnan(z) ? 0. : z;
      const double mean    = sum / std::max<std::size_t>(1, map.n_valid());
      double       largest = 0.;
      for (const double z : map.heights)
        largest = std::fmax(largest, std::abs(z - mean));
      // Both parts are of one size: each has the round-off of the larger.
      const double scale = largest > 0. ? 1. / largest : 0.;
      Grid         grid{nx, ny, std::vector<Complex>(std::size_t(nx) * ny)};
      for (unsigned int j = 0; j < map.ny; ++j)
        for (unsigned int i = 0; i < map.nx; ++i)
          if (!std::isnan(map(i, j)))
            grid.values[std::size_t(j) * nx + i] = {(map(i, j) - mean) * scale,
                                                    1.};
      return grid;
    }
  } // namespace



  Autocorrelation::Autocorrelation(const HeightMap &map)
    : n_x(map.nx / 2)
    , n_y(map.ny / 2)
    , dx(map.dx)
    , dy(map.dy)
  {
    // The transform repeats the map; zeros keep it from meeting itself.
    Grid grid = padded(map,
                       transform_length(map.nx + n_x),
                       transform_length(map.ny + n_y));
    grid.transform(gsl_fft_forward);
    separate_spectra(grid);
    grid.transform(gsl_fft_backward); // sums of products + i numbers of them
    const double n_points = double(grid.nx) * grid.ny;
    const double variance = grid.values[0].real() / grid.values[0].imag();
    values.reserve(std::size_t(n_x + 1) * (2 * n_y + 1));
    for (int j = -n_y; j <= n_y; ++j)
      for (int i = 0; i <= n_x; ++i)
        {
          const unsigned int row = (j + grid.ny) % grid.ny;
          const Complex pairs    = grid.values[std::size_t(row) * grid.nx + i];
          const bool    known    = pairs.imag() > 0.5 * n_points;
          values.push_back(known ? pairs.real() / pairs.imag() / variance :
                                   missing_height);
        }
  }



  double
  Autocorrelation::operator()(const double lag_x, const double lag_y) const
  {
    const double sign = lag_x < 0. ? -1. : 1.;
    const double x = sign * lag_x / dx, y = sign * lag_y / dy;
    if (!(x <= n_x && std::abs(y) <= n_y))
      return missing_height;
    const int    i = std::min<int>(x, std::max(0, n_x - 1));
    const int    j = std::clamp<int>(std::floor(y), -n_y, std::max(0, n_y - 1));
    const double s = x - i, t = y - j;
    // A map of one row or column has no further ones.
    const int right = std::min(i + 1, n_x), above = std::min(j + 1, n_y);
    return (1. - t) * ((1. - s) * at(i, j) + s * at(right, j)) +
           t * ((1. - s) * at(i, above) + s * at(right, above));
  }



  Autocorrelation::Decay
  Autocorrelation::decay(const double direction) const
  {
    const double c = std::cos(direction), s = std::sin(direction);
    const double step   = spacing();
    double       before = 1.;
    for (unsigned int k = 1;; ++k)
      {
        const double now = (*this)(k * step * c, k * step * s);
        if (std::isnan(now))
          return {(k - 1) * step, false};
        if (now <= level)
          return {step * (k - (level - now) / (before - now)), true};
        before = now;
      }
  }



  double
  Autocorrelation::longest_lag() const
  {
    return std::hypot(n_x * dx, n_y * dy);
  }



  double
  Autocorrelation::spacing() const
  {
    return is_profile() ? dx : std::min(dx, dy);
  }



  ArealTexture
  areal_texture(const HeightMap &map)
  {
    const Autocorrelation correlation(map);
    // At the longest lag, neighbouring directions are a pixel apart; their
    // number is even, so that both axes are among them.
    const double longest = correlation.longest_lag() / correlation.spacing();
    const unsigned int n_directions =
      correlation.is_profile() ? 1 : 2 * std::ceil(0.5 * M_PI * longest);
    double fastest = std::numeric_limits<double>::infinity(), slowest = 0.;
    bool   every = !correlation.is_profile(), any = false;
    for (unsigned int k = 0; k < n_directions; ++k)
      {
        const auto decay = correlation.decay(k * M_PI / n_directions);
        slowest          = std::max(slowest, decay.lag);
        every            = every && decay.is_found;
        any              = any || decay.is_found;
        if (decay.is_found)
          fastest = std::min(fastest, decay.lag);
      }
    ArealTexture texture;
    if (!any)
      return texture;
    texture.Sal       = fastest;
    texture.Str_bound = fastest / slowest;
    if (every)
      texture.Str = texture.Str_bound;
    return texture;
  }
} // namespace asperity
