#include <asperity/base/errors.h>
#include <asperity/surrogate/friction_law.h>

#include <gtest/gtest.h>

#include <cmath>

#include "../../source/surrogate/law_checksum.h"
#include "../files.h"
#include "sample_data.h"

using namespace asperity;
using Json = nlohmann::ordered_json;

namespace
{
  FrictionLaw
  small_law(const bool with_known_deviation = false)
  {
    FrictionLawDescription description;
    description.inputs = {
      {"Load/Pressure", "p", "MPa", 3e8, 1.3e9, Scale::linear},
      {"Load/Velocity", "v", "m/min", 1. / 3., 10. / 3., Scale::logarithmic}};
    description.output                    = "mu \"quoted\"";
    description.largest_trusted_deviation = 0.1 + 0.2;
    description.n_profiles                = 4;
    description.topography_scatter        = 1. / 30.;
    description.shear_limit         = {6.3e8, 1.03, 298.15, 1793.15, 1., 1e4};
    description.provenance["files"] = {"surface.sdf", "scene.prm"};
    description.mechanisms          = {"ploughing", "oil"};
    description.inputs[1].reference = 1.25;
    description.choices = {{"preparation", 0.25, 1. / 3.}, {"scene", 0., 0.1}};
    std::vector<double> x, y, known;
    for (std::size_t j = 0; j < 20; ++j)
      {
        const std::vector<double> z = evenly_spread_point(j, 2);
        x.push_back(3e8 + 1e9 * z[0]);
        x.push_back(1. / 3. + 3. * z[1]);
        y.push_back(0.1 * std::exp(-z[0]) * (1. + 0.2 * z[1]));
        if (with_known_deviation)
          known.push_back(0.001 / (1. + z[0]));
      }
    return FrictionLaw::train(description, x, y, known);
  }

  const Json &
  good_document()
  {
    static const Json document = small_law().to_json();
    return document;
  }

  /** To all entries of objects, but not into lists or the provenance. */
  void
  collect_pointers(const Json               &object,
                   const std::string        &pointer,
                   std::vector<std::string> &pointers)
  {
    for (auto entry = object.begin(); entry != object.end(); ++entry)
      {
        const std::string here = pointer + "/" + entry.key();
        pointers.push_back(here);
        if (entry->is_object() && entry.key() != "provenance")
          collect_pointers(*entry, here, pointers);
      }
  }

  /** The message about a document in which one entry was changed. */
  std::string
  message_with(const std::string &pointer, const Json &value)
  {
    Json document                         = good_document();
    document[Json::json_pointer(pointer)] = value;
    return message_of<InputError>(
      [&]() { FrictionLaw::from_json(document, "law.json"); });
  }
} // namespace



TEST(FrictionLawFile, predicts_the_same_bits_after_a_round_trip)
{
  for (const bool with_known_deviation : {false, true})
    {
      const FrictionLaw law  = small_law(with_known_deviation);
      const std::string path = test_folder() + "/law.json";
      law.save(path);
      const FrictionLaw same = FrictionLaw::load(path);
      EXPECT_EQ(same.to_json(), law.to_json());
      EXPECT_EQ(same.offset(), law.offset());
      EXPECT_EQ(same.factor(), law.factor());
      EXPECT_EQ(same.data().x, law.data().x);
      EXPECT_EQ(same.data().known_deviation, law.data().known_deviation);
      EXPECT_EQ(same.process().alpha(), law.process().alpha());
      for (std::size_t j = 50; j < 80; ++j)
        {
          std::vector<double> x = evenly_spread_point(j, 2);
          x[0]                  = 1.4e9 * x[0];
          x[1]                  = 4. * x[1];
          const LawPrediction a = law.predict(x.data()),
                              b = same.predict(x.data());
          EXPECT_EQ(a.mean, b.mean);
          EXPECT_EQ(a.deviation, b.deviation);
          EXPECT_EQ(a.gradient, b.gradient);
          EXPECT_EQ(a.lower, b.lower);
          EXPECT_EQ(a.trusted, b.trusted);
        }
      const FrictionLawDescription &description = same.description();
      EXPECT_EQ(description.inputs[1].name, "Load/Velocity");
      EXPECT_EQ(description.inputs[1].symbol, "v");
      EXPECT_EQ(description.inputs[1].unit, "m/min");
      EXPECT_EQ(description.inputs[1].lower, 1. / 3.);
      EXPECT_EQ(description.inputs[1].scale, Scale::logarithmic);
      EXPECT_EQ(description.output, "mu \"quoted\"");
      EXPECT_EQ(description.n_profiles, 4u);
      EXPECT_EQ(description.topography_error,
                law.description().topography_error);
      EXPECT_EQ(description.topography_scatter, 1. / 30.);
      EXPECT_EQ(description.largest_trusted_deviation, 0.1 + 0.2);
      EXPECT_EQ(description.leave_one_out_error,
                law.description().leave_one_out_error);
      EXPECT_EQ(description.calibration, law.description().calibration);
      EXPECT_EQ(description.shear_limit(900.),
                law.description().shear_limit(900.));
      EXPECT_EQ(description.provenance["files"][0], "surface.sdf");
      EXPECT_EQ(description.mechanisms, law.description().mechanisms);
      EXPECT_FALSE(description.inputs[0].reference);
      EXPECT_EQ(description.inputs[1].reference, 1.25);
      ASSERT_EQ(description.choices.size(), 2u);
      EXPECT_EQ(description.choices[0].kind, "preparation");
      EXPECT_EQ(description.choices[0].below, 0.25);
      EXPECT_EQ(description.choices[0].above, 1. / 3.);
      EXPECT_EQ(description.choices[1].kind, "scene");
    }
}



TEST(FrictionLawFile, of_version_6_has_no_choices)
{
  Json document       = good_document();
  document["version"] = 6;
  document.erase("choices");
  document["checksum"] = law_checksum(document);
  EXPECT_TRUE(
    FrictionLaw::from_json(document, "law.json").description().choices.empty());
}



TEST(FrictionLawFile, every_entry_is_needed)
{
  std::vector<std::string> pointers;
  collect_pointers(good_document(), "", pointers);
  collect_pointers(good_document()["inputs"][1], "/inputs/1", pointers);
  EXPECT_EQ(pointers.size(), 50u);
  for (const std::string &pointer : pointers)
    {
      Json       document = good_document();
      const auto place    = Json::json_pointer(pointer);
      document[place.parent_pointer()].erase(place.back());
      const std::string message = message_of<InputError>(
        [&]() { FrictionLaw::from_json(document, "law.json"); });
      EXPECT_EQ(message,
                pointer == "/format" ?
                  "law.json: The document is no friction law: its entry "
                  "'format' must be 'asperity friction law'." :
                  "law.json: The friction law has no entry '" +
                    pointer.substr(1) +
                    "'; every one that Asperity writes is expected.");
    }
}



TEST(FrictionLawFile, wrong_entries_are_named)
{
  const std::string by  = "law.json: The entry ",
                    law = "' of the friction law is ";
  EXPECT_EQ(message_with("/version", 1),
            by + "'version" + law +
              "1; 3 to 7, which this program reads, is expected.");
  EXPECT_EQ(message_with("/kernel", "cubic"),
            by + "'kernel" + law +
              "\"cubic\"; 'rbf' or 'matern_3_2' or 'matern_5_2' is expected.");
  EXPECT_EQ(message_with("/inputs/1/scale", 3),
            by + "'inputs/1/scale" + law +
              "3; 'linear' or 'logarithmic' is expected.");
  EXPECT_EQ(message_with("/inputs/0/lower", "3e8"),
            by + "'inputs/0/lower" + law + "\"3e8\"; a number is expected.");
  EXPECT_EQ(message_with("/inputs/0/name", 7),
            by + "'inputs/0/name" + law + "7; a text is expected.");
  EXPECT_EQ(message_with("/topography/profiles", 0),
            by + "'topography/profiles" + law +
              "0; a number of at least 1 without decimals is expected.");
  EXPECT_EQ(message_with("/inputs", 7),
            by + "'inputs" + law + "7; a list is expected.");
  EXPECT_EQ(message_with("/output", "mu"),
            by + "'output" + law + "\"mu\"; an object is expected.");
  EXPECT_EQ(message_with("/output/factor", 0.),
            by + "'output/factor" + law +
              "0.0; a positive number is expected.");
  EXPECT_EQ(message_with("/hyperparameters/noise_variance", -1),
            by + "'hyperparameters/noise_variance" + law +
              "-1; a number that is not negative is expected.");
  EXPECT_EQ(message_with("/hyperparameters/length_scales", Json::array({1})),
            by + "'hyperparameters/length_scales" + law +
              "[1]; a list of 2 numbers, one an input, is expected.");
  EXPECT_EQ(message_with("/data/x/4", Json::array({1, 2, 3})),
            by + "'data/x/4" + law +
              "[1,2,3]; a list of 2 numbers, one an input, is expected.");
  EXPECT_EQ(message_with("/data/y/4", -1),
            "law.json: Value number 5 of 'mu \"quoted\"' is -1; on a "
            "logarithmic scale all must be positive.");
  EXPECT_EQ(message_with("/shear_limit/exponent", 0),
            by + "'shear_limit/exponent" + law +
              "0; a positive number is expected.");
}



TEST(FrictionLawFile, other_documents_are_refused)
{
  const std::string path    = test_folder() + "/other.json";
  const auto        message = [&]() {
    return message_of<InputError>([&]() { FrictionLaw::load(path); });
  };
  EXPECT_EQ(message(),
            "The file '" + path +
              "' could not be opened; a friction law is expected.");
  overwrite(path, "{\"format\": ");
  EXPECT_EQ(message(),
            "The file '" + path +
              "' is no JSON document at line 1, column 12; a friction law is "
              "expected.");
  overwrite(path, "{\"format\":\n  1e400}");
  EXPECT_EQ(
    message(),
    "The file '" + path +
      "' holds a number that is too large; a friction law is expected.");
  for (const std::string &bomb :
       {std::string(100000, '['), "{\"a\":" + std::string(100, '[')})
    {
      overwrite(path, bomb);
      EXPECT_EQ(message(),
                "The file '" + path +
                  "' has more levels or keys than any that Asperity writes; a "
                  "friction law is expected.");
    }
  overwrite(path, "{\"mu\": 0.1}");
  EXPECT_EQ(message(),
            path + ": The document is no friction law: its entry 'format' must "
                   "be 'asperity friction law'.");
  overwrite(path, "[1, 2]");
  EXPECT_EQ(message(),
            path + ": The document is no friction law: its entry 'format' must "
                   "be 'asperity friction law'.");
}



// Any number or text that is not as it was written, however plausible.
TEST(FrictionLawFile, changed_contents_are_refused)
{
  const std::string message =
    "law.json: The friction law was changed after it was written: its checksum "
    "is not that of its contents; expected the file as Asperity wrote it.";
  EXPECT_EQ(message_with("/output/factor", 1e-308), message);
  EXPECT_EQ(message_with("/data/y/0", 1e308), message);
  EXPECT_EQ(message_with("/data/y/7", 0.1), message);
  EXPECT_EQ(message_with("/hyperparameters/length_scales/0", 1.), message);
  EXPECT_EQ(message_with("/largest_trusted_deviation", 1e300), message);
  EXPECT_EQ(message_with("/provenance/note", "y"), message);
  EXPECT_EQ(message_with("/mechanisms/0", "adhesion"), message);
  EXPECT_EQ(message_with("/checksum", "0000000000000000"), message);
}



// Other programs may sort the keys and write 1.0 as 1.
TEST(FrictionLawFile, layout_and_order_do_not_count)
{
  const nlohmann::json sorted = nlohmann::json::parse(good_document().dump());
  Json                 other  = Json::parse(sorted.dump(7));
  ASSERT_NE(other.dump(), good_document().dump());
  ASSERT_EQ(other["shear_limit"]["strain"], 1.);
  other["shear_limit"]["strain"] = 1;
  EXPECT_EQ(FrictionLaw::from_json(other, "law.json").data().y,
            small_law().data().y);
}



TEST(FrictionLawFile, names_stay_in_one_line)
{
  for (const std::string pointer :
       {"/inputs/0/name", "/inputs/0/symbol", "/output/name", "/mechanisms/0"})
    for (const std::string &name : {std::string("x\n      CALL ABORT"),
                                    std::string(),
                                    std::string(201, 'x')})
      EXPECT_NE(message_with(pointer, name)
                  .find(
                    "a text of 1 to 200 characters in one line is expected"),
                std::string::npos)
        << pointer;
  EXPECT_EQ(message_with("/inputs/0/unit", "furlong"),
            "law.json: The entry 'inputs/0/unit' of the friction law is "
            "\"furlong\"; a unit that Asperity knows is expected.");
  EXPECT_EQ(message_with("/inputs/1/symbol", "p"),
            "law.json: The inputs 'Load/Pressure' and 'Load/Velocity' of the "
            "law have one name or symbol; different ones are expected.");
}



namespace
{
  /** As programs before the checksum wrote it. */
  Json
  old_document()
  {
    Json document       = good_document();
    document["version"] = 3;
    document.erase("model");
    document.erase("mechanisms");
    document.erase("checksum");
    document["shear_limit"].erase("softens");
    for (Json &input : document["inputs"])
      input.erase("reference");
    return document;
  }
} // namespace



TEST(FrictionLawFile, files_without_a_checksum_are_read)
{
  const FrictionLaw law = FrictionLaw::from_json(old_document(), "law.json");
  const double      x[] = {8e8, 1.};
  EXPECT_EQ(law.mean(x), small_law().mean(x));
  EXPECT_TRUE(law.description().mechanisms.empty());
}



TEST(FrictionLawFile, files_of_processes_alone_are_read)
{
  Json document       = good_document();
  document["version"] = 4;
  document.erase("model");
  document["checksum"]  = law_checksum(document);
  const FrictionLaw law = FrictionLaw::from_json(document, "law.json");
  const double      x[] = {8e8, 1.};
  EXPECT_EQ(law.mean(x), small_law().mean(x));
}



TEST(FrictionLawFile, their_damaged_numbers_are_refused)
{
  for (const auto &[pointer, value] : {std::make_pair("/output/factor", 1e-308),
                                       {"/output/factor", 1e300},
                                       {"/output/offset", 1e308},
                                       {"/data/y/0", 1e308},
                                       {"/inputs/0/upper", 1e308}})
    {
      Json document                         = old_document();
      document[Json::json_pointer(pointer)] = value;
      EXPECT_NE(message_of<InputError>(
                  [&]() { FrictionLaw::from_json(document, "law.json"); }),
                "")
        << pointer << " = " << value;
    }
}
