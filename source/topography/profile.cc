#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/splines/spline_fit.h>
#include <asperity/topography/profile.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    /** Bilinear between the four samples around (u, v), in sample spacings. */
    double
    interpolate(const HeightMap &map, const double u, const double v)
    {
      const auto cell = [](const double t, const unsigned int n) {
        return static_cast<unsigned int>(
          std::clamp(std::floor(t), 0., std::max(0., n - 2.)));
      };
      const unsigned int i = cell(u, map.nx);
      const unsigned int j = cell(v, map.ny);
      const double       s = u - i;
      const double       t = v - j;
      // Corners without weight do not count, missing ones least of all.
      double height = 0.;
      for (unsigned int b = 0; b < 2; ++b)
        for (unsigned int a = 0; a < 2; ++a)
          {
            const double weight = (a ? s : 1. - s) * (b ? t : 1. - t);
            if (std::abs(weight) > 1e-9)
              height += weight * map(i + a, j + b);
          }
      return height;
    }

    /** The part of point + s*direction in [0, length], as bounds on s. */
    void
    clip(const double point,
         const double direction,
         const double length,
         double      &begin,
         double      &end)
    {
      if (std::abs(direction) < 1e-12)
        {
          if (point < 0. || point > length)
            end = begin - 1.;
          return;
        }
      const double first  = -point / direction;
      const double second = (length - point) / direction;
      begin               = std::max(begin, std::min(first, second));
      end                 = std::min(end, std::max(first, second));
    }

    bool
    is_along_x(const ProfileLine &line)
    {
      return std::abs(std::sin(line.angle)) < 1e-9 && std::cos(line.angle) > 0.;
    }

    bool
    is_along_y(const ProfileLine &line)
    {
      return std::abs(std::cos(line.angle)) < 1e-9 && std::sin(line.angle) > 0.;
    }

    std::string
    too_few(const HeightMap &map, const std::size_t n)
    {
      return "Only " + std::to_string(n) +
             " samples of the profile lie in the map of " +
             quoted_name(map.provenance.file) +
             "; check its direction, position and "
             "length.";
    }

    /** All samples of the nearest row or column. */
    std::vector<double>
    samples_along_axis(const HeightMap &map, const ProfileLine &line)
    {
      const bool         along_x = is_along_x(line);
      const double       across  = along_x ? line.y / map.dy : line.x / map.dx;
      const unsigned int n_lines = along_x ? map.ny : map.nx;
      if (!(across > -0.5 && across < n_lines - 0.5))
        throw InputError(too_few(map, 0));
      const auto index = static_cast<unsigned int>(
        std::lround(std::clamp(across, 0., n_lines - 1.)));
      std::vector<double> heights;
      for (unsigned int k = 0; k < (along_x ? map.nx : map.ny); ++k)
        heights.push_back(along_x ? map(k, index) : map(index, k));
      return heights;
    }

    std::vector<double>
    samples_along_line(const HeightMap   &map,
                       const ProfileLine &line,
                       const double       spacing)
    {
      const double tx    = std::cos(line.angle);
      const double ty    = std::sin(line.angle);
      double       begin = -1e300, end = 1e300;
      clip(line.x, tx, (map.nx - 1) * map.dx, begin, end);
      clip(line.y, ty, (map.ny - 1) * map.dy, begin, end);
      std::vector<double> heights;
      for (unsigned int k = 0; begin + k * spacing <= end + 1e-9 * spacing; ++k)
        {
          const double s = begin + k * spacing;
          heights.push_back(interpolate(map,
                                        (line.x + s * tx) / map.dx,
                                        (line.y + s * ty) / map.dy));
        }
      return heights;
    }
  } // namespace

  Profile
  extract_profile(const HeightMap   &map,
                  const ProfileLine &line,
                  const unsigned int min_points)
  {
    Profile profile;
    if (is_along_x(line) || is_along_y(line))
      {
        profile.spacing = is_along_x(line) ? map.dx : map.dy;
        profile.heights = samples_along_axis(map, line);
      }
    else if (map.ny < 2)
      throw InputError(quoted_name(map.provenance.file) +
                       " holds a single profile; its direction is x.");
    else
      {
        profile.spacing = std::min(map.dx, map.dy);
        profile.heights = samples_along_line(map, line, profile.spacing);
      }

    if (line.from != 0. || line.to != 0.)
      {
        const double last  = profile.heights.size() - 1.;
        const double first = std::round(line.from / profile.spacing);
        double       end =
          line.to > 0. ? std::round(line.to / profile.spacing) : last;
        // A length may name the outer edge of the map, one beyond the last.
        if (end == last + 1.)
          end = last;
        if (!(first >= 0. && first < end && end <= last))
          throw InputError(too_few(map, 0));
        profile.heights = {profile.heights.begin() + std::size_t(first),
                           profile.heights.begin() + std::size_t(end) + 1};
      }
    if (profile.heights.size() < min_points)
      throw InputError(too_few(map, profile.heights.size()));
    return profile;
  }

  Profile
  resample(const Profile &profile, const double spacing, const std::size_t n)
  {
    std::vector<double>           x;
    std::vector<dealii::Point<2>> points;
    for (std::size_t i = 0; i < profile.heights.size(); ++i)
      {
        x.push_back(i * profile.spacing);
        points.emplace_back(x.back(), profile.heights[i]);
      }
    const SplineFit fit = interpolate(averaged_knots(x, 3), points, x);
    Profile         result;
    result.spacing = spacing;
    for (std::size_t k = 0; k < n; ++k)
      result.heights.push_back(
        fit.curve.value(std::min(k * spacing, x.back()))[1]);
    return result;
  }
} // namespace asperity
