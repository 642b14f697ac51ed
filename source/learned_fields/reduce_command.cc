#include <asperity/base/atomic_file.h>
#include <asperity/base/command_options.h>
#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/law_export/commands.h>
#include <asperity/learned_fields/commands.h>
#include <asperity/learned_fields/field_errors.h>
#include <asperity/learned_fields/pod_decoder.h>
#include <asperity/learned_fields/train_decoder.h>

#include <deal.II/base/timer.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>

namespace asperity
{
  namespace
  {
    /** What the command line asks for. */
    struct ReduceOptions
    {
      std::string           campaign, model;
      DecoderOptions        decoder;
      std::optional<double> held_out;
    };

    double
    number_of(const CommandOptions &options,
              const std::string    &option,
              const double          value,
              const double          least,
              const double          most)
    {
      const auto found = options.values.find(option);
      if (found == options.values.end())
        return value;
      try
        {
          const double number =
            parse_quantity(found->second, dimension_of("1"));
          if (number >= least && number <= most)
            return number;
        }
      catch (const InputError &)
        {} // the sentence below says more
      throw InputError("The option '" + option + "' is " +
                       quoted_text(found->second) + "; a number of " +
                       format_quantity(least, "1") + " to " +
                       format_quantity(most, "1") + " is expected.");
    }

    /** Of 1 to most. */
    unsigned int
    whole_number_of(const CommandOptions &options,
                    const std::string    &option,
                    const unsigned int    value,
                    const double          most)
    {
      const double number = number_of(options, option, value, 1., most);
      if (number != std::floor(number))
        throw InputError("The option '" + option + "' is " +
                         quoted_text(options.values.at(option)) +
                         "; a whole number is expected.");
      return static_cast<unsigned int>(number);
    }

    ReduceOptions
    parse(const std::vector<std::string> &arguments)
    {
      const CommandOptions options(
        arguments,
        {"--latent", "--decoder", "--held-out", "--model", "--epochs"});
      if (options.words.size() != 1)
        throw InputError("'asperity reduce' takes the folder of one campaign, "
                         "as in 'asperity reduce output/campaign --latent 4'.");
      ReduceOptions result;
      result.campaign = options.words[0];
      result.model    = result.campaign + "/field_model.h5";
      if (const auto found = options.values.find("--model");
          found != options.values.end())
        result.model = found->second;
      result.decoder.n_codes =
        whole_number_of(options, "--latent", result.decoder.n_codes, 100.);
      if (const auto found = options.values.find("--decoder");
          found != options.values.end())
        result.decoder.name = found->second;
      result.decoder.n_epochs =
        whole_number_of(options, "--epochs", result.decoder.n_epochs, 1e5);
      check_decoder(result.decoder);
      if (options.values.count("--epochs") != 0 &&
          result.decoder.name == PodDecoder::decoder_name)
        throw InputError("The option '--epochs' is given with '--decoder pod', "
                         "which trains no network; expected without.");
      if (options.values.count("--held-out") != 0)
        result.held_out = number_of(options, "--held-out", 0.2, 0.01, 0.9);
      return result;
    }

    void
    print_singular_values(const std::vector<double> &values)
    {
      double all = 0.;
      for (const double value : values)
        all += value * value;
      if (all == 0.)
        return;
      std::cout << "  singular values over the first";
      double so_far = 0.;
      for (std::size_t k = 0; k < values.size() && k < 16; ++k)
        {
          so_far += values[k] * values[k];
          const bool is_power = k > 0 && (k & (k + 1)) == 0;
          std::cout << (k == 0 ? " " : ", ")
                    << format_quantity(values[k] / values[0], "1", 2);
          if (k == 0 || is_power)
            std::cout << " (" << k + 1 << ": "
                      << format_quantity(100. * so_far / all, "1", 4)
                      << " % of the variance)";
        }
      std::cout << "\n";
    }
  } // namespace



  int
  reduce_fields(const std::vector<std::string> &arguments)
  {
    dealii::Timer       timer;
    const ReduceOptions options = parse(arguments);
    if (!is_first_rank())
      return 0;
    const FieldData data = read_fields(options.campaign, options.held_out);
    std::cout << "Fields of " << data.n_runs(false) << " runs, "
              << data.n_runs(true)
              << " more are held out: " << data.layout.size()
              << " numbers a run at " << data.layout.n_times() << " times\n";
    const TrainedDecoder trained = train_decoder(data, options.decoder);
    std::cout << "Decoder " << trained.decoder->name() << ", latent size "
              << options.decoder.n_codes << "\n";
    print_singular_values(trained.singular_values);
    const FieldModel  model(data, trained.decoder, trained.codes);
    const FieldErrors errors = errors_of(model, data, trained.codes);
    print_errors(std::cout, errors);
    for (const std::string &warning : data.warnings)
      std::cout << "Warning: " << warning << "\n";
    model.save(options.model);
    const std::string table =
      (std::filesystem::path(options.model).parent_path() / "field_errors.csv")
        .string();
    write_atomically(table,
                     [&](std::ostream &out) { write_errors(out, errors); });
    std::cout << "Written to " << options.model << " and " << table << " in "
              << format_quantity(timer.wall_time(), "s", 3) << "; try\n"
              << "  asperity field " << options.model
              << example_arguments(model.mu_law().description()) << "\n";
    return 0;
  }
} // namespace asperity
