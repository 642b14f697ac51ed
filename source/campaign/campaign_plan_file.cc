#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/base/version.h>
#include <asperity/campaign/campaign_plan.h>
#include <asperity/postprocess/summary.h>

#include <nlohmann/json.hpp>

// The plan on disk.

namespace asperity
{
  using json = nlohmann::ordered_json;

  namespace
  {
    const char *const plan_format = "asperity campaign plan 2";

    json
    to_json(const std::vector<LawInput> &inputs)
    {
      json list = json::array();
      for (const LawInput &input : inputs)
        list.push_back(
          {{"entry", input.name},
           {"unit", input.unit},
           {"lower", input.lower},
           {"upper", input.upper},
           {"scale", input.scale == Scale::linear ? "linear" : "logarithmic"}});
      return list;
    }

    /** Values by entry; of a file its path and MD5. */
    json
    to_json(const InputRecord &record)
    {
      json object = json::object();
      for (const RecordedEntry &entry : record.entries)
        if (entry.is_file)
          object[entry.path] = {{"file", entry.value}, {"md5", entry.content}};
        else
          object[entry.path] = entry.value;
      return object;
    }

    InputRecord
    to_record(const json &object)
    {
      InputRecord record;
      for (const auto &[path, value] : object.items())
        if (value.is_object())
          record.entries.push_back(
            {path, value.at("file"), true, value.at("md5")});
        else
          record.entries.push_back({path, value, false, ""});
      return record;
    }

    bool
    is_of_output(const std::string &path)
    {
      return path.compare(0, 7, "Output/") == 0;
    }
  } // namespace



  void
  CampaignPlan::save(const std::string &path) const
  {
    json document;
    document["format"]     = plan_format;
    document["program"]    = version_line();
    document["inputs"]     = to_json(inputs_);
    document["profiles"]   = profiles;
    document["base_scene"] = to_json(base_scene);
    document["points"]     = json::array();
    for (const PlannedPoint &point : points_)
      document["points"].push_back({{"id", point.id},
                                    {"role", point.test ? "test" : "training"},
                                    {"x", point.x}});
    write_summary(path, document);
  }



  void
  CampaignPlan::read(const std::string &path)
  {
    const json document = read_summary(path);
    try
      {
        if (document.at("format") != plan_format)
          throw InputError("The file " + quoted_name(path) +
                           " has the format " + document.at("format").dump() +
                           ", but \"" + plan_format +
                           "\" is expected; take another output directory.");
        if (document.at("inputs") != to_json(inputs_) ||
            document.at("profiles") != json(profiles))
          throw InputError("The inputs, ranges or profiles are not those of "
                           "the campaign in " +
                           quoted_name(path) +
                           "; take another output directory.");
        const std::string change =
          base_scene.change_since(to_record(document.at("base_scene")),
                                  is_of_output);
        if (!change.empty())
          throw InputError("The base scene is not that of the campaign in " +
                           quoted_name(path) + ": " + change +
                           "; take another output directory.");
        if (document.at("program") != version_line())
          warning_ = "The campaign in " + quoted_name(path) +
                     " was begun by another program, " +
                     document.at("program").get<std::string>() +
                     ", than the one that goes on with it.";
        points_.clear();
        for (const json &point : document.at("points"))
          add(point.at("role") == "test",
              point.at("x").get<std::vector<double>>());
      }
    catch (const json::exception &)
      {
        throw InputError(
          "The file " + quoted_name(path) +
          " is not the plan of a campaign as Asperity writes it; "
          "take another output directory.");
      }
  }
} // namespace asperity
