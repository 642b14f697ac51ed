#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/campaign/run_record.h>
#include <asperity/contact_zone/scene_computation.h>
#include <asperity/postprocess/summary.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/timer.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <sstream>

namespace asperity
{
  using json = nlohmann::ordered_json;

  std::string
  RunOrder::name(const unsigned int n_profiles) const
  {
    std::string number = std::to_string(id);
    if (number.size() < 4)
      number.insert(0, 4 - number.size(), '0');
    return n_profiles > 1 ? number + "_p" + std::to_string(profile + 1) :
                            number;
  }



  namespace
  {
    RunRecord
    record_of(const SceneResult &result)
    {
      RunRecord record;
      record.done = true;
      if (result.status != FrictionStatus::valid)
        record.no_result = asperity::name(result.status);
      record.mu                   = result.friction.mu;
      record.mu_end               = result.friction.mu_end;
      record.spread               = result.friction.spread;
      record.contact_fraction     = result.friction.contact_fraction;
      record.oil_pressure         = result.friction.oil_pressure;
      record.oil_load_share       = result.oil_load_share;
      record.sliding_distance     = result.last.sliding_distance;
      record.max_plastic_strain   = result.last.max_plastic_strain;
      record.max_temperature      = result.last.max_temperature;
      record.max_contact_pressure = result.last.max_contact_pressure;
      record.over_distance        = result.over_distance;
      record.lubricant            = result.lubricant;
      record.mechanisms           = result.mechanisms;
      record.warnings             = result.warnings;
      record.steps                = result.steps;
      record.newton_iterations    = result.newton_iterations;
      return record;
    }

    RunRecord
    failure(const std::string &reason)
    {
      RunRecord record;
      record.reason = reason;
      return record;
    }
  } // namespace



  RunRecord
  execute(const std::string &base_scene, const RunOrder &order)
  {
    dealii::Timer timer;
    RunRecord     record;
    try
      {
        SceneInput input(base_scene, order.changes);
        record =
          record_of(compute_scene(input.parameters, Ranks(), order.field_file));
        if (!std::isfinite(record.mu))
          record = failure("mu is not a finite number.");
      }
    catch (const InputError &error)
      {
        record = failure(error.what());
      }
    catch (const ComputationError &error)
      {
        record = failure(error.what());
      }
    catch (const dealii::ExceptionBase &error)
      {
        std::ostringstream text;
        error.print_info(text);
        record = failure("deal.II: " + text.str());
      }
    record.seconds = timer.wall_time();
    return record;
  }



  namespace
  {
    /** Its name in records. */
    constexpr char contact_pressure[] = "max_contact_pressure";

    json
    values_of(const RunOrder &order)
    {
      json values = json::object();
      for (const auto &[path, text] : order.changes)
        values[path] = text;
      return values;
    }

    /** Names and places of the numbers, for writing and reading. */
    template <typename Record, typename Function>
    void
    for_each_number(Record &record, const Function &f)
    {
      f("mu", record.mu);
      f("mu_end", record.mu_end);
      f("spread", record.spread);
      f("contact_fraction", record.contact_fraction);
      f("oil_pressure", record.oil_pressure);
      f("oil_load_share", record.oil_load_share);
      f("sliding_distance", record.sliding_distance);
      f("max_plastic_strain", record.max_plastic_strain);
      f("max_temperature", record.max_temperature);
    }

    RunRecord
    parse(const json &document)
    {
      RunRecord record;
      record.done    = document.at("status") == "done";
      record.seconds = document.at("seconds");
      if (!record.done)
        {
          record.reason = document.at("reason");
          return record;
        }
      // records of older programs have no word of it
      record.no_result = document.value("no_result", "");
      record.mechanisms =
        document.value("mechanisms", std::vector<std::string>());
      for_each_number(record, [&](const char *name, double &value) {
        value = document.at("results").at(name);
      });
      record.max_contact_pressure =
        document.at("results").value(contact_pressure, 0.);
      for (const json &mean : document.at("over_distance"))
        record.over_distance.push_back(
          {mean.at("from"), mean.at("to"), mean.at("mu")});
      record.lubricant = document.at("lubricant");
      record.warnings = document.at("warnings").get<std::vector<std::string>>();
      record.steps    = document.at("steps");
      record.newton_iterations = document.at("newton_iterations");
      return record;
    }
  } // namespace



  void
  write_record(const std::string &path,
               const RunOrder    &order,
               const RunRecord   &record)
  {
    json document;
    document["id"]      = order.id;
    document["profile"] = order.profile + 1;
    document["inputs"]  = values_of(order);
    document["status"]  = record.done ? "done" : "failed";
    if (record.done)
      {
        for_each_number(record, [&](const char *name, const double value) {
          document["results"][name] = value;
        });
        document["results"][contact_pressure] = record.max_contact_pressure;
        document["over_distance"]             = json::array();
        for (const DistanceMean &mean : record.over_distance)
          document["over_distance"].push_back(
            {{"from", mean.from}, {"to", mean.to}, {"mu", mean.mu}});
        if (!record.no_result.empty())
          document["no_result"] = record.no_result;
        document["lubricant"]         = record.lubricant;
        document["mechanisms"]        = record.mechanisms;
        document["warnings"]          = record.warnings;
        document["steps"]             = record.steps;
        document["newton_iterations"] = record.newton_iterations;
      }
    else
      document["reason"] = record.reason;
    document["seconds"] = record.seconds;
    write_summary(path, document);
  }



  std::optional<RunRecord>
  read_record(const std::string &path, const RunOrder &order)
  {
    if (!std::filesystem::exists(path))
      return {};
    const json document = read_summary(path);
    try
      {
        if (document.at("inputs") != values_of(order))
          throw InputError(
            "The file " + quoted_name(path) + " holds a run at " +
            document.at("inputs").dump() + ", where the campaign expects " +
            values_of(order).dump() + "; take another output directory.");
        return parse(document);
      }
    catch (const json::exception &)
      {
        throw InputError("The file " + quoted_name(path) +
                         " is not the record of a run as Asperity writes it; "
                         "remove it, so that the run is computed again.");
      }
  }
} // namespace asperity
