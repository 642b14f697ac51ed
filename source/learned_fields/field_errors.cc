#include <asperity/base/atomic_file.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/learned_fields/field_errors.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace asperity
{
  namespace
  {
    std::vector<double>
    difference(std::vector<double> a, const std::vector<double> &b)
    {
      for (std::size_t i = 0; i < a.size(); ++i)
        a[i] -= b[i];
      return a;
    }

    /** 0 where all vanishes. */
    double
    over(const double error, const double truth)
    {
      return truth == 0. ? 0. : error / truth;
    }

    /** Of each field, the root of the mean square of its norms over the
     *  held-out runs. */
    std::vector<double>
    sizes_of(const FieldData &data)
    {
      std::vector<double> sizes(data.layout.n_fields(), 0.);
      for (const FieldRun &run : data.runs)
        for (std::size_t f = 0; f < sizes.size() && run.held; ++f)
          sizes[f] += data.layout.squared_norm(run.values, f) /
                      static_cast<double>(data.n_runs(true));
      for (double &size : sizes)
        size = std::sqrt(size);
      return sizes;
    }

    std::string
    in_percent(const double value)
    {
      return format_quantity(100. * value, "1", 3) + " %";
    }

    /** "3.1 % (8 %)" in a column. */
    std::string
    cell(const ErrorOfRuns &error)
    {
      std::string text =
        in_percent(error.mean) + " (" + in_percent(error.largest) + ")";
      text.resize(std::max<std::size_t>(text.size() + 2, 24), ' ');
      return text;
    }

    /** @param sizes of the fields, for those that vanish in the run */
    void
    add_run(const FieldModel           &model,
            const FieldRun             &run,
            const std::vector<double>  &code,
            const FieldPrediction      &at,
            const std::vector<double>  &sizes,
            const std::size_t           n,
            std::vector<FieldErrorRow> &rows)
    {
      const FieldLayout        &layout  = model.layout();
      const std::vector<double> best    = model.decoder().decode(code);
      const std::vector<double> of_best = difference(best, run.values),
                                of_predicted =
                                  difference(model.decoder().decode(at.code),
                                             run.values);
      for (std::size_t f = 0; f < layout.n_fields(); ++f)
        {
          constexpr double nothing = 1e-2;
          double truth = std::sqrt(layout.squared_norm(run.values, f));
          if (truth < nothing * sizes[f])
            truth = sizes[f];
          rows[f].best.add(over(std::sqrt(layout.squared_norm(of_best, f)),
                                truth),
                           n);
          rows[f].predicted.add(
            over(std::sqrt(layout.squared_norm(of_predicted, f)), truth), n);
        }
      const auto judged = model.judge(code, run.x);
      for (std::size_t i = 0; i < run.mu.size(); ++i)
        {
          FieldErrorRow &row   = rows[layout.n_fields() + i];
          const double   truth = std::abs(run.mu[i]);
          row.best.add(over(std::abs(judged[i].mu - run.mu[i]), truth), n);
          row.predicted.add(over(std::abs(at.moments[i].mu - run.mu[i]), truth),
                            n);
        }
    }
  } // namespace



  void
  ErrorOfRuns::add(const double error, const std::size_t n_runs)
  {
    mean += error / n_runs;
    largest = std::max(largest, error);
  }



  FieldErrors
  errors_of(const FieldModel                       &model,
            const FieldData                        &data,
            const std::vector<std::vector<double>> &codes)
  {
    FieldErrors        result;
    const FieldLayout &layout = model.layout();
    for (const FieldKind &kind : layout.about().fields)
      result.rows.push_back({kind.name, {}, {}});
    for (const double share : layout.about().shares)
      result.rows.push_back(
        {"mu at " + format_quantity(share, "1") + " of the time", {}, {}});
    const std::size_t         n     = data.n_runs(true);
    const std::vector<double> sizes = sizes_of(data);
    for (std::size_t r = 0; r < data.runs.size(); ++r)
      {
        const FieldRun &run = data.runs[r];
        if (!run.held)
          continue;
        const FieldPrediction at = model.predict(run.x);
        add_run(model, run, codes[r], at, sizes, n, result.rows);
        for (std::size_t i = 0; i < run.mu.size(); ++i)
          if (std::abs(at.moments[i].mu - run.mu[i]) <=
              1.96 * at.moments[i].mu_deviation)
            result.share_in_interval += 1. / (n * run.mu.size());
        if (at.trust.score() <= 1.)
          result.share_trusted += 1. / n;
      }
    return result;
  }



  void
  write_errors(std::ostream &out, const FieldErrors &errors)
  {
    out << "quantity,mean error with the best code [-],largest,"
           "mean error with the code of the inputs [-],largest\n";
    for (const FieldErrorRow &row : errors.rows)
      out << row.quantity << ',' << shortest_decimal(row.best.mean) << ','
          << shortest_decimal(row.best.largest) << ','
          << shortest_decimal(row.predicted.mean) << ','
          << shortest_decimal(row.predicted.largest) << '\n';
  }



  void
  print_errors(std::ostream &out, const FieldErrors &errors)
  {
    std::string head = "  error on held-out runs, mean (largest)";
    head.resize(42, ' ');
    out << head << "best code               code of the inputs\n";
    for (const FieldErrorRow &row : errors.rows)
      {
        std::string name = "  " + row.quantity;
        name.resize(42, ' ');
        out << name << cell(row.best) << trim(cell(row.predicted)) << "\n";
      }
    out << "  mu inside of its 95 % interval: "
        << in_percent(errors.share_in_interval)
        << "; trusted: " << in_percent(errors.share_trusted)
        << " of the held-out runs\n";
  }
} // namespace asperity
