#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/random_numbers.h>
#include <asperity/surrogate/design.h>
#include <asperity/surrogate/sensitivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <ostream>
#include <utility>

namespace asperity
{
  namespace
  {
    /** Values of the function at the rows of A, of B, and of A with one column
     *  of B for each input. */
    struct Evaluations
    {
      std::vector<double>              a, b;
      std::vector<std::vector<double>> mixed;
    };

    std::vector<double>
    columns(const std::vector<double> &points,
            const std::size_t          width,
            const std::size_t          first,
            const std::size_t          n_columns)
    {
      std::vector<double> result;
      for (std::size_t row = first; row < points.size(); row += width)
        result.insert(result.end(),
                      points.begin() + row,
                      points.begin() + row + n_columns);
      return result;
    }

    Evaluations
    evaluate(const std::size_t       n,
             const unsigned int      d,
             const FunctionOfPoints &function)
    {
      const std::vector<double> points = unit_sobol(n, 2 * d);
      const std::vector<double> a      = columns(points, 2 * d, 0, d);
      const std::vector<double> b      = columns(points, 2 * d, d, d);

      const auto values = [&](const std::vector<double> &x) {
        std::vector<double> y(n);
        function(n, x.data(), y.data());
        return y;
      };
      Evaluations result = {values(a), values(b), {}};
      for (unsigned int i = 0; i < d; ++i)
        {
          std::vector<double> mixed = a;
          for (std::size_t row = 0; row < n; ++row)
            mixed[row * d + i] = b[row * d + i];
          result.mixed.push_back(values(mixed));
        }
      return result;
    }

    /** The estimators are less noisy if the function is small. */
    void
    subtract_mean(Evaluations &f)
    {
      double mean = 0.;
      for (const auto *values : {&f.a, &f.b})
        mean += std::accumulate(values->begin(), values->end(), 0.) /
                (2. * static_cast<double>(f.a.size()));
      for (auto *values : {&f.a, &f.b})
        for (double &value : *values)
          value -= mean;
      for (auto &values : f.mixed)
        for (double &value : values)
          value -= mean;
    }

    /** First-order and total index of each input from some of the rows. */
    std::vector<std::pair<double, double>>
    estimate(const Evaluations &f, const std::vector<std::size_t> &rows)
    {
      const double n   = static_cast<double>(rows.size());
      double       sum = 0., squares = 0.;
      for (const std::size_t row : rows)
        {
          sum += f.a[row] + f.b[row];
          squares += f.a[row] * f.a[row] + f.b[row] * f.b[row];
        }
      const double variance = squares / (2. * n) - sum * sum / (4. * n * n);

      std::vector<std::pair<double, double>> result;
      for (const auto &mixed : f.mixed)
        {
          double first = 0., total = 0.;
          for (const std::size_t row : rows)
            {
              const double change = mixed[row] - f.a[row];
              first += f.b[row] * change;
              total += change * change;
            }
          result.emplace_back(first / (n * variance),
                              total / (2. * n * variance));
        }
      return result;
    }

    bool
    is_constant(const Evaluations &f)
    {
      for (const auto *values : {&f.a, &f.b})
        for (const double value : *values)
          if (value != f.a.front())
            return false;
      return true;
    }

    /** Half widths of 95 % intervals by resampling. */
    void
    add_confidence(const Evaluations             &f,
                   const SensitivityOptions      &options,
                   std::vector<SensitivityIndex> &indices)
    {
      const std::size_t        n = options.n_points;
      RandomNumbers            random(options.seed);
      std::vector<std::size_t> rows(n);
      // sums and sums of squares of deviations from the estimates, all zero
      std::vector<std::array<double, 4>> sums(indices.size());
      for (unsigned int i = 0; i < options.n_resamples; ++i)
        {
          for (std::size_t &row : rows)
            row = random.below(n);
          const auto resampled = estimate(f, rows);
          for (std::size_t k = 0; k < indices.size(); ++k)
            {
              const double first = resampled[k].first - indices[k].S1;
              const double total = resampled[k].second - indices[k].ST;
              sums[k][0] += first;
              sums[k][1] += first * first;
              sums[k][2] += total;
              sums[k][3] += total * total;
            }
        }
      const double m          = options.n_resamples;
      const auto   half_width = [m](const double sum, const double squares) {
        return 1.96 *
               std::sqrt(std::max(0., squares - sum * sum / m) / (m - 1.));
      };
      for (std::size_t k = 0; k < indices.size(); ++k)
        {
          indices[k].S1_conf = half_width(sums[k][0], sums[k][1]);
          indices[k].ST_conf = half_width(sums[k][2], sums[k][3]);
        }
    }
  } // namespace



  std::vector<SensitivityIndex>
  sensitivity_indices(const unsigned int        n_inputs,
                      const FunctionOfPoints   &function,
                      const SensitivityOptions &options)
  {
    if (options.n_points < 2 || options.n_resamples < 2)
      throw InputError("Sensitivity indices from " +
                       std::to_string(options.n_points) + " points and " +
                       std::to_string(options.n_resamples) +
                       " resamples were asked for; at least 2 of each are "
                       "expected.");
    Evaluations f = evaluate(options.n_points, n_inputs, function);

    std::vector<SensitivityIndex> indices(n_inputs);
    if (is_constant(f))
      return indices;
    subtract_mean(f);
    std::vector<std::size_t> all(options.n_points);
    std::iota(all.begin(), all.end(), 0);
    const auto estimates = estimate(f, all);
    for (unsigned int i = 0; i < n_inputs; ++i)
      {
        indices[i].S1 = estimates[i].first;
        indices[i].ST = estimates[i].second;
      }
    add_confidence(f, options, indices);
    return indices;
  }



  std::vector<SensitivityIndex>
  sensitivity_indices(const FrictionLaw &law, const SensitivityOptions &options)
  {
    const std::vector<LawInput> &inputs = law.description().inputs;
    const unsigned int           d      = inputs.size();
    return sensitivity_indices(
      d,
      [&](const std::size_t n, const double *unit, double *values) {
        const auto x = map_to_box(inputs, {unit, unit + n * d});
        law.means(n, x.data(), values);
      },
      options);
  }



  void
  write_sensitivity(std::ostream                        &out,
                    const FrictionLawDescription        &description,
                    const std::vector<SensitivityIndex> &indices)
  {
    out << "# Sobol sensitivity indices of " << description.output
        << "; conf is the half width of the 95 % interval\n";
    for (const LawInput &input : description.inputs)
      out << "# " << input.symbol << " is uniformly distributed "
          << (input.scale == Scale::logarithmic ? "on a logarithmic scale " :
                                                  "")
          << "from " << format_quantity(input.lower, input.unit, 6) << " to "
          << format_quantity(input.upper, input.unit, 6) << '\n';
    out << "input,symbol,S1,S1_conf,ST,ST_conf\n";
    for (std::size_t i = 0; i < indices.size(); ++i)
      {
        const SensitivityIndex &index = indices[i];
        out << description.inputs[i].name << ','
            << description.inputs[i].symbol;
        for (const double value :
             {index.S1, index.S1_conf, index.ST, index.ST_conf})
          out << ',' << shortest_decimal(value);
        out << '\n';
      }
  }



  void
  write_sensitivity(const std::string                   &path,
                    const FrictionLawDescription        &description,
                    const std::vector<SensitivityIndex> &indices)
  {
    write_atomically(path, [&](std::ostream &out) {
      write_sensitivity(out, description, indices);
    });
  }
} // namespace asperity
