#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/law_export/friction_grid.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity
{
  namespace
  {
    constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

    /** How the positions on the other two axes are sampled while one axis is
     *  divided; the finished grid is measured everywhere. */
    constexpr unsigned int n_samples = 5;

    constexpr std::size_t max_nodes_per_axis = 200;

    double
    rounded(const double value)
    {
      return parse_number(format_quantity(value, "1", FrictionGrid::n_digits));
    }

    /** Rounded, but not out of the range. */
    double
    rounded_within(const double value, const double lower, const double upper)
    {
      const double result = rounded(value);
      if (result == 0. || (result >= lower && result <= upper))
        return result;
      const double last_digit =
        std::pow(10.,
                 std::floor(std::log10(std::abs(result))) + 1. -
                   FrictionGrid::n_digits);
      return rounded(result + (result < lower ? last_digit : -last_digit));
    }

    double
    relative_error(const double value, const double exact)
    {
      return std::abs(value - exact) / std::max(std::abs(exact), 1e-300);
    }

    /** Equidistant on the scale on which the law sees the input. */
    double
    sample(const LawInput &input, const double fraction)
    {
      return input.scale == Scale::logarithmic ?
               input.lower * std::pow(input.upper / input.lower, fraction) :
               input.lower + fraction * (input.upper - input.lower);
    }
  } // namespace



  FrictionGrid::FrictionGrid(const ContactPointLaw     &law,
                             const FrictionGridOptions &options)
    : law(law)
    , options_(options)
  {
    const std::array<Dimension, 3> dimensions = {
      {Dimension::stress, Dimension::velocity, Dimension::temperature}};
    for (unsigned int c = 0; c < 3; ++c)
      if (dimension_of(options.units[c]) != dimensions[c])
        throw InputError("The unit " + quoted_name(options.units[c]) + " for " +
                         ContactPointLaw::symbols()[c] +
                         " in a friction table is none of a " +
                         to_string(dimensions[c]) + ".");
    if (!(options.tolerance > 0. && options.tolerance < 1.))
      throw InputError("The tolerance of friction tables is " +
                       format_number(options.tolerance) +
                       "; a number above 0 and below 1 is expected.");

    for (unsigned int c = 0; c < 3; ++c)
      {
        offsets[c] = to_si(0., options.units[c]);
        factors[c] = to_si(1., options.units[c]) - offsets[c];
      }

    const auto divide = [&](const double limit) {
      for (unsigned int c = 0; c < 3; ++c)
        nodes_[c] = axis(c, limit);
    };
    const std::size_t max_nodes = std::max<std::size_t>(8, options.max_nodes);
    // The errors along the three axes add up at worst, so the limit for each of
    // them is lowered until their sum is small enough.
    double                 limit      = 0.5 * options.tolerance;
    constexpr unsigned int n_attempts = 12;
    bool                   fits       = true;
    for (unsigned int i = 0; i < n_attempts && fits && !tolerance_is_reached_;
         ++i)
      {
        divide(limit);
        for (fits = n_nodes() <= max_nodes; n_nodes() > max_nodes;)
          divide(limit *= 1.3);
        tabulate();
        n_checked_ = 0;
        error = measure({{quarters(0), quarters(1), quarters(2)}}, n_checked_);
        // a little in reserve for what lies between the quarters
        tolerance_is_reached_ = error <= 0.95 * options.tolerance;
        limit *= std::clamp(0.85 * options.tolerance / error, 0.3, 0.9);
      }
  }



  double
  FrictionGrid::si(const unsigned int coordinate, const double value) const
  {
    return value * factors[coordinate] + offsets[coordinate];
  }



  std::vector<double>
  FrictionGrid::axis(const unsigned int coordinate, const double limit) const
  {
    const LawInput *const input = law.input(coordinate);
    if (input == nullptr)
      return {not_a_number};
    const std::string &unit  = options_.units[coordinate];
    const double       lower = from_si(input->lower, unit),
                 upper       = from_si(input->upper, unit);

    std::vector<double> result = {rounded_within(lower, lower, upper)};
    double              from   = lower;
    while (result.size() + 1 < max_nodes_per_axis &&
           error_along(coordinate, from, upper) > limit)
      {
        double     small = 0., large = 1.;
        const auto at = [&](const double fraction) {
          return from + fraction * (upper - from);
        };
        for (unsigned int i = 0; i < 10; ++i)
          {
            const double middle = 0.5 * (small + large);
            if (error_along(coordinate, from, at(middle)) > limit)
              large = middle;
            else
              small = middle;
          }
        from = at(small > 0. ? small : large);
        if (const double node = rounded_within(from, lower, upper);
            node > result.back())
          result.push_back(node);
      }
    if (const double node = rounded_within(upper, lower, upper);
        node > result.back())
      result.push_back(node);
    return result;
  }



  double
  FrictionGrid::error_along(const unsigned int coordinate,
                            const double       from,
                            const double       to) const
  {
    const unsigned int a = (coordinate + 1) % 3, b = (coordinate + 2) % 3;
    const auto         n = [&](const unsigned int c) {
      return law.input(c) == nullptr ? 1u : n_samples;
    };
    std::vector<ContactPoint> points;
    for (unsigned int i = 0; i < n(a); ++i)
      for (unsigned int j = 0; j < n(b); ++j)
        for (unsigned int quarter = 0; quarter <= 4; ++quarter)
          {
            ContactPoint point;
            for (const auto &[c, index] : {std::pair(a, i), std::pair(b, j)})
              point[c] = law.input(c) == nullptr ?
                           not_a_number :
                           sample(*law.input(c), index / (n_samples - 1.));
            point[coordinate] =
              si(coordinate, from + 0.25 * quarter * (to - from));
            points.push_back(point);
          }
    const std::vector<double> mu     = law.means(points);
    double                    result = 0.;
    for (std::size_t i = 0; i < mu.size(); i += 5)
      for (unsigned int quarter = 1; quarter < 4; ++quarter)
        result =
          std::max(result,
                   relative_error(mu[i] + 0.25 * quarter * (mu[i + 4] - mu[i]),
                                  mu[i + quarter]));
    return result;
  }



  void
  FrictionGrid::tabulate()
  {
    std::vector<ContactPoint> points;
    for (std::size_t k = 0; k < nodes_[2].size(); ++k)
      for (std::size_t j = 0; j < nodes_[1].size(); ++j)
        for (std::size_t i = 0; i < nodes_[0].size(); ++i)
          points.push_back(point(i, j, k));
    values = law.means(points);
    for (double &value : values)
      value = rounded(value);
  }



  double
  FrictionGrid::interpolate(const ContactPoint &at) const
  {
    std::array<std::size_t, 3> begin;
    std::array<double, 3>      weight;
    for (unsigned int c = 0; c < 3; ++c)
      {
        const std::vector<double> &axis = nodes_[c];
        begin[c]                        = 0;
        weight[c]                       = 0.;
        if (axis.size() == 1)
          continue;
        const auto next =
          std::upper_bound(axis.begin() + 1, axis.end() - 1, at[c]);
        begin[c]  = static_cast<std::size_t>(next - axis.begin()) - 1;
        weight[c] = (at[c] - axis[begin[c]]) / (*next - axis[begin[c]]);
      }
    double result = 0.;
    for (unsigned int corner = 0; corner < 8; ++corner)
      {
        double                     factor = 1.;
        std::array<std::size_t, 3> node   = begin;
        for (unsigned int c = 0; c < 3; ++c)
          {
            const bool upper = ((corner >> c) & 1) != 0;
            factor *= upper ? weight[c] : 1. - weight[c];
            node[c] += upper ? 1 : 0;
          }
        if (factor != 0.)
          result += factor * mu(node[0], node[1], node[2]);
      }
    return result;
  }



  double
  FrictionGrid::measure(const Axes &quarters, std::size_t &n_points) const
  {
    double result = 0.;
    for (const double T : quarters[2])
      for (const double v : quarters[1])
        {
          std::vector<ContactPoint> points, in_si;
          for (const double p : quarters[0])
            {
              points.push_back({{p, v, T}});
              in_si.push_back({{si(0, p), si(1, v), si(2, T)}});
            }
          const std::vector<double> exact = law.means(in_si);
          for (std::size_t i = 0; i < points.size(); ++i)
            result = std::max(result,
                              relative_error(interpolate(points[i]), exact[i]));
          n_points += points.size();
        }
    return result;
  }



  std::vector<double>
  FrictionGrid::quarters(const unsigned int coordinate) const
  {
    const std::vector<double> &nodes = nodes_[coordinate];
    std::vector<double>        result;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
      for (unsigned int quarter = 0; quarter < 4; ++quarter)
        result.push_back(nodes[i] + 0.25 * quarter * (nodes[i + 1] - nodes[i]));
    result.push_back(nodes.back());
    return result;
  }



  const std::vector<double> &
  FrictionGrid::nodes(const unsigned int coordinate) const
  {
    return nodes_[coordinate];
  }



  ContactPoint
  FrictionGrid::point(const std::size_t i,
                      const std::size_t j,
                      const std::size_t k) const
  {
    return {{si(0, nodes_[0][i]), si(1, nodes_[1][j]), si(2, nodes_[2][k])}};
  }



  double
  FrictionGrid::mu(const std::size_t i,
                   const std::size_t j,
                   const std::size_t k) const
  {
    return values[(k * nodes_[1].size() + j) * nodes_[0].size() + i];
  }



  std::size_t
  FrictionGrid::n_nodes() const
  {
    return nodes_[0].size() * nodes_[1].size() * nodes_[2].size();
  }



  double
  FrictionGrid::interpolation_error() const
  {
    return error;
  }



  double
  FrictionGrid::interpolation_error(const unsigned int coordinate,
                                    const std::size_t  node) const
  {
    Axes where        = {{quarters(0), quarters(1), quarters(2)}};
    where[coordinate] = {nodes_[coordinate][node]};
    std::size_t n     = 0;
    return measure(where, n);
  }



  std::size_t
  FrictionGrid::n_checked() const
  {
    return n_checked_;
  }



  bool
  FrictionGrid::tolerance_is_reached() const
  {
    return tolerance_is_reached_;
  }



  const FrictionGridOptions &
  FrictionGrid::options() const
  {
    return options_;
  }
} // namespace asperity
