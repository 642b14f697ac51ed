#include <asperity/base/atomic_file.h>
#include <asperity/base/command_options.h>
#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/law_export/law_options.h>
#include <asperity/learned_fields/commands.h>
#include <asperity/learned_fields/field_model.h>
#include <asperity/postprocess/vtu_series.h>

#include <deal.II/base/timer.h>

#include <cmath>
#include <filesystem>
#include <iostream>

namespace asperity
{
  namespace
  {
    std::vector<double>
    point_of(const FrictionLawDescription &law, const CommandOptions &options)
    {
      const std::map<std::string, double> given =
        input_values(law, options, "field", {"--output"});
      std::vector<double>      point;
      std::vector<std::string> missing;
      for (const LawInput &input : law.inputs)
        if (const auto entry = given.find(input.name); entry != given.end())
          point.push_back(entry->second);
        else
          missing.push_back(option_of(law, input) + " \"" +
                            format_quantity(input.lower, input.unit, 6) + "\"");
      if (!missing.empty())
        throw InputError("The fields also need " + join(missing, ", ") +
                         ", for example.");
      return point;
    }

    /** Six digits as other pictures, by the number of the time. */
    std::string
    edge_table(const std::string &directory, const unsigned int time)
    {
      return directory + "/edge_" + std::to_string(time + 1) + ".csv";
    }

    void
    write_fields(const FieldModel          &model,
                 const std::vector<double> &values,
                 const std::vector<double> &x,
                 const std::string         &directory)
    {
      const FieldSnapshots &about = model.layout().about();
      VtuSeries             chip(directory, "chip"), edge(directory, "contact");
      for (unsigned int i = 0; i < model.layout().n_times(); ++i)
        {
          const auto  fields = model.layout().unpack(values, i);
          FieldMoment moment = model.moment(i, x);
          moment.step        = i + 1;
          chip.write(moment.step, moment.time, [&](std::ostream &out) {
            write_chip_fields(out, about, fields, moment);
          });
          edge.write(moment.step, moment.time, [&](std::ostream &out) {
            write_edge_fields(out, about, fields, moment);
          });
          write_atomically(edge_table(directory, i), [&](std::ostream &out) {
            write_edge_table(out, about, fields);
          });
        }
    }

    void
    require_finite(const std::vector<double> &values)
    {
      for (const double value : values)
        if (!std::isfinite(value))
          throw InputError("The model gives no finite fields at this point: "
                           "the file is damaged, or the point is absurd.");
    }

    /** Why the fields are not to be trusted, or that they are. */
    std::string
    trust_line(const FieldModel          &model,
               const FieldTrust          &trust,
               const std::vector<double> &x)
    {
      std::vector<std::string> reasons;
      const auto              &inputs = model.mu_law().description().inputs;
      for (std::size_t i = 0; i < x.size(); ++i)
        {
          const double margin =
            FrictionLaw::edge_tolerance * (inputs[i].upper - inputs[i].lower);
          if (x[i] < inputs[i].lower - margin ||
              x[i] > inputs[i].upper + margin)
            reasons.push_back(
              inputs[i].symbol + " = " +
              format_quantity(x[i], inputs[i].unit, 6) +
              " is outside of the data, " +
              format_quantity(inputs[i].lower, inputs[i].unit, 6) + " to " +
              format_quantity(inputs[i].upper, inputs[i].unit, 6));
        }
      const auto judge = [&](const double value, const std::string &what) {
        if (!(value <= 1.))
          reasons.push_back(what + " is " + format_quantity(value, "1", 3) +
                            " times its limit");
      };
      judge(trust.load, "the difference of normal traction and load");
      judge(trust.stress, "the imbalance of traction and stress");
      judge(trust.shear, "the difference of shear and mu p");
      judge(trust.codes, "the deviation of the code");
      const std::string score = "trust score " +
                                format_quantity(trust.score(), "1", 3) +
                                " (up to 1 as good as the held-out runs): ";
      if (!reasons.empty())
        return score + "these fields are not to be trusted, since " +
               join(reasons, ", and ") + ".";
      return score + "trusted.";
    }

    void
    print(const FieldModel          &model,
          const FieldPrediction     &at,
          const std::vector<double> &x)
    {
      for (unsigned int i = 0; i < at.moments.size(); ++i)
        {
          const FieldMomentPrediction &moment = at.moments[i];
          const FieldMoment            when   = model.moment(i, x);
          std::cout << "at " << format_quantity(when.time, "us", 3) << ", "
                    << format_quantity(when.sliding_distance, "um", 3)
                    << " of sliding: mu = "
                    << format_quantity(moment.mu, "1", 5) << " +- "
                    << format_quantity(moment.mu_deviation, "1", 2)
                    << " (standard deviation); normal traction against p "
                    << format_quantity(100. * moment.load_residual, "1", 2)
                    << " %, against stress "
                    << format_quantity(100. * moment.stress_residual, "1", 2)
                    << " %, shear against mu p "
                    << format_quantity(100. * moment.shear_residual, "1", 2)
                    << " % of p\n";
        }
      std::cout << trust_line(model, at.trust, x) << "\n";
    }
  } // namespace



  int
  predict_fields(const std::vector<std::string> &arguments)
  {
    const CommandOptions options(arguments);
    if (options.words.size() != 1)
      throw InputError(
        "'asperity field' takes one model, as in 'asperity field "
        "field_model.h5 -p 450MPa -v 90m/min -T 300degC'.");
    const FieldModel          model = FieldModel::load(options.words[0]);
    const std::vector<double> x =
      point_of(model.mu_law().description(), options);
    std::string directory =
      (std::filesystem::path(options.words[0]).parent_path() / "field")
        .string();
    if (const auto found = options.values.find("--output");
        found != options.values.end())
      directory = found->second;
    if (!is_first_rank())
      return 0;
    dealii::Timer             timer;
    const FieldPrediction     at         = model.predict(x);
    const double              of_mu      = timer.wall_time();
    const std::vector<double> values     = model.decoder().decode(at.code);
    const double              of_decoder = timer.wall_time() - of_mu;
    require_finite(values);
    print(model, at, x);
    write_fields(model, values, x, directory);
    std::cout << "Computed in " << format_quantity(1e3 * of_mu, "1", 2)
              << " ms, and the fields in "
              << format_quantity(1e3 * of_decoder, "1", 2)
              << " ms; chip.pvd, contact.pvd and edge_1.csv to edge_"
              << at.moments.size() << ".csv are in " << directory << "\n";
    return 0;
  }
} // namespace asperity
