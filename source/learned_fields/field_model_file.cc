#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/learned_fields/field_model.h>
#include <asperity/learned_fields/manifold_decoder.h>
#include <asperity/learned_fields/network_decoder.h>
#include <asperity/learned_fields/pod_decoder.h>
#include <asperity/postprocess/hdf5_file.h>

#include <nlohmann/json.hpp>

#include <filesystem>

namespace asperity
{
  namespace
  {
    const char *const format_name = "asperity field model, version 1";
    const char *const expected    = "the fields that 'asperity reduce' learns";

    /** Columns of the tables `times` and `limits`. */
    constexpr unsigned int n_numbers_of_time = 5, n_limits = 5;

    std::string
    law_name(const std::string &kind, const std::size_t i)
    {
      return "law of " + kind + " " + std::to_string(i + 1);
    }

    FrictionLaw
    read_law(const Hdf5Content &content,
             const std::string &name,
             const std::string &origin)
    {
      try
        {
          return FrictionLaw::from_json(
            nlohmann::ordered_json::parse(content.text(name, origin)), origin);
        }
      catch (const nlohmann::json::exception &)
        {
          throw InputError("The file " + quoted_name(origin) + " has a " +
                           name + " that is damaged; " + expected +
                           " are expected.");
        }
    }
  } // namespace



  std::unique_ptr<FieldDecoder>
  load_decoder(const Hdf5Content &content,
               const FieldLayout &layout,
               const std::string &origin)
  {
    const std::string &name = content.text("decoder", origin);
    if (name == PodDecoder::decoder_name)
      return std::make_unique<PodDecoder>(content, layout.size(), origin);
    if (name == ManifoldDecoder::decoder_name)
      return std::make_unique<ManifoldDecoder>(content, layout.size(), origin);
    if (name == NetworkDecoder::decoder_name)
      return std::make_unique<NetworkDecoder>(layout, content, origin);
    throw InputError("The file " + quoted_name(origin) + " has the decoder " +
                     quoted_text(name) + ", which this program does not know.");
  }



  void
  FieldModel::save(const std::string &path) const
  {
    Hdf5Content content     = layout_.about().content();
    content.texts["format"] = format_name;
    decoder_->save(content);
    std::vector<double> numbers;
    for (const FieldTime &time : times)
      numbers.insert(numbers.end(),
                     {time.share,
                      time.time,
                      time.sliding_distance,
                      time.direction,
                      time.pressure});
    content.tables["times"]  = {times.size(), n_numbers_of_time, numbers};
    content.tables["spread"] = {spread.size(), 1, spread};
    content.tables["limits"] = {
      1,
      n_limits,
      {limits_.load, limits_.stress, limits_.shear, limits_.codes, limits_.mu}};
    for (std::size_t k = 0; k < code_laws.size(); ++k)
      content.texts[law_name("code", k)] = code_laws[k].to_json().dump();
    for (std::size_t i = 0; i < mu_laws.size(); ++i)
      content.texts[law_name("mu", i)] = mu_laws[i].to_json().dump();
    content.write(path);
  }



  FieldModel
  FieldModel::load(const std::string &path)
  {
    const Hdf5Content content = Hdf5Content::read(path, expected);
    const auto        fail    = [&](const std::string &what) {
      throw InputError("The file " + quoted_name(path) + " " + what + "; " +
                       expected + " are expected.");
    };
    if (content.text("format", path) != format_name)
      fail("has the format " + quoted_text(content.text("format", path)));
    const FieldLayout      layout(FieldSnapshots::from_content(content, path));
    std::vector<FieldTime> times;
    const Hdf5Table &rows = content.table("times", n_numbers_of_time, path);
    for (std::size_t i = 0; i < rows.n_rows; ++i)
      {
        const double *row = &rows.values[n_numbers_of_time * i];
        times.push_back({row[0], row[1], row[2], row[3], row[4]});
      }
    FieldModel model(layout, times, load_decoder(content, layout, path));
    model.spread = content.table("spread", 1, path).values;
    const std::vector<double> &limits =
      content.table("limits", n_limits, path).values;
    if (limits.size() != n_limits || model.times.empty() ||
        model.times.size() != model.layout_.n_times() ||
        model.spread.size() != model.decoder_->n_codes())
      fail("has tables that do not fit each other");
    model.limits_ = {limits[0], limits[1], limits[2], limits[3], limits[4]};
    for (std::size_t k = 0; k < model.spread.size(); ++k)
      model.code_laws.push_back(read_law(content, law_name("code", k), path));
    for (std::size_t i = 0; i < model.times.size(); ++i)
      model.mu_laws.push_back(read_law(content, law_name("mu", i), path));
    return model;
  }
} // namespace asperity
